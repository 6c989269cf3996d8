#include <catch2/catch.hpp>
#include <cmath>

#include "render/map_colours.hpp"
#include "render/map_lines.hpp"
#include "render/map_renderer.hpp"

using namespace biotope;

namespace {
constexpr std::array<std::uint8_t, 4> tone{1, 2, 3, 255};
}

TEST_CASE("a line of two points is a band of two triangles, its sides apart across the line") {
  RibbonMesh mesh;
  const std::vector<RibbonPoint> points{{0, 0, 0.5F, 2}, {10, 0, 1, 2}};
  add_ribbon(mesh, points, tone);
  REQUIRE(mesh.vertices.size() == 4);
  CHECK(mesh.indices.size() == 6);
  CHECK(mesh.vertices[0].normal_x == Approx(0).margin(1e-6));
  CHECK(std::abs(mesh.vertices[0].normal_y) == Approx(1));
  CHECK(mesh.vertices[0].normal_y == Approx(-mesh.vertices[1].normal_y));
  CHECK(mesh.vertices[0].strength == 0.5F);
  CHECK(mesh.vertices[3].strength == 1);
}

TEST_CASE("a bend is mitred but never to a spike") {
  RibbonMesh mesh;
  const std::vector<RibbonPoint> right_angle{{0, 0, 1, 0}, {10, 0, 1, 0}, {10, 10, 1, 0}};
  add_ribbon(mesh, right_angle, tone);
  const RibbonVertex& corner = mesh.vertices[2];
  CHECK(std::hypot(corner.normal_x, corner.normal_y) == Approx(std::sqrt(2.0)).epsilon(1e-4));
  RibbonMesh back;
  const std::vector<RibbonPoint> hairpin{{0, 0, 1, 0}, {10, 0, 1, 0}, {0, 0.01F, 1, 0}};
  add_ribbon(back, hairpin, tone);
  for (const RibbonVertex& vertex : back.vertices) CHECK(std::hypot(vertex.normal_x, vertex.normal_y) <= 2.001);
}

TEST_CASE("points that coincide do not make holes, and a single point makes nothing") {
  RibbonMesh mesh;
  add_ribbon(mesh, std::vector<RibbonPoint>{{3, 3, 1, 0}}, tone);
  CHECK(mesh.vertices.empty());
  add_ribbon(mesh, std::vector<RibbonPoint>{{3, 3, 1, 0}, {3, 3, 1, 0}, {5, 3, 1, 0}}, tone);
  for (const RibbonVertex& vertex : mesh.vertices) {
    CHECK(std::isfinite(vertex.normal_x));
    CHECK(std::isfinite(vertex.normal_y));
  }
}

TEST_CASE("herds of one species on one spot are one larger mark; others keep their own") {
  const auto length = [](int, int animals) { return float(10 + animals); };
  const auto mark = [&](float x, int species, int animals) {
    return HerdMarker{x, 0, 0, length(species, animals), tone, species, animals};
  };
  const auto merged = merged_marks({mark(0, 1, 5), mark(0.5F, 1, 8), mark(0.5F, 2, 3), mark(40, 1, 2)}, 1, length);
  REQUIRE(merged.size() == 3);
  CHECK(merged[0].animals == 13);
  CHECK(merged[0].pixels == 23);
  CHECK(merged[0].x == 0.5F);
  // From close by they are two places.
  CHECK(merged_marks({mark(0, 1, 5), mark(0.5F, 1, 8)}, 64, length).size() == 2);
}

TEST_CASE("the busiest trail is the strongest, and a thousandth of it is the faintest") {
  TrailNetwork trails;
  TrailRoute route;
  route.points = {{0, 0}, {1, 0}, {2, 0}};
  route.weight = {1e6F, 1e3F, 1};
  trails.routes = {route};
  const RibbonMesh mesh = trail_ribbons(trails);
  REQUIRE(mesh.vertices.size() == 6);
  CHECK(mesh.vertices[0].strength == Approx(1));
  CHECK(mesh.vertices[2].strength == Approx(0).margin(1e-4));
  CHECK(mesh.vertices[4].strength == 0);
}

TEST_CASE("colour maps run evenly from end to end and stay within the screen's colours") {
  for (int map = 0; map < colour_maps - 1; ++map) {
    float last = -1;
    for (int i = 0; i <= 64; ++i) {
      const auto colour = colour_of(ColourMap(map), float(i) / 64);
      for (const float channel : colour) {
        CHECK(channel >= 0);
        CHECK(channel <= 1);
      }
      const float value = 0.2126F * colour[0] + 0.7152F * colour[1] + 0.0722F * colour[2];
      if (last >= 0) CHECK(std::abs(value - last) < 0.09F);
      last = value;
    }
  }
}

TEST_CASE("sequential colour maps keep one direction of lightness") {
  for (const ColourMap map : {ColourMap::viridis, ColourMap::inferno, ColourMap::greens, ColourMap::browns, ColourMap::blues}) {
    const auto value = [&](float t) {
      const auto c = colour_of(map, t);
      return 0.2126F * c[0] + 0.7152F * c[1] + 0.0722F * c[2];
    };
    const float direction = value(1) - value(0);
    for (int i = 0; i < 16; ++i) CHECK((value(float(i + 1) / 16) - value(float(i) / 16)) * direction > 0);
  }
}

TEST_CASE("categories repeat after twelve and the table holds what legends show") {
  CHECK(category_colour(0) == category_colour(12));
  CHECK(category_colour(-1) == category_colour(11));
  CHECK(category_colour(3) != category_colour(4));
  const auto table = colour_table();
  REQUIRE(table.size() == std::size_t(colour_maps * colour_table_width * 4));
  const auto first = colour_of(ColourMap::greens, 0.5F / colour_table_width);
  CHECK(table[std::size_t(int(ColourMap::greens) * colour_table_width * 4)] == std::lround(first[0] * 255));
}

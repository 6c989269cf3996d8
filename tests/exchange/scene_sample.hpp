#pragma once

#include <catch2/catch.hpp>

#include "core/base/random.hpp"
#include "tests/scenes/small_valley.hpp"

namespace biotope_test {

/// Something of every kind that can be placed.
inline biotope::Placements some_placements() {
  using namespace biotope;
  Placements placements;
  placements.water.rivers = {{{{1.1F, 2}, {30, 40.25F}, {-3, 120}}, 1.0 / 3}, {{{5, 5}, {6, 6}}, 12}};
  placements.water.lakes = {{{{10, 10}, {20, 10}, {15.7F, 22}}, 2.3F}};
  placements.places.fords = {{{12.3F, 4}, 7.7F}};
  placements.places.exits = {{{0, 64}, 20}, {{159, 3}, 11.1F}};
  placements.places.waypoints = {{{80, 80}, 0.35F}};
  placements.places.pinned_trails = {{{{1, 1}, {2.2F, 3.3F}}, 12345.6F}};
  placements.places.forbidden_trails = {{{{9, 9}, {99, 9}, {99, 99}}, 0.1F}};
  placements.plans = {{"reindeer", {50, 60.5F}, 2, {{{40, 41}, 6.25F, 9.1F}, {{44, 45}, 22.5F, 26}}}, {"wolf", {1, 1}, 0, {}}};
  return placements;
}

/// Layers of the kinds that came with version 2, states, a selection and placements.
inline void add_newer_parts(biotope::Document& document) {
  using namespace biotope;
  const int width = document.terrain->height.width();
  const int height = document.terrain->height.height();
  const auto dotted = [&](float value) {
    PaintLayer layer(width, height);
    for (int i = 0; i < 40; ++i) layer.set((i * 37) % width, (i * 11) % height, {value, 1 - float(i) / 64});
    return std::make_shared<PaintLayer>(layer);
  };
  document.layers[{LayerKind::resource, "texture"}] = dotted(3.5F);
  document.layers[{LayerKind::geology, "class"}] = dotted(2);
  document.layers[{LayerKind::loss, document.species->front().name}] = dotted(0.4F);
  document.layers[{LayerKind::passage, "all"}] = dotted(-1);
  document.layers[{LayerKind::ground, "height"}] = dotted(-12.5F);
  document.layer_states[{LayerKind::ground, "height"}] = {true, false};
  document.layer_states[{LayerKind::loss, "nobody"}] = {false, true};
  SelectionMask selection(width, height);
  for (int i = 0; i < 100; ++i) selection.set(60 + i % 20, 40 + i / 20, std::uint8_t(255 - i));
  document.selection = std::make_shared<const SelectionMask>(selection);
  SelectionMask locked(width, height);
  for (int i = 0; i < 60; ++i) locked.set(30 + i % 10, 70 + i / 10, std::uint8_t(200 + i % 50));
  document.locked_area = std::make_shared<const SelectionMask>(locked);
  document.placements = some_placements();
}

/// A document with something in every part that a scene saves.
inline biotope::Document full_document() {
  using namespace biotope;
  auto made = scenes::small_document(std::string(BIOTOPE_SOURCE_DIR) + "/assets");
  if (!made) FAIL(made.error().message);
  Document document = *made;
  Terrain terrain = *document.terrain;
  const int width = terrain.height.width();
  const int height = terrain.height.height();
  for (std::size_t i = 0; i < terrain.height.size(); ++i) {
    terrain.height[i] += float(random_unit({11, i}) * 1e-3);
  }
  terrain.voids = Grid<std::uint8_t>(width, height);
  terrain.voids(3, 5) = 1;
  terrain.cell_size = 10.0 / 3;
  terrain.latitude = 42.123456789012345;
  terrain.georeference = {"LOCAL_CS[\"somewhere\"]", {0.1, 10.0 / 3, 0, 1e7 / 3, 0, -10.0 / 3}};
  document.terrain = std::make_shared<const Terrain>(terrain);
  document.inflows = {{12, 0, 1.0 / 3 * 1e9}, {159, 127, 42}};
  document.title = "Vallée de l'été \"1\"";
  document.seed = 0xfedcba9876543210ULL;
  document.use_proportions = {{0, false}, {2, true}};

  PaintLayer density(width, height);
  for (int i = 0; i < 500; ++i) {
    const auto n = std::uint64_t(i);
    density.set(random_int(0, 90, {1, n}), random_int(0, height - 1, {2, n}),
                {float(random_unit({3, n})), float(random_unit({4, n}))});
  }
  PaintLayer moisture(width, height);
  moisture.set(159, 127, {9, 1});
  document.layers[{LayerKind::plant_density, document.species->front().name}] = std::make_shared<PaintLayer>(density);
  document.layers[{LayerKind::resource, "moisture"}] = std::make_shared<PaintLayer>(moisture);
  document.layers[{LayerKind::animal_density, "nobody"}] = std::make_shared<PaintLayer>(width, height);

  add_newer_parts(document);
  for (int month = 0; month < months; ++month) {
    document.given_environment.monthly[1].push_back(std::make_shared<const Grid<float>>(width, height, 1 + float(month) / 3));
  }
  Grid<Geology> geology(width, height, Geology::marl);
  geology(1, 1) = Geology::alluvium;
  document.given_environment.geology = std::make_shared<const Grid<Geology>>(geology);
  return document;
}

/// Everything of two documents is the same, to the bit.
inline void require_same(const biotope::Document& a, const biotope::Document& b) {
  REQUIRE(a.terrain->height == b.terrain->height);
  REQUIRE(a.terrain->voids == b.terrain->voids);
  REQUIRE(a.terrain->cell_size == b.terrain->cell_size);
  REQUIRE(a.terrain->latitude == b.terrain->latitude);
  REQUIRE(a.terrain->name == b.terrain->name);
  REQUIRE(a.terrain->georeference.wkt == b.terrain->georeference.wkt);
  REQUIRE(a.terrain->georeference.transform == b.terrain->georeference.transform);
  REQUIRE(a.title == b.title);
  REQUIRE(a.seed == b.seed);
  REQUIRE(a.use_proportions == b.use_proportions);
  REQUIRE(a.climate == b.climate);
  REQUIRE(*a.species == *b.species);
  REQUIRE(a.inflows.size() == b.inflows.size());
  for (std::size_t i = 0; i < a.inflows.size(); ++i) {
    REQUIRE(a.inflows[i].x == b.inflows[i].x);
    REQUIRE(a.inflows[i].y == b.inflows[i].y);
    REQUIRE(a.inflows[i].catchment_area == b.inflows[i].catchment_area);
  }
  REQUIRE(a.layers.size() == b.layers.size());
  for (const auto& [id, layer] : a.layers) REQUIRE(*layer == *b.layers.at(id));
  REQUIRE(a.layer_states == b.layer_states);
  REQUIRE(bool(a.selection) == bool(b.selection));
  if (a.selection) REQUIRE(*a.selection == *b.selection);
  REQUIRE(bool(a.locked_area) == bool(b.locked_area));
  if (a.locked_area) REQUIRE(*a.locked_area == *b.locked_area);
  REQUIRE(a.placements == b.placements);
  for (std::size_t r = 0; r < a.given_environment.monthly.size(); ++r) {
    const auto& maps = a.given_environment.monthly[r];
    REQUIRE(maps.size() == b.given_environment.monthly[r].size());
    for (std::size_t month = 0; month < maps.size(); ++month) {
      REQUIRE(*maps[month] == *b.given_environment.monthly[r][month]);
    }
  }
  REQUIRE(bool(a.given_environment.geology) == bool(b.given_environment.geology));
  if (a.given_environment.geology) REQUIRE(*a.given_environment.geology == *b.given_environment.geology);
}

}  // namespace biotope_test

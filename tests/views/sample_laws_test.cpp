// What the plants of the built-in valley agree with: its maps, its water, its trails.
#include <algorithm>
#include <cmath>
#include <map>
#include <mutex>

#include "core/base/parallel.hpp"
#include "render/ground_picture.hpp"
#include "render/plant_placement.hpp"
#include "tests/views/sample_maps.hpp"

using namespace biotope;
using namespace biotope::test;

namespace {

struct Planted {
  std::shared_ptr<const MapsSnapshot> maps;
  std::shared_ptr<const GroundPicture> picture;
  PlantPlacement plants;
};

/// The valley with its plants as the 3D view places them.
Planted planted_valley() {
  Planted out;
  out.maps = sample("valley");
  out.picture = make_ground({out.maps, 5, {}, glm::normalize(glm::vec3(0.4F, -0.3F, 0.8F))}, nullptr);
  out.plants = PlantPlacement(
      PlantGround{out.maps, out.picture->lines->shore, out.picture->lines->trails, std::make_shared<const Grazing>(*out.maps)});
  return out;
}

template <class Visit>
void each_block(const Planted& valley, Stratum stratum, const Visit& visit) {
  const int columns = int(valley.maps->terrain().width_metres() / double(PlantPlacement::block_side(stratum)));
  const int rows = int(valley.maps->terrain().height_metres() / double(PlantPlacement::block_side(stratum)));
  parallel_each(std::size_t(columns) * std::size_t(rows), [&](std::size_t i) {
    const int column = int(i) % columns;
    const int row = int(i) / columns;
    visit(i, valley.plants.block(stratum, column, row));
  });
}

/// Distance of a place from the middle line of the nearest route, m.
double distance_to_routes(const MapsSnapshot& maps, glm::dvec2 place) {
  const Terrain& terrain = maps.terrain();
  const auto metres = [&](PathPoint p) {
    return glm::dvec2((double(p.x) + 0.5) * terrain.cell_size, (terrain.height.height() - 0.5 - double(p.y)) * terrain.cell_size);
  };
  double nearest = 1e9;
  for (const TrailRoute& route : maps.trails->routes) {
    for (std::size_t i = 0; i + 1 < route.points.size(); ++i) {
      const glm::dvec2 a = metres(route.points[i]);
      const glm::dvec2 along = metres(route.points[i + 1]) - a;
      const double t = std::clamp(glm::dot(place - a, along) / std::max(glm::dot(along, along), 1e-9), 0.0, 1.0);
      nearest = std::min(nearest, glm::length(place - a - t * along));
    }
  }
  return nearest;
}

}  // namespace

TEST_CASE("in the valley no trunk stands on a trail or in the water that is drawn") {
  const Planted valley = planted_valley();
  const TrailLines& trails = *valley.picture->lines->trails;
  std::mutex lock;
  std::vector<PlantInstance> beside;
  int on_trail = 0;
  int wet = 0;
  std::size_t all = 0;
  for (const Stratum stratum : {Stratum::tree, Stratum::shrub}) {
    each_block(valley, stratum, [&](std::size_t, const std::vector<PlantInstance>& plants) {
      const std::lock_guard hold(lock);
      all += plants.size();
      for (const PlantInstance& plant : plants) {
        const float inside = trails.inside(plant.x, plant.y);
        on_trail += inside > -valley.plants.trunk_radius(plant) + 1e-3F ? 1 : 0;
        wet += valley.plants.has_room(plant.x, plant.y, 0) ? 0 : 1;
        if (inside > -1.5F) beside.push_back(plant);
      }
    });
  }
  CHECK(all > 100000);
  CHECK(on_trail == 0);
  CHECK(wet == 0);
  // The lines tell what the routes say: no trunk within the narrowest trail's width of any of them.
  REQUIRE(beside.size() > 100);
  std::sort(beside.begin(), beside.end(), [](const auto& a, const auto& b) { return std::pair(a.x, a.y) < std::pair(b.x, b.y); });
  for (std::size_t i = 0; i < beside.size(); i += beside.size() / 60) {
    CHECK(distance_to_routes(*valley.maps, {beside[i].x, beside[i].y}) >= double(trail_half_width(0)));
  }
}

TEST_CASE("in the valley no herb grows on the bare middle of a trail") {
  const Planted valley = planted_valley();
  const TrailLines& trails = *valley.picture->lines->trails;
  std::size_t seen = 0;
  const int blocks = int(valley.maps->terrain().width_metres() / double(herb_block_side));
  for (int row = 3; row < blocks && seen < 40; row += 5) {
    for (int column = 3; column < blocks && seen < 40; column += 5) {
      if (trails.none_within(float(column) * herb_block_side, float(row) * herb_block_side, herb_block_side)) continue;
      ++seen;
      for (const PlantInstance& plant : valley.plants.block(Stratum::herb, column, row)) {
        CHECK(trails.inside(plant.x, plant.y) <= 0);
        CHECK(trails.worn(plant.x, plant.y) < 0.62F);
      }
    }
  }
  CHECK(seen == 40);
}

TEST_CASE("in the valley plants per hectare are those of the maps, water and trails taken out, within 2 % for every species") {
  const Planted valley = planted_valley();
  const Terrain& terrain = valley.maps->terrain();
  const auto& plants = valley.maps->web->levels[0];
  for (const Stratum stratum : {Stratum::tree, Stratum::shrub}) {
    std::mutex lock;
    std::map<int, double> stands;
    std::map<int, double> trunk;
    each_block(valley, stratum, [&](std::size_t, const std::vector<PlantInstance>& block) {
      const std::lock_guard hold(lock);
      for (const PlantInstance& plant : block) {
        ++stands[int(plant.plant)];
        trunk[int(plant.plant)] += double(valley.plants.trunk_radius(plant));
      }
    });
    for (const auto& [plant, number] : stands) {
      const auto radius = float(trunk[plant] / number);
      std::vector<double> row_sums(std::size_t(terrain.height.height()), 0);
      std::vector<double> row_areas(row_sums.size(), 0);
      parallel_rows(0, terrain.height.height(), [&](int y) {
        for (int x = 0; x < terrain.height.width(); ++x) {
          const double density = valley.plants.density(plant, x, y);
          if (density <= 0) continue;
          // Share of the cell that water and trails leave.
          int room = 0;
          for (int part = 0; part < 16; ++part) {
            const double east = (x + (part % 4 + 0.5) / 4) * terrain.cell_size;
            const double north = (terrain.height.height() - 1 - y + (part / 4 + 0.5) / 4) * terrain.cell_size;
            room += valley.plants.has_room(float(east), float(north), radius) ? 1 : 0;
          }
          row_sums[std::size_t(y)] += density * terrain.cell_area() * room / 16;
          row_areas[std::size_t(y)] += terrain.cell_area();
        }
      });
      double expected = 0;
      double hectares = 0;
      for (std::size_t y = 0; y < row_sums.size(); ++y) {
        expected += row_sums[y];
        hectares += row_areas[y] / 1e4;
      }
      INFO(valley.maps->web->species[std::size_t(plants[std::size_t(plant)])].name << ": " << number << " of " << expected
                                                                                   << " on " << hectares << " ha");
      if (hectares < 20) continue;
      // Of few plants the number may be off by chance, as far as one and a half standard deviations of independent draws.
      CHECK(number == Approx(expected).epsilon(0.02).margin(1.5 * std::sqrt(expected)));
    }
  }
}

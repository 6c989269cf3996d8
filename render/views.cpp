#include <algorithm>
#include <array>
#include <cmath>
#include <glm/gtc/constants.hpp>
#include <memory>
#include <vector>

#include "render/landscape_renderer.hpp"
#include "render/plant_placement.hpp"

namespace biotope {

namespace {

/// A place to stand, in cells.
struct Spot {
  int x = 0;
  int y = 0;
};

/// Metres from the south-west corner of a cell's centre.
glm::dvec2 metres_of(const Terrain& terrain, Spot spot) {
  return {(spot.x + 0.5) * terrain.cell_size, (terrain.height.height() - 0.5 - spot.y) * terrain.cell_size};
}

/// A ford or piece of river in the inner part of the map, preferring much water, open ground and gentle banks; the middle when
/// there is no water.
Spot water_spot(const MapsSnapshot& snapshot) {
  const Terrain& terrain = snapshot.terrain();
  const int width = terrain.height.width();
  const int height = terrain.height.height();
  Spot best{width / 2, height / 2};
  if (!snapshot.hydrology) return best;
  const Hydrology& water = *snapshot.hydrology;
  double best_score = 0;
  const auto consider = [&](int x, int y, double bonus) {
    const double across = std::min({x, width - 1 - x, y, height - 1 - y}) / double(std::min(width, height));
    if (across < 0.12) return;
    const double flow = std::sqrt(std::max(0.0F, water.discharge(x, y)));
    const double trees = snapshot.tree_cover ? cover_fraction((*snapshot.tree_cover)(x, y)) : 0;
    const double slope = snapshot.derivatives ? snapshot.derivatives->slope(x, y) : 0;
    const double score = flow * (1 + bonus) * (1 - 0.7 * trees) * (0.4 + across) / (1 + 4 * slope);
    if (score <= best_score) return;
    best_score = score;
    best = {x, y};
  };
  for (const Ford& ford : water.fords) consider(ford.x, ford.y, 0.3);
  for (const RiverReach& reach : water.reaches) {
    for (std::size_t i = 0; i < reach.cells.size(); i += 8) consider(int(reach.cells[i]) % width, int(reach.cells[i]) / width, 0);
  }
  return best;
}

/// How good it is to look from `eye` toward a heading: relief rises behind an open middle ground, and water lies ahead.
double view_score(const MapsSnapshot& snapshot, const glm::dvec3& eye, double heading, double reach) {
  const Terrain& terrain = snapshot.terrain();
  const double east = std::sin(heading);
  const double north = std::cos(heading);
  double highest = -1;
  double visible = 0;
  double wet = 0;
  for (double t = 20; t < reach; t *= 1.12) {
    const double x = eye.x + east * t;
    const double y = eye.y + north * t;
    if (x < 0 || y < 0 || x > terrain.width_metres() || y > terrain.height_metres()) break;
    const double rise = (ground_height(terrain, x, y) - eye.z) / t;
    if (rise > highest) {
      highest = rise;
      visible += std::log(t);
      if (snapshot.hydrology) {
        const int cx = std::clamp(int(x / terrain.cell_size), 0, terrain.height.width() - 1);
        const int cy = std::clamp(terrain.height.height() - 1 - int(y / terrain.cell_size), 0, terrain.height.height() - 1);
        wet += snapshot.hydrology->water_depth(cx, cy) > 0 && t < 250 ? 2.0 : 0.0;
      }
    }
    if (rise > 0.35 && t < 150) return 0;
  }
  return visible + wet + 30 * std::clamp(highest, 0.0, 0.3);
}

/// Trees within `reach` metres of a place.
std::vector<PlantInstance> trees_around(const MapsSnapshot& snapshot, glm::dvec2 place, double reach) {
  std::vector<PlantInstance> trees;
  if (!snapshot.web || snapshot.cover.empty()) return trees;
  const PlantPlacement placement(std::make_shared<const MapsSnapshot>(snapshot));
  const auto block_at = [](double metres) { return int(std::floor(metres / double(woody_block_side))); };
  for (int row = block_at(place.y - reach); row <= block_at(place.y + reach); ++row) {
    for (int column = block_at(place.x - reach); column <= block_at(place.x + reach); ++column) {
      const auto block = placement.block(Stratum::tree, column, row);
      trees.insert(trees.end(), block.begin(), block.end());
    }
  }
  return trees;
}

/// How much of a view trees close before the eye leave free, 0..1.
double free_sight(const std::vector<PlantInstance>& trees, const glm::dvec3& eye, double heading) {
  double hidden = 0;
  for (const PlantInstance& tree : trees) {
    const glm::dvec2 to(double(tree.x) - eye.x, double(tree.y) - eye.y);
    const double away = std::max(1.0, glm::length(to));
    const double ahead = (to.x * std::sin(heading) + to.y * std::cos(heading)) / away;
    // Branches of the nearest reach into the picture from all sides but the back; others hide what they stand before.
    if (away < 8 && ahead > -0.6) hidden += 4;
    if (ahead > 0.9) hidden += std::pow(9 / away, 2.0);
  }
  return 1 / (1 + hidden);
}

}  // namespace

Camera first_view(const MapsSnapshot& snapshot) {
  const Terrain& terrain = snapshot.terrain();
  const glm::dvec2 water = metres_of(terrain, water_spot(snapshot));
  const double reach = std::max(terrain.width_metres(), terrain.height_metres());
  const std::vector<PlantInstance> trees = trees_around(snapshot, water, 75);
  Camera camera;
  double best = -1;
  // From a bank some way off, over the water and along the valley.
  for (int turn = 0; turn < 32; ++turn) {
    const double heading = turn * glm::two_pi<double>() / 32;
    for (const double back : {22.0, 45.0}) {
      const double x = std::clamp(water.x - std::sin(heading) * back, 0.0, terrain.width_metres());
      const double y = std::clamp(water.y - std::cos(heading) * back, 0.0, terrain.height_metres());
      const glm::dvec3 eye(x, y, ground_height(terrain, x, y) + 5.5);
      double score = view_score(snapshot, eye, heading, reach) * (0.3 + 0.7 * free_sight(trees, eye, heading));
      if (snapshot.tree_cover) {
        const int cx = std::clamp(int(x / terrain.cell_size), 0, terrain.height.width() - 1);
        const int cy = std::clamp(terrain.height.height() - 1 - int(y / terrain.cell_size), 0, terrain.height.height() - 1);
        score *= 1 - 0.5 * cover_fraction((*snapshot.tree_cover)(cx, cy));
      }
      // Side light from the late-morning south-east models forms best; looking into the sun or away from it flattens them.
      score *= 1 + 0.12 * std::abs(std::sin(heading - glm::radians(135.0)));
      if (score <= best) continue;
      best = score;
      camera.position = eye;
      camera.heading = float(glm::degrees(heading));
    }
  }
  camera.pitch = -5;
  return camera;
}

Camera overview(const MapsSnapshot& snapshot) {
  const Terrain& terrain = snapshot.terrain();
  const double side = std::max(terrain.width_metres(), terrain.height_metres());
  // On a large terrain every few cells tell its heights well enough, and without a halt.
  const int step = std::max(1, std::max(terrain.height.width(), terrain.height.height()) / 1024);
  float low = terrain.height(0, 0);
  float high = low;
  for (int y = 0; y < terrain.height.height(); y += step) {
    for (int x = 0; x < terrain.height.width(); x += step) {
      low = std::min(low, terrain.height(x, y));
      high = std::max(high, terrain.height(x, y));
    }
  }
  Camera camera;
  camera.heading = 0;
  camera.pitch = -38;
  camera.vertical_field = 45;
  camera.position = {0.5 * terrain.width_metres(), 0.5 * terrain.height_metres() - 0.86 * side, 0.5 * (low + high) + 0.72 * side};
  return camera;
}

}  // namespace biotope

#include "ui/plant_pick.hpp"

#include <algorithm>
#include <cmath>
#include <set>
#include <utility>

#include "render/plant_placement.hpp"

namespace biotope {
namespace {

constexpr double farthest = 400;       // m at which one tells a plant
constexpr double trunk_radius = 0.35;  // m, made easy to hit

struct Shape {
  double height = 1;
  double crown_radius = 1;
  double bare = 0;  ///< m of trunk under the crown
};

int species_of(const MapsSnapshot& maps, const PlantInstance& plant) { return maps.web->levels[0][std::size_t(plant.plant)]; }

Shape shape_of(const MapsSnapshot& maps, const PlantInstance& plant) {
  const PlantShape& shape = maps.web->species[std::size_t(species_of(maps, plant))].plant().shape;
  const auto scale = double(plant.scale);
  return {double(shape.height) * scale, 0.5 * double(shape.crown_diameter) * scale,
          double(shape.trunk_fraction) * double(shape.height) * scale};
}

glm::dvec3 foot_of(const PlantInstance& plant) { return {double(plant.x), double(plant.y), double(plant.z)}; }

/// Metres along a ray of length 1 to an upright ellipsoid; nothing when it passes.
std::optional<double> hit_ellipsoid(const glm::dvec3& from, const glm::dvec3& ray, const glm::dvec3& centre, double radius,
                                    double half_height) {
  const glm::dvec3 squash(1 / radius, 1 / radius, 1 / half_height);
  const glm::dvec3 o = (from - centre) * squash;
  const glm::dvec3 d = ray * squash;
  const double a = glm::dot(d, d);
  const double b = glm::dot(o, d);
  const double root = b * b - a * (glm::dot(o, o) - 1);
  if (root < 0) return std::nullopt;
  const double near = (-b - std::sqrt(root)) / a;
  if (near > 0) return near;
  return std::nullopt;
}

std::optional<double> hit_plant(const glm::dvec3& from, const glm::dvec3& ray, const glm::dvec3& foot, const Shape& shape) {
  const double half = 0.5 * (shape.height - shape.bare);
  const auto crown =
      hit_ellipsoid(from, ray, foot + glm::dvec3(0, 0, shape.bare + half), shape.crown_radius, std::max(half, 0.05));
  if (shape.bare < 1) return crown;
  const auto trunk = hit_ellipsoid(from, ray, foot + glm::dvec3(0, 0, 0.5 * shape.bare), trunk_radius, 0.6 * shape.bare);
  if (!crown || (trunk && *trunk < *crown)) return trunk;
  return crown;
}

/// Whether a place is among a plant's leaves.
bool in_crown(const glm::dvec3& place, const glm::dvec3& foot, const Shape& shape) {
  const double half = std::max(0.5 * (shape.height - shape.bare), 0.05);
  const glm::dvec3 from_centre = place - foot - glm::dvec3(0, 0, shape.bare + half);
  const glm::dvec3 scaled = from_centre / glm::dvec3(shape.crown_radius, shape.crown_radius, half);
  return glm::dot(scaled, scaled) < 1;
}

bool shown(const std::vector<bool>& visible, int species) {
  const auto index = std::size_t(species);
  return index >= visible.size() || visible[index];
}

/// Blocks (column, row) within a crown's reach of a line on the ground.
std::set<std::pair<int, int>> blocks_along(const glm::dvec3& from, const glm::dvec3& ray, double reach) {
  constexpr double crown_reach = 8;
  std::set<std::pair<int, int>> blocks;
  const auto side = double(woody_block_side);
  for (double t = 0; t <= reach; t += 12) {
    const glm::dvec3 at = from + ray * t;
    for (const double east : {-crown_reach, crown_reach}) {
      for (const double north : {-crown_reach, crown_reach}) {
        blocks.insert({int(std::floor((at.x + east) / side)), int(std::floor((at.y + north) / side))});
      }
    }
  }
  return blocks;
}

bool has_plants(const MapsSnapshot& maps) { return maps.web && !maps.cover.empty(); }

}  // namespace

PlantsAround::PlantsAround(const PlantPlacement& placement, const glm::dvec3& place, double reach,
                           const std::vector<bool>& visible_species) {
  const MapsSnapshot* maps = placement.snapshot();
  if (maps == nullptr || !has_plants(*maps)) return;
  const auto side = double(woody_block_side);
  const auto block_of = [&](double metres) { return int(std::floor(metres / side)); };
  for (int row = block_of(place.y - reach); row <= block_of(place.y + reach); ++row) {
    for (int column = block_of(place.x - reach); column <= block_of(place.x + reach); ++column) {
      for (const Stratum stratum : {Stratum::tree, Stratum::shrub}) {
        for (const PlantInstance& plant : placement.block(stratum, column, row)) {
          const glm::dvec3 foot = foot_of(plant);
          if (std::hypot(foot.x - place.x, foot.y - place.y) > reach || !shown(visible_species, species_of(*maps, plant)))
            continue;
          const Shape shape = shape_of(*maps, plant);
          plants_.push_back({foot, shape.height, shape.crown_radius, shape.bare});
        }
      }
    }
  }
}

bool PlantsAround::free(const glm::dvec3& from, const glm::dvec3& to) const {
  const double reach = glm::length(to - from);
  if (reach <= 0) return true;
  const glm::dvec3 ray = (to - from) / reach;
  return std::none_of(plants_.begin(), plants_.end(), [&](const Obstacle& plant) {
    const Shape shape{plant.height, plant.crown_radius, plant.bare};
    const auto away = hit_plant(from, ray, plant.foot, shape);
    return in_crown(from, plant.foot, shape) || (away && *away < reach);
  });
}

std::optional<PickedPlant> pick_plant(const PlantPlacement& placement, const glm::dvec3& origin, const glm::vec3& direction,
                                      double reach, const std::vector<bool>& visible_species) {
  const MapsSnapshot* maps = placement.snapshot();
  if (maps == nullptr || !has_plants(*maps)) return std::nullopt;
  const glm::dvec3 ray = glm::normalize(glm::dvec3(direction));
  std::optional<PickedPlant> picked;
  double nearest = std::min(reach, farthest);
  for (const auto& [column, row] : blocks_along(origin, ray, nearest)) {
    for (const Stratum stratum : {Stratum::tree, Stratum::shrub}) {
      for (const PlantInstance& plant : placement.block(stratum, column, row)) {
        const int species = species_of(*maps, plant);
        if (!shown(visible_species, species)) continue;
        const auto away = hit_plant(origin, ray, foot_of(plant), shape_of(*maps, plant));
        if (!away || *away >= nearest) continue;
        nearest = *away;
        picked = PickedPlant{species, foot_of(plant), *away};
      }
    }
  }
  return picked;
}

std::optional<PickedPlant> herb_at(const PlantPlacement& placement, const glm::dvec3& place,
                                   const std::vector<bool>& visible_species) {
  const MapsSnapshot* maps = placement.snapshot();
  if (maps == nullptr || !has_plants(*maps)) return std::nullopt;
  const auto side = double(herb_block_side);
  std::optional<PickedPlant> picked;
  double nearest = 0.5;
  for (const PlantInstance& plant :
       placement.block(Stratum::herb, int(std::floor(place.x / side)), int(std::floor(place.y / side)))) {
    const double away = std::hypot(double(plant.x) - place.x, double(plant.y) - place.y);
    const int species = species_of(*maps, plant);
    if (away >= nearest || !shown(visible_species, species)) continue;
    nearest = away;
    picked = PickedPlant{species, foot_of(plant), 0};
  }
  return picked;
}

}  // namespace biotope

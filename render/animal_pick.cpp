#include "render/animal_pick.hpp"

#include <algorithm>
#include <cmath>

#include "render/landscape_renderer.hpp"

namespace biotope {

std::optional<AnimalAt> pick_animal(std::span<const AnimalAt> drawn, const glm::dvec3& origin, const glm::vec3& direction,
                                    double reach, double least_angle) {
  if (glm::length(direction) <= 0) return std::nullopt;
  const glm::dvec3 along = glm::normalize(glm::dvec3(direction));
  std::optional<AnimalAt> best;
  double nearest = reach;
  for (const AnimalAt& animal : drawn) {
    const glm::dvec3 middle = animal.place + glm::dvec3(0, 0, 0.62 * double(animal.height)) - origin;
    const double ahead = glm::dot(middle, along);
    if (ahead <= 0) continue;
    const double aside = glm::length(middle - along * ahead);
    const double radius = std::max(0.42 * double(animal.length), least_angle * ahead);
    if (aside > radius) continue;
    // Of several in one line of sight the nearest, but one that is hit in the middle before one that is only grazed.
    const double distance = ahead + 0.5 * aside;
    if (distance >= nearest) continue;
    nearest = distance;
    best = animal;
  }
  return best;
}

std::optional<AnimalAt> animal_near(std::span<const AnimalAt> drawn, const glm::dvec2& place, double radius) {
  std::optional<AnimalAt> best;
  double nearest = radius;
  for (const AnimalAt& animal : drawn) {
    const double distance = glm::length(glm::dvec2(animal.place) - place);
    if (distance > nearest) continue;
    nearest = distance;
    best = animal;
  }
  return best;
}

std::optional<HerdPlace> herd_place(const MapsSnapshot& maps, int plan_number, double hour) {
  if (!maps.plans || !maps.graph || !maps.web || plan_number < 0 || std::size_t(plan_number) >= maps.plans->size())
    return std::nullopt;
  const DailyPlan& plan = (*maps.plans)[std::size_t(plan_number)];
  if (plan.level < 0 || std::size_t(plan.level) >= maps.graph->levels.size()) return std::nullopt;
  const Terrain& terrain = maps.terrain();
  const HerdState state = herd_state(plan, maps.graph->levels[std::size_t(plan.level)], hour, terrain.cell_size);
  HerdPlace place;
  place.centre.x = (double(state.at.x) + 0.5) * terrain.cell_size;
  place.centre.y = (terrain.height.height() - 0.5 - double(state.at.y)) * terrain.cell_size;
  place.centre.z = double(ground_height(terrain, place.centre.x, place.centre.y));
  place.heading = state.heading;
  place.speed = state.speed;
  place.activity = state.activity;
  const float length = maps.web->species[std::size_t(plan.species)].animal().shape.body_length;
  place.radius = length * (1 + 1.4F * std::sqrt(float(std::max(1, plan.size))));
  return place;
}

}  // namespace biotope

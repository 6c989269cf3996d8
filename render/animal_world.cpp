#include "render/animal_world.hpp"

#include <algorithm>

#include "render/landscape_renderer.hpp"

namespace biotope {

std::shared_ptr<const HerdWorld> herd_world(const MapsSnapshot& maps, std::shared_ptr<const HerdDetails> details) {
  if (!maps.plans || !maps.graph || !maps.web) return nullptr;
  auto world = std::make_shared<HerdWorld>();
  world->web = maps.web;
  world->ground = maps.ground();
  world->levels = maps.animals;
  world->graph = maps.graph;
  world->plans = maps.plans;
  world->seed = maps.document.seed;
  world->details = std::move(details);
  return world;
}

float surface_height(const Grid<float>& surface, const Terrain& terrain, glm::dvec2 place) {
  const double scale = double(surface.width()) / terrain.height.width();
  const double x = place.x / terrain.cell_size * scale - 0.5;
  const double y = (double(terrain.height.height()) - place.y / terrain.cell_size) * scale - 0.5;
  return sample_bilinear(surface, x, y);
}

float standing_height(const Grid<float>& surface, const Terrain& terrain, glm::dvec2 place) {
  return std::min(surface_height(surface, terrain, place), ground_height(terrain, place.x, place.y));
}

}  // namespace biotope

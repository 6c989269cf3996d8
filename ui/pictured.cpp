#include "ui/pictured.hpp"

#include <algorithm>

namespace biotope {
namespace {

bool knows_plants(const MapsSnapshot& maps) {
  return maps.web && maps.hydrology && maps.environment && !maps.cover.empty() &&
         std::all_of(maps.cover.begin(), maps.cover.end(), [](const auto& cover) { return cover != nullptr; });
}

/// Whether the same growth was lost to fire and the like.
bool same_losses(const MapsSnapshot& a, const MapsSnapshot& b) {
  for (std::size_t i = 0; i < a.web->species.size(); ++i) {
    if (a.loss(int(i)) != b.loss(int(i))) return false;
  }
  return true;
}

/// Whether two snapshots of which not all is known yet look the same.
bool look_alike(const MapsSnapshot& a, const MapsSnapshot& b) {
  return a.surface() == b.surface() && a.web == b.web && a.hydrology == b.hydrology && a.environment == b.environment &&
         a.derivatives == b.derivatives && a.cover == b.cover && a.places == b.places && same_losses(a, b) &&
         a.document.climate == b.document.climate && a.document.seed == b.document.seed;
}

}  // namespace

std::shared_ptr<const MapsSnapshot> pictured_maps(const std::shared_ptr<const MapsSnapshot>& newest,
                                                  const std::shared_ptr<const MapsSnapshot>& complete,
                                                  const std::shared_ptr<const MapsSnapshot>& before) {
  if (!newest || newest->complete) return newest ? newest : before;
  const bool followed = before && before->document.terrain == newest->document.terrain;
  // A new landscape: its ground at once, and its plants.
  if (!followed) return newest;
  const bool lives = complete && complete->document.terrain == newest->document.terrain && complete->web == newest->web;
  if (!knows_plants(*newest)) return before;
  if (!lives) return knows_plants(*before) && before->web == newest->web ? before : newest;
  if (!before->complete && look_alike(*before, *newest)) return before;
  auto maps = std::make_shared<MapsSnapshot>(*newest);
  maps->animals = complete->animals;
  maps->movement = complete->movement;
  maps->graph = complete->graph;
  maps->trails = complete->trails;
  maps->plans = complete->plans;
  return maps;
}

}  // namespace biotope

#include "core/pipeline/stale_stages.hpp"

#include <algorithm>
#include <set>

namespace biotope {
namespace {

/// Everything that reads the levels from `level` up.
void mark_from(StaleStages& stale, int level) {
  stale.levels_from = std::min(stale.levels_from, level);
  stale.trails = stale.days = true;
}

void mark_ground(StaleStages& stale) {
  stale.water = stale.environment = true;
  mark_from(stale, 0);
}

/// What a complete snapshot owes: what is global was that of before.
void mark_inexact(StaleStages& stale, const MapsSnapshot& answered) {
  if (!answered.shaded) stale.environment = true;
  if (!answered.exact()) mark_from(stale, 0);
}

void mark_layer(StaleStages& stale, const LayerId& layer, const FoodWeb& web) {
  switch (layer.kind) {
    case LayerKind::ground:
      return mark_ground(stale);
    case LayerKind::resource:
    case LayerKind::geology:
    case LayerKind::plant_density:
      return mark_from(stale, 0);
    case LayerKind::loss:
    case LayerKind::passage:
      return mark_from(stale, 1);
    case LayerKind::animal_density:
      break;
  }
  for (std::size_t level = 1; level < web.levels.size(); ++level) {
    for (const int species : web.levels[level]) {
      if (web.species[std::size_t(species)].name == layer.name) mark_from(stale, int(level));
    }
  }
}

void mark_paint(StaleStages& stale, const MapsSnapshot& answered, const Document& document) {
  std::set<LayerId> layers;
  for (const Document* one : {&answered.document, &document}) {
    for (const auto& [layer, paint] : one->layers) layers.insert(layer);
  }
  for (const LayerId& layer : layers) {
    if (active_paint(answered.document, layer) != active_paint(document, layer)) mark_layer(stale, layer, *answered.web);
  }
}

/// A change of desired shares is one of the levels above it; any other change of species is one of everything that lives.
void mark_species(StaleStages& stale, const MapsSnapshot& answered, const Document& document) {
  if (answered.document.species == document.species) return;
  const auto& before = *answered.document.species;
  const auto& after = *document.species;
  if (before.size() != after.size()) return mark_from(stale, 0);
  for (std::size_t i = 0; i < before.size(); ++i) {
    if (before[i] == after[i]) continue;
    Species shared = before[i];
    shared.proportions = after[i].proportions;
    if (shared != after[i] || shared.is_plant()) return mark_from(stale, 0);
    mark_layer(stale, {LayerKind::animal_density, shared.name}, *answered.web);
  }
}

void mark_places(StaleStages& stale, const Placements& before, const Placements& after) {
  if (before.water != after.water) mark_ground(stale);
  const Places& one = before.places;
  const Places& other = after.places;
  if (one.fords != other.fords || one.exits != other.exits || one.waypoints != other.waypoints) mark_from(stale, 1);
  if (one != other) stale.trails = stale.days = true;
  if (before.plans != after.plans) stale.days = true;
}

bool same_inflows(const Document& a, const Document& b) {
  return std::equal(a.inflows.begin(), a.inflows.end(), b.inflows.begin(), b.inflows.end(),
                    [](const Inflow& one, const Inflow& other) {
                      return one.x == other.x && one.y == other.y && one.catchment_area == other.catchment_area;
                    });
}

StaleStages everything() {
  StaleStages stale;
  mark_ground(stale);
  return stale;
}

}  // namespace

StaleStages stale_stages(const MapsSnapshot* answered, const Document& document) {
  if (answered == nullptr || !answered->complete || !answered->web || !answered->document.species || !document.species) {
    return everything();
  }
  const Document& before = answered->document;
  if (before.terrain != document.terrain || !(before.climate == document.climate)) return everything();
  if (before.given_environment.monthly != document.given_environment.monthly ||
      before.given_environment.geology != document.given_environment.geology) {
    return everything();
  }
  StaleStages stale;
  mark_inexact(stale, *answered);
  if (!same_inflows(before, document)) mark_ground(stale);
  mark_paint(stale, *answered, document);
  mark_species(stale, *answered, document);
  mark_places(stale, before.placements, document.placements);
  // Chance plays no part in what grows.
  if (before.seed != document.seed) mark_from(stale, 1);
  for (int level = 0; level < int(answered->web->levels.size()); ++level) {
    const auto uses = [level](const Document& one) {
      const auto found = one.use_proportions.find(level);
      return found == one.use_proportions.end() || found->second;
    };
    if (uses(before) != uses(document)) mark_from(stale, level);
  }
  return stale;
}

StaleStages still_stale(StaleStages stale, const MapsSnapshot& reached) {
  if (reached.complete) {
    stale = {};
    mark_inexact(stale, reached);
    return stale;
  }
  if (reached.hydrology) stale.water = false;
  if (reached.environment && reached.shaded) stale.environment = false;
  if (reached.cover.empty()) return stale;
  const int levels = reached.web ? int(reached.web->levels.size()) : 0;
  const int done = 1 + int(reached.animals.size());
  if (stale.levels_from < done) stale.levels_from = done < levels ? done : StaleStages::no_level;
  if (reached.trails) stale.trails = false;
  if (reached.plans) stale.days = false;
  return stale;
}

}  // namespace biotope

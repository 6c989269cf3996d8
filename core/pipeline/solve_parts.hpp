#pragma once

#include <memory>
#include <vector>

#include "core/ecosystem/places.hpp"
#include "core/pipeline/maps_snapshot.hpp"

namespace biotope {

// Small steps of a solve.

/// The species without their desired shares.
[[nodiscard]] inline std::vector<Species> without_shares(std::vector<Species> species) {
  for (Species& one : species) one.proportions.clear();
  return species;
}

/// Keeps a value's pointer while it is equal; null for a blank one.
inline void keep_equal(std::shared_ptr<const Places>& slot, const Places& places) {
  if (places == Places{}) {
    slot = nullptr;
  } else if (!slot || !(*slot == places)) {
    slot = std::make_shared<const Places>(places);
  }
}

/// Mean height of a terrain, m.
[[nodiscard]] inline double mean_height(const Terrain& terrain) {
  double sum = 0;
  for (const float height : terrain.height.cells()) sum += height;
  return terrain.height.empty() ? 0 : sum / double(terrain.height.size());
}

/// Levels of the graph with the spatial edges that movement found.
[[nodiscard]] inline ResourceAccessGraph assembled_graph(const MapsSnapshot& maps) {
  ResourceAccessGraph graph;
  graph.levels.push_back({0, {}, {}, {}});
  for (std::size_t i = 0; i < maps.animals.size(); ++i) {
    graph.levels.push_back(*maps.animals[i]->graph);
    graph.levels.back().edges = maps.movement[i].edges;
  }
  return graph;
}

/// Whether a document has what a solve needs.
[[nodiscard]] inline Status check_inputs(const Document& document) {
  if (!document.terrain || document.terrain->height.width() < 2 || document.terrain->height.height() < 2) {
    return fail("There is no terrain to compute on: open a DEM, a scene or a sample (at least 2 x 2 cells).");
  }
  if (!document.species || document.species->empty())
    return fail("There are no species: open a species file or take the default one.");
  return {};
}

}  // namespace biotope

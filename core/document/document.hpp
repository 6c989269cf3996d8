#pragma once

#include <array>
#include <compare>
#include <cstdint>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "core/base/paint.hpp"
#include "core/climate/climate.hpp"
#include "core/climate/environment.hpp"
#include "core/document/placements.hpp"
#include "core/document/selection.hpp"
#include "core/species/species.hpp"
#include "core/terrain/hydrology.hpp"
#include "core/terrain/terrain.hpp"

namespace biotope {

/// Which map a layer of paint lies over.
enum class LayerKind : std::uint8_t {
  resource,        ///< name: "illumination", "temperature", "moisture" (index 1..9 of the yearly mean) or "texture" (index 1..9)
  plant_density,   ///< name: species; unit: covered fraction 0..1
  animal_density,  ///< name: species; unit: individuals / km2
  geology,         ///< name: "class"; value: a Geology, taken where coverage is at least 0.5
  loss,            ///< name: species; share of its yearly growth lost to an external event (fire, disease), 0..1; computed: 0
  passage,         ///< name: "all"; at least 0.5: an obstacle for every animal, at most -0.5: open to every animal; computed: 0
  ground           ///< name: "height"; metres above sea level
};
struct LayerId {
  LayerKind kind = LayerKind::plant_density;
  std::string name;
  auto operator<=>(const LayerId&) const = default;
};

/// How a layer takes part.
struct LayerState {
  /// Its paint is kept but does not count.
  bool hidden = false;
  /// No brush changes it.
  bool locked = false;
  bool operator==(const LayerState&) const = default;
};

/// Maps that replace computed ones (the command line's --environment); empty members are computed.
struct GivenEnvironment {
  std::array<std::vector<std::shared_ptr<const Grid<float>>>, monthly_resources> monthly;  ///< 12 maps or none
  std::shared_ptr<const Grid<Geology>> geology;
};

/// The one thing that is saved: what the person made, and nothing that is computed. A value: copying copies pointers to
/// immutable parts, so a copy is a snapshot of the inputs.
struct Document {
  std::shared_ptr<const Terrain> terrain;
  std::vector<Inflow> inflows;
  Climate climate;
  std::shared_ptr<const std::vector<Species>> species;
  /// Whether each food-chain level aims at its species' desired shares; missing entries are true.
  std::map<int, bool> use_proportions;
  std::uint64_t seed = 1;
  std::map<LayerId, std::shared_ptr<const PaintLayer>> layers;
  /// States that are not the default one.
  std::map<LayerId, LayerState> layer_states;
  /// Where edits act; null: everywhere.
  std::shared_ptr<const SelectionMask> selection;
  /// Where no edit changes paint, whatever is selected; null: nowhere.
  std::shared_ptr<const SelectionMask> locked_area;
  Placements placements;
  GivenEnvironment given_environment;
  /// What a person calls it.
  std::string title;
};

/// Paint of a layer as it counts: null when nothing is painted or the layer is hidden.
[[nodiscard]] inline std::shared_ptr<const PaintLayer> active_paint(const Document& document, const LayerId& id) {
  const auto state = document.layer_states.find(id);
  if (state != document.layer_states.end() && state->second.hidden) return nullptr;
  const auto found = document.layers.find(id);
  return found == document.layers.end() ? nullptr : found->second;
}
[[nodiscard]] inline bool is_locked(const Document& document, const LayerId& id) {
  const auto state = document.layer_states.find(id);
  return state != document.layer_states.end() && state->second.locked;
}

}  // namespace biotope

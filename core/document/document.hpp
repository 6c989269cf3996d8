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
#include "core/species/species.hpp"
#include "core/terrain/hydrology.hpp"
#include "core/terrain/terrain.hpp"

namespace biotope {

/// Which map a layer of paint lies over.
enum class LayerKind : std::uint8_t {
  resource,       ///< name: "illumination", "temperature" or "moisture"; unit: index 1..9 of the yearly mean
  plant_density,  ///< name: species; unit: covered fraction 0..1
  animal_density  ///< name: species; unit: individuals / km2
};
struct LayerId {
  LayerKind kind = LayerKind::plant_density;
  std::string name;
  auto operator<=>(const LayerId&) const = default;
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
  GivenEnvironment given_environment;
  /// What a person calls it.
  std::string title;
};

}  // namespace biotope

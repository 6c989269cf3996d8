#pragma once

#include <vector>

#include "render/frame.hpp"
#include "render/plant_blocks.hpp"
#include "render/plant_kinds.hpp"

namespace biotope {

/// How many plants of each level of detail may be drawn, and how far one sees them.
struct PlantBudget {
  std::size_t near = 220;
  std::size_t mid = 900;
  std::size_t far = 25000;
  std::size_t tufts = 4500;
  float tree_reach = 1900;  ///< m
  float shrub_reach = 420;  ///< m
  float herb_reach = 60;    ///< m
  [[nodiscard]] static PlantBudget of(float quality);
  [[nodiscard]] float reach(Stratum stratum) const {
    return stratum == Stratum::tree ? tree_reach : stratum == Stratum::shrub ? shrub_reach : herb_reach;
  }
};

/// Instances to draw in a frame: for every kind its near meshes, then its mid ones; all that are far together.
struct PlantSelection {
  std::vector<std::vector<PlantInstance>> near;
  std::vector<std::vector<PlantInstance>> mid;
  std::vector<PlantInstance> far;
  std::size_t count = 0;
  /// Distances between which far trees thin out, m.
  float far_from = 0;
  float far_to = 0;
};

/// Chooses level of detail by size on the screen and by the budget: a function of blocks and view alone.
[[nodiscard]] PlantSelection select_plants(const PlantBlocks& blocks, const std::vector<PlantKind>& kinds,
                                           const SpeciesVisibility& visible, const PlantBudget& budget,
                                           const FrameUniforms& frame, const Frustum& frustum);

}  // namespace biotope

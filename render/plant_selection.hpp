#pragma once

#include <array>
#include <vector>

#include "render/frame.hpp"
#include "render/plant_blocks.hpp"
#include "render/plant_kinds.hpp"
#include "render/woody_blocks.hpp"

namespace biotope {

/// How many plants of each level of detail may be drawn, and how far one sees them.
struct PlantBudget {
  std::size_t close = 10;
  std::size_t near = 90;
  std::size_t mid = 700;
  std::size_t far = 25000;
  std::size_t tufts = 9000;
  std::size_t undergrowth = 600;
  float tree_reach = 1900;  ///< m
  float shrub_reach = 600;  ///< m
  float herb_reach = 80;    ///< m
  float blade_reach = 8;    ///< m to which every blade of a tuft is drawn
  /// Plants kept on the graphics side.
  std::uint32_t resident = 400000;
  /// Height on the screen, in pixels of a picture 540 high, from which a plant is a close, a near or at least a mid mesh, and
  /// from which undergrowth is drawn.
  float close_pixels = 420;
  float near_pixels = 150;
  float mid_pixels = 62;
  float undergrowth_pixels = 8;
  /// From quality 0.25 on a software renderer to 4 on a strong GPU, where a million plants are a scene.
  [[nodiscard]] static PlantBudget of(float quality);
  /// Memory of blocks on the processor's side: the resident ones with their herbs, and what was left behind not long ago.
  [[nodiscard]] std::size_t block_bytes() const {
    return 3 * std::size_t(resident) * sizeof(PlantInstance) + (std::size_t(24) << 20U);
  }
  [[nodiscard]] float reach(Stratum stratum) const {
    return stratum == Stratum::tree ? tree_reach : stratum == Stratum::shrub ? shrub_reach : herb_reach;
  }
};

/// Where levels of detail give way to each other: `lod` of the plant shaders.
struct PlantLevels {
  float close_pixels = 0;
  float near_pixels = 0;
  float mid_pixels = 0;
  float far_from = 0;  ///< m from which far plants thin out
  float far_to = 0;    ///< m where none is left
};

/// What glMultiDrawArraysIndirect reads of a block.
struct FarDraw {
  std::uint32_t vertices = 4;
  std::uint32_t plants = 0;
  std::uint32_t first_vertex = 0;
  std::uint32_t first_plant = 0;
};

/// What glMultiDrawElementsIndirect reads of a run of plants.
struct MeshDraw {
  std::uint32_t indices = 0;
  std::uint32_t plants = 0;
  std::uint32_t first_index = 0;
  std::uint32_t first_vertex = 0;
  std::uint32_t first_plant = 0;
};

/// What is drawn in a frame, the nearest first. Meshes by kind and model (plant_models * kind + model); tufts by kind.
struct PlantSelection {
  std::vector<std::vector<PlantInstance>> close;
  std::vector<std::vector<PlantInstance>> near;
  std::vector<std::vector<PlantInstance>> mid;
  std::vector<std::vector<PlantInstance>> near_tufts;
  std::vector<std::vector<PlantInstance>> far_tufts;
  /// By Undergrowth, and the height on the screen from which it is drawn.
  std::vector<std::vector<PlantInstance>> undergrowth;
  float undergrowth_pixels = 0;
  /// Of trees and of shrubs.
  std::array<std::vector<FarDraw>, 2> far;
  std::array<PlantLevels, 2> levels;
  /// Metres over which tufts of blades give way to those drawn as cards, and where the last of these are.
  glm::vec2 tuft_change{0};
  float herb_reach = 0;
  std::size_t count = 0;
  glm::vec3 eye{0};
};

/// Chooses level of detail by size on the screen and by the budget: a function of blocks and view alone. Far plants are drawn
/// block by block from the arena, as many of each block as its distance leaves.
[[nodiscard]] PlantSelection select_plants(const PlantBlocks& blocks, const WoodyBlocks& woody, const PlantKinds& plants,
                                           const SpeciesVisibility& visible, const PlantBudget& budget,
                                           const FrameUniforms& frame, const Frustum& frustum);

}  // namespace biotope

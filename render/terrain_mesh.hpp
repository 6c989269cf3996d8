#pragma once

#include <glm/glm.hpp>
#include <vector>

#include "core/base/grid.hpp"
#include "render/frame.hpp"

namespace biotope {

/// A square piece of ground to draw with one patch mesh: what the vertex shader reads per instance.
struct GroundPatch {
  float west;
  float south;
  float side;         ///< m
  float morph_end;    ///< distance at which its vertices have become those of the next coarser level, m
};

/// Lowest and highest ground of squares of 2^level x patch_cells cells, for culling and distances.
class HeightBounds {
 public:
  HeightBounds() = default;
  HeightBounds(const Grid<float>& surface, double cell_size, int patch_cells);
  /// Bounds within [west, west + side] x [south, south + side]; those of the whole ground outside of it.
  [[nodiscard]] glm::vec2 of(double west, double south, double side) const;
  [[nodiscard]] glm::vec2 whole() const { return whole_; }

 private:
  std::vector<Grid<glm::vec2>> levels_;
  double unit_ = 1;    ///< side of a square of level 0, m
  double height_ = 0;  ///< of the terrain, north to south, m
  glm::vec2 whole_{0, 1};
};

/// How fine the ground is drawn.
struct PatchSettings {
  int patch_cells = 16;       ///< quads a side of the patch mesh
  float range_factor = 4;     ///< a level reaches this many of its sides
  double width = 0;           ///< terrain, m
  double height = 0;
  double finest_side = 64;    ///< side of the smallest patch, m
};

/// Chooses patches by distance from the eye (continuous distance-dependent level of detail, Strugar 2009). The ground goes on beyond its
/// border by its own size on every side, where the shader mirrors it.
[[nodiscard]] std::vector<GroundPatch> select_patches(const PatchSettings& settings, const HeightBounds& bounds, const glm::dvec3& eye,
                                                      const Frustum& frustum);

}  // namespace biotope

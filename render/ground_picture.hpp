#pragma once

#include <glm/glm.hpp>
#include <memory>
#include <stop_token>

#include "render/ground_maps.hpp"
#include "render/line_field.hpp"
#include "render/terrain_mesh.hpp"
#include "render/texel_pyramid.hpp"
#include "render/trail_lines.hpp"

namespace biotope {

/// What a picture of the ground is made from.
struct GroundRequest {
  std::shared_ptr<const MapsSnapshot> snapshot;
  int month = 5;
  SpeciesVisibility visible;
  glm::vec3 light{0, 0, 1};  ///< toward the light
};
/// True when both ask for the same picture.
[[nodiscard]] bool same_request(const GroundRequest& a, const GroundRequest& b);
/// True when shadows of one light are good for the other.
[[nodiscard]] bool same_light(const glm::vec3& a, const glm::vec3& b);
/// True when both terrains cover the same ground with the same cells, so that a picture of one may stand for the other.
[[nodiscard]] bool same_extent(const Terrain& a, const Terrain& b);

/// Cells a side of a finest square of ground, by which heights and water are looked up.
inline constexpr int ground_patch_cells = 16;

/// The ground's form.
struct GroundShape {
  Grid<float> surface;  ///< as it is drawn, m
  HeightBounds bounds;
  TexelPyramid<float> heights;
  TexelPyramid<Rgba> normals;
  Grid<float> shading;  ///< the surface, thinned out for shadows
};

/// Water and trails.
struct GroundLines {
  /// Where water is drawn.
  std::shared_ptr<const ShoreMap> shore;
  /// Squares of ground_patch_cells cells with water in them or near, counted from the south-west.
  Grid<std::uint8_t> near_water;
  TexelPyramid<Rg> lines;  ///< shore and wear of a LineField
  /// Where trails are drawn; null without trails.
  std::shared_ptr<const TrailLines> trails;
  TexelPyramid<Rgba> currents;  ///< how the water moves: see water_flow()
};

struct GroundTints {
  TexelPyramid<Rgba> ground;
  TexelPyramid<Rgba> canopy;
};

struct GroundLight {
  glm::vec3 light{0};
  TexelPyramid<std::uint8_t> sunlit;
};

/// All that is drawn of the ground, ready for upload. Immutable: two pictures share what they have in common, down to tiles of
/// texels.
struct GroundPicture {
  GroundRequest of;
  /// A quick picture of at most coarse_ground_side texels a side, without water and trails, to be shown until the real one is
  /// there.
  bool coarse = false;
  std::shared_ptr<const GroundShape> shape;
  std::shared_ptr<const GroundLines> lines;
  std::shared_ptr<const GroundTints> tints;
  std::shared_ptr<const GroundLight> light;

  [[nodiscard]] const Terrain& terrain() const { return of.snapshot->terrain(); }
};

inline constexpr int coarse_ground_side = 512;

/// Makes a picture. What is alike in `before` (may be null) is taken from it; the picture looks the same with any `before`. Null
/// when `stop` asked for it on the way. Parallel.
[[nodiscard]] std::shared_ptr<const GroundPicture> make_ground(const GroundRequest& request, const GroundPicture* before,
                                                               const std::stop_token& stop = {});
[[nodiscard]] std::shared_ptr<const GroundPicture> make_coarse_ground(const GroundRequest& request);

}  // namespace biotope

#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <span>
#include <vector>

#include "core/base/grid.hpp"
#include "core/movement/trails.hpp"
#include "core/terrain/terrain.hpp"

namespace biotope {

/// A straight piece of a trail as it is drawn. Metres from the south-west corner.
struct TrailPiece {
  glm::vec2 from{0};
  glm::vec2 to{0};
  float half_width = 0;  ///< m of bare earth on either side of the middle
  float use = 0;         ///< 0..1; 1 on the most used trail

  bool operator==(const TrailPiece& other) const = default;
};

/// Half the width of bare earth, m, of a trail that is used so much (0..1): 0.5 m wide where little used, up to 2 m.
[[nodiscard]] constexpr float trail_half_width(float use) { return 0.25F + 0.75F * use; }
/// How much a trail is used, 0..1, from its weight and that of the heaviest one. In steps, so that a change of weights far away
/// changes no trail here by a hair.
[[nodiscard]] float trail_use(float weight, float heaviest);
/// The greatest weight of a network.
[[nodiscard]] float heaviest_weight(const TrailNetwork& trails);
/// How worn the ground is, 0..1, `inside` metres within the edge of a trail, where its edge is `soft` metres wide.
[[nodiscard]] float worn_share(float inside, float use, float soft);

/// Where trails are drawn, to be asked by place: what LineField shows in fine cells, exactly.
class TrailLines {
 public:
  TrailLines() = default;
  /// `soft`: width of the trails' edges, m.
  TrailLines(const Terrain& terrain, const TrailNetwork& trails, float soft);

  /// Farthest from an edge that is told, m.
  static constexpr float reach = 5;
  /// Metres within the edge of the nearest trail (x east, y north of the south-west corner); negative outside, -reach where none
  /// is near.
  [[nodiscard]] float inside(float x, float y) const;
  /// How worn the ground is there, 0..1.
  [[nodiscard]] float worn(float x, float y) const;
  /// True when no trail is within reach of the square.
  [[nodiscard]] bool none_within(float west, float south, float side) const;
  /// True when both tell the same in all of the square; may say no where they do.
  [[nodiscard]] bool same_within(const TrailLines& other, float west, float south, float side) const;
  bool operator==(const TrailLines& other) const = default;

 private:
  [[nodiscard]] std::span<const TrailPiece> at(int column, int row) const;

  int columns_ = 0;
  int rows_ = 0;
  float soft_ = 0.5F;
  /// By square of ground, row by row from the south-west: where its pieces begin in `pieces_`; one more at the end.
  std::vector<std::uint32_t> first_;
  std::vector<TrailPiece> pieces_;
};

}  // namespace biotope

#pragma once

#include <functional>
#include <vector>

#include "core/base/grid.hpp"
#include "core/terrain/tile_set.hpp"

namespace biotope {

/// What leads a diffusion: a conductance of each cell (see diffuse), or one of all.
struct Conductance {
  const Grid<float>* cells = nullptr;
  float uniform = 0;
};

/// Some steps of `diffuse` over values that change here and there. What every pass along rows or columns made is kept, and of the
/// elimination where it stood at the borders of tiles; so a change is followed, pass by pass, from the tiles in which it lies
/// to where it is nothing any more, and no farther. Equal to `diffuse` of the same values to the bit. Keeps two grids a step.
class FollowedDiffusion {
 public:
  explicit FollowedDiffusion(int steps) : steps_(steps) {}

  /// Everything anew. Asks go_on(step) before each step; where it says no, forgets all and returns false.
  bool restart(const Grid<float>& values, const Conductance& conductance, const std::function<bool(int)>& go_on);
  [[nodiscard]] bool started() const { return !passes_.empty(); }
  void forget() { passes_.clear(); }
  /// Values and conductance of the same size, changed in some tiles (of tile_side). Returns tiles in which the result may be
  /// another.
  TileSet follow(const Grid<float>& values, const Conductance& conductance, const TileSet& changed);
  [[nodiscard]] const Grid<float>& result() const { return passes_.back().out; }

 private:
  /// What a pass made, and its forward elimination at the last cell before each tile: [tile][line].
  struct Pass {
    bool along_rows = true;
    Grid<float> out;
    std::vector<float> shares;
    std::vector<float> values;
  };
  struct Room;
  class Line;
  static TileSet run(Pass& pass, const Grid<float>& in, const Conductance& conductance, const TileSet& asked);

  int steps_;
  std::vector<Pass> passes_;
};

}  // namespace biotope

#pragma once

#include <memory>
#include <vector>

#include "core/pipeline/maps_snapshot.hpp"

namespace biotope {

/// What animals and losses leave of each plant's yearly growth, by cell, without a map for it: the shares of the pieces of land
/// that the animal levels ate from, and the paint of losses.
class Grazing {
 public:
  Grazing() = default;
  explicit Grazing(const MapsSnapshot& snapshot);

  /// Share 0..1 of the growth of plant `plant` (place in level 0 of the web) that is left in a cell; what animals
  /// leave of it is told in steps of 1/64.
  [[nodiscard]] float left(int plant, int x, int y) const;
  /// True when both leave the same everywhere; may say no where they do.
  [[nodiscard]] bool same_as(const Grazing& other) const;

 private:
  struct Eater {
    std::shared_ptr<const Partition> partition;
    /// By piece.
    std::vector<float> left;
  };
  struct Plant {
    std::vector<Eater> eaters;
    std::shared_ptr<const PaintLayer> loss;
  };
  std::vector<Plant> plants_;
};

}  // namespace biotope

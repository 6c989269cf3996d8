#pragma once

#include <map>
#include <memory>
#include <shared_mutex>
#include <vector>

#include "core/movement/herd_world.hpp"
#include "render/line_field.hpp"
#include "render/plant_placement.hpp"

namespace biotope {

/// What animals heed of what is drawn: where water is drawn, and the trunks of the trees that the plants' placement says, made a
/// block at a time when they are first asked for.
class AnimalSurroundings : public HerdDetails {
 public:
  /// `shore` may be null; a `placement` without a snapshot has no trunks. Blocks of `before` (may be null) whose maps are the
  /// same are taken over.
  AnimalSurroundings(std::shared_ptr<const ShoreMap> shore, double cell_size, PlantPlacement placement,
                     std::shared_ptr<const AnimalSurroundings> before = nullptr);

  /// Where its trees are from; null without trees.
  [[nodiscard]] const MapsSnapshot* trees_of() const { return placement_.snapshot(); }
  [[nodiscard]] std::optional<float> shore(Place place) const override;
  void stems(Place low, Place high, std::vector<Stem>& stems) const override;
  [[nodiscard]] bool same_within(const HerdDetails& other, Place low, Place high) const override;

 private:
  using Block = std::shared_ptr<const std::vector<Stem>>;
  [[nodiscard]] Block block(int column, int row) const;
  [[nodiscard]] std::vector<Stem> grown(int column, int row) const;
  [[nodiscard]] bool same_shore(const AnimalSurroundings& other, Place low, Place high) const;
  [[nodiscard]] bool same_plants(const AnimalSurroundings& other) const;

  std::shared_ptr<const ShoreMap> shore_;
  double shore_cell_;
  PlantPlacement placement_;
  /// Heights of trees by their number among the plants.
  std::vector<float> heights_;
  mutable std::shared_mutex lock_;
  /// By row and column.
  mutable std::map<std::pair<int, int>, Block> blocks_;
};

}  // namespace biotope

#pragma once

#include <array>
#include <memory>

#include "core/pipeline/maps_snapshot.hpp"
#include "render/line_field.hpp"
#include "render/plant_grazing.hpp"
#include "render/trail_lines.hpp"

namespace biotope {

/// Where trails are known by cells only, no plant grows where more of the ground than this is worn.
inline constexpr float trodden_wear = 0.3F;

/// All that plants are placed by.
struct PlantGround {
  std::shared_ptr<const MapsSnapshot> maps;
  /// Where water is drawn; null: in the cells of water.
  std::shared_ptr<const ShoreMap> shore;
  /// Where trails are drawn; null: in cells that they wear out.
  std::shared_ptr<const TrailLines> trails;
  /// What is left of the growth; null: all.
  std::shared_ptr<const Grazing> grazing;
};

/// The cells of the terrain that a square of ground lies on (metres from the south-west corner).
[[nodiscard]] Rect cells_under(const Terrain& terrain, double west, double south, double side);

/// Where plants may stand otherwise than they did: compares what they are placed by, cell for cell, so that an edit has only
/// those pieces of ground planted anew that it touched. Both grounds are of the same extent, seed and plants.
class PlantChanges {
 public:
  PlantChanges(PlantGround before, PlantGround now);

  /// Whether anything that plants of a stratum heed is another within a square (metres from the south-west corner).
  [[nodiscard]] bool within(Stratum stratum, double west, double south, double side) const;
  /// False when nothing at all is another.
  [[nodiscard]] bool any() const;

 private:
  [[nodiscard]] bool other_cover(Stratum stratum, const Rect& cells) const;
  [[nodiscard]] bool other_water(const Rect& cells) const;
  [[nodiscard]] bool other_shore(const Rect& cells) const;
  [[nodiscard]] bool other_trails(const Rect& cells, float west, float south, float side) const;
  [[nodiscard]] bool other_floor(const Rect& cells) const;
  [[nodiscard]] bool other_growth(Stratum stratum, const Rect& cells) const;

  PlantGround before_;
  PlantGround now_;
  /// Places in level 0 of the web whose cover is not the same map, by stratum.
  std::array<std::vector<std::size_t>, strata> covers_;
  /// Places in level 0 of the web of what is eaten, by stratum.
  std::array<std::vector<int>, strata> eaten_;
  bool heights_ = false;
  bool water_ = false;
  bool shore_ = false;
  bool trails_ = false;
  bool floor_ = false;
  bool growth_ = false;
};

}  // namespace biotope

#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <vector>

#include "core/base/grid.hpp"
#include "core/document/document.hpp"

namespace biotope {

/// What a condition of a filter looks at.
enum class FilterQuantity : std::uint8_t {
  slope,           ///< degrees
  altitude,        ///< m
  aspect,          ///< degrees clockwise from north that the ground faces; low > high wraps around north
  water_distance,  ///< m to the nearest water
  map              ///< the final value of another layer's map, in its unit
};

/// Keeps edits to cells whose quantity lies in [low, high]; outside, the weight falls to 0 over `softness` (the quantity's unit).
struct FilterCondition {
  FilterQuantity quantity = FilterQuantity::slope;
  LayerId map{};  ///< of FilterQuantity::map
  float low = 0;
  float high = 0;
  float softness = 0;
  bool inverted = false;
  bool operator==(const FilterCondition&) const = default;
};

/// Where a brush or a fill may act: the product of its conditions and of the document's selection. What the document's locked
/// area leaves is a factor of every filter.
struct BrushFilter {
  std::vector<FilterCondition> conditions{};
  bool use_selection = true;
  bool operator==(const BrushFilter&) const = default;
};

/// The maps that filters read; all of the terrain's size. Missing ones let everything pass.
struct FilterMaps {
  std::shared_ptr<const Grid<float>> slope;           ///< degrees
  std::shared_ptr<const Grid<float>> altitude;        ///< m
  std::shared_ptr<const Grid<float>> aspect;          ///< degrees clockwise from north, negative on flat ground
  std::shared_ptr<const Grid<float>> water_distance;  ///< m
  std::map<LayerId, std::shared_ptr<const Grid<float>>> values;
};

/// Weight 0..1 of one condition at a value; 0 where the value is not a number. A negative aspect (flat ground faces nowhere) lies
/// in no interval. Conditions other than aspect take `low` and `high` in either order.
[[nodiscard]] float condition_weight(const FilterCondition& condition, float value);

/// Weight 0..1 that a filter leaves to a cell; the product of its conditions, without the selection.
[[nodiscard]] float filter_weight(const BrushFilter& filter, const FilterMaps& maps, int x, int y);

/// A filter made ready for many cells: maps are looked up once. The filter, maps and masks must outlive it.
class CellFilter {
 public:
  /// `maps` may be null: then the conditions let everything pass. `selection` counts when the filter asks for it, `locked_area`
  /// always.
  CellFilter(const BrushFilter& filter, const FilterMaps* maps, const SelectionMask* selection,
             const SelectionMask* locked_area = nullptr);
  /// Weight 0..1 of a cell.
  [[nodiscard]] float operator()(int x, int y) const;
  /// True when nothing of a tile (numbered as in TiledMap) is selected.
  [[nodiscard]] bool blocks_tile(std::size_t tile) const;

 private:
  struct Part {
    const FilterCondition* condition;
    const Grid<float>* values;
  };
  std::vector<Part> parts_;
  const SelectionMask* selection_;
  const SelectionMask* locked_area_;
};

/// The map that a condition looks at; null when it is missing.
[[nodiscard]] const Grid<float>* filter_map(const FilterCondition& condition, const FilterMaps& maps);

/// What `distance_to` says where there is nothing to be near to, m.
inline constexpr float no_distance = 1e9F;

/// Distance (m) of every cell to the nearest cell where `wet` is not 0; `no_distance` where there is none. Exact (two passes of
/// lower envelopes), O(n), parallel.
[[nodiscard]] Grid<float> distance_to(const Grid<std::uint8_t>& wet, double cell_size);

}  // namespace biotope

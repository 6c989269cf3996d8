#include "core/document/brush_filter.hpp"

#include <algorithm>
#include <cmath>

namespace biotope {
namespace {

/// How far a value lies outside of [low, high], in its unit; 0 inside.
float distance_outside(float low, float high, float value) { return std::max({0.0F, low - value, value - high}); }

/// The same on a circle of 360 degrees, for the arc that runs clockwise from `low` to `high`.
float degrees_outside(float low, float high, float value) {
  const auto turned = [](float degrees) {
    const float rest = std::fmod(degrees, 360.0F);
    return rest < 0 ? rest + 360 : rest;
  };
  if (high - low >= 360) return 0;
  const float arc = turned(high - low);
  const float along = turned(value - low);
  return along <= arc ? 0 : std::min(along - arc, 360 - along);
}

float inside_weight(const FilterCondition& condition, float value) {
  float outside = 0;
  if (condition.quantity == FilterQuantity::aspect) {
    if (value < 0) return 0;
    outside = degrees_outside(condition.low, condition.high, value);
  } else {
    outside = distance_outside(std::min(condition.low, condition.high), std::max(condition.low, condition.high), value);
  }
  if (outside <= 0) return 1;
  return condition.softness > 0 ? std::max(0.0F, 1 - outside / condition.softness) : 0;
}

}  // namespace

float condition_weight(const FilterCondition& condition, float value) {
  if (std::isnan(value)) return 0;
  const float weight = inside_weight(condition, value);
  return condition.inverted ? 1 - weight : weight;
}

const Grid<float>* filter_map(const FilterCondition& condition, const FilterMaps& maps) {
  switch (condition.quantity) {
    case FilterQuantity::slope:
      return maps.slope.get();
    case FilterQuantity::altitude:
      return maps.altitude.get();
    case FilterQuantity::aspect:
      return maps.aspect.get();
    case FilterQuantity::water_distance:
      return maps.water_distance.get();
    case FilterQuantity::map:
      break;
  }
  const auto found = maps.values.find(condition.map);
  return found == maps.values.end() ? nullptr : found->second.get();
}

CellFilter::CellFilter(const BrushFilter& filter, const FilterMaps* maps, const SelectionMask* selection,
                       const SelectionMask* locked_area)
    : selection_(filter.use_selection ? selection : nullptr), locked_area_(locked_area) {
  if (maps == nullptr) return;
  for (const FilterCondition& condition : filter.conditions) {
    if (const Grid<float>* values = filter_map(condition, *maps)) parts_.push_back({&condition, values});
  }
}

float CellFilter::operator()(int x, int y) const {
  float weight = selected(selection_, x, y);
  if (locked_area_ != nullptr) weight *= 1 - locked_share(locked_area_, x, y);
  for (const Part& part : parts_) {
    if (weight <= 0) return 0;
    weight *= condition_weight(*part.condition, (*part.values)(x, y));
  }
  return weight;
}

bool CellFilter::blocks_tile(std::size_t tile) const {
  return selection_ != nullptr && !selection_->tile(tile) && selection_->background() == 0;
}

float filter_weight(const BrushFilter& filter, const FilterMaps& maps, int x, int y) {
  return CellFilter(filter, &maps, nullptr)(x, y);
}

}  // namespace biotope

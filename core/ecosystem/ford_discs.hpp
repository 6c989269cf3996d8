#pragma once

#include <vector>

#include "core/ecosystem/confinement.hpp"

namespace biotope {

/// Ground that a ford opens: all cells whose centres lie within `radius` cells of a place (column and row).
struct FordDisc {
  double x = 0;
  double y = 0;
  double radius = 0;
  bool operator==(const FordDisc&) const = default;
};

/// Where no water is too deep for anybody: around the fords that were found a disc as wide as the river and a cell, so that a
/// corridor reaches from bank to bank; around those that a person placed their radius. Found ones come first, each in the order
/// of its list.
[[nodiscard]] std::vector<FordDisc> ford_discs(const Ground& ground);

/// Radius (cells) of a place that is `metres` wide each way: it holds at least one cell however small it is.
[[nodiscard]] double place_radius(float metres, double cell_size);

}  // namespace biotope

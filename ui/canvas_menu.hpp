#pragma once

#include "ui/widgets.hpp"

namespace biotope {

/// The menu of a place: why the selected species is, or is not, here; everything that lives here; painting it.
void draw_cell_menu(const UiContext& ui, int x, int y);

/// A species that is at a cell, with how much of it there is.
struct Presence {
  int species = 0;
  /// Covered fraction for plants, individuals / km2 of its region for animals.
  double amount = 0;
};
/// Plants with cover and animals whose region holds some at a cell; plants first, the most first.
[[nodiscard]] std::vector<Presence> present_at(const MapsSnapshot& snapshot, int x, int y);

}  // namespace biotope

#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/pipeline/maps_snapshot.hpp"
#include "ui/editor_state.hpp"

namespace biotope {

/// Where one sees a plant best: where it covers much, and rather near `from` (cells) than far. Nothing where it grows nowhere.
[[nodiscard]] std::optional<PathPoint> good_place_of_plant(const MapsSnapshot& maps, int species, PathPoint from);

/// Flies to where a species is: to the nearest herd of an animal, which is then chosen, or to where a plant grows well.
void show_species(EditorState& state, int species);

/// Fords that hydrology found and that somebody placed, and exits, one after the other.
struct Crossing {
  std::string name;  ///< "Ford 3"
  PathPoint at;
};
[[nodiscard]] std::vector<Crossing> crossings(const MapsSnapshot& maps);
/// Flies to the next of them.
void show_next_crossing(EditorState& state);

/// The double-click of a list's row, when the last item was clicked twice: "show it in 3D".
[[nodiscard]] bool row_double_clicked();

}  // namespace biotope

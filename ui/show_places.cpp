#include "ui/show_places.hpp"

#include <imgui.h>

#include <algorithm>
#include <cmath>

#include "ui/camera_mark.hpp"
#include "ui/editor_actions.hpp"
#include "ui/exploring.hpp"

namespace biotope {
namespace {

constexpr int looks_a_side = 160;    // places looked at along a side
constexpr double near_metres = 600;  // within which distance hardly counts

double tree_distance(const Species& species) {
  // A tree is looked at from a few times its height, a herb from near.
  return std::clamp(3.5 * double(species.plant().shape.height), 8.0, 70.0);
}

}  // namespace

std::optional<PathPoint> good_place_of_plant(const MapsSnapshot& maps, int species, PathPoint from) {
  if (!maps.web || maps.web->levels.empty()) return std::nullopt;
  const auto& plants = maps.web->levels[0];
  const auto found = std::find(plants.begin(), plants.end(), species);
  const auto index = std::size_t(found - plants.begin());
  if (found == plants.end() || index >= maps.cover.size() || !maps.cover[index]) return std::nullopt;
  const CoverMap& cover = *maps.cover[index];
  const Grid<float>& height = maps.terrain().height;
  const int step = std::max(1, std::max(height.width(), height.height()) / looks_a_side);
  std::optional<PathPoint> best;
  double most = 0;
  for (int y = step / 2; y < height.height(); y += step) {
    for (int x = step / 2; x < height.width(); x += step) {
      const double share = cover_fraction(cover(x, y));
      if (share <= 0) continue;
      const double away = std::hypot(double(x) - double(from.x), double(y) - double(from.y)) * maps.terrain().cell_size;
      const double score = share / (1 + away / near_metres);
      if (score <= most) continue;
      most = score;
      best = PathPoint{float(x), float(y)};
    }
  }
  return best;
}

void show_species(EditorState& state, int species) {
  if (!state.shown || !state.shown->web || !state.document.terrain || species < 0) return;
  const Species& shown = state.shown->web->species[std::size_t(species)];
  if (!shown.is_plant()) {
    if (choose_nearest_herd(state, species)) {
      go_to_herd(state);
    } else {
      announce(state, "No herd of " + display_name(shown) + " is here");
    }
    return;
  }
  if (const auto place = good_place_of_plant(*state.shown, species, camera_cell(state))) {
    show_place(state, *place, tree_distance(shown));
  } else {
    announce(state, display_name(shown) + " grows nowhere here");
  }
}

std::vector<Crossing> crossings(const MapsSnapshot& maps) {
  std::vector<Crossing> list;
  const auto add = [&](const char* name, int number, PathPoint at) { list.push_back({name + std::to_string(number), at}); };
  int fords = 0;
  if (maps.places) {
    for (const PlacedFord& ford : maps.places->fords) add("Ford ", ++fords, ford.at);
  }
  if (maps.hydrology) {
    for (const Ford& ford : maps.hydrology->fords) add("Ford ", ++fords, {float(ford.x), float(ford.y)});
  }
  int exits = 0;
  if (maps.places) {
    for (const PlacedExit& exit : maps.places->exits) add("Exit ", ++exits, exit.at);
  }
  return list;
}

void show_next_crossing(EditorState& state) {
  if (!state.shown) return;
  const std::vector<Crossing> list = crossings(*state.shown);
  if (list.empty()) {
    announce(state, "No ford and no exit here");
    return;
  }
  const int number = (state.exploring.last_crossing + 1) % int(list.size());
  state.exploring.last_crossing = number;
  const Crossing& crossing = list[std::size_t(number)];
  show_place(state, crossing.at, 45);
  announce(state, crossing.name);
}

bool row_double_clicked() { return ImGui::IsItemHovered() && ImGui::IsMouseDoubleClicked(ImGuiMouseButton_Left); }

}  // namespace biotope

#include <algorithm>
#include <cmath>

#include "core/species/desired_shares.hpp"
#include "ui/editor_actions.hpp"
#include "ui/format.hpp"
#include "ui/panels/panels.hpp"

namespace biotope {
namespace {

/// Position of a species in its level; -1 where it is not of it.
int position_in_level(const FoodWeb& web, int level, int species) {
  const std::vector<int>& numbers = web.levels[std::size_t(level)];
  const auto found = std::ranges::find(numbers, species);
  return found == numbers.end() ? -1 : int(found - numbers.begin());
}

/// Shares of the level as the maps have them; empty where they are not known yet.
std::vector<double> achieved_shares_of(const EditorState& state, const FoodWeb& web, int level) {
  std::vector<double> shares;
  for (const int number : web.levels[std::size_t(level)]) {
    const auto index = std::size_t(number);
    if (index >= state.figures.size() || !std::isfinite(state.figures[index].achieved)) return {};
    shares.push_back(state.figures[index].achieved);
  }
  return shares;
}

void change_share(EditorState& state, const FoodWeb& web, int level, const Species& species, double share) {
  const std::vector<double> achieved = achieved_shares_of(state, web, level);
  change_document(state, "Desired share of " + display_name(species), [&](Document& document) {
    document.species = std::make_shared<std::vector<Species>>(
        with_desired_share(*document.species, web, level, document.climate.name, species.name, share, achieved));
  });
}

/// The slider of the selected species; dead where none of the level is selected. It is there all the time: a list that moved
/// under the pointer would take the second half of a double click.
void draw_share_slider(const UiContext& ui, const FoodWeb& web, int level) {
  EditorState& state = ui.state;
  const int position = position_in_level(web, level, state.selected_species);
  if (position < 0) {
    float none = 0;
    ImGui::BeginDisabled();
    labelled_slider(ui.theme, "Desired share", none, 0, 1, "choose a species");
    ImGui::EndDisabled();
    return;
  }
  const Species& species = web.species[std::size_t(state.selected_species)];
  const std::vector<double> desired = desired_proportions(web, level, state.document.climate.name);
  const std::vector<double> achieved = achieved_shares_of(state, web, level);
  const bool asked = !desired.empty();
  const std::vector<double>& shown = asked ? desired : achieved;
  const double before = shown.empty() ? 0 : shown[std::size_t(position)];
  float share = state.dragged_value.value_or(float(before));
  labelled_slider(ui.theme, ("Desired share: " + display_name(species)).c_str(), share, 0, 1,
                  asked || state.dragged_value ? format_percent(double(share)) : "none asked");
  tooltip(ui.theme, "Part of the level's cover or animals. The others share the rest as they did before.");
  if (ImGui::IsItemActive()) {
    state.dragged_value = share;
  } else if (state.dragged_value) {
    const double edited = *state.dragged_value;
    state.dragged_value.reset();
    change_share(state, web, level, species, edited);
  }
}

}  // namespace

void draw_desired_shares(const UiContext& ui, const FoodWeb& web, int level) {
  EditorState& state = ui.state;
  const auto found = state.document.use_proportions.find(level);
  bool use = found == state.document.use_proportions.end() || found->second;
  ImGui::PushID(level);
  if (ImGui::Checkbox("Aim at desired shares", &use)) {
    change_document(state, use ? "Aim at desired shares" : "Compete freely",
                    [&](Document& document) { document.use_proportions[level] = use; });
  }
  tooltip(ui.theme, "On: the level aims at its species' desired shares. Off: the fittest take what they can.");
  if (use) draw_share_slider(ui, web, level);
  ImGui::PopID();
}

}  // namespace biotope

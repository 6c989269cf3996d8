#include <algorithm>

#include "ui/editor_actions.hpp"
#include "ui/format.hpp"
#include "ui/panels/panels.hpp"

namespace biotope {

void draw_trails_panel(const UiContext& ui) {
  EditorState& state = ui.state;
  heading(ui.theme, "Trails");
  if (!state.shown || !state.shown->trails) {
    hint(ui.theme, "Trails are found when all animals have settled");
    return;
  }
  const TrailNetwork& trails = *state.shown->trails;
  float most = 0;
  for (const TrailRoute& route : trails.routes) {
    for (const float weight : route.weight) most = std::max(most, weight);
  }
  readout(ui.theme, "Routes", format_count(double(trails.routes.size())));
  readout(ui.theme, "Length of all", format_length(trails.total_length()));
  readout(ui.theme, "Busiest", trails.routes.empty() ? "no trail" : format_value(most / 1000, "t/yr"));
  if (state.shown->plans) readout(ui.theme, "Herds walking them", format_count(double(state.shown->plans->size())));
  ImGui::Dummy(ImVec2(0, ui.theme.px(4)));
  hint(ui.theme,
       "Width and tone follow use: kilograms of animal that pass in a year. Trails clear plants and wear the ground in the 3D "
       "view; "
       "your terrain itself is never changed.");
}

}  // namespace biotope

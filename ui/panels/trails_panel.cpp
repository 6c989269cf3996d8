#include <array>

#include "ui/editor_actions.hpp"
#include "ui/format.hpp"
#include "ui/panels/panels.hpp"
#include "ui/panels/placing_panel.hpp"
#include "ui/show_places.hpp"

namespace biotope {
namespace {

/// Length by use as one bar of three tones, with its numbers beneath.
void draw_lengths(const UiContext& ui, const TrailFigures& figures) {
  const Theme& theme = ui.theme;
  heading(theme, "Length by use");
  struct Part {
    const char* name;
    double metres;
    float alpha;
  };
  const std::array<Part, 3> parts{{{"Heavy, over 10 % of the busiest", figures.heavy_length, 1.0F},
                                   {"Middle, 1 to 10 %", figures.middle_length, 0.55F},
                                   {"Light, under 1 %", figures.light_length, 0.25F}}};
  const double sum = figures.heavy_length + figures.middle_length + figures.light_length;
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const float width = ImGui::GetContentRegionAvail().x;
  const float height = theme.px(10);
  ImDrawList& list = *ImGui::GetWindowDrawList();
  float x = at.x;
  for (const Part& part : parts) {
    const float share = sum > 0 ? width * float(part.metres / sum) : 0;
    list.AddRectFilled(ImVec2(x, at.y), ImVec2(x + share, at.y + height), colour_u32(with_alpha(theme.accent, part.alpha)));
    x += share;
  }
  ImGui::Dummy(ImVec2(width, height + theme.px(2)));
  for (const Part& part : parts) readout(theme, part.name, format_length(part.metres));
}

/// The busiest routes; a click brings one to the middle of the map.
void draw_most_used(const UiContext& ui, const TrailFigures& figures) {
  const Theme& theme = ui.theme;
  heading(theme, "Most used routes");
  for (const TrailFigures::Route& route : figures.most_used) {
    ImGui::PushID(int(route.index));
    const ImVec2 at = ImGui::GetCursorScreenPos();
    const float width = ImGui::GetContentRegionAvail().x;
    if (ImGui::Selectable("##route")) {
      MapView& view = ui.state.view.map;
      view.centre_x = double(route.middle.x);
      view.centre_y = double(route.middle.y);
    }
    if (row_double_clicked()) show_place(ui.state, route.middle);
    tooltip(theme, "Click: move the map there. Double-click: see it in 3D");
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const float bar = width * (figures.busiest > 0 ? route.greatest / figures.busiest : 0);
    const float line = ImGui::GetFontSize();
    list.AddRectFilled(ImVec2(at.x, at.y + line), ImVec2(at.x + bar, at.y + line + theme.px(2)),
                       colour_u32(with_alpha(theme.accent, 0.7F)));
    list.AddText(at, colour_u32(theme.text), ("Route " + std::to_string(route.index + 1)).c_str());
    const std::string numbers = format_length(route.length) + ", " + format_value(route.greatest / 1000, "t/yr");
    list.AddText(ImVec2(at.x + width - ImGui::CalcTextSize(numbers.c_str()).x, at.y), colour_u32(theme.muted), numbers.c_str());
    ImGui::PopID();
  }
}

}  // namespace

void draw_trails_panel(const UiContext& ui) {
  EditorState& state = ui.state;
  heading(ui.theme, "Trails");
  if (!state.shown || !state.shown->trails) {
    hint(ui.theme, "Trails are found when all animals have settled");
    return;
  }
  const TrailNetwork& trails = *state.shown->trails;
  const TrailFigures& figures = state.trail_figures;
  readout(ui.theme, "Routes", format_count(double(trails.routes.size())));
  readout(ui.theme, "Length of all", format_length(trails.total_length()));
  readout(ui.theme, "Busiest", trails.routes.empty() ? "no trail" : format_value(figures.busiest / 1000, "t/yr"));
  if (state.shown->plans) readout(ui.theme, "Herds walking them", format_count(double(state.shown->plans->size())));
  draw_way_things(ui);
  if (!trails.routes.empty()) {
    draw_lengths(ui, figures);
    draw_most_used(ui, figures);
  }
  ImGui::Dummy(ImVec2(0, ui.theme.px(4)));
  hint(ui.theme,
       "Width and tone follow use: kilograms of animal that pass in a year. Trails clear plants and wear the ground in the 3D "
       "view; "
       "your terrain itself is never changed.");
}

}  // namespace biotope

#include "ui/panels/herd_state_panel.hpp"

#include <algorithm>
#include <cstdio>

#include "ui/format.hpp"
#include "ui/herd_needs.hpp"
#include "ui/icons.hpp"

namespace biotope {
namespace {

/// Commands of the chosen herd as small buttons in a row.
void draw_ways(const UiContext& ui) {
  const float side = ui.theme.px(28);
  ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, ImVec2(ui.theme.px(4), ui.theme.px(4)));
  bool first = true;
  for (const char* id : {"explore.previous_herd", "explore.next_herd", "explore.herd", "explore.follow"}) {
    if (!first) ImGui::SameLine();
    first = false;
    command_button(ui, id, side);
  }
  ImGui::PopStyleVar();
}

std::string hours_text(double hours) {
  char text[24];
  std::snprintf(text, sizeof text, "%.1f h", hours);
  return text;
}

void draw_need(const UiContext& ui, const HerdNeed& need) {
  const Theme& theme = ui.theme;
  const ImVec4& colour = need.met() ? theme.accent : theme.attention;
  const char* icon = theme.has_icons ? (need.met() ? icons::check : icons::warning) : (need.met() ? "+" : "!");
  ImGui::TextColored(colour, "%s", icon);
  ImGui::SameLine(0, theme.px(6));
  std::string value;
  if (need.short_supply) {
    value = "too little for all of them";
  } else if (need.places == 0) {
    value = "not found today";
  } else {
    value = hours_text(need.hours);
    if (need.places > 1) value += " at " + std::to_string(need.places) + (need.herds > 0 ? " herds" : " places");
  }
  const float room = ImGui::GetContentRegionAvail().x - ImGui::CalcTextSize(value.c_str()).x - theme.px(10);
  const std::string name = fitted_text(need.name + (need.now ? " (now)" : ""), room);
  readout(theme, name, value);
}

}  // namespace

void draw_herd_state(const UiContext& ui, const DailyPlan& plan) {
  const MapsSnapshot& maps = *ui.state.shown;
  const HerdOutlook outlook = herd_outlook(maps, plan, ui.state.clock.hour);
  if (!outlook.where.empty()) {
    const bool walks = outlook.doing == "walking";
    const std::string text =
        (walks ? "On its way to " : "At ") + outlook.where + (walks ? ", there at " : " until ") + format_clock(outlook.until);
    wrapped(ui.theme.text, text);
  }
  draw_ways(ui);
  ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, ImVec2(ui.theme.px(6), ui.theme.px(2)));
  for (const HerdNeed& need : outlook.needs) draw_need(ui, need);
  ImGui::PopStyleVar();
}

}  // namespace biotope

#include "ui/panels/herd_panel.hpp"

#include <algorithm>
#include <cmath>

#include "ui/editor_actions.hpp"
#include "ui/format.hpp"
#include "ui/herd_day.hpp"
#include "ui/icons.hpp"
#include "ui/panels/herd_state_panel.hpp"
#include "ui/show_places.hpp"

namespace biotope {
namespace {

/// Takes hold of the part of a stop under an hour.
void take_stop(HerdDay& own, const PlanEdit& day, float hour, float reach) {
  own.grip = DayGrip::none;
  for (std::size_t i = 0; i < day.stops.size(); ++i) {
    const PlanStopEdit& stop = day.stops[i];
    const bool at_end = std::abs(hour - stop.leave) < reach;
    const bool at_start = std::abs(hour - stop.arrive) < reach;
    if (!at_start && !at_end && (hour < stop.arrive || hour > stop.leave)) continue;
    own.held_stop = int(i);
    own.grip = at_end ? DayGrip::until : at_start ? DayGrip::from : DayGrip::whole;
    own.grip_offset = hour - stop.arrive;
    return;
  }
}

/// The day with the held stop where the pointer has it.
PlanEdit dragged_day(const HerdDay& own, PlanEdit day, float hour) {
  const auto stop = std::size_t(own.held_stop);
  const PlanStopEdit before = day.stops[stop];
  if (own.grip == DayGrip::whole) {
    const float arrive = hour - own.grip_offset;
    set_hours(day, stop, arrive, arrive + before.leave - before.arrive);
  } else if (own.grip == DayGrip::from) {
    set_hours(day, stop, std::min(hour, before.leave - 0.25F), before.leave);
  } else {
    set_hours(day, stop, before.arrive, hour);
  }
  return day;
}

void draw_stop_boxes(const UiContext& ui, const PlanEdit& day, const DailyPlan* plan, ImVec2 at, float width, float height) {
  const Theme& theme = ui.theme;
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const auto along = [&](float hour) { return at.x + width * std::clamp(hour, 0.0F, 24.0F) / 24; };
  list.AddRectFilled(at, ImVec2(at.x + width, at.y + height), colour_u32(with_alpha(theme.text, 0.07F)), theme.px(3));
  for (int hour = 6; hour < 24; hour += 6) {
    list.AddLine(ImVec2(along(float(hour)), at.y), ImVec2(along(float(hour)), at.y + height), colour_u32(theme.line));
  }
  for (std::size_t i = 0; i < day.stops.size(); ++i) {
    const PlanStopEdit& stop = day.stops[i];
    const bool late = plan != nullptr && plan->edited &&
                      std::find(plan->shifted_stops.begin(), plan->shifted_stops.end(), int(i)) != plan->shifted_stops.end();
    const auto box = [&](float from, float until) {
      const ImVec2 low(along(from), at.y + theme.px(3));
      const ImVec2 high(std::max(along(until), along(from) + theme.px(2)), at.y + height - theme.px(3));
      list.AddRectFilled(low, high, colour_u32(with_alpha(late ? theme.attention : theme.accent, 0.75F)), theme.px(3));
      const std::string number = std::to_string(i + 1);
      if (high.x - low.x > ImGui::CalcTextSize(number.c_str()).x + theme.px(4))
        list.AddText(ImVec2(low.x + theme.px(4), low.y + theme.px(3)), colour_u32(theme.window), number.c_str());
    };
    box(stop.arrive, std::min(stop.leave, 24.0F));
    if (stop.leave > 24) box(0, stop.leave - 24);
  }
  const float now = along(float(ui.state.clock.hour));
  list.AddLine(ImVec2(now, at.y - theme.px(2)), ImVec2(now, at.y + height + theme.px(2)), colour_u32(theme.text), theme.px(1.5F));
}

/// The bar of the day; stops are dragged whole or by an end. The change becomes one step when it is let go.
void draw_day_bar(const UiContext& ui, const PlanEdit& day, const DailyPlan* plan) {
  HerdDay& own = ui.state.herd_day;
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const float width = ImGui::GetContentRegionAvail().x;
  const float height = ui.theme.px(30);
  ImGui::InvisibleButton("day", ImVec2(width, height));
  const float hour = (ImGui::GetIO().MousePos.x - at.x) / width * 24;
  if (ImGui::IsItemActivated()) take_stop(own, day, hour, ui.theme.px(5) / width * 24);
  if (ImGui::IsItemActive() && own.grip != DayGrip::none && ImGui::IsMouseDragging(ImGuiMouseButton_Left, 1)) {
    own.preview = dragged_day(own, day, hour);
  }
  if (ImGui::IsItemDeactivated() && own.grip != DayGrip::none) {
    own.grip = DayGrip::none;
    own.held_stop = -1;
    if (own.preview) {
      const PlanEdit moved = *own.preview;
      own.preview.reset();
      change_day(ui.state, "Change the hours of a stop", [&](PlanEdit& edit) { edit.stops = moved.stops; });
    }
  }
  tooltip(ui.theme,
          "Drag a stop along the day, or its ends to stay longer or shorter. Amber: the way there takes too long for the hour "
          "you asked for");
  draw_stop_boxes(ui, day, plan, at, width, height);
}

/// What to do with a stop of the list.
enum class StopAction : int { none, earlier, later, remove };

/// Earlier, later, out: in a row.
StopAction draw_stop_buttons(const Theme& theme, bool may_go_earlier, bool may_go_later) {
  StopAction action = StopAction::none;
  if (ImGui::ArrowButton("earlier", ImGuiDir_Up) && may_go_earlier) action = StopAction::earlier;
  tooltip(theme, "Go there before the stop above");
  ImGui::SameLine(0, theme.px(2));
  if (ImGui::ArrowButton("later", ImGuiDir_Down) && may_go_later) action = StopAction::later;
  tooltip(theme, "Go there after the stop below");
  ImGui::SameLine(0, theme.px(2));
  if (icon_button(theme, "remove", theme.has_icons ? icons::close : "x", theme.muted, "Leave this stop out"))
    action = StopAction::remove;
  return action;
}

/// What the stop is at: a resource, or a herd that a predator visits.
std::string name_of(const EditorState& state, const PlanEdit& day, const DailyPlan* plan, std::size_t index) {
  const MapsSnapshot& maps = *state.shown;
  const bool planned = plan != nullptr && plan->stops.size() == day.stops.size() && !state.herd_day.preview;
  if (planned) return stop_name(maps, *plan, plan->stops[index]);
  const int level = plan != nullptr ? plan->level : 1;
  return resource_name(maps, level, node_near(maps, level, day.stops[index].at));
}

StopAction draw_stop(const UiContext& ui, const PlanEdit& day, std::size_t index, const std::string& what, bool reachable) {
  const Theme& theme = ui.theme;
  const PlanStopEdit& stop = day.stops[index];
  const PathPoint place = stop_place(ui.state, day, index);
  StopAction action = StopAction::none;
  ImGui::PushID(int(index));
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const float room = ImGui::GetContentRegionAvail().x;
  // The buttons come with the pointer, so that names have room.
  const bool reached =
      ImGui::IsWindowHovered() && ImGui::IsMouseHoveringRect(at, ImVec2(at.x + room, at.y + ImGui::GetFrameHeight()));
  const float width = room - (reached ? theme.px(72) : 0);
  if (ImGui::Selectable("##stop", false, 0, ImVec2(width, 0))) {
    ui.state.view.map.centre_x = double(place.x);
    ui.state.view.map.centre_y = double(place.y);
    ui.state.clock.hour = std::fmod(double(stop.arrive), 24.0);
  }
  if (row_double_clicked()) show_place(ui.state, place);
  tooltip(theme,
          "Click: go there, to that hour. Double-click: see it in 3D. On the map the numbered circle can be dragged to another "
          "resource");
  const std::string hours = format_clock(double(stop.arrive)) + " - " + format_clock(double(stop.leave));
  const std::string name = std::to_string(index + 1) + "  " + what;
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const float hours_width = ImGui::CalcTextSize(hours.c_str()).x;
  list.AddText(at, colour_u32(reachable ? theme.text : theme.attention),
               fitted_text(name, width - hours_width - theme.px(10)).c_str());
  list.AddText(ImVec2(at.x + width - hours_width - theme.px(4), at.y), colour_u32(theme.muted), hours.c_str());
  ImGui::SameLine(0, 0);
  if (reached) {
    action = draw_stop_buttons(theme, index > 0, index + 1 < day.stops.size());
  } else {
    ImGui::Dummy(ImVec2(0, ImGui::GetFrameHeight()));
  }
  ImGui::PopID();
  return action;
}

void draw_stops(const UiContext& ui, const PlanEdit& day, const DailyPlan* plan) {
  EditorState& state = ui.state;
  std::size_t chosen = 0;
  StopAction action = StopAction::none;
  for (std::size_t i = 0; i < day.stops.size(); ++i) {
    const bool reachable =
        plan == nullptr || !plan->edited ||
        std::find(plan->unreachable_stops.begin(), plan->unreachable_stops.end(), int(i)) == plan->unreachable_stops.end();
    const StopAction wanted = draw_stop(ui, day, i, name_of(state, day, plan, i), reachable);
    if (wanted == StopAction::none) continue;
    action = wanted;
    chosen = i;
  }
  if (action == StopAction::earlier)
    change_day(state, "Reorder stops", [&](PlanEdit& edit) { swap_stops(edit, chosen, chosen - 1); });
  if (action == StopAction::later)
    change_day(state, "Reorder stops", [&](PlanEdit& edit) { swap_stops(edit, chosen, chosen + 1); });
  if (action == StopAction::remove) {
    change_day(state, "Leave out a stop", [&](PlanEdit& edit) { edit.stops.erase(edit.stops.begin() + std::ptrdiff_t(chosen)); });
  }
}

/// What the herd is and does now.
void draw_head(const UiContext& ui, const PlanEdit& day, const DailyPlan* plan) {
  EditorState& state = ui.state;
  const MapsSnapshot& maps = *state.shown;
  const int species = maps.web->find(day.species);
  const std::string name = species < 0 ? day.species : display_name(maps.web->species[std::size_t(species)]);
  const float close = ImGui::GetFontSize() + ui.theme.px(10);
  ImGui::PushFont(ui.theme.bold);
  ImGui::TextColored(ui.theme.accent, "%s", fitted_text("A day of " + name, ImGui::GetContentRegionAvail().x - close).c_str());
  ImGui::PopFont();
  ImGui::SameLine(ImGui::GetContentRegionMax().x - close + ui.theme.px(6));
  const bool closed = icon_button(ui.theme, "close herd", ui.theme.has_icons ? icons::close : "x", ui.theme.muted, "Close");
  if (plan != nullptr) {
    const HerdState now =
        herd_state(*plan, maps.graph->levels[std::size_t(plan->level)], state.clock.hour, maps.terrain().cell_size);
    hint(ui.theme, std::to_string(plan->size) + (plan->size == 1 ? " animal, " : " animals, ") + activity_word(now.activity) +
                       " at " + format_clock(state.clock.hour) + (plan->edited ? "; planned by you" : ""));
    if (!plan->pursuits.empty()) hint(ui.theme, pursuit_text(maps, *plan, state.clock.hour));
    if (!plan->unreachable_stops.empty()) {
      ImGui::TextColored(ui.theme.attention, "%s",
                         (std::to_string(plan->unreachable_stops.size()) + " stops cannot be reached in time").c_str());
    }
  } else {
    hint(ui.theme, "This herd is not there any more");
  }
  if (closed) forget_herd(state);
}

}  // namespace

void draw_herd_panel(const UiContext& ui) {
  EditorState& state = ui.state;
  const auto day = chosen_day(state);
  if (!day || !state.shown || !state.shown->web || !state.shown->graph) return;
  const DailyPlan* plan = chosen_plan(state);
  draw_head(ui, *day, plan);
  if (!state.herd_day.herd) return;
  if (plan != nullptr) draw_herd_state(ui, *plan);
  draw_day_bar(ui, *day, plan);
  draw_stops(ui, *day, plan);
  const float half = (ImGui::GetContentRegionAvail().x - ui.theme.px(6)) / 2;
  if (ImGui::Button(state.herd_day.adding ? "Click a resource" : "Add a stop", ImVec2(half, 0)))
    state.herd_day.adding = !state.herd_day.adding;
  tooltip(ui.theme, "Then click a resource on the map: the herd goes there at the clock's hour");
  ImGui::SameLine(0, ui.theme.px(6));
  ImGui::BeginDisabled(!day_is_edited(state));
  if (ImGui::Button("Computed day", ImVec2(half, 0))) restore_day(state);
  ImGui::EndDisabled();
  tooltip(ui.theme, "Give the computed day back; can be undone");
}

void draw_herd_day(const UiContext& ui, const ViewPen& pen) {
  const EditorState& state = ui.state;
  const auto day = chosen_day(state);
  if (!day) return;
  if (const DailyPlan* plan = chosen_plan(state)) {
    std::vector<PathPoint> way;
    way.reserve(plan->way.size());
    for (const auto& point : plan->way) way.push_back(point.at);
    pen.line(way, {IM_COL32(255, 255, 255, 220), 1.8F, IM_COL32(20, 22, 24, 170), 1.1F});
  }
  ImDrawList& list = *ImGui::GetWindowDrawList();
  for (std::size_t i = 0; i < day->stops.size(); ++i) {
    const PathPoint cell = stop_place(state, *day, i);
    const auto at = pen.place(cell);
    if (!at) continue;
    const bool held = state.herd_day.held_stop == int(i);
    const float r = ui.theme.px(held ? 12 : 10);
    list.AddCircleFilled(*at, r + ui.theme.px(1.5F), mark_colour(pen, cell, IM_COL32(20, 22, 24, 200)));
    list.AddCircleFilled(*at, r, mark_colour(pen, cell, colour_u32(ui.theme.accent)));
    const std::string number = std::to_string(i + 1);
    const ImVec2 size = ImGui::CalcTextSize(number.c_str());
    list.AddText(ImVec2(at->x - size.x / 2, at->y - size.y / 2), IM_COL32(20, 22, 24, 255), number.c_str());
  }
}

}  // namespace biotope

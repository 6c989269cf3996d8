#include "ui/panels/placing_panel.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <span>

#include "core/terrain/hydrology.hpp"
#include "ui/editor_actions.hpp"
#include "ui/format.hpp"
#include "ui/icons.hpp"
#include "ui/placing_actions.hpp"
#include "ui/show_places.hpp"

namespace biotope {
namespace {

struct Button {
  PlacingTool tool;
  const char* name;
  const char* tip;
};

constexpr std::array<Button, 3> water_buttons{
    {{PlacingTool::river, "River", "Click along its course, from its head downstream; Enter or a double click ends it"},
     {PlacingTool::lake, "Lake", "Click around its shore; a click on the first point closes it"},
     {PlacingTool::inflow, "Inflow", "Click where a river enters the map"}}};
constexpr std::array<Button, 6> way_buttons{
    {{PlacingTool::bend_trail, "Bend", "Press on a trail and pull it where it should go"},
     {PlacingTool::pin_trail, "Pin", "Click along a trail that must be there; Enter ends it"},
     {PlacingTool::forbid_trail, "Forbid", "Click along ground where no trail may be; Enter ends it"},
     {PlacingTool::ford, "Ford", "Click where animals may cross deep water"},
     {PlacingTool::exit, "Exit", "Click where animals come in and leave: it opens what blocks them"},
     {PlacingTool::waypoint, "Waypoint", "Click a place that herds come by"}}};

void draw_buttons(const UiContext& ui, std::span<const Button> buttons) {
  const float gap = ui.theme.px(6);
  const float width = (ImGui::GetContentRegionAvail().x - 2 * gap) / 3;
  for (std::size_t i = 0; i < buttons.size(); ++i) {
    if (i % 3 != 0) ImGui::SameLine(0, gap);
    const bool on = ui.state.placing.tool == buttons[i].tool;
    if (on) ImGui::PushStyleColor(ImGuiCol_Button, with_alpha(ui.theme.accent, 0.45F));
    if (ImGui::Button(buttons[i].name, ImVec2(width, 0))) choose_placing(ui.state, buttons[i].tool);
    if (on) ImGui::PopStyleColor();
    tooltip(ui.theme, buttons[i].tip);
  }
  for (const Button& button : buttons) {
    if (ui.state.placing.tool == button.tool) hint(ui.theme, std::string(button.tip) + ". Esc gives up.");
  }
}

double line_metres(const std::vector<PathPoint>& points, double cell_size) {
  double sum = 0;
  for (std::size_t i = 1; i < points.size(); ++i) {
    sum += std::hypot(double(points[i].x - points[i - 1].x), double(points[i].y - points[i - 1].y)) * cell_size;
  }
  return sum;
}

std::string summary(const PlacedThings& things, const PlacedItem& item, double cell_size) {
  const Placements& placements = things.placements;
  switch (item.kind) {
    case PlacedKind::inflow:
      return format_value(things.inflows[item.index].catchment_area / 1e6, "km² upstream");
    case PlacedKind::river:
      return format_value(placements.water.rivers[item.index].discharge, "m³/s");
    case PlacedKind::lake:
      return format_value(double(placements.water.lakes[item.index].depth), "m deep");
    case PlacedKind::waypoint:
      return format_percent(double(placements.places.waypoints[item.index].attraction));
    case PlacedKind::ford:
    case PlacedKind::exit:
      return format_length(double(radius_of(things, item)));
    default:
      return format_length(line_metres(points_of(things, item), cell_size));
  }
}

/// A slider over a value of the selected thing; the change becomes one step when it is let go.
void property(const UiContext& ui, const char* name, float now, float least, float most,
              const std::function<std::string(float)>& text, const std::function<void(PlacedThings&, float)>& set) {
  EditorState& state = ui.state;
  float value = state.dragged_value.value_or(now);
  if (labelled_slider(ui.theme, name, value, least, most, text(value), true)) state.dragged_value = value;
  if (!ImGui::IsItemDeactivatedAfterEdit()) return;
  state.dragged_value.reset();
  change_placed(state, name, [&](PlacedThings& things) { set(things, value); });
}

void draw_properties(const UiContext& ui, const PlacedThings& things, const PlacedItem& item) {
  const std::size_t i = item.index;
  const Places& places = things.placements.places;
  const auto metres = [](float value) { return format_length(double(value)); };
  switch (item.kind) {
    case PlacedKind::river: {
      const auto text = [](float value) {
        return format_value(double(value), "m³/s") + ", " + format_value(double(river_width(value)), "m wide");
      };
      property(ui, "Discharge", float(things.placements.water.rivers[i].discharge), 0.02F, 200, text,
               [i](PlacedThings& all, float value) { all.placements.water.rivers[i].discharge = double(value); });
      break;
    }
    case PlacedKind::lake:
      property(ui, "Depth", things.placements.water.lakes[i].depth, 0.6F, 60, metres,
               [i](PlacedThings& all, float value) { all.placements.water.lakes[i].depth = value; });
      break;
    case PlacedKind::inflow: {
      const auto text = [](float value) { return format_value(double(value), "km²"); };
      property(ui, "Catchment upstream", float(things.inflows[i].catchment_area / 1e6), 0.01F, 20000, text,
               [i](PlacedThings& all, float value) { all.inflows[i].catchment_area = double(value) * 1e6; });
      break;
    }
    case PlacedKind::ford:
      property(ui, "Radius", places.fords[i].radius, 2, 200, metres,
               [i](PlacedThings& all, float value) { all.placements.places.fords[i].radius = value; });
      break;
    case PlacedKind::exit:
      property(ui, "Radius", places.exits[i].radius, 2, 200, metres,
               [i](PlacedThings& all, float value) { all.placements.places.exits[i].radius = value; });
      break;
    case PlacedKind::waypoint:
      property(
          ui, "How often a herd comes by", places.waypoints[i].attraction, 0.01F, 0.5F,
          [](float value) { return format_percent(double(value)); },
          [i](PlacedThings& all, float value) { all.placements.places.waypoints[i].attraction = value; });
      break;
    case PlacedKind::pinned_trail:
      property(
          ui, "Use, at least", places.pinned_trails[i].weight / 1000, 0.1F, 5000,
          [](float value) { return format_value(double(value), "t/yr"); },
          [i](PlacedThings& all, float value) { all.placements.places.pinned_trails[i].weight = value * 1000; });
      break;
    case PlacedKind::forbidden_trail:
      property(ui, "Width to each side", places.forbidden_trails[i].radius, 2, 300, metres,
               [i](PlacedThings& all, float value) { all.placements.places.forbidden_trails[i].radius = value; });
      break;
  }
}

void draw_list(const UiContext& ui, std::span<const PlacedKind> kinds) {
  EditorState& state = ui.state;
  const PlacedThings things = placed_things(state.document);
  std::optional<PlacedItem> removed;
  for (const PlacedKind kind : kinds) {
    for (std::size_t i = 0; i < count_of(things, kind); ++i) {
      const PlacedItem item{kind, i};
      ImGui::PushID(int(kind) * 10000 + int(i));
      const float close = ui.theme.px(24);
      const float width = ImGui::GetContentRegionAvail().x - close;
      const ImVec2 at = ImGui::GetCursorScreenPos();
      if (ImGui::Selectable("##thing", state.placing.selected == item, 0, ImVec2(width, 0))) {
        state.placing.selected = item;
        const PathPoint first = points_of(things, item).front();
        state.view.map.centre_x = double(first.x);
        state.view.map.centre_y = double(first.y);
      }
      if (row_double_clicked()) show_place(state, points_of(things, item).front());
      tooltip(ui.theme, "Click: select it and move the map there. Double-click: see it in 3D", "Del removes it");
      ImDrawList& list = *ImGui::GetWindowDrawList();
      list.AddText(at, colour_u32(ui.theme.text), (std::string(placed_name(kind)) + " " + std::to_string(i + 1)).c_str());
      const std::string right = summary(things, item, state.document.terrain->cell_size);
      list.AddText(ImVec2(at.x + width - ImGui::CalcTextSize(right.c_str()).x - ui.theme.px(6), at.y), colour_u32(ui.theme.muted),
                   right.c_str());
      ImGui::SameLine(0, 0);
      if (icon_button(ui.theme, "remove", ui.theme.has_icons ? icons::close : "x", ui.theme.muted, "Remove; can be undone"))
        removed = item;
      if (state.placing.selected == item) draw_properties(ui, things, item);
      ImGui::PopID();
    }
  }
  if (!removed) return;
  state.placing.selected = removed;
  remove_selected(state);
}

}  // namespace

void draw_water_things(const UiContext& ui) {
  heading(ui.theme, "Draw water");
  draw_buttons(ui, water_buttons);
  static constexpr std::array<PlacedKind, 3> kinds{PlacedKind::river, PlacedKind::lake, PlacedKind::inflow};
  draw_list(ui, kinds);
}

void draw_way_things(const UiContext& ui) {
  heading(ui.theme, "Draw and place");
  draw_buttons(ui, way_buttons);
  static constexpr std::array<PlacedKind, 5> kinds{PlacedKind::pinned_trail, PlacedKind::forbidden_trail, PlacedKind::ford,
                                                   PlacedKind::exit, PlacedKind::waypoint};
  draw_list(ui, kinds);
}

}  // namespace biotope

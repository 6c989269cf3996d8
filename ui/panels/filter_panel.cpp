#include "ui/panels/filter_panel.hpp"

#include <algorithm>
#include <cmath>

#include "ui/editor_actions.hpp"
#include "ui/format.hpp"
#include "ui/icons.hpp"
#include "ui/paint_targets.hpp"
#include "ui/paint_widgets.hpp"

namespace biotope {
namespace {

/// How far the sliders of a quantity go.
struct Scale {
  float low = 0;
  float high = 1;
  std::string unit;
};

Scale scale_of(const EditorState& state, const FilterCondition& condition) {
  switch (condition.quantity) {
    case FilterQuantity::slope:
      return {0, 70, "°"};
    case FilterQuantity::altitude:
      return {state.ground.height_range[0], std::max(state.ground.height_range[1], state.ground.height_range[0] + 1), "m"};
    case FilterQuantity::aspect:
      return {0, 360, "°"};
    case FilterQuantity::water_distance:
      return {0, 500, "m"};
    case FilterQuantity::map: {
      const LayerLimits limits = limits_of(state, condition.map);
      return {limits.low, limits.high, limits.unit};
    }
  }
  return {};
}

const char* compass(float degrees) {
  static constexpr const char* names[] = {"N", "NE", "E", "SE", "S", "SW", "W", "NW"};
  return names[std::size_t(std::lround(degrees / 45)) % 8];
}

std::string range_text(const FilterCondition& condition, const Scale& scale) {
  if (condition.quantity == FilterQuantity::aspect) return std::string(compass(condition.low)) + " to " + compass(condition.high);
  if (condition.quantity == FilterQuantity::map && condition.map.kind == LayerKind::geology) {
    const auto name = [](float value) {
      return geology_names()[std::size_t(std::clamp(int(std::lround(value)), 0, geology_classes - 1))];
    };
    return name(condition.low) == name(condition.high) ? name(condition.low)
                                                       : name(condition.low) + " to " + name(condition.high);
  }
  const std::string low = scale.unit == "%" ? format_round_number(std::round(condition.low * 100)) : format_number(condition.low);
  return low + " to " + format_value(condition.high, scale.unit);
}

/// A square button with a letter or icon, lit while it is on.
bool toggle(const Theme& theme, const char* id, const char* icon, bool on, const char* tip) {
  return icon_button(theme, id, icon, on ? theme.accent : theme.muted, tip);
}

}  // namespace

std::string condition_title(const EditorState& state, const FilterCondition& condition) {
  switch (condition.quantity) {
    case FilterQuantity::slope:
      return "Slope";
    case FilterQuantity::altitude:
      return "Height";
    case FilterQuantity::aspect:
      return "Facing";
    case FilterQuantity::water_distance:
      return "Distance to water";
    case FilterQuantity::map:
      return layer_title(condition.map, state.web());
  }
  return {};
}

std::string condition_text(const EditorState& state, const FilterCondition& condition) {
  return std::string(condition.inverted ? "not " : "") + range_text(condition, scale_of(state, condition));
}

FilterCondition new_condition(const EditorState& state, FilterQuantity quantity, const LayerId& map) {
  FilterCondition condition;
  condition.quantity = quantity;
  condition.map = map;
  const Scale scale = scale_of(state, condition);
  condition.low = scale.low;
  condition.high = scale.low + 0.5F * (scale.high - scale.low);
  if (quantity == FilterQuantity::slope) condition.high = 15;
  if (quantity == FilterQuantity::water_distance) condition.high = 50;
  if (quantity == FilterQuantity::aspect) {
    condition.low = 135;
    condition.high = 225;
  }
  const bool classes = map.kind == LayerKind::geology && quantity == FilterQuantity::map;
  if (classes) condition.high = condition.low;
  condition.softness = classes ? 0 : 0.05F * (scale.high - scale.low);
  return condition;
}

std::optional<FilterCondition> condition_menu(const EditorState& state) {
  std::optional<FilterCondition> chosen;
  for (const FilterQuantity quantity :
       {FilterQuantity::slope, FilterQuantity::altitude, FilterQuantity::aspect, FilterQuantity::water_distance}) {
    FilterCondition condition;
    condition.quantity = quantity;
    if (ImGui::MenuItem(condition_title(state, condition).c_str())) chosen = new_condition(state, quantity);
  }
  if (ImGui::BeginMenu("Another map")) {
    if (const auto layer = layer_menu(state)) chosen = new_condition(state, FilterQuantity::map, *layer);
    ImGui::EndMenu();
  }
  return chosen;
}

bool draw_condition(const UiContext& ui, FilterCondition& condition) {
  const Scale scale = scale_of(ui.state, condition);
  const bool classes = condition.quantity == FilterQuantity::map && condition.map.kind == LayerKind::geology;
  bool changed = range_slider(ui.theme, "range", condition.low, condition.high, scale.low, scale.high, condition.softness,
                              condition.quantity == FilterQuantity::aspect);
  if (classes) {
    condition.low = std::round(condition.low);
    condition.high = std::round(condition.high);
    return changed;
  }
  ImGui::PushStyleColor(ImGuiCol_Text, ui.theme.muted);
  ImGui::PushStyleVar(ImGuiStyleVar_FramePadding, ImVec2(ui.theme.px(4), ui.theme.px(1)));
  ImGui::SetNextItemWidth(-1);
  const std::string shown = "ends over " + format_value(condition.softness, scale.unit) + (scale.unit == "%" ? "%" : "");
  changed = ImGui::SliderFloat("##softness", &condition.softness, 0, 0.5F * (scale.high - scale.low), shown.c_str(),
                               ImGuiSliderFlags_Logarithmic) ||
            changed;
  ImGui::PopStyleVar();
  ImGui::PopStyleColor();
  tooltip(ui.theme, "How softly the brush fades out beyond the range");
  return changed;
}

void draw_filter_section(const UiContext& ui) {
  EditorState& state = ui.state;
  const Theme& theme = ui.theme;
  BrushFilter& filter = state.brush.filter;
  const std::string note =
      filter.conditions.empty()
          ? (state.document.selection && filter.use_selection ? "inside the selection" : "everywhere")
          : std::to_string(filter.conditions.size()) + (filter.conditions.size() == 1 ? " condition" : " conditions");
  if (!section(theme, "Where it paints", note, false)) return;
  std::optional<std::size_t> removed;
  for (std::size_t i = 0; i < filter.conditions.size(); ++i) {
    FilterCondition& condition = filter.conditions[i];
    ImGui::PushID(int(i));
    const float side = ImGui::GetFontSize() + theme.px(6);
    readout(theme, condition_title(state, condition), "");
    const std::string text = condition_text(state, condition);
    const float right = ImGui::GetContentRegionMax().x - 2 * side - theme.px(4);
    ImGui::SameLine(right - ImGui::CalcTextSize(text.c_str()).x - theme.px(4));
    ImGui::TextUnformatted(text.c_str());
    ImGui::SameLine(right);
    if (toggle(theme, "not", theme.has_icons ? icons::invert : "!", condition.inverted, "Everywhere but there")) {
      condition.inverted = !condition.inverted;
    }
    ImGui::SameLine(right + side + theme.px(2));
    if (toggle(theme, "off", theme.has_icons ? icons::close : "x", false, "Take this condition away")) removed = i;
    (void)draw_condition(ui, condition);
    ImGui::PopID();
  }
  if (removed) filter.conditions.erase(filter.conditions.begin() + std::ptrdiff_t(*removed));
  const float half = (ImGui::GetContentRegionAvail().x - theme.px(6)) / 2;
  if (ImGui::Button("Add a condition ...", ImVec2(half, 0))) ImGui::OpenPopup("add condition");
  tooltip(theme, "Keep the brush to slopes, heights, directions, banks or another map's values");
  ImGui::SameLine(0, theme.px(6));
  const bool shown = state.paint.show_filter;
  ImGui::PushStyleColor(ImGuiCol_Button, shown ? with_alpha(theme.accent, 0.3F) : theme.raised);
  if (ImGui::Button("Show on the map", ImVec2(half, 0))) state.paint.show_filter = !shown;
  ImGui::PopStyleColor();
  tooltip(theme, "A red film lies where the brush does not act", ui.commands.keys("brush.show_filter"));
  if (ImGui::BeginPopup("add condition")) {
    if (auto added = condition_menu(state)) filter.conditions.push_back(std::move(*added));
    ImGui::EndPopup();
  }
  if (state.document.selection) {
    ImGui::Checkbox("Only inside the selection", &filter.use_selection);
  }
}

}  // namespace biotope

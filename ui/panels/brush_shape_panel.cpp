#include "ui/panels/brush_shape_panel.hpp"

#include "ui/brush_stamps.hpp"
#include "ui/editor_actions.hpp"
#include "ui/format.hpp"
#include "ui/icons.hpp"
#include "ui/paint_widgets.hpp"

namespace biotope {
namespace {

void use_stamp(EditorState& state, const BrushStamp& stamp) {
  state.brush.stamp = stamp.weights;
  state.paint.stamp = stamp.name;
}

void ask_for_stamp(EditorState& state) {
  FileRequest request;
  request.title = "An image as the shape of the brush";
  request.action = "Use";
  request.browser.endings = {".png", ".jpg", ".jpeg", ".tif", ".tiff", ".bmp"};
  request.then = [](EditorState& later, const std::filesystem::path& file) {
    const auto stamp = load_stamp(file.string());
    if (stamp) {
      use_stamp(later, *stamp);
    } else {
      complain(later, "This image is no stamp", stamp.error());
    }
  };
  ask_for_file(state, std::move(request));
}

/// A square with a stamp in it; true when it was clicked.
bool stamp_button(const Theme& theme, const char* id, const Grid<float>* stamp, bool chosen, const std::string& tip, float side) {
  const ImVec2 at = ImGui::GetCursorScreenPos();
  ImGui::PushStyleColor(ImGuiCol_Button, chosen ? with_alpha(theme.accent, 0.3F) : with_alpha(theme.text, 0.06F));
  const bool clicked = ImGui::Button(id, ImVec2(side, side));
  ImGui::PopStyleColor();
  const float inset = theme.px(4);
  draw_stamp(*ImGui::GetWindowDrawList(), ImVec2(at.x + inset, at.y + inset), side - 2 * inset, stamp,
             colour_u32(chosen ? theme.accent : theme.muted));
  tooltip(theme, tip);
  return clicked;
}

void draw_stamps(const UiContext& ui) {
  EditorState& state = ui.state;
  const Theme& theme = ui.theme;
  const float gap = theme.px(4);
  const float side = std::min((ImGui::GetContentRegionAvail().x - 5 * gap) / 6, theme.px(40));
  if (stamp_button(theme, "##disk", nullptr, state.paint.stamp.empty(), "A disk with the falloff above", side)) {
    state.brush.stamp = nullptr;
    state.paint.stamp.clear();
  }
  bool built_in = state.paint.stamp.empty();
  for (const BrushStamp& stamp : built_in_stamps()) {
    ImGui::SameLine(0, gap);
    const bool chosen = state.paint.stamp == stamp.name;
    built_in = built_in || chosen;
    if (stamp_button(theme, ("##" + stamp.name).c_str(), stamp.weights.get(), chosen, stamp.name, side)) use_stamp(state, stamp);
  }
  ImGui::SameLine(0, gap);
  if (built_in) {
    if (ImGui::Button(theme.has_icons ? icons::image : "...", ImVec2(side, side))) ask_for_stamp(state);
    tooltip(theme, "Use an image: white paints, black and clear do not");
  } else if (stamp_button(theme, "##image", state.brush.stamp.get(), true,
                          stamp_title(state.paint.stamp) + "\nClick for another image", side)) {
    ask_for_stamp(state);
  }
  if (state.paint.stamp.empty()) return;
  labelled_slider(theme, "Turn", state.brush.stamp_turn, 0, 360, format_value(std::round(state.brush.stamp_turn), "°"));
  ImGui::Checkbox("Turn each dab by chance", &state.brush.stamp_turns_by_chance);
}

}  // namespace

void draw_shape_section(const UiContext& ui) {
  EditorState& state = ui.state;
  const Theme& theme = ui.theme;
  Brush& brush = state.brush;
  const std::string note = state.paint.stamp.empty() ? format_percent(brush.hardness) + " hard" : stamp_title(state.paint.stamp);
  if (!section(theme, "Shape", note, false)) return;
  if (state.paint.stamp.empty()) {
    draw_falloff(theme, brush, ImVec2(ImGui::GetContentRegionAvail().x, theme.px(52)));
    int falloff = int(brush.falloff);
    if (segmented(theme, "falloff", {"Smooth", "Linear", "Round", "Sharp"}, falloff, ImGui::GetContentRegionAvail().x)) {
      brush.falloff = Falloff(falloff);
    }
    ImGui::Dummy(ImVec2(0, theme.px(1)));
    labelled_slider(theme, "Hardness", brush.hardness, 0, 1, format_percent(brush.hardness));
    tooltip(theme, "Soft edge or flat disk");
  }
  labelled_slider(theme, "Spacing", brush.spacing, 0.05F, 2, format_percent(brush.spacing), true);
  tooltip(theme, "Distance from dab to dab, as a share of the radius");
  draw_stamps(ui);
  ImGui::Checkbox("Pen pressure on size", &brush.pressure_sizes);
  tooltip(theme, "A tablet's pen pressed lightly draws a small dab. A mouse presses wholly");
  ImGui::Checkbox("Pen pressure on strength", &brush.pressure_strengthens);
  tooltip(theme, "A tablet's pen pressed lightly paints gently");
}

}  // namespace biotope

#include "ui/panels/layers_panel.hpp"

#include <algorithm>
#include <array>

#include "ui/editor_actions.hpp"
#include "ui/format.hpp"
#include "ui/icons.hpp"
#include "ui/layer_actions.hpp"
#include "ui/paint_targets.hpp"
#include "ui/paint_widgets.hpp"

namespace biotope {
namespace {

constexpr std::size_t most_rows = 5;  // of the compact list; more scroll

struct MixRow {
  const char* name;
  const char* tip;
  LayerMix mix;
};
constexpr std::array<MixRow, 6> mixes{{{"Replace", "The other paint instead of this", LayerMix::replace},
                                       {"Over", "The other paint on top of this", LayerMix::over},
                                       {"Under", "The other paint where this covers nothing", LayerMix::under},
                                       {"Subtract", "This paint comes off where the other covers", LayerMix::subtract},
                                       {"Intersect", "This paint stays only where the other covers", LayerMix::intersect},
                                       {"Maximum", "The greater value where both cover", LayerMix::maximum}}};

const char* icon_of(LayerKind kind) {
  switch (kind) {
    case LayerKind::resource:
      return icons::drop;
    case LayerKind::plant_density:
      return icons::leaf;
    case LayerKind::animal_density:
      return icons::paw;
    case LayerKind::geology:
      return icons::mountain;
    case LayerKind::loss:
      return icons::fire;
    case LayerKind::passage:
      return icons::ban;
    case LayerKind::ground:
      return icons::mountain;
  }
  return "";
}

std::optional<LayerMix> mix_entries(const Theme& theme) {
  std::optional<LayerMix> chosen;
  for (const MixRow& row : mixes) {
    if (ImGui::MenuItem(row.name)) chosen = row.mix;
    tooltip(theme, row.tip);
  }
  return chosen;
}

void draw_mix_menu(const UiContext& ui, const LayerId& layer) {
  EditorState& state = ui.state;
  if (!ImGui::BeginMenu("Mix in another layer")) return;
  bool any = false;
  for (const auto& [other, paint] : state.document.layers) {
    if (other == layer) continue;
    any = true;
    ImGui::PushID(other.name.c_str());
    ImGui::PushID(int(other.kind));
    if (ImGui::BeginMenu(layer_title(other, state.web()).c_str())) {
      if (const auto mix = mix_entries(ui.theme)) mix_layers(state, layer, other, *mix);
      ImGui::EndMenu();
    }
    ImGui::PopID();
    ImGui::PopID();
  }
  if (!any) ImGui::TextDisabled("There is no other paint");
  ImGui::EndMenu();
}

void draw_layer_menu(const UiContext& ui, const LayerId& layer) {
  EditorState& state = ui.state;
  const bool painted = state.document.layers.contains(layer);
  if (ImGui::MenuItem("Copy the paint", nullptr, false, painted)) copy_layer(state, layer);
  const std::string paste = state.copied ? "Paste " + state.copied->title : std::string("Paste");
  if (ImGui::BeginMenu(paste.c_str(), state.copied.has_value())) {
    if (const auto mix = mix_entries(ui.theme)) paste_layer(state, layer, *mix);
    ImGui::EndMenu();
  }
  draw_mix_menu(ui, layer);
  ImGui::Separator();
  if (ImGui::MenuItem("Import an image ...")) import_layer_image(state, layer);
  if (ImGui::MenuItem("Export the paint ...", nullptr, false, painted)) export_layer_paint(state, layer);
  if (ImGui::MenuItem("Export the map ...")) export_layer_map(state, layer);
  ImGui::Separator();
  if (ImGui::MenuItem("Take all paint off", nullptr, false, painted)) clear_paint(state, layer);
}

/// Eye, lock, back to computed and the menu of a row; true when the menu is asked for.
bool draw_row_buttons(const UiContext& ui, const LayerId& layer, const LayerState& now, ImVec2 at, ImVec2 size) {
  EditorState& state = ui.state;
  const Theme& theme = ui.theme;
  const float side = ImGui::GetFontSize() + theme.px(6);
  const float top = at.y + (size.y - side) / 2;
  const float right = at.x + size.x;
  const auto button = [&](float x, const char* id, const char* icon, const char* letter, const ImVec4& colour, const char* tip) {
    ImGui::SetCursorScreenPos(ImVec2(x, top));
    return icon_button(theme, id, theme.has_icons ? icon : letter, colour, tip);
  };
  if (button(at.x + theme.px(2), "eye", now.hidden ? icons::eye_closed : icons::eye, now.hidden ? "-" : "o",
             now.hidden ? with_alpha(theme.muted, 0.5F) : theme.muted,
             now.hidden ? "Let this paint count again" : "Hide: the paint is kept but does not count"))
    set_layer_hidden(state, layer, !now.hidden);
  if (button(at.x + theme.px(4) + side, "lock", now.locked ? icons::lock : icons::unlock, now.locked ? "x" : ".",
             now.locked ? theme.attention : with_alpha(theme.muted, 0.35F), now.locked ? "Unlock" : "Lock: no brush changes it"))
    set_layer_locked(state, layer, !now.locked);
  if (button(right - 2 * side - theme.px(4), "restore", icons::restore, "R", theme.muted, "Back to computed: take all paint off"))
    clear_paint(state, layer);
  return button(right - side - theme.px(2), "more", icons::more, ":", theme.muted, "Copy, paste, mix, import, export");
}

void draw_row(const UiContext& ui, const LayerId& layer, bool target) {
  EditorState& state = ui.state;
  const Theme& theme = ui.theme;
  const auto found = state.document.layer_states.find(layer);
  const LayerState now = found == state.document.layer_states.end() ? LayerState{} : found->second;
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const ImVec2 size(ImGui::GetContentRegionAvail().x, ImGui::GetFontSize() + theme.px(9));
  const float side = ImGui::GetFontSize() + theme.px(6);
  ImGui::PushID(layer.name.c_str());
  ImGui::PushID(int(layer.kind));
  if (ImGui::Selectable("##layer", target, ImGuiSelectableFlags_AllowItemOverlap, size)) choose_layer(state, layer);
  tooltip(theme, "Click to look at this layer and paint it; right-click for more");
  ImGui::SetItemAllowOverlap();
  const bool right_clicked = ImGui::IsItemHovered() && ImGui::IsMouseReleased(ImGuiMouseButton_Right);
  const bool asked = draw_row_buttons(ui, layer, now, at, size);
  if (asked || right_clicked) ImGui::OpenPopup("layer menu");
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const float top = at.y + (size.y - ImGui::GetFontSize()) / 2;
  const float icon_left = at.x + theme.px(10) + 2 * side;
  const float left = icon_left + (theme.has_icons ? theme.px(22) : 0);
  const float room = at.x + size.x - 2 * side - theme.px(8) - left;
  if (theme.has_icons) list.AddText(ImVec2(icon_left, top), colour_u32(theme.muted), icon_of(layer.kind));
  list.AddText(ImVec2(left, top), colour_u32(now.hidden ? theme.muted : theme.text),
               fitted_text(layer_title(layer, state.web()), room).c_str());
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, ImVec2(theme.px(8), theme.px(8)));
  ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, ImVec2(theme.px(8), theme.px(6)));
  if (ImGui::BeginPopup("layer menu")) {
    draw_layer_menu(ui, layer);
    ImGui::EndPopup();
  }
  ImGui::PopStyleVar(2);
  ImGui::SetCursorScreenPos(ImVec2(at.x, at.y + size.y + theme.px(1)));
  ImGui::Dummy(ImVec2(0, 0));
  ImGui::PopID();
  ImGui::PopID();
}

float row_height(const Theme& theme) { return ImGui::GetFontSize() + theme.px(10); }

/// The layers that hold paint and the one that is looked at, so that one can paste and import into it.
std::vector<LayerId> rows_of(const EditorState& state) {
  std::vector<LayerId> layers = listed_layers(state.document);
  const std::optional<LayerId> target = paint_target(state);
  if (target && std::find(layers.begin(), layers.end(), *target) == layers.end()) layers.push_back(*target);
  return layers;
}

void draw_rows(const UiContext& ui) {
  const std::optional<LayerId> target = paint_target(ui.state);
  ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, ImVec2(ui.theme.px(8), 0));
  for (const LayerId& layer : rows_of(ui.state)) draw_row(ui, layer, target && *target == layer);
  ImGui::PopStyleVar();
}

}  // namespace

float layers_height(const UiContext& ui) {
  const float line = ImGui::GetFrameHeightWithSpacing() + ui.theme.px(2);
  if (!ui.state.paint.layers_open) return line;
  const std::size_t rows = std::clamp<std::size_t>(rows_of(ui.state).size(), 1, most_rows);
  return line + float(rows) * row_height(ui.theme) + ui.theme.px(4);
}

void draw_layers_panel(const UiContext& ui, bool compact) {
  EditorState& state = ui.state;
  const std::size_t count = listed_layers(state.document).size();
  const std::string note = count == 0 ? "nothing painted" : std::to_string(count) + " painted";
  if (!compact) {
    heading(ui.theme, "Layers of paint");
    draw_rows(ui);
    return;
  }
  state.paint.layers_open = section(ui.theme, "Layers", note, false);
  if (!state.paint.layers_open) return;
  ImGui::BeginChild("layer rows");
  draw_rows(ui);
  ImGui::EndChild();
}

}  // namespace biotope

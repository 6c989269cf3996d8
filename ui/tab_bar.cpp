#include <algorithm>

#include "ui/editor_actions.hpp"
#include "ui/format.hpp"
#include "ui/icons.hpp"
#include "ui/parts.hpp"

namespace biotope {
namespace {

constexpr const char* tab_icons[tab_count] = {icons::mountain, icons::thermometer, icons::leaf,
                                              icons::paw,      icons::road,        icons::project};

/// What a tab shows of itself in the room there is.
enum class TabFace : std::uint8_t { icon, name, both };

void draw_tab(const UiContext& ui, Tab tab, TabFace face) {
  EditorState& state = ui.state;
  const Theme& theme = ui.theme;
  const bool chosen = state.view.tab == tab;
  std::string label(tab_title(tab));
  if (theme.has_icons && face == TabFace::both) label = std::string(tab_icons[std::size_t(tab)]) + "  " + label;
  if (theme.has_icons && face == TabFace::icon) label = std::string(tab_icons[std::size_t(tab)]) + "##" + label;
  ImGui::PushStyleColor(ImGuiCol_Button, ImVec4(0, 0, 0, 0));
  ImGui::PushStyleColor(ImGuiCol_Text, chosen ? theme.text : theme.muted);
  if (ImGui::Button(label.c_str())) state.view.tab = tab;
  ImGui::PopStyleColor(2);
  if (chosen) {
    const ImVec2 low = ImGui::GetItemRectMin();
    const ImVec2 high = ImGui::GetItemRectMax();
    ImGui::GetWindowDrawList()->AddRectFilled(ImVec2(low.x + theme.px(4), high.y + theme.px(1)),
                                              ImVec2(high.x - theme.px(4), high.y + theme.px(3)), colour_u32(theme.accent), 1);
  }
  const bool warns = tab == Tab::project && state.shown && (!state.shown->warnings.empty() || !state.shown->status);
  if (warns) {
    const ImVec2 corner(ImGui::GetItemRectMax().x - theme.px(3), ImGui::GetItemRectMin().y + theme.px(6));
    ImGui::GetWindowDrawList()->AddCircleFilled(corner, theme.px(3.5F),
                                                colour_u32(state.shown->status ? theme.attention : theme.loss), 16);
  }
  const std::string id = "tab." + std::to_string(int(tab) + 1);
  tooltip(theme, "Maps and tools about: " + std::string(tab_title(tab)), ui.commands.keys(id));
}

/// Entries of the tab's list, under a grey title where the species changes.
void draw_map_list(const UiContext& ui) {
  EditorState& state = ui.state;
  const FoodWeb* web = state.web();
  int species = -1;
  for (const MapEntry& entry : maps_of_tab(state.view.tab, web, -1)) {
    const auto layer = web == nullptr ? std::nullopt : layer_of_map(entry.id, *web);
    const bool of_species = layer && (layer->kind == LayerKind::plant_density || layer->kind == LayerKind::animal_density ||
                                      layer->kind == LayerKind::loss);
    std::string label = entry.title;
    if (of_species) {
      if (species != entry.id.item) {
        species = entry.id.item;
        ImGui::Separator();
        ImGui::TextDisabled("%s", display_name(web->species[std::size_t(species)]).c_str());
      }
      const std::size_t colon = label.rfind(": ");
      if (colon != std::string::npos) label = "   " + label.substr(colon + 2);
    }
    ImGui::PushID(int(entry.id.kind) * 1000 + entry.id.item);
    if (ImGui::Selectable(label.c_str(), shown_map(state) == entry.id)) show_map(state, entry.id);
    ImGui::PopID();
  }
}

/// The list of maps of the tab and, for monthly ones, the choice between the month and the year.
void draw_map_choice(const UiContext& ui, float width) {
  EditorState& state = ui.state;
  if (state.view.tab == Tab::project) return;
  const MapId shown = visible_map(state);
  const bool monthly =
      shown.kind == MapKind::illumination || shown.kind == MapKind::temperature || shown.kind == MapKind::moisture;
  const float month_width = monthly ? ui.theme.px(76) : 0;
  const std::string title = describe_map(shown, state.web()).title;
  ImGui::SetNextItemWidth(width - month_width - (monthly ? ui.theme.px(6) : 0));
  ImGui::SetNextWindowSizeConstraints(ImVec2(0, 0), ImVec2(ui.theme.px(420), ui.theme.px(520)));
  const std::string cut = fitted_text(title, width - month_width - ui.theme.px(44));
  if (ImGui::BeginCombo("##maps", cut.c_str(), ImGuiComboFlags_HeightLargest)) {
    draw_map_list(ui);
    ImGui::EndCombo();
  }
  tooltip(ui.theme, "The map over the terrain: " + title);
  if (!monthly) return;
  ImGui::SameLine(0, ui.theme.px(6));
  if (ImGui::Button(state.view.by_month ? short_month_name(state.clock.month).data() : "Year", ImVec2(month_width, 0))) {
    state.view.by_month = !state.view.by_month;
  }
  tooltip(ui.theme, state.view.by_month ? "Shows the clock's month; click for the yearly mean"
                                        : "Shows the yearly mean; click for the clock's month");
}

void draw_view_popup(const UiContext& ui) {
  EditorState& state = ui.state;
  if (ImGui::Button(ui.theme.has_icons ? icons::eye : "View")) ImGui::OpenPopup("shown");
  tooltip(ui.theme, "What is shown on the map and in 3D");
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, ImVec2(ui.theme.px(12), ui.theme.px(10)));
  if (ImGui::BeginPopup("shown")) {
    ImGui::PushItemWidth(ui.theme.px(210));
    labelled_slider(ui.theme, "Opacity of the map", state.view.opacity, 0, 1, format_percent(state.view.opacity));
    ImGui::Separator();
    for (const char* id :
         {"view.water", "view.contours", "view.trails", "view.herds", "view.plants", "view.hatch", "view.iso_lines"}) {
      const EditorCommand* command = ui.commands.find(id);
      bool on = checked(*command, state);
      if (ImGui::Checkbox(command->name.c_str(), &on)) run(*command, state);
    }
    ImGui::PopItemWidth();
    ImGui::Dummy(ImVec2(ui.theme.px(220), 0));
    ImGui::EndPopup();
  }
  ImGui::PopStyleVar();
}

/// A thin line along the lower edge while something is computed.
void draw_progress_line(const UiContext& ui, ImVec2 size) {
  const EditorState& state = ui.state;
  const WorkerProgress progress = state.worker ? state.worker->progress() : WorkerProgress{};
  const bool loading = state.loading.running();
  if (!progress.busy && !loading) return;
  const double fraction = loading ? state.loading.fraction() : progress.fraction;
  const ImVec2 origin = ImGui::GetWindowPos();
  const float top = origin.y + size.y - ui.theme.px(3);
  ImDrawList& list = *ImGui::GetWindowDrawList();
  list.AddRectFilled(ImVec2(origin.x, top), ImVec2(origin.x + size.x, origin.y + size.y), colour_u32(ui.theme.raised));
  const float width = size.x * float(std::clamp(fraction, 0.02, 1.0));
  list.AddRectFilled(ImVec2(origin.x, top), ImVec2(origin.x + width, origin.y + size.y), colour_u32(ui.theme.accent));
}

}  // namespace

void draw_tab_bar(const UiContext& ui, ImVec2 size) {
  const bool roomy = size.x > ui.theme.px(880);
  const TabFace face = roomy ? TabFace::both : size.x > ui.theme.px(640) ? TabFace::name : TabFace::icon;
  ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, ImVec2(ui.theme.px(roomy ? 4 : 0), 0));
  ImGui::PushStyleVar(ImGuiStyleVar_FramePadding, ImVec2(ui.theme.px(roomy ? 9 : 7), ui.theme.px(5)));
  for (int tab = 0; tab < tab_count; ++tab) {
    if (tab > 0) ImGui::SameLine();
    draw_tab(ui, Tab(tab), face);
  }
  ImGui::SameLine();
  const float eye = ui.theme.px(36);
  const float left = ImGui::GetCursorPosX();
  const float right = size.x - ui.theme.px(6);
  const float width = std::clamp(right - left - eye - ui.theme.px(16), ui.theme.px(90), ui.theme.px(320));
  ImGui::SetCursorPosX(right - width - eye - ui.theme.px(2));
  ImGui::PopStyleVar();
  draw_map_choice(ui, width);
  ImGui::SameLine(right - eye + ui.theme.px(4));
  draw_view_popup(ui);
  ImGui::PopStyleVar();
  draw_progress_line(ui, size);
}

}  // namespace biotope

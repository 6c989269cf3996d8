#include "ui/editor_window.hpp"

#include <algorithm>

#include "ui/editor_actions.hpp"
#include "ui/panels/food_chain.hpp"
#include "ui/panels/views_window.hpp"
#include "ui/parts.hpp"

namespace biotope {
namespace {

constexpr ImGuiWindowFlags fixed = ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoSavedSettings |
                                   ImGuiWindowFlags_NoBringToFrontOnFocus | ImGuiWindowFlags_NoNavFocus;

/// A part of the main window with its own background and padding.
bool begin_part(const char* name, ImVec2 at, ImVec2 size, const ImVec4& background, ImVec2 padding, ImGuiWindowFlags extra = 0) {
  ImGui::SetNextWindowPos(at);
  ImGui::SetNextWindowSize(size);
  ImGui::PushStyleColor(ImGuiCol_WindowBg, background);
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, padding);
  ImGui::PushStyleVar(ImGuiStyleVar_WindowRounding, 0);
  ImGui::PushStyleVar(ImGuiStyleVar_WindowMinSize, ImVec2(1, 1));
  const bool open = ImGui::Begin(name, nullptr, fixed | extra);
  ImGui::PopStyleVar(3);
  ImGui::PopStyleColor();
  return open;
}

/// An invisible bar between two parts that is dragged; returns by how many pixels.
float drag_bar(const char* id, ImVec2 size, const Theme& theme) {
  ImGui::InvisibleButton(id, size);
  const bool active = ImGui::IsItemActive();
  if (ImGui::IsItemHovered() || active) {
    ImGui::SetMouseCursor(ImGuiMouseCursor_ResizeEW);
    ImGui::GetWindowDrawList()->AddRectFilled(ImGui::GetItemRectMin(), ImGui::GetItemRectMax(),
                                              colour_u32(with_alpha(theme.accent, active ? 0.9F : 0.5F)));
  }
  return active ? ImGui::GetIO().MouseDelta.x : 0;
}

}  // namespace

Result<std::unique_ptr<EditorWindow>> EditorWindow::create() {
  auto map = MapCanvas::create();
  if (!map) return tl::unexpected(map.error());
  auto landscape = LandscapeCanvas::create();
  if (!landscape) return tl::unexpected(landscape.error());
  return std::unique_ptr<EditorWindow>(new EditorWindow(std::move(*map), std::move(*landscape)));
}

void EditorWindow::draw_views(const UiContext& ui, ImVec2 size) {
  EditorView& view = ui.state.view;
  mode_ = view.mode;
  if (view.mode == ViewMode::map) {
    map_->draw(ui, size);
    return;
  }
  if (view.mode == ViewMode::landscape) {
    landscape_->draw(ui, size);
    return;
  }
  const float bar = ui.theme.px(5);
  const float left = std::clamp(size.x * view.split, ui.theme.px(160), size.x - ui.theme.px(160));
  ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, ImVec2(0, 0));
  map_->draw(ui, ImVec2(left, size.y));
  ImGui::SameLine();
  const float moved = drag_bar("divider", ImVec2(bar, size.y), ui.theme);
  if (moved != 0 && size.x > 0) view.split = std::clamp((left + moved) / size.x, 0.1F, 0.9F);
  ImGui::SameLine();
  landscape_->draw(ui, ImVec2(size.x - left - bar, size.y));
  ImGui::PopStyleVar();
}

EditorWindow::Division EditorWindow::divided(const Theme& theme, ImVec2 screen, float menu) const {
  Division parts;
  parts.menu = menu;
  parts.status = theme.px(26);
  parts.tools = theme.px(44);
  parts.tabs = theme.px(42);
  parts.clock = theme.px(78);
  parts.inspector = std::clamp(inspector_width_ * theme.scale, theme.px(260), std::max(theme.px(260), screen.x * 0.38F));
  parts.middle = screen.y - menu - parts.status;
  parts.views = ImVec2(std::max(screen.x - parts.tools - parts.inspector, theme.px(120)),
                       std::max(parts.middle - parts.tabs - parts.clock, 32.0F));
  return parts;
}

void EditorWindow::draw_middle(const UiContext& ui, const Division& parts) {
  const Theme& theme = ui.theme;
  const float width = parts.views.x;
  begin_part("tools", ImVec2(0, parts.menu), ImVec2(parts.tools, parts.middle), theme.window, ImVec2(theme.px(6), theme.px(6)));
  draw_toolbar(ui);
  ImGui::End();
  begin_part("tabs", ImVec2(parts.tools, parts.menu), ImVec2(width, parts.tabs), theme.window, ImVec2(theme.px(6), theme.px(5)));
  draw_tab_bar(ui, ImVec2(width, parts.tabs));
  ImGui::End();
  begin_part("views", ImVec2(parts.tools, parts.menu + parts.tabs), parts.views, theme.window, ImVec2(0, 0),
             ImGuiWindowFlags_NoScrollWithMouse);
  draw_views(ui, parts.views);
  ImGui::End();
  begin_part("clock", ImVec2(parts.tools, parts.menu + parts.tabs + parts.views.y), ImVec2(width, parts.clock), theme.window,
             ImVec2(theme.px(10), theme.px(8)));
  draw_clock_bar(ui, ImVec2(width, parts.clock));
  ImGui::End();
}

void EditorWindow::draw_right(const UiContext& ui, const Division& parts) {
  const Theme& theme = ui.theme;
  const float left = parts.tools + parts.views.x;
  const float edge = theme.px(5);
  begin_part("inspector edge", ImVec2(left, parts.menu), ImVec2(edge, parts.middle), theme.panel, ImVec2(0, 0));
  inspector_width_ -= drag_bar("edge", ImVec2(edge, parts.middle), theme) / theme.scale;
  inspector_width_ = std::clamp(inspector_width_, 260.0F, 720.0F);
  ImGui::End();
  begin_part("inspector", ImVec2(left + edge, parts.menu), ImVec2(parts.inspector - edge, parts.middle), theme.panel,
             ImVec2(theme.px(10), theme.px(8)));
  draw_inspector(ui);
  ImGui::End();
}

void EditorWindow::draw(const UiContext& ui) {
  const Theme& theme = ui.theme;
  const ImVec2 screen = ImGui::GetIO().DisplaySize;
  const Division parts = divided(theme, screen, draw_menu_bar(ui));
  ui.state.pointer.over_map = false;
  landscape_->make_pictures(ui.state);
  draw_middle(ui, parts);
  draw_right(ui, parts);
  begin_part("status", ImVec2(0, screen.y - parts.status), ImVec2(screen.x, parts.status), theme.window,
             ImVec2(theme.px(10), theme.px(3)));
  draw_status_bar(ui, ImVec2(screen.x, parts.status));
  ImGui::End();

  draw_food_chain(ui);
  draw_views_window(ui);
  draw_export_card(ui);
  draw_dialogs(ui);
  if (ui.state.messages.empty()) import_.draw(ui);
  handle_shortcuts(ui, landscape_->takes_letters());
  post_edits(ui.state);
}

}  // namespace biotope

#include "ui/editor_window.hpp"

#include <algorithm>

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

void EditorWindow::draw(const UiContext& ui) {
  const Theme& theme = ui.theme;
  const ImVec2 screen = ImGui::GetIO().DisplaySize;
  const float menu = draw_menu_bar(ui);
  const float status = theme.px(26);
  const float tools = theme.px(44);
  const float tabs = theme.px(42);
  const float clock = theme.px(78);
  const float inspector = std::clamp(inspector_width_ * theme.scale, theme.px(260), std::max(theme.px(260), screen.x * 0.45F));
  const float middle = screen.y - menu - status;
  const float views = std::max(screen.x - tools - inspector, theme.px(120));
  ui.state.pointer.over_map = false;
  landscape_->make_pictures(ui.state);

  begin_part("tools", ImVec2(0, menu), ImVec2(tools, middle), theme.window, ImVec2(theme.px(6), theme.px(6)));
  draw_toolbar(ui);
  ImGui::End();
  begin_part("tabs", ImVec2(tools, menu), ImVec2(views, tabs), theme.window, ImVec2(theme.px(6), theme.px(5)));
  draw_tab_bar(ui, ImVec2(views, tabs));
  ImGui::End();
  const ImVec2 view_size(views, std::max(middle - tabs - clock, 32.0F));
  begin_part("views", ImVec2(tools, menu + tabs), view_size, theme.window, ImVec2(0, 0), ImGuiWindowFlags_NoScrollWithMouse);
  draw_views(ui, view_size);
  ImGui::End();
  begin_part("clock", ImVec2(tools, menu + tabs + view_size.y), ImVec2(views, clock), theme.window,
             ImVec2(theme.px(10), theme.px(8)));
  draw_clock_bar(ui, ImVec2(views, clock));
  ImGui::End();
  begin_part("inspector edge", ImVec2(tools + views, menu), ImVec2(theme.px(5), middle), theme.panel, ImVec2(0, 0));
  inspector_width_ -= drag_bar("edge", ImVec2(theme.px(5), middle), theme) / theme.scale;
  inspector_width_ = std::clamp(inspector_width_, 260.0F, 720.0F);
  ImGui::End();
  begin_part("inspector", ImVec2(tools + views + theme.px(5), menu), ImVec2(inspector - theme.px(5), middle), theme.panel,
             ImVec2(theme.px(10), theme.px(8)));
  draw_inspector(ui);
  ImGui::End();
  begin_part("status", ImVec2(0, screen.y - status), ImVec2(screen.x, status), theme.window, ImVec2(theme.px(10), theme.px(3)));
  draw_status_bar(ui, ImVec2(screen.x, status));
  ImGui::End();

  draw_food_chain(ui);
  draw_views_window(ui);
  draw_export_card(ui);
  draw_dialogs(ui);
  if (ui.state.messages.empty()) import_.draw(ui);
  handle_shortcuts(ui, landscape_->takes_letters());
}

}  // namespace biotope

#pragma once

#include <memory>

#include "ui/import_dialog.hpp"
#include "ui/landscape_canvas.hpp"
#include "ui/map_canvas.hpp"
#include "ui/widgets.hpp"

namespace biotope {

/// The whole editor inside one Dear ImGui frame: menus, tools, tabs, views, inspector, clock and status.
class EditorWindow {
 public:
  /// Needs a current OpenGL 4.5 context.
  [[nodiscard]] static Result<std::unique_ptr<EditorWindow>> create();

  /// Between ImGui::NewFrame and ImGui::Render.
  void draw(const UiContext& ui);
  [[nodiscard]] const LandscapeCanvas& landscape() const { return *landscape_; }
  /// True while the pictures are not yet what they will be.
  [[nodiscard]] bool refining() const {
    return (mode_ != ViewMode::landscape && map_->refining()) || (mode_ != ViewMode::map && landscape_->refining()) ||
           import_.busy() || landscape_->makes_pictures();
  }

 private:
  EditorWindow(std::unique_ptr<MapCanvas> map, std::unique_ptr<LandscapeCanvas> landscape)
      : map_(std::move(map)), landscape_(std::move(landscape)) {}
  /// How the window is divided, pixels.
  struct Division {
    float menu = 0, status = 0, tools = 0, tabs = 0, clock = 0, inspector = 0;
    float middle = 0;  ///< height between menu and status
    ImVec2 views;
  };
  [[nodiscard]] Division divided(const Theme& theme, ImVec2 screen, float menu) const;
  void draw_views(const UiContext& ui, ImVec2 size);
  /// Tools, tabs, views and clock.
  void draw_middle(const UiContext& ui, const Division& parts);
  /// The inspector and the edge that it is widened by.
  void draw_right(const UiContext& ui, const Division& parts);

  std::unique_ptr<MapCanvas> map_;
  std::unique_ptr<LandscapeCanvas> landscape_;
  ImportDialog import_;
  ViewMode mode_ = ViewMode::split;  ///< drawn last
  float inspector_width_ = 320;      ///< at scale 1
};

}  // namespace biotope

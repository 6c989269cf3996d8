#pragma once

#include <memory>

#include "core/exchange/dem_import.hpp"
#include "render/map_renderer.hpp"
#include "render/offscreen_context.hpp"
#include "ui/background_task.hpp"
#include "ui/widgets.hpp"

namespace biotope {

/// Shows what a terrain file holds, and how it will be read, before it replaces anything.
class ImportDialog {
 public:
  void draw(const UiContext& ui);
  /// True while a file is being looked at.
  [[nodiscard]] bool busy() const { return looking_.running(); }

 private:
  void look(const std::filesystem::path& file);
  void take_preview();
  void draw_picture(const UiContext& ui, float side);
  void draw_facts(const UiContext& ui) const;
  void draw_fields(const UiContext& ui);
  void draw_raw_fields(const UiContext& ui);
  [[nodiscard]] bool needs_cell_size() const;
  [[nodiscard]] DemImportOptions chosen(bool with_crop) const;
  void drag_crop(const MapView& view, ImVec2 at, float side);
  void draw_crop(const UiContext& ui, const MapView& view, ImVec2 at, float side) const;

  std::filesystem::path file_;
  BackgroundTask<DemPreview> looking_;
  std::optional<DemPreview> preview_;
  std::string problem_;
  std::shared_ptr<const MapsSnapshot> picture_;
  std::unique_ptr<MapRenderer> renderer_;
  std::unique_ptr<RenderTarget> target_;

  double cell_size_ = 0;  ///< metres; 0: the file's
  double vertical_scale_ = 1;
  int longer_side_ = 0;  ///< 0: as it is
  bool keep_voids_ = false;
  std::optional<Rect> crop_;  ///< cells of the file; nothing: all of it
  ImVec2 crop_from_;          ///< where the drag over the picture began
  bool is_raw_ = false;
  RawLayout raw_;
};

}  // namespace biotope

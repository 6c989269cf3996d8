#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "core/pipeline/maps_snapshot.hpp"
#include "render/gl_objects.hpp"
#include "render/map_picture.hpp"
#include "render/map_renderer.hpp"
#include "render/streamed_grid.hpp"

namespace biotope {

/// The map's ground on the graphics card: heights, relief and water, brought in a piece a frame.
class MapGround {
 public:
  void ask(const MapRequest& request);
  /// Takes what was made since and uploads what the budget allows; true when what is shown has changed.
  bool bring_in(UploadBudget& budget);
  void wait() { maker_.wait_idle(); }
  [[nodiscard]] bool complete() const { return !coming_ && idle_; }
  /// Null before the first.
  [[nodiscard]] const std::shared_ptr<const MapPicture>& shown() const { return shown_; }
  [[nodiscard]] GLuint heights() const { return heights_.texture().name(); }
  [[nodiscard]] GLuint relief() const { return relief_.texture().name(); }
  /// 0 where no water is known.
  [[nodiscard]] GLuint water() const { return water_.texture().name(); }

 private:
  void take(std::shared_ptr<const MapPicture> picture);
  bool upload(UploadBudget& budget);

  std::optional<MapRequest> asked_;
  std::shared_ptr<const MapPicture> shown_;
  std::shared_ptr<const MapPicture> coming_;
  bool idle_ = true;
  StreamedGrid<float> heights_;
  StreamedGrid<Rgba> relief_;
  StreamedGrid<Rg> water_;
  MapMaker maker_;
};

/// The values of a map, uploaded when the grid's pointer changes; until they are there the map before stays with its colours.
class OverlayTexture {
 public:
  /// True when what is shown has changed.
  bool bring_in(const MapOverlay& wanted, UploadBudget& budget);
  void patch(const Grid<float>& cells, const Rect& rect);
  [[nodiscard]] bool coming() const { return grid_.coming(); }
  /// The map whose values the texture holds.
  [[nodiscard]] const std::optional<MapOverlay>& shown() const { return shown_; }
  [[nodiscard]] const Texture& texture() const { return grid_.texture(); }

 private:
  StreamedGrid<float> grid_;
  std::shared_ptr<const Grid<float>> coming_cells_;
  std::optional<MapOverlay> shown_;
};

/// The coverage of a layer of paint; uploads the tiles whose pointers changed.
class PaintTexture {
 public:
  /// Returns the cells that have changed.
  Rect set(const PaintLayer& layer);
  void clear();
  [[nodiscard]] const Texture& texture() const { return texture_; }

 private:
  Texture texture_;
  int width_ = 0;
  int height_ = 0;
  std::vector<PaintLayer::TilePointer> tiles_;
};

/// A picture that is kept and copied while nothing in it changes.
class KeptPicture {
 public:
  /// Makes it of this size; what it held is lost when the size changes. True when it did.
  bool resize(int width, int height);
  /// Draws go into it from now on.
  void bind() const;
  /// Copies it whole into another framebuffer.
  void copy_to(GLuint framebuffer) const;

 private:
  Texture colour_;
  Framebuffer framebuffer_;
  int width_ = 0;
  int height_ = 0;
};

}  // namespace biotope

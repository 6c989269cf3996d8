#pragma once

#include <memory>
#include <optional>

#include "render/landscape_renderer.hpp"
#include "render/offscreen_context.hpp"

namespace biotope {

/// What water mirrors in a picture that is drawn in tiles: the plants of the whole picture, of which each tile sees only a part.
/// They are drawn once for all tiles of a picture, and not finer than waves let one see.
class WholeMirror {
 public:
  /// All that it follows from.
  struct Of {
    Camera camera;
    LandscapeOptions options;
    glm::ivec2 size{0};
    std::shared_ptr<const MapsSnapshot> maps;
    std::shared_ptr<const void> ground;
    bool operator==(const Of&) const = default;
  };
  [[nodiscard]] bool holds(const Of& of) const { return of_ == of; }
  /// Makes an empty target of it the one that is drawn into, over all of the viewport.
  void begin(Of of);
  /// Binds it as what water mirrors.
  void bind() const;
  void forget() { of_.reset(); }

 private:
  std::optional<Of> of_;
  std::unique_ptr<RenderTarget> target_;
};

}  // namespace biotope

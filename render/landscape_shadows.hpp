#pragma once

#include <array>
#include <optional>
#include <vector>

#include "core/base/status.hpp"
#include "render/animal_renderer.hpp"
#include "render/plant_shadows.hpp"
#include "render/shadow_map.hpp"

namespace biotope {

/// The pictures that the light sees of plants and animals around the eye. What stands in a cascade is drawn again only when its
/// picture would be another one; what moves is drawn in every frame. So a picture is the same whatever was drawn before it, but
/// for those that must keep a window's pace: there only some squares are drawn anew in a frame, and the others stay as they are,
/// where they are on the land.
class LandscapeShadows {
 public:
  /// Squares that a frame may draw anew where a window must keep its pace, and for one that may wait for all.
  static constexpr int most_in_window = 2;
  static constexpr int all = shadow_cascades;

  [[nodiscard]] static Result<LandscapeShadows> create();
  /// Chooses what of a view is drawn anew: of the squares that changed the nearest and then those that wait longest, `most` in
  /// all; those that never were are drawn in any case. Returns the view with the squares as they will be. Plants may be null, and
  /// must be prepared for the frame otherwise.
  ShadowView choose(const ShadowView& view, const PlantRenderer* plants, const PlantShadowLook& look, int most);
  /// Draws what was chosen and the animals, which must be prepared for the chosen view. The uniform block of the frame must be
  /// bound. The shadows are then bound for what is drawn with them.
  DrawCount draw(const PlantRenderer* plants, const AnimalRenderer& animals);
  /// Whether squares are left that a next frame must draw anew.
  [[nodiscard]] bool pending() const { return pending_; }
  /// Squares that the last frame drew anew.
  [[nodiscard]] int drawn_anew() const;

 private:
  /// What a square shows.
  struct Square {
    PlantShadowPicture picture;
    ShadowCascade cascade;
  };
  ShadowMap map_;
  PlantShadows plants_;
  /// The squares that are there, and for how many frames each has waited to be drawn anew.
  std::array<std::optional<Square>, shadow_cascades> standing_;
  std::array<int, shadow_cascades> waited_{};
  /// The view that was chosen, and what its squares become in this frame.
  ShadowView view_;
  std::array<std::optional<Square>, shadow_cascades> wanted_;
  bool pending_ = false;
};

}  // namespace biotope

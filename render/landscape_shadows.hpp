#pragma once

#include <array>
#include <optional>

#include "core/base/status.hpp"
#include "render/animal_renderer.hpp"
#include "render/plant_shadows.hpp"
#include "render/shadow_map.hpp"

namespace biotope {

/// The pictures that the light sees of plants and animals around the eye. What stands in a cascade is drawn again only when its
/// picture would be another one; what moves is drawn in every frame. So a picture is the same whatever was drawn before it.
class LandscapeShadows {
 public:
  [[nodiscard]] static Result<LandscapeShadows> create();
  /// Draws what is not there yet; without plants where these are null. Both must be prepared for the frame, and the uniform
  /// block of the frame bound. The shadows are then bound for what is drawn with them.
  DrawCount draw(const ShadowView& view, const PlantRenderer* plants, const PlantShadowLook& look, const AnimalRenderer& animals);

 private:
  ShadowMap map_;
  PlantShadows plants_;
  /// What the pictures are of that are there.
  std::array<std::optional<PlantShadowPicture>, shadow_cascades> standing_;
};

}  // namespace biotope

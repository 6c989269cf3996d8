#include "render/landscape_shadows.hpp"

#include <utility>

namespace biotope {

Result<LandscapeShadows> LandscapeShadows::create() {
  LandscapeShadows out;
  auto plants = PlantShadows::create();
  if (!plants) return tl::unexpected(plants.error());
  out.plants_ = std::move(*plants);
  return out;
}

DrawCount LandscapeShadows::draw(const ShadowView& view, const PlantRenderer* plants, const PlantShadowLook& look,
                                 const AnimalRenderer& animals) {
  const DrawnElsewhere elsewhere(shadow_texels, shadow_texels);
  DrawCount drawn;
  const auto count = [&](const DrawCount& part) {
    drawn.draw_calls += part.draw_calls;
    drawn.triangles += part.triangles;
  };
  map_.begin(view);
  for (int cascade = 0; cascade < shadow_cascades; ++cascade) {
    // Where nothing has a shadow nothing is read.
    if (view.strength <= 0) break;
    std::optional<PlantShadowPicture>& standing = standing_[std::size_t(cascade)];
    PlantShadowPicture wanted = plants != nullptr ? shadow_picture(*plants, look, view, cascade) : PlantShadowPicture();
    const bool anew = !standing || *standing != wanted;
    if (anew) {
      map_.open_standing(cascade);
      if (plants != nullptr) count(plants_.draw(*plants, wanted));
      standing = std::move(wanted);
    }
    map_.open_moving(cascade, anew, animals.shadow_box(cascade));
    count(animals.draw_shadows(cascade));
  }
  map_.end();
  return drawn;
}

}  // namespace biotope

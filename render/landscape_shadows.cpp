#include "render/landscape_shadows.hpp"

#include <algorithm>
#include <utility>

namespace biotope {

Result<LandscapeShadows> LandscapeShadows::create() {
  LandscapeShadows out;
  auto plants = PlantShadows::create();
  if (!plants) return tl::unexpected(plants.error());
  out.plants_ = std::move(*plants);
  return out;
}

ShadowView LandscapeShadows::choose(const ShadowView& view, const PlantRenderer* plants, const PlantShadowLook& look, int most) {
  view_ = view;
  pending_ = false;
  wanted_ = {};
  // Where nothing has a shadow nothing is read.
  if (view.strength <= 0) return view_;
  std::vector<std::size_t> changed;
  for (std::size_t c = 0; c < shadow_cascades; ++c) {
    PlantShadowPicture picture = plants != nullptr ? shadow_picture(*plants, look, view, int(c)) : PlantShadowPicture();
    if (!standing_[c] || standing_[c]->picture != picture) {
      wanted_[c] = Square{std::move(picture), view.cascades[c]};
      if (standing_[c]) changed.push_back(c);
      if (!standing_[c]) --most;
    }
    ++waited_[c];
    if (!wanted_[c] || !standing_[c]) waited_[c] = 0;
  }
  // The nearest stays the first, so that it is never old; the others take turns.
  if (changed.size() > 2)
    std::stable_sort(changed.begin() + 1, changed.end(), [&](std::size_t a, std::size_t b) { return waited_[a] > waited_[b]; });
  for (std::size_t i = 0; i < changed.size(); ++i) {
    const std::size_t c = changed[i];
    if (int(i) < most) {
      waited_[c] = 0;
      continue;
    }
    wanted_[c].reset();
    view_.cascades[c] = seen_from(standing_[c]->cascade, look.eye);
    pending_ = true;
  }
  return view_;
}

DrawCount LandscapeShadows::draw(const PlantRenderer* plants, const AnimalRenderer& animals) {
  const DrawnElsewhere elsewhere(shadow_texels, shadow_texels);
  DrawCount drawn;
  const auto count = [&](const DrawCount& part) {
    drawn.draw_calls += part.draw_calls;
    drawn.triangles += part.triangles;
  };
  map_.begin(view_);
  for (std::size_t c = 0; c < shadow_cascades && view_.strength > 0; ++c) {
    const bool anew = wanted_[c].has_value();
    if (anew) {
      map_.open_standing(int(c));
      if (plants != nullptr) count(plants_.draw(*plants, wanted_[c]->picture));
      standing_[c] = *wanted_[c];
    }
    map_.open_moving(int(c), anew, animals.shadow_box(int(c)));
    count(animals.draw_shadows(int(c)));
  }
  map_.end();
  return drawn;
}

int LandscapeShadows::drawn_anew() const {
  return int(std::count_if(wanted_.begin(), wanted_.end(), [](const auto& square) { return square.has_value(); }));
}

}  // namespace biotope

#pragma once

#include "core/document/document.hpp"
#include "render/landscape_renderer.hpp"

namespace biotope {

/// How full a sample is painted.
struct Crowding {
  float animals = 5;    ///< times as many of every kind as there are without paint
  float trees = 0.55F;  ///< share of the ground that they cover, in equal parts by species; 0: no paint
  float shrubs = 0.8F;  ///< the same
};
/// A sample with paint on the densities of its trees, shrubs and animals. Where plants stand, herds, trails and days follow from
/// that as from any paint. `solved` is the sample without paint.
[[nodiscard]] Document crowded(const MapsSnapshot& solved, const Crowding& crowding);

/// What a graphics card is asked to hold: a million plants and two thousand animals in one view. The processor's part of its
/// frames, standing, walking and flying; with GALLIUM_NOOP=true GALLIUM_THREAD=0 in the environment Mesa's driver draws nothing,
/// and what is left is ours and that of Mesa's front end.
void measure_big_scene(LandscapeRenderer& renderer, const std::shared_ptr<const MapsSnapshot>& snapshot, float quality, int width,
                       int height, int frames);

}  // namespace biotope

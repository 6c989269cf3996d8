#include "core/movement/trail_raster.hpp"

#include <algorithm>
#include <cmath>

namespace biotope {
namespace {

/// Depth of the most used trails, m. Our choice.
constexpr float deepest_carving = 0.3F;

float distance_to_segment(float x, float y, PathPoint a, PathPoint b) {
  const float dx = b.x - a.x;
  const float dy = b.y - a.y;
  const float squared = dx * dx + dy * dy;
  const float t = squared > 0 ? std::clamp(((x - a.x) * dx + (y - a.y) * dy) / squared, 0.0F, 1.0F) : 0.0F;
  return std::hypot(x - a.x - t * dx, y - a.y - t * dy);
}

/// Draws one piece of a trail; where trails overlap the more worn one counts.
void draw_segment(const Ground& ground, PathPoint a, PathPoint b, float weight, float wade_depth, TrailNetwork& network) {
  const auto cell = float(ground.terrain->cell_size);
  const float intensity = trail_intensity(weight);
  const float width = trail_width(weight) / cell;
  const float reach = 0.5F * width + 0.5F;
  const float share = std::min(1.0F, width);
  const Rect rect = intersection(network.wear.rect(),
                                 {int(std::floor(std::min(a.x, b.x) - reach)), int(std::floor(std::min(a.y, b.y) - reach)),
                                  int(std::ceil(std::max(a.x, b.x) + reach)) + 1, int(std::ceil(std::max(a.y, b.y) + reach)) + 1});
  for (int y = rect.y0; y < rect.y1; ++y) {
    for (int x = rect.x0; x < rect.x1; ++x) {
      const float covered = std::clamp(reach - distance_to_segment(float(x), float(y), a, b), 0.0F, 1.0F);
      if (covered <= 0 || (ground.hydrology && ground.hydrology->water_depth(x, y) > wade_depth)) continue;
      float& wear = network.wear(x, y);
      wear = std::max(wear, intensity * covered * share);
      float& carving = network.carving(x, y);
      carving = std::max(carving, deepest_carving * intensity * covered * share);
    }
  }
}

}  // namespace

float trail_intensity(float weight) {
  constexpr float fully_worn = 3e6F;
  return std::min(1.0F, std::sqrt(std::max(0.0F, weight) / fully_worn));
}

float trail_width(float weight) { return 0.5F + 2.0F * trail_intensity(weight); }

void draw_trails(const Ground& ground, std::span<const float> wade_depth, TrailNetwork& network) {
  assert(wade_depth.size() == network.routes.size());
  const auto& height = ground.terrain->height;
  network.wear = Grid<float>(height.width(), height.height(), 0.0F);
  network.carving = Grid<float>(height.width(), height.height(), 0.0F);
  for (std::size_t r = 0; r < network.routes.size(); ++r) {
    const TrailRoute& route = network.routes[r];
    for (std::size_t i = 0; i + 1 < route.points.size(); ++i) {
      draw_segment(ground, route.points[i], route.points[i + 1], 0.5F * (route.weight[i] + route.weight[i + 1]), wade_depth[r], network);
    }
  }
}

}  // namespace biotope

#include <algorithm>
#include <cmath>

#include "render/landscape_renderer.hpp"

namespace biotope {

float ground_height(const Terrain& terrain, double x, double y) {
  return sample_bilinear(terrain.height, x / terrain.cell_size - 0.5, terrain.height.height() - 0.5 - y / terrain.cell_size);
}

double height_above_surface(const MapsSnapshot& snapshot, const glm::dvec3& place) {
  const Terrain& terrain = snapshot.terrain();
  const double above = place.z - double(ground_height(terrain, place.x, place.y));
  if (!snapshot.hydrology || snapshot.hydrology->water_depth.rect() != terrain.height.rect()) return above;
  const Grid<float>& depth = snapshot.hydrology->water_depth;
  const int x = int(std::floor(place.x / terrain.cell_size));
  const int y = depth.height() - 1 - int(std::floor(place.y / terrain.cell_size));
  return above - double(depth.clamped(x, y));
}

std::optional<glm::dvec3> pick_ground(const Terrain& terrain, const glm::dvec3& origin, const glm::vec3& direction,
                                      double reach) {
  if (terrain.height.empty() || glm::length(direction) <= 0) return std::nullopt;
  const glm::dvec3 along = glm::normalize(glm::dvec3(direction));
  const auto at = [&](double t) { return origin + t * along; };
  const auto inside = [&](const glm::dvec3& p) {
    return p.x >= 0 && p.y >= 0 && p.x <= terrain.width_metres() && p.y <= terrain.height_metres();
  };
  const auto above = [&](const glm::dvec3& p) { return p.z - ground_height(terrain, p.x, p.y); };
  // Steps of half a cell never jump over a ridge; far above the ground they may be longer, since it rises no faster than a wall.
  const double step = 0.5 * terrain.cell_size;
  double before = 0;
  bool was_inside = inside(origin);
  if (was_inside && above(origin) <= 0) return std::nullopt;
  for (double t = step; t <= reach; t += step) {
    const glm::dvec3 p = at(t);
    const bool now_inside = inside(p);
    if (was_inside && !now_inside) return std::nullopt;
    if (now_inside && above(p) <= 0) {
      if (!was_inside) return std::nullopt;
      double low = before;
      double high = t;
      for (int i = 0; i < 30; ++i) {
        const double middle = 0.5 * (low + high);
        (above(at(middle)) > 0 ? low : high) = middle;
      }
      glm::dvec3 hit = at(high);
      hit.z = ground_height(terrain, hit.x, hit.y);
      return hit;
    }
    was_inside = now_inside;
    before = t;
  }
  return std::nullopt;
}

}  // namespace biotope

#include "ui/walking.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "render/landscape_renderer.hpp"

namespace biotope {
namespace {

constexpr double step_length = 0.5;   // m
constexpr double search_reach = 400;  // m
constexpr double settling_rate = 9;   // 1/s, of the eyes to their height
constexpr double radians_a_degree = 0.017453292519943295;

double height_at(const WalkingGround& ground, glm::dvec2 at) { return double(ground_height(ground.terrain, at.x, at.y)); }

bool inside(const Terrain& terrain, glm::dvec2 at) {
  return at.x >= 0 && at.y >= 0 && at.x <= terrain.width_metres() && at.y <= terrain.height_metres();
}

glm::dvec2 within(const Terrain& terrain, glm::dvec2 at) {
  return {std::clamp(at.x, 0.0, terrain.width_metres()), std::clamp(at.y, 0.0, terrain.height_metres())};
}

/// Rise / run of the ground around a place, in its steepest direction.
double steepness(const WalkingGround& ground, glm::dvec2 at) {
  constexpr double arm = 0.5;
  const double east = height_at(ground, {at.x + arm, at.y}) - height_at(ground, {at.x - arm, at.y});
  const double north = height_at(ground, {at.x, at.y + arm}) - height_at(ground, {at.x, at.y - arm});
  return std::hypot(east, north) / (2 * arm);
}

bool can_stand(const WalkingGround& ground, glm::dvec2 at) {
  return inside(ground.terrain, at) && water_depth(ground, at) < 0.05 && steepness(ground, at) < steepest_climb;
}

}  // namespace

double water_depth(const WalkingGround& ground, glm::dvec2 at) {
  if (ground.water == nullptr || ground.water->water_depth.empty()) return 0;
  const Grid<float>& depth = ground.water->water_depth;
  const double column = std::clamp(at.x / ground.terrain.cell_size - 0.5, 0.0, double(depth.width() - 1));
  const double row =
      std::clamp((ground.terrain.height_metres() - at.y) / ground.terrain.cell_size - 0.5, 0.0, double(depth.height() - 1));
  const int x = std::min(int(column), std::max(depth.width() - 2, 0));
  const int y = std::min(int(row), std::max(depth.height() - 2, 0));
  const int right = std::min(x + 1, depth.width() - 1);
  const int below = std::min(y + 1, depth.height() - 1);
  const double east = column - x;
  const double south = row - y;
  const double upper = double(depth(x, y)) * (1 - east) + double(depth(right, y)) * east;
  const double lower = double(depth(x, below)) * (1 - east) + double(depth(right, below)) * east;
  return upper * (1 - south) + lower * south;
}

bool can_step(const WalkingGround& ground, glm::dvec2 from, glm::dvec2 to) {
  if (!inside(ground.terrain, to)) return false;
  const double depth = water_depth(ground, to);
  if (depth > deepest_wading && depth >= water_depth(ground, from)) return false;
  const double length = std::max(glm::length(to - from), 1e-6);
  const double rise = (height_at(ground, to) - height_at(ground, from)) / length;
  if (rise > steepest_climb) return false;
  // Aslant one does not get up a face either.
  if (rise > 0.1 && steepness(ground, to) > steepest_descent) return false;
  if (rise >= -steepest_descent) return true;
  // Over an edge nobody goes; who is on a steep face already gets down it.
  const glm::dvec2 behind = from - (to - from) / length * step_length;
  return (height_at(ground, from) - height_at(ground, behind)) / step_length < -steepest_descent;
}

glm::dvec2 walked(const WalkingGround& ground, glm::dvec2 from, glm::dvec2 metres) {
  // Straight on, else along what is in the way: first where less of the walk is lost.
  static constexpr std::array<double, 7> aside{0, 25, -25, 50, -50, 75, -75};
  const int steps = std::max(1, int(std::ceil(glm::length(metres) / step_length)));
  const glm::dvec2 step = metres / double(steps);
  glm::dvec2 at = within(ground.terrain, from);
  for (int i = 0; i < steps; ++i) {
    for (const double degrees : aside) {
      const double cosine = std::cos(degrees * radians_a_degree);
      const double sine = std::sin(degrees * radians_a_degree);
      const glm::dvec2 turned = glm::dvec2(step.x * cosine - step.y * sine, step.x * sine + step.y * cosine) * cosine;
      if (!can_step(ground, at, at + turned)) continue;
      at += turned;
      break;
    }
  }
  return at;
}

glm::dvec2 standing_place(const WalkingGround& ground, glm::dvec2 near) {
  const glm::dvec2 start = within(ground.terrain, near);
  if (can_stand(ground, start)) return start;
  for (double radius = 1; radius < search_reach; radius *= 1.15) {
    constexpr int directions = 24;
    for (int i = 0; i < directions; ++i) {
      const double angle = i * 2 * 3.14159265358979 / directions;
      const glm::dvec2 at = start + radius * glm::dvec2(std::sin(angle), std::cos(angle));
      if (can_stand(ground, at)) return at;
    }
  }
  return start;
}

double eye_level(const WalkingGround& ground, glm::dvec2 at) {
  // Who came into deep water keeps the head above it.
  return height_at(ground, at) + std::max(eye_height, water_depth(ground, at) + 0.4);
}

Camera camera_on_foot(const WalkingGround& ground, const Camera& camera, double right, double ahead, double seconds) {
  const double heading = double(camera.heading) * radians_a_degree;
  const glm::dvec2 forward(std::sin(heading), std::cos(heading));
  const glm::dvec2 side(forward.y, -forward.x);
  const glm::dvec2 before(camera.position.x, camera.position.y);
  const glm::dvec2 after = walked(ground, before, forward * ahead + side * right);
  Camera next = camera;
  const double wanted = eye_level(ground, after);
  const double settled = camera.position.z + (wanted - camera.position.z) * (1 - std::exp(-settling_rate * seconds));
  // Smooth, yet never under the ground on the way up.
  next.position = {after.x, after.y, std::max(settled, height_at(ground, after) + 0.5 * eye_height)};
  if (std::abs(next.position.z - wanted) < 0.002) next.position.z = wanted;
  return next;
}

}  // namespace biotope

#include "ui/camera_motion.hpp"

#include <algorithm>
#include <cmath>

#include "render/landscape_renderer.hpp"
#include "ui/walking.hpp"

namespace biotope {
namespace {

constexpr float steepest = 88;  // degrees
constexpr double radians_a_degree = 0.017453292519943295;

/// Degrees brought into 0..360.
float heading_of(float degrees) {
  const float rest = std::fmod(degrees, 360.0F);
  return rest < 0 ? rest + 360 : rest;
}

}  // namespace

glm::vec3 ray_through(const Camera& camera, PixelPoint canvas, PixelPoint pixel) {
  const glm::vec3 forward = camera.forward();
  const glm::vec3 right = camera.right();
  const glm::vec3 up = glm::cross(right, forward);
  const float half = std::tan(camera.vertical_field * 0.5F * float(radians_a_degree));
  const float x = float((pixel.x - canvas.x / 2) / (canvas.y / 2)) * half;
  const float y = float((canvas.y / 2 - pixel.y) / (canvas.y / 2)) * half;
  return glm::normalize(forward + right * x + up * y);
}

std::optional<PixelPoint> pixel_of(const Camera& camera, PixelPoint canvas, const glm::dvec3& place) {
  const glm::dvec3 offset = place - camera.position;
  const glm::dvec3 forward(camera.forward());
  const glm::dvec3 right(camera.right());
  const double away = glm::dot(offset, forward);
  if (away < 0.1) return std::nullopt;
  const double scale = canvas.y / 2 / (away * std::tan(camera.vertical_field * 0.5 * radians_a_degree));
  return PixelPoint{canvas.x / 2 + glm::dot(offset, right) * scale,
                    canvas.y / 2 - glm::dot(offset, glm::cross(right, forward)) * scale};
}

Camera turned(const Camera& camera, float right, float up) {
  Camera next = camera;
  next.heading = heading_of(camera.heading + right);
  next.pitch = std::clamp(camera.pitch + up, -steepest, steepest);
  return next;
}

Camera orbited(const Camera& camera, const glm::dvec3& around, float right, float up) {
  const glm::dvec3 arm = camera.position - around;
  const double distance = glm::length(arm);
  if (distance < 1e-6) return turned(camera, right, up);
  // The arm in the camera's own axes stays as it is while those axes turn.
  const auto axes = [](const Camera& c) {
    const glm::dvec3 forward(c.forward());
    const glm::dvec3 side(c.right());
    return std::array<glm::dvec3, 3>{side, forward, glm::cross(side, forward)};
  };
  const auto before = axes(camera);
  Camera next = camera;
  next.heading = heading_of(camera.heading + right);
  // An orbit looks at the ground: it never swings up to the sky, where there is nothing to turn around.
  next.pitch = std::clamp(camera.pitch + up, -steepest, std::max(camera.pitch, -4.0F));
  const auto after = axes(next);
  next.position = around;
  for (std::size_t axis = 0; axis < 3; ++axis) next.position += after[axis] * glm::dot(arm, before[axis]);
  return next;
}

Camera moved(const Camera& camera, double right, double forward, double up) {
  Camera next = camera;
  next.position += glm::dvec3(camera.right()) * right + glm::dvec3(camera.forward()) * forward + glm::dvec3(0, 0, up);
  return next;
}

Camera kept_over_ground(const Camera& camera, const Terrain& terrain, double clearance, const Hydrology* water) {
  Camera next = camera;
  const double reach = 2 * std::max(terrain.width_metres(), terrain.height_metres());
  next.position.x = std::clamp(next.position.x, -reach, terrain.width_metres() + reach);
  next.position.y = std::clamp(next.position.y, -reach, terrain.height_metres() + reach);
  const double x = std::clamp(next.position.x, 0.0, terrain.width_metres());
  const double y = std::clamp(next.position.y, 0.0, terrain.height_metres());
  const double ground = ground_height(terrain, x, y) + water_depth({terrain, water}, {x, y});
  next.position.z = std::clamp(next.position.z, ground + clearance, ground + 3 * reach);
  return next;
}

PathPoint cell_of(const Terrain& terrain, const glm::dvec3& place) {
  return {float(place.x / terrain.cell_size - 0.5), float((terrain.height_metres() - place.y) / terrain.cell_size - 0.5)};
}

glm::dvec3 place_of(const Terrain& terrain, PathPoint cell) {
  const double x = (double(cell.x) + 0.5) * terrain.cell_size;
  const double y = terrain.height_metres() - (double(cell.y) + 0.5) * terrain.cell_size;
  return {x, y, double(ground_height(terrain, x, y))};
}

}  // namespace biotope

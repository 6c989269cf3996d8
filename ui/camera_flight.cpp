#include "ui/camera_flight.hpp"

#include <algorithm>
#include <cmath>

#include "render/landscape_renderer.hpp"
#include "ui/camera_motion.hpp"

namespace biotope {
namespace {

constexpr double radians_a_degree = 0.017453292519943295;

/// How much of the line from an eye to a place lies free over the ground, 0..1.
double seen_share(const Terrain& terrain, const glm::dvec3& eye, const glm::dvec3& place) {
  constexpr int steps = 24;
  int free = 0;
  for (int i = 1; i < steps; ++i) {
    const glm::dvec3 at = eye + (place - eye) * (double(i) / steps);
    if (at.z > double(ground_height(terrain, at.x, at.y)) + 0.3) ++free;
  }
  return double(free) / (steps - 1);
}

}  // namespace

float shortest_turn(float from, float to) {
  const float turn = std::fmod(to - from, 360.0F);
  if (turn > 180) return turn - 360;
  return turn < -180 ? turn + 360 : turn;
}

Camera camera_on_flight(const CameraFlight& flight) {
  const double part = std::clamp(flight.elapsed / flight_seconds, 0.0, 1.0);
  if (part >= 1) return flight.to;
  const double eased = part * part * part * (part * (part * 6 - 15) + 10);
  Camera camera = flight.to;
  const glm::dvec3 way = flight.to.position - flight.from.position;
  camera.position = flight.from.position + way * eased;
  // Hills lie between far places: the middle of the way is higher.
  camera.position.z += 4 * eased * (1 - eased) * 0.12 * std::hypot(way.x, way.y);
  const auto share = float(eased);
  const float heading = flight.from.heading + shortest_turn(flight.from.heading, flight.to.heading) * share;
  camera.heading = heading < 0 ? heading + 360 : heading >= 360 ? heading - 360 : heading;
  camera.pitch = flight.from.pitch + (flight.to.pitch - flight.from.pitch) * share;
  camera.vertical_field = flight.from.vertical_field + (flight.to.vertical_field - flight.from.vertical_field) * share;
  return camera;
}

Camera view_of_place(const Terrain& terrain, const glm::dvec3& place, double distance, const Camera& before,
                     const Clearness& clearness, double slant) {
  constexpr int sides = 16;
  Camera best = before;
  double most = -1;
  for (int i = 0; i < sides; ++i) {
    // 0, +1, -1, +2, -2 ...: the sides nearest to the one looked from come first.
    const int side = (i + 1) / 2 * (i % 2 == 1 ? 1 : -1);
    const double heading = (double(before.heading) + side * 360.0 / sides) * radians_a_degree;
    const double away = distance * std::cos(slant * radians_a_degree);
    Camera camera = before;
    camera.position = place - glm::dvec3(std::sin(heading) * away, std::cos(heading) * away, 0);
    camera.position.z = place.z + distance * std::sin(slant * radians_a_degree);
    camera = kept_over_ground(camera, terrain, 2);
    const glm::dvec3 arm = place - camera.position;
    camera.heading = turned(camera, float(std::atan2(arm.x, arm.y) / radians_a_degree) - camera.heading, 0).heading;
    camera.pitch = std::clamp(float(std::atan2(arm.z, std::hypot(arm.x, arm.y)) / radians_a_degree), -80.0F, 10.0F);
    const double steep = std::abs(double(camera.pitch) + slant) / 90;
    const double clear = clearness ? clearness(camera.position) : 1;
    const double score = seen_share(terrain, camera.position, place) * (0.2 + 0.8 * clear) - 0.5 * steep;
    if (score <= most + 0.05) continue;
    most = score;
    best = camera;
  }
  return best;
}

}  // namespace biotope

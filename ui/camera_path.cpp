#include "ui/camera_path.hpp"

#include <algorithm>
#include <cmath>

#include "ui/camera_flight.hpp"

namespace biotope {
namespace {

constexpr double same_moment = 0.01;  // s

/// What is interpolated of a view: x, y, z, heading (degrees, not wrapped), pitch, field.
using Values = std::array<double, 6>;

Values values_of(const Camera& camera) {
  return {camera.position.x,      camera.position.y,    camera.position.z,
          double(camera.heading), double(camera.pitch), double(camera.vertical_field)};
}

/// The keys' values with headings that go on instead of jumping at north.
std::vector<Values> unwrapped(const CameraPath& path) {
  std::vector<Values> values;
  for (const CameraKey& key : path.keys) {
    Values next = values_of(key.camera);
    if (!values.empty()) {
      const double before = values.back()[3];
      next[3] = before + double(shortest_turn(float(before), key.camera.heading));
    }
    values.push_back(next);
  }
  return values;
}

/// Change a second at a key: of the line between its neighbours.
double slope_at(const CameraPath& path, const std::vector<Values>& values, std::size_t key, std::size_t which) {
  const std::size_t before = key == 0 ? 0 : key - 1;
  const std::size_t after = std::min(key + 1, values.size() - 1);
  const double seconds = path.keys[after].seconds - path.keys[before].seconds;
  return seconds > 0 ? (values[after][which] - values[before][which]) / seconds : 0;
}

Camera camera_of(const Values& values) {
  Camera camera;
  camera.position = {values[0], values[1], values[2]};
  const double heading = std::fmod(values[3], 360.0);
  camera.heading = float(heading < 0 ? heading + 360 : heading);
  camera.pitch = float(std::clamp(values[4], -89.0, 89.0));
  camera.vertical_field = float(std::clamp(values[5], 5.0, 120.0));
  return camera;
}

}  // namespace

double path_seconds(const CameraPath& path) {
  return path.keys.size() < 2 ? 0 : path.keys.back().seconds - path.keys.front().seconds;
}

Camera camera_on_path(const CameraPath& path, double seconds) {
  if (path.keys.empty()) return {};
  const double moment = path.keys.front().seconds + seconds;
  if (moment <= path.keys.front().seconds) return path.keys.front().camera;
  if (moment >= path.keys.back().seconds) return path.keys.back().camera;
  const auto after = std::upper_bound(path.keys.begin(), path.keys.end(), moment,
                                      [](double value, const CameraKey& key) { return value < key.seconds; });
  const auto next = std::size_t(after - path.keys.begin());
  const std::size_t from = next - 1;
  const double length = path.keys[next].seconds - path.keys[from].seconds;
  const double t = (moment - path.keys[from].seconds) / length;
  const std::vector<Values> values = unwrapped(path);
  Values now{};
  for (std::size_t i = 0; i < now.size(); ++i) {
    // Cubic Hermite: both ends' values and speeds.
    const double m0 = slope_at(path, values, from, i) * length;
    const double m1 = slope_at(path, values, next, i) * length;
    const double t2 = t * t;
    const double t3 = t2 * t;
    now[i] =
        (2 * t3 - 3 * t2 + 1) * values[from][i] + (t3 - 2 * t2 + t) * m0 + (3 * t2 - 2 * t3) * values[next][i] + (t3 - t2) * m1;
  }
  return camera_of(now);
}

double hour_on_path(const CameraPath& path, double seconds, double standing) {
  if (!path.hours) return standing;
  const double length = path_seconds(path);
  const double part = length > 0 ? std::clamp(seconds / length, 0.0, 1.0) : 0;
  const auto [from, to] = *path.hours;
  const double until = to < from ? to + 24 : to;
  const double hour = from + (until - from) * part;
  return hour > 24 ? hour - 24 : hour;
}

int frame_count(const CameraPath& path, double frames_a_second) {
  const double length = path_seconds(path);
  return length > 0 ? int(std::floor(length * frames_a_second + 1e-6)) + 1 : 0;
}

void set_key(CameraPath& path, const CameraKey& key) {
  std::erase_if(path.keys, [&](const CameraKey& other) { return std::abs(other.seconds - key.seconds) < same_moment; });
  const auto after = std::upper_bound(path.keys.begin(), path.keys.end(), key.seconds,
                                      [](double value, const CameraKey& other) { return value < other.seconds; });
  path.keys.insert(after, key);
}

}  // namespace biotope

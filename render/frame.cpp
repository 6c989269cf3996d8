#include "render/frame.hpp"

#include <algorithm>
#include <cmath>
#include <glm/gtc/matrix_transform.hpp>

namespace biotope {

Frustum::Frustum(const glm::mat4& m) {
  const auto row = [&](int i) { return glm::vec4(m[0][i], m[1][i], m[2][i], m[3][i]); };
  planes_ = {row(3) + row(0), row(3) - row(0), row(3) + row(1), row(3) - row(1), row(3) + row(2), row(3) - row(2)};
  for (glm::vec4& plane : planes_) plane /= glm::length(glm::vec3(plane));
}

bool Frustum::meets_sphere(const glm::vec3& centre, float radius) const {
  for (const glm::vec4& plane : planes_) {
    if (glm::dot(glm::vec3(plane), centre) + plane.w < -radius) return false;
  }
  return true;
}

bool Frustum::meets_box(const glm::vec3& low, const glm::vec3& high) const {
  for (const glm::vec4& plane : planes_) {
    const glm::vec3 farthest(plane.x > 0 ? high.x : low.x, plane.y > 0 ? high.y : low.y, plane.z > 0 ? high.z : low.z);
    if (glm::dot(glm::vec3(plane), farthest) + plane.w < 0) return false;
  }
  return true;
}

glm::mat4 view_projection(const Camera& camera, float aspect, float near_plane, float far_plane) {
  const glm::vec3 forward = camera.forward();
  const glm::vec3 up = glm::cross(camera.right(), forward);
  const glm::mat4 view = glm::lookAt(glm::vec3(0), forward, up);
  return glm::perspective(glm::radians(camera.vertical_field), aspect, near_plane, far_plane) * view;
}

void set_view(FrameUniforms& frame, const Camera& camera, int width, int height, float near_plane, float far_plane) {
  const float aspect = float(width) / float(height);
  const float tangent = std::tan(0.5F * glm::radians(camera.vertical_field));
  frame.view_projection = view_projection(camera, aspect, near_plane, far_plane);
  frame.eye = glm::vec4(glm::vec3(camera.position), 0.5F * float(height) / tangent);
  frame.camera_forward = glm::vec4(camera.forward(), tangent);
  frame.camera_right = glm::vec4(camera.right(), aspect);
  frame.camera_up = glm::vec4(glm::cross(camera.right(), camera.forward()), 0);
}

void set_light(FrameUniforms& frame, const Daylight& light, int month) {
  frame.light_direction = glm::vec4(light.light_direction, light.night);
  frame.light_colour = glm::vec4(light.light_colour, float(month));
  frame.sun_direction = glm::vec4(light.sun_direction, 0);
  frame.ambient_sky = glm::vec4(light.ambient_sky, 0);
  frame.ambient_ground = glm::vec4(light.ambient_ground, 0);
  frame.horizon = glm::vec4(light.horizon, 0);
  frame.zenith = glm::vec4(light.zenith, 0);
}

void set_weather(FrameUniforms& frame, const Weather& weather, double seconds) {
  const float wetness = weather.precipitation > 0 ? std::min(1.0F, 0.5F + weather.precipitation) : 0.0F;
  frame.weather = {weather.cloud, weather.precipitation, weather.fog, wetness};
  // It blows from where it comes: the other way round.
  const float from = glm::radians(weather.wind_direction);
  frame.wind = {-weather.wind * std::sin(from), -weather.wind * std::cos(from), float(seconds), 0};
}

}  // namespace biotope

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

void set_light(FrameUniforms& frame, const Daylight& light, double latitude, int month) {
  frame.light_direction = glm::vec4(light.light_direction, light.night);
  frame.light_colour = glm::vec4(light.light_colour, float(month));
  frame.sun_direction = glm::vec4(light.sun_direction, 0);
  frame.ambient_sky = glm::vec4(light.ambient_sky, 0);
  frame.ambient_ground = glm::vec4(light.ambient_ground, 0);
  frame.horizon = glm::vec4(light.horizon, 0);
  frame.zenith = glm::vec4(light.zenith, 0);
  frame.moon = glm::vec4(light.moon.direction, light.moon.lit);
  const float phi = glm::radians(float(latitude));
  frame.stars = {light.sidereal, std::sin(phi), std::cos(phi), light.sharpness};
  // Shadows of single clouds fade where the sky closes, and where the light comes so low that they would lie far away.
  const float single = light.sharpness * glm::smoothstep(0.06F, 0.30F, light.light_direction.z) * (1 - light.night);
  frame.glow = glm::vec4(light.glow, 0.72F * single);
  frame.fall.w = light.exposure;
}

void set_weather(FrameUniforms& frame, const Weather& weather, double seconds) {
  const float wetness = weather.precipitation > 0 ? std::min(1.0F, 0.5F + weather.precipitation) : 0.0F;
  frame.weather = {weather.cloud, weather.precipitation, weather.fog, wetness};
  // It blows from where it comes: the other way round.
  const double from = glm::radians(double(weather.wind_direction));
  const glm::dvec2 wind = -double(weather.wind) * glm::dvec2(std::sin(from), std::cos(from));
  frame.wind = {float(wind.x), float(wind.y), float(seconds), 0};
  // Up there it blows harder than at the ground.
  const glm::dvec2 drift = 2.5 * wind * seconds;
  frame.clouds = {float(drift.x), float(drift.y), frame.clouds.z, weather.cloud};
}

void set_air(FrameUniforms& frame, const Weather& weather, const AirLayer& air) {
  const float relief = air.highest - air.lowest;
  // Haze takes half the light over about 1.7 times the map's side, at most 12 km: far ridges are veiled but there.
  // From above one looks through thinner air at the whole of it.
  const float lifted = std::clamp(air.above / air.extent, 0.0F, 1.0F);
  const float low = std::clamp(1.7F * air.extent, 3000.0F, 12000.0F);
  const float clear = low + lifted * (std::max(4.5F * low, 5.0F * air.extent) - low);
  // Fog: sight (2 % of contrast left: Koschmieder's 3.912) shrinks by the same factor for every step, to 60 m.
  const float sight = 60.0F * std::pow(25000.0F / 60.0F, 1 - weather.fog);
  const float scale_height =
      glm::mix(std::max(300.0F, 1.2F * relief), std::max(110.0F, 0.22F * relief), std::min(1.0F, 1.5F * weather.fog));
  const float fog = weather.fog > 0 ? 3.912F / sight : 0.0F;
  frame.fog.x = 0.693F / clear + fog;
  frame.fog.y = 1.0F / scale_height;
  frame.fog.z = air.lowest;
  frame.clouds.z = std::max(air.lowest + 1400.0F, air.highest + 500.0F) - 500.0F * weather.precipitation;
}

void set_snow(FrameUniforms& frame, const SnowLine& line, const SnowfallHeight& fall, double latitude, const Weather& weather) {
  frame.fall.x = float(fall.height);
  frame.fall.y = float(fall.spread);
  // Where snow is falling it lies, whatever the month has left.
  double height = line.height;
  if (weather.precipitation > 0) height = std::min(height, fall.height + 0.5 * fall.spread);
  const bool any = weather.snow_cover && height < 0.5 * no_snow_line;
  frame.snow = {float(height), float(line.spread), float(latitude < 0 ? -line.aspect : line.aspect), any ? 1.0F : 0.0F};
}

}  // namespace biotope

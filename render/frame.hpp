#pragma once

#include <array>
#include <glm/glm.hpp>

#include "core/climate/snow_cover.hpp"
#include "render/camera.hpp"
#include "render/daylight.hpp"
#include "render/weather.hpp"

namespace biotope {

/// What every shader of the landscape reads (uniform block `Frame` of shaders/landscape/frame.glsl, std140).
struct FrameUniforms {
  glm::mat4 view_projection{1};  ///< of positions relative to the eye
  glm::vec4 eye{0};              ///< metres; w: pixels per radian
  glm::vec4 light_direction{0};  ///< w: night 0..1
  glm::vec4 light_colour{0};     ///< w: month as a float
  glm::vec4 sun_direction{0};
  glm::vec4 ambient_sky{0};
  glm::vec4 ambient_ground{0};
  glm::vec4 horizon{0};  ///< w: column of the whole picture that is the first of the part which is drawn
  glm::vec4 zenith{0};   ///< w: row of it
  glm::vec4 fog{0};      ///< extinction 1/m at the base height, 1/scale height, base height, quality
  glm::vec4 terrain{0};  ///< width, height (m), cell size (m), lowest ground (m)
  glm::vec4 camera_right{0};
  glm::vec4 camera_up{0};
  glm::vec4 camera_forward{0};  ///< w: tangent of half the vertical field
  glm::vec4 shade_area{0};      ///< canopy shade texture: west, south, side in metres, strength
  glm::vec4 weather{0};         ///< cloud 0..1, precipitation 0..1, fog 0..1, wetness of the ground 0..1
  glm::vec4 wind{0};            ///< m/s to the east and to the north; z: seconds of animation
  /// Height of the snow line (m), its spread (m), metres it lies lower on slopes that look north (negative in the south); w: 1
  /// where there is any.
  glm::vec4 snow{0};
  glm::vec4 fall{0};    ///< height where half of what falls is snow (m), spread (m); w: exposure
  glm::vec4 moon{0};    ///< toward the moon; w: share of its disc that is lit
  glm::vec4 stars{0};   ///< sidereal angle, sine and cosine of the latitude; w: share of the sun's disc that clouds leave
  glm::vec4 glow{0};    ///< light of the air around the sun; w: how much a cloud's shadow takes of direct light
  glm::vec4 clouds{0};  ///< drift to the east and north (m), height of their base (m), share of the sky
};
inline constexpr unsigned frame_binding = 0;

/// The six half-spaces a camera sees, for culling. Positions in metres relative to the eye.
class Frustum {
 public:
  Frustum() = default;
  explicit Frustum(const glm::mat4& view_projection);
  /// False only when the sphere lies wholly outside.
  [[nodiscard]] bool meets_sphere(const glm::vec3& centre, float radius) const;
  /// False only when the box lies wholly outside one side.
  [[nodiscard]] bool meets_box(const glm::vec3& low, const glm::vec3& high) const;

 private:
  std::array<glm::vec4, 6> planes_{};
};

/// View and projection of positions relative to the eye; `near` and `far` in metres.
[[nodiscard]] glm::mat4 view_projection(const Camera& camera, float aspect, float near_plane, float far_plane);

/// Fills the camera's and the light's part.
void set_view(FrameUniforms& frame, const Camera& camera, int width, int height, float near_plane, float far_plane);
void set_light(FrameUniforms& frame, const Daylight& light, double latitude, int month);
void set_weather(FrameUniforms& frame, const Weather& weather, double seconds);

/// Height and fog of the air: `lowest` and `highest` ground (m), `extent` the longer side of the map (m), `above` the eye's
/// height over the ground (m).
struct AirLayer {
  float lowest = 0;
  float highest = 1;
  float extent = 1000;
  float above = 2;
};
void set_air(FrameUniforms& frame, const Weather& weather, const AirLayer& air);
/// Snow on the ground and the height where rain turns into it. `latitude` in degrees. Call after set_view.
void set_snow(FrameUniforms& frame, const SnowLine& line, const SnowfallHeight& fall, double latitude, const Weather& weather);

}  // namespace biotope

// What every landscape shader knows: FrameUniforms of render/frame.hpp.
layout(std140, binding = 0) uniform Frame {
  mat4 view_projection;
  vec4 eye;
  vec4 light_direction;
  vec4 light_colour;
  vec4 sun_direction;
  vec4 ambient_sky;
  vec4 ambient_ground;
  vec4 horizon;
  vec4 zenith;
  vec4 fog;
  vec4 terrain;
  vec4 camera_right;
  vec4 camera_up;
  vec4 camera_forward;
  vec4 shade_area;
  vec4 weather;
  vec4 wind;
  vec4 snow;
  vec4 fall;
  vec4 moon;
  vec4 stars;
  vec4 glow;
  vec4 clouds;
} frame;

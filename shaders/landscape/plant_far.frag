#version 450 core
#include "landscape/frame.glsl"
#include "landscape/atmosphere.glsl"
#include "landscape/plant_dither.glsl"
#include "landscape/snow.glsl"
layout(binding = 9) uniform sampler2DArray pictures;
layout(binding = 10) uniform sampler2DArray surfaces;
uniform float picture_side;
in vec3 picture;
flat in vec3 sun;
flat in vec2 skyward;
flat in vec4 tone;
flat in float back;
flat in vec2 shown;
flat in float snow;
flat in float bare;
in vec4 veil;
out vec4 colour;

void main() {
  vec4 base = texture(pictures, picture);
  vec2 across = fwidth(picture.xy) * picture_side;
  float level = max(0.0, log2(max(across.x, across.y)));
  float threshold = dither();
  // Bare crowns are thinner than a pixel: where they cover some of it, they are seen.
  float least = mix(0.5 / (1.0 + 0.14 * level), 0.22, bare);
  if (base.a < least || threshold < shown.x || threshold >= shown.y) discard;
  vec4 surface = texture(surfaces, picture);
  vec3 normal = normalize(surface.xyz / max(base.a, 0.05) * 2.0 - 1.0);
  float open = surface.a / max(base.a, 0.05);
  vec3 plain = base.rgb / max(base.a, 0.05);
  float facing = dot(normal, sun);
  float direct = max((facing + 0.22) / 1.22, 0.0) * open * (0.70 + 0.30 * open);
  float through = 0.34 * back * max(0.45 - facing, 0.0) * open;
  float rise = dot(normal.yz, skyward);
  vec3 ambient = mix(frame.ambient_ground.rgb, frame.ambient_sky.rgb, 0.5 + 0.5 * rise) * (0.42 + 0.58 * open);
  vec3 light = frame.light_colour.rgb * tone.w * (direct + through * vec3(1.1, 1.0, 0.5)) + ambient;
  vec3 leaf = mix(plain * plain * tone.rgb, snow_albedo, snow * smoothstep(-0.1, 0.8, rise));
  vec3 lit = leaf * light;
  colour = vec4(to_screen(mix(lit, veil.rgb, veil.a)), 1.0);
}

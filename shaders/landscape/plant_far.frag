#version 450 core
#include "landscape/frame.glsl"
#include "landscape/atmosphere.glsl"
#include "landscape/snow.glsl"
layout(binding = 9) uniform sampler2DArray pictures;
layout(binding = 10) uniform sampler2DArray surfaces;
uniform float picture_side;
in vec3 picture;
flat in vec3 sun;
flat in vec2 skyward;
flat in float shaded;
flat in vec4 tone;
flat in float back;
flat in vec2 shown;
flat in vec4 clumps;  // across and up, where the crown begins, the plant's own
flat in float snow;
flat in float bare;
flat in float view;
in vec4 veil;
out vec4 colour;

void main() {
  // Clumps of leaves go over one by one, a trunk at once: to and from meshes, and from one view to the next.
  vec2 clump = floor(picture.xy * clumps.xy);
  float turn = picture.y < clumps.z ? 0.5 : fract(dot(clump, vec2(0.75487767, 0.56984029)) + clumps.w);
  vec3 at = vec3(picture.xy, picture.z + floor(view) + step(fract(7.0 * turn), fract(view) - 1e-3));
  vec4 base = texture(pictures, at);
  vec2 across = fwidth(picture.xy) * picture_side;
  float level = max(0.0, log2(max(across.x, across.y)));
  // Bare crowns are thinner than a pixel: where they cover some of it, they are seen.
  float least = mix(0.5 / (1.0 + 0.14 * level), 0.22, bare);
  if (base.a < least || turn < shown.x || turn >= shown.y) discard;
  vec4 surface = texture(surfaces, at);
  vec3 normal = normalize(surface.xyz / max(base.a, 0.05) * 2.0 - 1.0);
  float open = surface.a / max(base.a, 0.05);
  vec3 plain = base.rgb / max(base.a, 0.05);
  float facing = dot(normal, sun);
  float direct = max((facing + 0.22) / 1.22, 0.0) * open * (0.70 + 0.30 * open);
  float through = 0.44 * back * max(0.45 - facing, 0.0) * open;
  float rise = dot(normal.yz, skyward);
  vec3 ambient = mix(frame.ambient_ground.rgb, frame.ambient_sky.rgb, 0.5 + 0.5 * rise) * (0.50 + 0.50 * open);
  vec3 light = frame.light_colour.rgb * (tone.w * (1.0 - shaded * (1.0 - smoothstep(0.25, 0.80, picture.y)))) * (direct + through * vec3(1.15, 1.05, 0.45) + frame.light_direction.z * (1.0 - open) * vec3(0.050, 0.072, 0.020)) + ambient;
  vec3 leaf = mix(plain * plain * tone.rgb, snow_albedo, snow * smoothstep(-0.1, 0.8, rise));
  vec3 lit = leaf * light;
  colour = vec4(to_screen(mix(lit, veil.rgb, veil.a)), 1.0);
}

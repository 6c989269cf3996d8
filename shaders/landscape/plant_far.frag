#version 450 core
#include "landscape/frame.glsl"
#include "landscape/atmosphere.glsl"
layout(binding = 9) uniform sampler2DArray pictures;
layout(binding = 10) uniform sampler2DArray surfaces;
uniform float picture_side;
in vec3 picture;
flat in vec3 sun;
flat in vec2 skyward;
flat in vec4 tone;
flat in float back;
in vec4 veil;
out vec4 colour;

void main() {
  vec4 base = texture(pictures, picture);
  vec2 across = fwidth(picture.xy) * picture_side;
  float level = max(0.0, log2(max(across.x, across.y)));
  if (base.a * (1.0 + 0.14 * level) < 0.5) discard;
  vec4 surface = texture(surfaces, picture);
  vec3 normal = normalize(surface.xyz / max(base.a, 0.05) * 2.0 - 1.0);
  float open = surface.a / max(base.a, 0.05);
  vec3 plain = base.rgb / max(base.a, 0.05);
  float facing = dot(normal, sun);
  float direct = max((facing + 0.22) / 1.22, 0.0) * open;
  float through = 0.22 * back * max(0.4 - facing, 0.0) * open;
  float rise = dot(normal.yz, skyward);
  vec3 ambient = mix(frame.ambient_ground.rgb, frame.ambient_sky.rgb, 0.5 + 0.5 * rise) * (0.22 + 0.78 * open);
  vec3 light = frame.light_colour.rgb * tone.w * (direct + through * vec3(1.1, 1.0, 0.5)) + ambient;
  vec3 lit = plain * plain * tone.rgb * light;
  colour = vec4(to_screen(mix(lit, veil.rgb, veil.a)), 1.0);
}

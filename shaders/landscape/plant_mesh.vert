#version 450 core
#include "landscape/frame.glsl"
#include "landscape/atmosphere.glsl"
#include "landscape/ground.glsl"
#include "landscape/plant_light.glsl"
layout(location = 0) in vec3 position;
layout(location = 1) in vec3 normal;
layout(location = 2) in vec2 card_uv;
layout(location = 3) in vec4 material;  // picture, open, fall, leaf
layout(location = 4) in vec4 stands;    // foot, scale
layout(location = 5) in vec4 own;       // turn, tint, rank, plant
layout(binding = 6) uniform sampler2D sunlit;
layout(binding = 7) uniform sampler2D canopy_shade;
uniform float under_crowns;  // 1 for what grows in the shade of others
uniform float bare;
uniform float bloom;
out vec3 card;
out vec3 light;
out vec3 tone;
out vec4 veil;

void main() {
  float c = cos(own.x);
  float s = sin(own.x);
  mat2 turned = mat2(c, s, -s, c);
  vec3 at = position * stands.w;
  vec3 offset = stands.xyz - frame.eye.xyz + vec3(turned * at.xy, at.z);
  vec3 upward = vec3(turned * normal.xy, normal.z);
  vec3 view = normalize(offset);
  float sun = textureLod(sunlit, ground_uv(stands.xy), 0.0).r;
  if (under_crowns > 0.5 && frame.shade_area.w > 0.0) {
    vec2 shaded = (stands.xy - frame.shade_area.xy) / frame.shade_area.z;
    sun *= 1.0 - frame.shade_area.w * textureLod(canopy_shade, shaded, 0.0).r;
    // Lit as the ground is, so that tufts do not stand out of it.
    upward = normalize(mix(upward, vec3(0.0, 0.0, 1.0), 0.85));
    sun *= max(frame.light_direction.z, 0.0) / max((frame.light_direction.z + 0.22) / 1.22, 0.02);
  }
  light = foliage_light(upward, view, material.y, sun);
  tone = material.w > 0.5 ? own_tone(own.y) : vec3(0.8 + 0.4 * own.y);
  card = vec3(card_uv, material.x);
  float amount = haze(offset);
  veil = vec4(apply_haze(vec3(0.0), offset, 1.0), amount);
  gl_Position = frame.view_projection * vec4(offset, 1.0);
  // Where leaves have fallen, twigs are left (picture 8).
  if (material.z < bare) card.z = 8.0;
  // Flowers (picture 7) that are not out are not drawn.
  if (material.x > 6.5 && fract(own.y * 13.7) >= bloom) gl_Position = vec4(2.0, 2.0, 2.0, 1.0);
}

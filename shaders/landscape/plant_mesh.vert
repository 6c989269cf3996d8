#version 450 core
#include "landscape/frame.glsl"
#include "landscape/atmosphere.glsl"
#include "landscape/clouds.glsl"
#include "landscape/ground.glsl"
#include "landscape/shade.glsl"
#include "landscape/plant_kinds.glsl"
#include "landscape/plant_light.glsl"
#include "landscape/plant_lod.glsl"
#include "landscape/plant_wind.glsl"
#include "landscape/snow.glsl"
#include "landscape/plant_snow.glsl"
layout(location = 0) in vec3 position;
layout(location = 1) in vec3 normal;
layout(location = 2) in vec2 card_uv;
layout(location = 3) in vec4 material;  // picture, open, fall, leaf
layout(location = 4) in vec4 stands;    // foot, scale
layout(location = 5) in vec4 own;       // turn, tint, rank, plant
layout(binding = 6) uniform sampler2D sunlit;
uniform vec3 wood_colour;
uniform vec3 high_wood_colour;
uniform vec2 level;  // height on the screen in pixels from which a finer mesh is drawn, and from which this one is
out vec3 card;
out vec3 leaf_tone;
out vec3 wood_tone;
out vec4 veil;
#ifdef WITH_SHADOWS
out vec3 light;
out vec3 direct;     // what of the light the sun sends
out vec4 in_shadow;  // relative to the eye; w: share of the sun that is thought to come here
flat out float nearer;
#endif

void main() {
  int plant = int(own.w + 0.5);
  float height = kinds.form[plant].y * stands.w;
  vec3 foot = stands.xyz - frame.eye.xyz;
  float pixels = seen_pixels(foot, height, own.z);
  float turn = turn_of_card(material.z, own.y);
  bool shown = turn >= level_share(level.x, pixels) && turn < level_share(level.y, pixels);

  float c = cos(own.x);
  float s = sin(own.x);
  mat2 turned = mat2(c, s, -s, c);
  vec3 at = position * stands.w;
  at.xy = turned * at.xy;
  vec3 stand = own_stand(own.y);
  at.z *= stand.z;
  at.xy += stand.xy * at.z;
  at += sway(at, height, stands.xy, material.w, fract(material.z), own.y);
  vec3 offset = foot + at;
  vec3 upward = vec3(turned * normal.xy, normal.z);
  bool bare = material.z < own_bare(plant, own.y);
  float open = bare ? mix(material.y, 1.0, 0.6) : material.y;
  // Among other crowns little sun comes down to the lower parts.
  float shade = drawn_shade(stands.xy + at.xy - toward_light_on_ground() * at.z).x;
  float up = clamp(position.z / kinds.form[plant].y, 0.0, 1.0);
  float sun = textureLod(sunlit, ground_uv(stands.xy), 0.0).r * cloud_light(stands.xy, stands.z);
  float past_crowns = 1.0 - 0.85 * shade * (1.0 - smoothstep(0.25, 0.85, up) * smoothstep(1.0, 4.0, height));
#ifdef WITH_SHADOWS
  vec3 view = normalize(offset);
  light = foliage_light(upward, view, open, 0.0);
  direct = foliage_light(upward, view, open, sun) - light;
  in_shadow = vec4(offset, past_crowns);
  // A crown's own shade is painted on its leaves.
  nearer = material.w > 0.5 ? 0.6 * kinds.form[plant].x * stands.w : 0.35;
#else
  vec3 light = foliage_light(upward, normalize(offset), open, sun * past_crowns);
#endif
  // Every card a little lighter or darker than its neighbours.
  float card_tone = 0.84 + 0.32 * fract(material.z * 7.77);
  leaf_tone = own_leaf(plant, own.y) * own_tone(own.y) * card_tone;
  wood_tone = mix(wood_colour, high_wood_colour, smoothstep(0.3, 0.65, up)) * (0.8 + 0.4 * own.y);
  float snow = crown_snow(stands.z, upward, plant, own.y) * smoothstep(0.2, 0.6, open);
  leaf_tone = mix(leaf_tone, snow_albedo, snow);
  wood_tone = mix(wood_tone, snow_albedo, 0.5 * snow);
  // Where leaves have fallen, twigs are left (picture 8): dark whatever the bark.
  card = vec3(card_uv, material.x);
  if (bare) card.z = 8.0;
  if (material.w > 0.5) wood_tone = min(wood_tone, vec3(0.095, 0.083, 0.075));
#ifndef WITH_SHADOWS
  leaf_tone *= light;
  wood_tone *= light;
#endif
  // Twigs are thinner than the dots that show them: what is behind them shines through, the more the farther they are.
  float thin = bare && material.w > 0.5 ? smoothstep(4.0, 45.0, length(foot)) : 0.0;
  veil = vec4(haze_colour(offset), mix(haze(offset), 1.0, 0.05 * thin));
  gl_Position = shown ? frame.view_projection * vec4(offset, 1.0) : vec4(2.0, 2.0, 2.0, 1.0);
}

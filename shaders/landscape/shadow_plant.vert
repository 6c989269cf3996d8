#version 450 core
// A mesh of a plant as the light sees it; stands as in plant_mesh.vert.
#include "landscape/frame.glsl"
#include "landscape/plant_kinds.glsl"
#include "landscape/plant_light.glsl"
#define WIND_SECONDS moment
uniform float moment;  // of the leaves, s
#include "landscape/plant_wind.glsl"
#include "landscape/shadow_view.glsl"
layout(location = 0) in vec3 position;
layout(location = 2) in vec2 card_uv;
layout(location = 3) in vec4 material;  // picture, open, fall, leaf
layout(location = 4) in vec4 stands;    // foot, scale
layout(location = 5) in vec4 own;       // turn, tint, rank, plant
uniform int cascade;
uniform vec3 origin;  // place of the land, m
uniform vec4 square;  // from there: middle, half side, depth of the middle
out vec3 card;

void main() {
  int plant = int(own.w + 0.5);
  float height = kinds.form[plant].y * stands.w;
  float c = cos(own.x);
  float s = sin(own.x);
  vec3 at = position * stands.w;
  at.xy = mat2(c, s, -s, c) * at.xy;
  vec3 stand = own_stand(own.y);
  at.z *= stand.z;
  at.xy += stand.xy * at.z;
  at += sway(at, height, stands.xy, material.w, fract(material.z), own.y);
  card = vec3(card_uv, material.z < own_bare(plant, own.y) ? 8.0 : material.x);
  vec3 seen = in_light(cascade, stands.xyz - origin + at);
  gl_Position = vec4((seen.xy - square.xy) / square.z, (square.w - seen.z) * shadows.right[cascade].w, 1.0);
}

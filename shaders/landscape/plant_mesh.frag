#version 450 core
#include "landscape/frame.glsl"
#include "landscape/atmosphere.glsl"
#include "landscape/plant_dither.glsl"
layout(binding = 8) uniform sampler2DArray leaves;
in vec3 card;
in vec3 light;
in vec3 leaf_tone;
in vec3 wood_tone;
in vec4 veil;
flat in vec2 shown;
out vec4 colour;

void main() {
  vec4 leaf = texture(leaves, card);
  float threshold = dither();
  if (leaf.a < 0.5 || threshold < shown.x || threshold >= shown.y) discard;
  vec3 lit = mix(leaf_tone, wood_tone, leaf.b) * light * (2.0 * leaf.r);
  colour = vec4(to_screen(mix(lit, veil.rgb, veil.a)), 1.0);
}

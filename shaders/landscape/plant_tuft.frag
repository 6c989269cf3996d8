#version 450 core
#include "landscape/frame.glsl"
#include "landscape/atmosphere.glsl"
#include "landscape/plant_dither.glsl"
layout(binding = 8) uniform sampler2DArray leaves;
in vec3 card;
in vec3 tone;
in vec3 flower_tone;
in vec4 veil;
flat in vec2 shown;
out vec4 colour;

void main() {
  // Sharper than a mean would be: blades stay blades.
  vec4 leaf = texture(leaves, card, -0.8);
  float threshold = dither();
  if (leaf.a < 0.5 || threshold < shown.x || threshold >= shown.y) discard;
  vec3 lit = mix(tone, flower_tone, leaf.g) * (2.0 * leaf.r);
  colour = vec4(to_screen(mix(lit, veil.rgb, veil.a)), 1.0);
}

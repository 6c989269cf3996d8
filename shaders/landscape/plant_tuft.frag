#version 450 core
#include "landscape/frame.glsl"
#include "landscape/atmosphere.glsl"
layout(binding = 8) uniform sampler2DArray leaves;
in vec3 card;
in vec3 tone;
in vec3 flower_tone;
in vec4 veil;
out vec4 colour;

void main() {
  // Sharper than a mean would be: blades stay blades.
  vec4 leaf = texture(leaves, card, -0.8);
  if (leaf.a < 0.5) discard;
  vec3 lit = mix(tone, flower_tone, leaf.g) * (2.0 * leaf.r);
  colour = vec4(to_screen(mix(lit, veil.rgb, veil.a)), 1.0);
}

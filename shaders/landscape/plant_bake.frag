#version 450 core
#include "landscape/frame.glsl"
#include "landscape/plant_light.glsl"
layout(binding = 8) uniform sampler2DArray leaves;
in vec3 card;
in vec3 leaf_tone;
in vec3 wood_tone;
in vec4 facing;
layout(location = 0) out vec4 colour;
layout(location = 1) out vec4 surface;

void main() {
  vec4 leaf = texture(leaves, card);
  if (leaf.a < 0.5) discard;
  vec3 base = mix(leaf_tone * yellowed_leaf(leaf.g), wood_tone, leaf.b) * (2.0 * leaf.r);
  colour = vec4(sqrt(clamp(base, 0.0, 1.0)), 1.0);
  surface = vec4(normalize(facing.xyz) * 0.5 + 0.5, facing.w);
}

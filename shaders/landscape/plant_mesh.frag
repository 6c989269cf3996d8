#version 450 core
#include "landscape/frame.glsl"
#include "landscape/atmosphere.glsl"
layout(binding = 8) uniform sampler2DArray leaves;
uniform vec3 leaf_colour;
uniform vec3 wood_colour;
uniform vec3 flower_colour;
in vec3 card;
in vec3 light;
in vec3 tone;
in vec4 veil;
out vec4 colour;

void main() {
  vec4 leaf = texture(leaves, card);
  // Mipmaps thin out what they average: keep cards as dense from afar as they are from near.
  vec2 across = fwidth(card.xy) * 128.0;
  float level = max(0.0, log2(max(across.x, across.y)));
  if (leaf.a * (1.0 + 0.14 * level) < 0.5) discard;
  float covered = max(leaf.a, 0.2);
  // Twigs (picture 8) are dark whatever the bark.
  vec3 wood = card.z > 7.5 ? min(wood_colour, vec3(0.105, 0.080, 0.063)) : wood_colour;
  vec3 base = mix(mix(leaf_colour, flower_colour, min(leaf.g / covered, 1.0)), wood, min(leaf.b / covered, 1.0));
  vec3 lit = base * tone * light * (2.0 * leaf.r / covered);
  colour = vec4(to_screen(mix(lit, veil.rgb, veil.a)), 1.0);
}

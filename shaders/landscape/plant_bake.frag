#version 450 core
layout(binding = 8) uniform sampler2DArray leaves;
uniform vec3 leaf_colour;
uniform vec3 wood_colour;
uniform vec3 flower_colour;
in vec3 card;
in vec4 facing;
layout(location = 0) out vec4 colour;
layout(location = 1) out vec4 surface;

void main() {
  vec4 leaf = texture(leaves, card);
  if (leaf.a < 0.3) discard;
  float covered = max(leaf.a, 0.2);
  // Twigs (picture 8) are dark whatever the bark.
  vec3 wood = card.z > 7.5 ? min(wood_colour, vec3(0.105, 0.080, 0.063)) : wood_colour;
  vec3 base = mix(mix(leaf_colour, flower_colour, min(leaf.g / covered, 1.0)), wood, min(leaf.b / covered, 1.0));
  colour = vec4(sqrt(clamp(base * (2.0 * leaf.r / covered), 0.0, 1.0)), 1.0);
  surface = vec4(normalize(facing.xyz) * 0.5 + 0.5, facing.w);
}

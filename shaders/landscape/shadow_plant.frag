#version 450 core
layout(binding = 8) uniform sampler2DArray leaves;
in vec3 card;
void main() {
  if (texture(leaves, card).a < 0.5) discard;
}

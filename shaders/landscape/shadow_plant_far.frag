#version 450 core
layout(binding = 9) uniform sampler2DArray pictures;
in vec3 picture;
void main() {
  if (texture(pictures, picture).a < 0.4) discard;
}

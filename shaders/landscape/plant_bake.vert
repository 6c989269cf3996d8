#version 450 core
layout(location = 0) in vec3 position;
layout(location = 1) in vec3 normal;
layout(location = 2) in vec2 card_uv;
layout(location = 3) in vec4 material;
uniform mat4 projection;
uniform vec3 right;
uniform vec3 up;
uniform vec3 toward;
uniform float bare;
out vec3 card;
out vec4 facing;  // normal in the picture's frame, open

void main() {
  card = vec3(card_uv, material.x);
  facing = vec4(dot(normal, right), dot(normal, up), dot(normal, toward), material.y);
  gl_Position = projection * vec4(position, 1.0);
  // Where leaves have fallen, twigs are left (picture 8).
  if (material.z < bare) card.z = 8.0;
}

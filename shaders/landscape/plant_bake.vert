#version 450 core
#include "landscape/plant_kinds.glsl"
layout(location = 0) in vec3 position;
layout(location = 1) in vec3 normal;
layout(location = 2) in vec2 card_uv;
layout(location = 3) in vec4 material;
uniform mat4 projection;
uniform vec3 right;
uniform vec3 up;
uniform vec3 toward;
uniform int plant;
uniform vec3 wood_colour;
uniform vec3 high_wood_colour;
uniform vec3 leaf_colour;
out vec3 card;
out vec3 leaf_tone;
out vec3 wood_tone;
out vec4 facing;  // normal in the picture's frame, open

void main() {
  card = vec3(card_uv, material.x);
  bool bare = material.z < kinds.fresh[plant].w;
  float open = bare ? mix(material.y, 1.0, 0.6) : material.y;
  facing = vec4(dot(normal, right), dot(normal, up), dot(normal, toward), open);
  gl_Position = projection * vec4(position, 1.0);
  leaf_tone = leaf_colour * (0.84 + 0.32 * fract(material.z * 7.77));
  wood_tone = mix(wood_colour, high_wood_colour, smoothstep(0.3, 0.65, position.z / kinds.form[plant].y));
  // Where leaves have fallen, twigs are left (picture 8): dark whatever the bark.
  if (bare) card.z = 8.0;
  if (material.w > 0.5) wood_tone = min(wood_tone, vec3(0.098, 0.087, 0.080));
}

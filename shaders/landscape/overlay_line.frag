#version 450 core
in vec2 place;
in float nearness;
in vec2 ribbon;   // pixels across and along
in vec3 widths;   // half of the line's, half with its casing, a dash
in vec4 colour;
in vec4 casing;
uniform vec2 planes;  // 1 / near, 1 / far
layout(binding = 0) uniform sampler2D depths;
out vec4 seen;

// How faint a hidden line is, and how long its dots are in pixels.
const float faint = 0.42;
const float dot_length = 4.0;

void main() {
  float depth = texture(depths, place).r;
  float scene = 1.0 / mix(planes.x, planes.y, depth);
  float line = 1.0 / nearness;
  // A line lies on the ground, in the grass: what is only just before it does not hide it.
  float behind = line - scene - (1.2 + 0.015 * line);
  float hidden = smoothstep(0.0, 0.6 + 0.01 * line, behind);
  float away = abs(ribbon.x);
  float core = clamp(widths.x - away + 0.5, 0.0, 1.0);
  float whole = clamp(widths.y - away + 0.5, 0.0, 1.0);
  if (widths.z > 0.0 && mod(ribbon.y, 2.0 * widths.z) > widths.z) core = 0.0;
  float alpha = mix(casing.a * whole, colour.a, core);
  bool gap = mod(ribbon.y, 2.0 * dot_length) > dot_length;
  alpha *= mix(1.0, gap ? 0.0 : faint, hidden);
  seen = vec4(mix(casing.rgb, colour.rgb, core), alpha);
}

#version 450 core
layout(location = 0) out vec4 colour;
in float across;
flat in float half_width;
in vec4 shown;
uniform vec4 override_colour;  // its alpha > 0 replaces the tone

void main() {
  // A line thinner than a pixel covers only that share of it.
  float inside = clamp(half_width + 0.5 - abs(across), 0.0, 1.0) * clamp(2.0 * half_width, 0.0, 1.0);
  vec4 tone = override_colour.a > 0.0 ? vec4(override_colour.rgb, override_colour.a * shown.a) : shown;
  colour = vec4(tone.rgb, tone.a * inside);
}

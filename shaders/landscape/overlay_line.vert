#version 450 core
// Ribbons of lines over the picture: render/overlay_lines.hpp.
layout(location = 0) in vec2 pixel;
layout(location = 1) in vec3 nearness_across_along;
layout(location = 2) in vec3 widths_dash;
layout(location = 3) in vec4 line_colour;
layout(location = 4) in vec4 line_casing;
uniform vec2 size;
out vec2 place;
out float nearness;
out vec2 ribbon;
out vec3 widths;
out vec4 colour;
out vec4 casing;
void main() {
  place = vec2(pixel.x / size.x, 1.0 - pixel.y / size.y);
  nearness = nearness_across_along.x;
  ribbon = nearness_across_along.yz;
  widths = widths_dash;
  colour = line_colour;
  casing = line_casing;
  gl_Position = vec4(place * 2.0 - 1.0, 0.0, 1.0);
}

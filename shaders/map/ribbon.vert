#version 450 core
// A polyline as a band of constant width on screen, at least as wide as the thing is on the ground.
layout(location = 0) in vec2 cell;
layout(location = 1) in vec2 normal;    // unit normal times miter, pointing to this side
layout(location = 2) in float side;     // -1 or 1
layout(location = 3) in float strength; // 0..1: how much use, water or youth
layout(location = 4) in float metres;   // width on the ground
layout(location = 5) in vec4 tone;

uniform vec2 viewport;
uniform vec2 centre;
uniform float cells_per_pixel;
uniform float cell_size;
uniform vec2 width_range;  // pixels at strength 0 and 1
uniform float casing;      // extra pixels on each side
uniform float emphasis;    // exponent over strength: 1 grows evenly, more keeps all but the strongest thin and faint
uniform vec2 fade_range;   // opacity at strength 0 and 1

out float across;
flat out float half_width;
out vec4 shown;

void main() {
  float weight = pow(strength, emphasis);
  half_width = 0.5 * max(mix(width_range.x, width_range.y, weight), metres / (cell_size * cells_per_pixel)) + casing;
  float reach = half_width + 1.0;
  vec2 pixel = (cell - centre) / cells_per_pixel + 0.5 * viewport + normal * reach;
  across = side * reach;
  shown = vec4(tone.rgb, tone.a * mix(fade_range.x, fade_range.y, weight));
  gl_Position = vec4(pixel.x / viewport.x * 2.0 - 1.0, 1.0 - pixel.y / viewport.y * 2.0, 0.0, 1.0);
}

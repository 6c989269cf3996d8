#version 450 core
// A herd's mark: a quad around its place, turned to its heading in the fragment shader.
layout(location = 0) in vec2 cell;
layout(location = 1) in float heading;  // radians clockwise from north
layout(location = 2) in float extent;   // pixels from nose to tail
layout(location = 3) in vec4 tone;

uniform vec2 viewport;
uniform vec2 centre;
uniform float cells_per_pixel;

out vec2 local;        // pixels, nose toward -y
flat out float pixels;
flat out vec4 shown;

void main() {
  vec2 corner = vec2(gl_VertexID & 1, gl_VertexID >> 1) * 2.0 - 1.0;
  vec2 offset = corner * (extent * 0.75 + 3.0);
  vec2 pixel = (cell - centre) / cells_per_pixel + 0.5 * viewport + offset;
  float c = cos(heading), s = sin(heading);
  local = vec2(c * offset.x + s * offset.y, -s * offset.x + c * offset.y);
  pixels = extent;
  shown = tone;
  gl_Position = vec4(pixel.x / viewport.x * 2.0 - 1.0, 1.0 - pixel.y / viewport.y * 2.0, 0.0, 1.0);
}

#version 450 core
// An animal seen from above: body, neck and head, with an outline that stands on any ground.
layout(location = 0) out vec4 colour;
in vec2 local;
flat in float pixels;
flat in vec4 shown;

float ellipse(vec2 p, vec2 radii) {
  float k = length(p / radii);
  float slope = length(p / (radii * radii));
  return k * (k - 1.0) / max(slope, 1e-4);
}

float smooth_union(float a, float b, float k) {
  float h = clamp(0.5 + 0.5 * (b - a) / k, 0.0, 1.0);
  return mix(b, a, h) - k * h * (1.0 - h);
}

void main() {
  vec2 p = local / pixels;
  float body = ellipse(p - vec2(0.0, 0.14), vec2(0.20, 0.36));
  float head = ellipse(p - vec2(0.0, -0.36), vec2(0.105, 0.16));
  float shape = smooth_union(body, head, 0.14) * pixels;
  float fill = clamp(0.5 - shape, 0.0, 1.0);
  float outline = clamp(1.0 + clamp(pixels / 16.0, 0.5, 1.3) - shape, 0.0, 1.0);
  vec3 dark = vec3(0.06, 0.07, 0.08);
  vec3 lit = shown.rgb * (0.92 + 0.22 * smoothstep(0.2, -0.2, p.x));
  colour = vec4(mix(dark, lit, fill), outline * shown.a);
}

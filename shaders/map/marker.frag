#version 450 core
// A herd's mark, nose toward -y: a drop where it is small, an animal seen from above where there is room for one.
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

// Hull of a disk of radius `blunt` at the origin and one of radius `sharp` at (0, -reach).
float drop(vec2 p, float blunt, float sharp, float reach) {
  float slant = (blunt - sharp) / reach;
  float along = sqrt(max(1.0 - slant * slant, 0.0));
  vec2 q = vec2(abs(p.x), -p.y);
  float place = dot(q, vec2(-slant, along));
  if (place < 0.0) return length(q) - blunt;
  if (place > along * reach) return length(q - vec2(0.0, reach)) - sharp;
  return dot(q, vec2(along, slant)) - blunt;
}

float animal(vec2 p) {
  float body = ellipse(p - vec2(0.0, 0.16), vec2(0.17, 0.32));
  float neck = drop(p - vec2(0.0, -0.10), 0.11, 0.07, 0.22);
  float head = drop(p - vec2(0.0, -0.32), 0.10, 0.045, 0.14);
  float ears = ellipse(vec2(abs(p.x) - 0.12, p.y + 0.30), vec2(0.07, 0.035));
  return min(smooth_union(body, smooth_union(neck, head, 0.05), 0.08), ears);
}

void main() {
  vec2 p = local / pixels;
  float small = drop(p - vec2(0.0, 0.20), 0.25, 0.03, 0.66);
  float shape = mix(small, animal(p), smoothstep(19.0, 24.0, pixels)) * pixels;
  float fill = clamp(0.5 - shape, 0.0, 1.0);
  float outline = clamp(0.5 + clamp(pixels / 15.0, 0.9, 1.4) - shape, 0.0, 1.0);
  vec3 dark = vec3(0.06, 0.07, 0.08);
  vec3 lit = shown.rgb * (0.94 + 0.18 * smoothstep(0.2, -0.2, p.x));
  colour = vec4(mix(dark, lit, fill), outline * mix(0.85, 1.0, fill) * shown.a);
}

#version 450 core
// How much of the sky stems, stones and hollows hide from what lies beside them: of some places around a point, how many stand over
// its surface (after McGuire, Osman, Bukowski and Hennessy: The Alchemy screen-space ambient obscurance algorithm, 2011).
#include "landscape/frame.glsl"
#include "landscape/screen_depth.glsl"
#include "landscape/plant_dither.glsl"
uniform vec4 within;  // lower left pixel of what is drawn, and size of the whole picture
uniform float most;  // pixels that are looked around at most
out vec4 shade;

vec3 place_at(ivec2 pixel, vec2 size) {
  float away = metres(texelFetch(depths, clamp(pixel, ivec2(0), ivec2(size) - 1), 0).r);
  // Pixels per radian tell how wide a metre is.
  return vec3((vec2(pixel) + 0.5 + within.xy - 0.5 * within.zw) / frame.eye.w, 1.0) * away;
}

void main() {
  vec2 size = vec2(textureSize(depths, 0));
  ivec2 pixel = ivec2(gl_FragCoord.xy);
  vec3 here = place_at(pixel, size);
  // The nearer of the two neighbours is on the same surface.
  vec3 left = here - place_at(pixel - ivec2(1, 0), size);
  vec3 right = place_at(pixel + ivec2(1, 0), size) - here;
  vec3 below = here - place_at(pixel - ivec2(0, 1), size);
  vec3 above = place_at(pixel + ivec2(0, 1), size) - here;
  vec3 across = abs(left.z) < abs(right.z) ? left : right;
  vec3 upward = abs(below.z) < abs(above.z) ? below : above;
  vec3 normal = normalize(cross(upward, across));
  float radius = 0.45 + 0.012 * here.z;
  float reach = clamp(radius / here.z * frame.eye.w, 3.0, most);
  float turn = 6.2832 * dither();
  float sum = 0.0;
  const int samples = 14;
  for (int i = 0; i < samples; ++i) {
    float part = (float(i) + 0.5) / float(samples);
    float angle = turn + 2.39996 * float(i);
    vec3 there = place_at(pixel + ivec2(vec2(cos(angle), sin(angle)) * reach * sqrt(part)), size) - here;
    float squared = dot(there, there);
    float near = max(1.0 - squared / (radius * radius), 0.0);
    sum += max(dot(there, normal) - 0.012 * here.z * 0.1 - 0.01, 0.0) / (squared + 0.02) * near * radius;
  }
  float hidden = clamp(2.2 * sum / float(samples), 0.0, 1.0);
  // Far away there is haze before it, and a metre is smaller than a pixel.
  shade = vec4(1.0 - 0.75 * hidden * exp(-here.z * 0.008));
}

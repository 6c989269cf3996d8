#version 450 core
#include "landscape/frame.glsl"
#include "landscape/screen_depth.glsl"
layout(binding = 0) uniform sampler2D picture;
layout(binding = 2) uniform sampler2D shades;
uniform vec2 corner;
out vec4 colour;

const vec3 luma = vec3(0.30, 0.59, 0.11);

// Edges are blended along their direction (after Lottes: FXAA, 2009).
vec3 smooth_edges(vec2 uv, vec2 pixel) {
  vec3 middle = textureLod(picture, uv, 0.0).rgb;
  float m = dot(middle, luma);
  float nw = dot(textureLod(picture, uv + vec2(-1.0, 1.0) * pixel, 0.0).rgb, luma);
  float ne = dot(textureLod(picture, uv + vec2(1.0, 1.0) * pixel, 0.0).rgb, luma);
  float sw = dot(textureLod(picture, uv + vec2(-1.0, -1.0) * pixel, 0.0).rgb, luma);
  float se = dot(textureLod(picture, uv + vec2(1.0, -1.0) * pixel, 0.0).rgb, luma);
  float least = min(m, min(min(nw, ne), min(sw, se)));
  float most = max(m, max(max(nw, ne), max(sw, se)));
  vec2 along = vec2((sw + se) - (nw + ne), (nw + sw) - (ne + se));
  float flatness = max((nw + ne + sw + se) * 0.03, 0.008);
  along = clamp(along / (min(abs(along.x), abs(along.y)) + flatness), -6.0, 6.0) * pixel;
  vec3 narrow = 0.5 * (textureLod(picture, uv - along / 6.0, 0.0).rgb + textureLod(picture, uv + along / 6.0, 0.0).rgb);
  vec3 wide = 0.5 * narrow + 0.25 * (textureLod(picture, uv - 0.5 * along, 0.0).rgb + textureLod(picture, uv + 0.5 * along, 0.0).rgb);
  float w = dot(wide, luma);
  vec3 blended = w < least || w > most ? narrow : wide;
  // What hardly differs stays sharp.
  return mix(middle, blended, smoothstep(0.03, 0.10, most - least));
}

// The shade of neighbours on the same surface: each pixel holds one of a pattern of samples.
float smooth_shade(ivec2 pixel, float depth) {
  ivec2 last = textureSize(shades, 0) - 1;
  float here = metres(depth);
  float sum = 0.0;
  float weights = 0.0;
  for (int y = -2; y <= 2; ++y) {
    for (int x = -2; x <= 2; ++x) {
      ivec2 at = clamp(pixel + ivec2(x, y), ivec2(0), last);
      float away = abs(metres(texelFetch(depths, at, 0).r) - here) / (0.1 + 0.02 * here);
      float weight = max(1.0 - away, 0.001);
      sum += weight * texelFetch(shades, at, 0).r;
      weights += weight;
    }
  }
  return sum / weights;
}

void main() {
  vec2 place = gl_FragCoord.xy - corner;
  ivec2 pixel = ivec2(place);
  vec2 size = vec2(textureSize(picture, 0));
  float depth = texelFetch(depths, pixel, 0).r;
  vec3 light = texelFetch(picture, pixel, 0).rgb;
#ifdef WITH_SMOOTH_EDGES
  light = smooth_edges(place / size, 1.0 / size);
#endif
#ifdef WITH_OCCLUSION
  if (depth < 1.0) light *= smooth_shade(pixel, depth);
#endif
  colour = vec4(light, 1.0);
  gl_FragDepth = depth;
}

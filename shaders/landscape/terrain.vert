#version 450 core
#include "landscape/frame.glsl"
#include "landscape/atmosphere.glsl"
#include "landscape/clouds.glsl"
#include "landscape/ground.glsl"
layout(location = 0) in vec2 corner;   // 0..1 over the patch
layout(location = 1) in vec4 patch_of; // west, south, side, morph end
uniform float patch_cells;
out vec3 offset;
out vec2 place;
out vec4 veil;
out float clear_sky;

float height_at(vec2 p) { return textureLod(heights, ground_uv(ground_source(p)), 0.0).r; }

void main() {
  vec2 at = patch_of.xy + corner * patch_of.z;
  float to_eye = distance(vec3(at, height_at(at)), frame.eye.xyz);
  // Vertices that the next coarser level lacks slide onto their neighbours before that level takes over.
  float morph = clamp((to_eye / patch_of.w - 0.7) / 0.28, 0.0, 1.0);
  vec2 odd = fract(corner * patch_cells * 0.5) * 2.0 / patch_cells;
  place = patch_of.xy + (corner - odd * morph) * patch_of.z;
  float height = height_at(place);
  offset = vec3(place, height) - frame.eye.xyz;
  veil = vec4(haze_colour(offset), haze(offset));
  clear_sky = cloud_light(place, height);
  gl_Position = frame.view_projection * vec4(offset, 1.0);
}

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

// How far a vertex at a place has slid, 0..1, where its level ends at a distance.
float slide(vec2 at, float end) {
  float to_eye = distance(vec3(at, height_at(at)), frame.eye.xyz);
  return clamp((to_eye / end - 0.7) / 0.28, 0.0, 1.0);
}

void main() {
  // Vertices that the next coarser level lacks slide onto their neighbours before that level takes over; and on to those of the
  // level after it, where a patch reaches as far as that: so that patches of two levels meet without a crack.
  vec2 odd = fract(corner * patch_cells * 0.5) * 2.0 / patch_cells;
  vec2 coarse_odd = fract((corner - odd) * patch_cells * 0.25) * 4.0 / patch_cells;
  vec2 slid = corner - odd * slide(patch_of.xy + corner * patch_of.z, patch_of.w);
  slid -= coarse_odd * slide(patch_of.xy + slid * patch_of.z, 2.0 * patch_of.w);
  place = patch_of.xy + slid * patch_of.z;
  float height = height_at(place);
  offset = vec3(place, height) - frame.eye.xyz;
  veil = vec4(haze_colour(offset), haze(offset));
  clear_sky = cloud_light(place, height);
  gl_Position = frame.view_projection * vec4(offset, 1.0);
}

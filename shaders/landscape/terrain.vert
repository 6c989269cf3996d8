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
#ifdef WITH_LESS
#include "landscape/shade.glsl"
layout(binding = 4) uniform sampler2D canopy_colours;
layout(binding = 5) uniform sampler2D lines;
layout(binding = 6) uniform sampler2D sunlit;
uniform vec4 canopy_range;
out vec2 on_map;
out vec3 early;
flat out vec4 reflected;
#ifdef WATER_ALONE
#include "landscape/shore_near.glsl"
#endif
#endif

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
#ifdef WITH_LESS
  on_map = ground_uv(ground_source(place));
  // Land beyond the border fades into the haze.
  vec2 beyond = max(max(-place, place - frame.terrain.xy), vec2(0.0)) / frame.terrain.xy;
  veil.a = max(veil.a, smoothstep(0.0, 0.85, max(beyond.x, beyond.y)));
  vec2 parity = 1.0 - 2.0 * mod(abs(floor(ground_source(place) / frame.terrain.xy)), 2.0);
  vec2 out_from = vec2(greaterThan(place, frame.terrain.xy)) - vec2(lessThan(place, vec2(0.0)));
  reflected = vec4(parity, border_shear * out_from);
  clear_sky *= textureLod(sunlit, on_map, 0.0).r;
  float cover = textureLod(canopy_colours, ground_uv(ground_source(place + 8.0 * toward_light_on_ground())), 1.5).a;
  early = vec3(textureLod(detail, place * 0.0067, 0.0).a, cover, shade_of_cover(cover * canopy_range.z));
#ifdef WATER_ALONE
  gl_CullDistance[0] = nearness_of_water(on_map, patch_of.z / patch_cells, length(offset));
#endif
#endif
  gl_Position = frame.view_projection * vec4(offset, 1.0);
}

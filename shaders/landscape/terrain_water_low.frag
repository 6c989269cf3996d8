#version 450 core
// Water alone, laid over the ground that is drawn already: software renderers run both sides of every branch, and most ground is dry.
#include "landscape/frame.glsl"
#include "landscape/atmosphere.glsl"
#include "landscape/clouds.glsl"
#include "landscape/shade.glsl"
#include "landscape/snow.glsl"
const bool with_detail = false;
#include "landscape/water.glsl"
#include "landscape/ford.glsl"
layout(binding = 5) uniform sampler2D lines;
uniform vec4 canopy_range;
uniform vec4 show;
in vec3 offset;
in vec2 place;
in vec4 veil;
in float clear_sky;
in vec2 on_map;
in vec3 early;
out vec4 colour;
#include "landscape/shore.glsl"
#include "landscape/brush_ring.glsl"

void main() {
  float to_eye = length(offset);
  float pixel = to_eye / frame.eye.w;
  vec4 fine = texture(detail, place * 0.37, -1.3);
  vec4 middle = texture(detail, place * 0.043 + 0.13, -0.7);
  float inside = (texture(lines, on_map).r * 255.0 - 128.0) * (shore_reach / 127.0);
  float wet = wet_share(inside, fine, middle, to_eye, pixel);
  vec2 drawn = drawn_shade(place);
  float light_share = clear_sky * light_in_flecks(early.z * (1.0 - drawn.y) + drawn.x, fleck_at(place));
  const vec4 trees = vec4(0.030, 0.042, 0.020, 0.30);
  vec3 lit = water_colour(offset, place, on_map, bed_colour(fine, middle), max(inside, 0.0), light_share, trees, to_eye);
  vec4 stone = stone_seen(place, offset / to_eye, riffle_at(on_map) * exp(-to_eye * 0.008), pixel);
  vec3 sky = mix(frame.ambient_ground.rgb, frame.ambient_sky.rgb, 0.5 + 0.5 * stone.z);
  vec3 shone = frame.light_colour.rgb * max(dot(stone.xyz, frame.light_direction.xyz), 0.0) * light_share;
  lit = mix(lit, stone_colour(fine, middle) * (0.30 + 0.80 * clamp(stone.z, 0.0, 1.0)) * (shone + sky), stone.w);
  lit = with_brush(lit, place, to_eye);
  colour = vec4(to_screen(mix(lit, veil.rgb, veil.a)), wet);
}

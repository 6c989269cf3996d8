// Where the ground is: height texture over the terrain, mirrored beyond its border. Needs frame.glsl.
layout(binding = 0) uniform sampler2D heights;

vec2 ground_uv(vec2 place) { return vec2(place.x / frame.terrain.x, 1.0 - place.y / frame.terrain.y); }

// Beyond the border the land goes on as a mirror image, sheared so that it does not look like one: a place there and the one that
// it is taken from (whole tiles away from the terrain, for a texture that repeats mirrored).
const float border_shear = 0.62;
vec2 ground_source(vec2 place) {
  vec2 outside = max(max(-place, place - frame.terrain.xy), vec2(0.0));
  return place + border_shear * outside.yx;
}
// Patches of a meadow, some metres wide: darker and bluer where clover and broad leaves stand, paler where stalks ripen. `a`: the
// detail noise at sward_place().
vec2 sward_place(vec2 place) { return vec2(place.x * 0.8 + place.y * 0.6, place.y * 0.8 - place.x * 0.6) * 0.12; }
vec3 sward_patch(float a) { return mix(vec3(0.76, 0.88, 0.82), vec3(1.14, 1.06, 0.98), smoothstep(0.30, 0.70, a)); }
// A normal at the source as it is seen at the place.
vec3 ground_normal_at(vec3 normal, vec2 place) {
  vec2 parity = 1.0 - 2.0 * mod(abs(floor(ground_source(place) / frame.terrain.xy)), 2.0);
  vec2 out_from = vec2(greaterThan(place, frame.terrain.xy)) - vec2(lessThan(place, vec2(0.0)));
  vec2 slope = normal.xy * parity;
  return normalize(vec3(slope + border_shear * out_from * slope.yx, normal.z));
}

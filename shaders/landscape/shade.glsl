// The shade of crowns, drawn from above around the eye as it falls on the ground (render/plant_renderer.hpp). Needs frame.glsl and
// `detail` (clouds.glsl).
layout(binding = 7) uniform sampler2D canopy_shade;

// Metres that a shadow moves to the side per metre of height, toward the light; the same as in plant_shade.vert.
vec2 toward_light_on_ground() { return frame.light_direction.xy / max(frame.light_direction.z, 0.14); }

// Share of direct light that crowns of some cover take from the ground on the mean: more the more aslant the light comes (as in
// crowns_seen() of plant_canopy.glsl).
float shade_of_cover(float cover) {
  float sine = max(frame.light_direction.z, 0.14);
  float hidden = 1.0 - pow(1.0 - min(cover, 0.98), sqrt(1.0 + 1.45 * (1.0 / (sine * sine) - 1.0)));
  return 0.9 * frame.shade_area.w * hidden;
}

// Share of direct light that crowns take from the ground at a place; y: 1 where that is known, 0 far from the eye.
vec2 drawn_shade(vec2 place) {
  vec2 at = (place - frame.shade_area.xy) / max(frame.shade_area.z, 1.0);
  vec2 edge = smoothstep(vec2(0.0), vec2(0.08), at) * (1.0 - smoothstep(vec2(0.92), vec2(1.0), at));
  float known = edge.x * edge.y * step(0.001, frame.shade_area.w);
  return vec2(textureLod(canopy_shade, at, 0.0).r * frame.shade_area.w * known, known);
}

// Sun comes through leaves in flecks, which wander as it does: the share that is let through where `shade` is taken on the whole.
// `fleck` 0..1 with mean one half.
float light_in_flecks(float shade, float fleck) {
  float through = 1.0 - shade;
  float lit = smoothstep(-0.13, 0.13, fleck - 0.80 + 0.60 * through);
  // In the open and in the depth of a wood all is even.
  return mix(through, lit, 2.6 * through * shade);
}
float fleck_at(vec2 place) {
  vec2 at = place + 7.0 * toward_light_on_ground();
  return texture(detail, at * 0.083).b;
}

// Shadows of trees, shrubs and animals from the light's pictures (render/shadow_map.hpp). Needs frame.glsl, shadow_view.glsl.
layout(binding = 12) uniform sampler2DArrayShadow shadow_depths;

// Share of direct light that comes past plants and animals to a point (relative to the eye); `nearer`: metres toward the light that
// are looked over, so that a leaf is not shaded by itself; `beyond`: the share where the pictures end; `threshold` 0..1: this dot's.
float light_past_plants(vec3 offset, float nearer, float beyond, float threshold) {
  // The finest square that holds the point; near its border some dots take the next.
  vec3 reach;
  for (int i = 0; i < 3; ++i) {
    vec2 away = abs(vec2(dot(shadows.right[i].xyz, offset), dot(shadows.up[i].xyz, offset)) - shadows.cascades[i].xy);
    reach[i] = max(away.x, away.y) / shadows.cascades[i].z;
  }
  float border = 0.97 - 0.06 * threshold;
  int cascade = reach.x < border ? 0 : reach.y < border ? 1 : 2;
  vec4 square = shadows.cascades[cascade];
  vec3 at = in_light(cascade, offset);
  vec2 uv = (at.xy - square.xy) / square.z * 0.5 + 0.5;
  float step = 0.5 * square.w / square.z;
  float depth = 0.5 - 0.5 * (at.z + nearer + 2.0 * square.w - shadows.up[cascade].w) * shadows.right[cascade].w;
  float lit = 0.0;
  for (int y = -1; y <= 1; ++y) {
    for (int x = -1; x <= 1; ++x) lit += texture(shadow_depths, vec4(uv + vec2(x, y) * step, float(cascade), depth));
  }
  float known = shadows.toward[0].w * (1.0 - smoothstep(0.80, 0.97, reach.z));
  // Leaves let some light through.
  return mix(beyond, 0.18 + 0.82 * lit / 9.0, known);
}

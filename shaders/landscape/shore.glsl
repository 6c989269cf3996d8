// Where water begins, and what lies under it. Needs frame.glsl; `fine` and `middle`: the detail noise of terrain_surface.glsl.

const float shore_reach = 8.0;  // m from the shore to which distances are told

// Share of a pixel that is water, `inside` metres from the shore. As wide as it is, but never narrower than a good part of a
// `pixel` (m), so that a river stays one line from afar.
float wet_share(float inside, vec4 fine, vec4 middle, float to_eye, float pixel) {
  float grazing = max(-offset.z / to_eye, 0.12);
  float soft = max(pixel * 0.6, 0.10);
  float shore = inside + 0.55 * (fine.b - 0.5) * exp(-to_eye * 0.02) + 0.9 * (middle.b - 0.5) * exp(-to_eye * 0.005);
  return smoothstep(-soft, soft, shore + min(0.28 * pixel / grazing, 2.2)) * show.x;
}
vec3 bed_colour(vec4 fine, vec4 middle) {
  float pale = clamp(0.25 * middle.b + 0.35 * middle.a + 0.5 * fine.b - 0.05, 0.0, 1.0);
  return mix(vec3(0.075, 0.068, 0.042), vec3(0.215, 0.195, 0.140), pale);
}
vec3 stone_colour(vec4 fine, vec4 middle) { return vec3(0.105, 0.100, 0.088) * (0.35 + 0.9 * fine.b + 0.4 * middle.a); }

// Stones that a shallow, rough stream breaks over: at fords, and in steep brooks. Needs frame.glsl, `currents` and `with_detail`.
const float stone_cell = 1.15;  // m from one stone to the next, about
const float flatness = 1.3;     // stones are so much wider than high

// How much of a riffle flows at a place: rough and shallow water.
float riffle_at(vec2 uv) {
  vec4 coded = texture(currents, uv);
  return smoothstep(0.28, 0.55, coded.a) * smoothstep(0.55, 0.25, coded.b * deepest_water);
}

// Where the line of sight meets a stone before it comes to the water: its normal, and how much of the pixel it fills.
vec4 stone_seen(vec2 place, vec3 view, float riffle, float pixel) {
  vec4 seen = vec4(0.0);
  float nearest = 1e3;
  // Stones stand before the place that is seen behind them.
  vec2 before = place - view.xy * min(0.10 / max(-view.z, 0.05), 0.6);
  vec2 first = floor(before / stone_cell - 0.5);
  vec3 ray = vec3(view.xy, view.z * flatness);
  float far = dot(ray, ray);
  for (int i = 0; i < 4; ++i) {
    vec2 cell = first + vec2(i & 1, i >> 1);
    vec4 random = fract(sin(vec4(dot(cell, vec2(12.99, 78.23)), dot(cell, vec2(39.35, 11.14)), dot(cell, vec2(73.16, 52.24)), dot(cell, vec2(21.7, 93.9)))) * 43758.55);
    vec2 middle = (cell + 0.35 + 0.3 * random.xy) * stone_cell;
    float turn = atan(place.y - middle.y, place.x - middle.x);
    float uneven = 1.0 + 0.16 * sin(2.0 * turn + 6.3 * random.x) + 0.10 * sin(3.0 * turn + 6.3 * random.y);
    float radius = (0.10 + 0.28 * random.z * random.z) * uneven * step(random.w, 0.62 * riffle);
    // Its middle lies a little below the surface.
    vec3 from = vec3(place - middle, 0.30 * radius * flatness);
    float along = dot(from, ray) / far;
    float away = sqrt(max(dot(from, from) - along * along * far, 0.0));
    float back = -along - sqrt(max(radius * radius - away * away, 0.0) / far);
    float share = radius > 0.0 && back < 0.0 ? smoothstep(radius + pixel, radius - pixel, away) : 0.0;
    if (share > 0.0 && back < nearest) {
      nearest = back;
      vec3 normal = (from + ray * back) / radius;
      seen = vec4(normalize(vec3(normal.xy, normal.z * flatness)), share);
    }
  }
  return seen;
}

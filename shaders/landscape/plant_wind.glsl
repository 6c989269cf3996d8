// How the wind moves plants: a function of place and of frame.wind alone, nothing in a calm. Needs frame.glsl.
#ifndef WIND_SECONDS
#define WIND_SECONDS frame.wind.z
#endif

// Strength of the wind at a place, m/s: gusts travel with it.
float gust(vec2 place) {
  float speed = length(frame.wind.xy);
  vec2 way = frame.wind.xy / max(speed, 1e-3);
  float along = dot(place, way);
  float across = dot(place, vec2(-way.y, way.x));
  float t = WIND_SECONDS;
  float wave = sin(along * 0.11 - t * (0.5 + 0.11 * speed) + 1.3 * sin(across * 0.045)) * 0.32 +
               sin(along * 0.37 - t * (1.1 + 0.3 * speed) + 2.1 * sin(across * 0.13 + 0.7)) * 0.18;
  return speed * (0.62 + wave);
}

// Where the wind carries a point of a tree. `at`: m from its foot, `height` of the tree; `loose`: 0 wood .. 1 leaves; `phase`: 0..1 of the
// leaf, `own`: 0..1 of the tree.
vec3 sway(vec3 at, float height, vec2 place, float loose, float phase, float own) {
  float strength = gust(place);
  vec2 way = frame.wind.xy / max(length(frame.wind.xy), 1e-3);
  float t = WIND_SECONDS;
  float beat = 6.2 / sqrt(max(height, 0.5));
  float up = clamp(at.z / height, 0.0, 1.2);
  float swing = strength * (1.0 + 0.45 * sin(t * beat + own * 40.0)) * 0.0016 * height * up * up;
  float side = strength * 0.0005 * height * up * up * sin(t * beat * 0.83 + own * 71.0);
  vec3 moved = vec3(way * swing + vec2(-way.y, way.x) * side, 0.0);
  // Boughs nod, leaves shiver.
  float nod = sin(t * (beat * 1.9 + 0.7) + phase * 29.0 + own * 13.0);
  float shiver = sin(t * (6.0 + 3.0 * phase) + phase * 91.0);
  return moved + loose * strength * vec3(way * (0.006 * nod + 0.003 * shiver), 0.007 * nod + 0.003 * shiver);
}

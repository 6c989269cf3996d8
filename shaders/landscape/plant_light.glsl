// Light on foliage. Needs frame.glsl.

// This plant's own tone: some fresher, some browner. `tint` 0..1.
vec3 own_tone(float tint) {
  float value = 0.84 + 0.32 * fract(tint * 7.31);
  return value * mix(vec3(0.94, 1.02, 1.0), vec3(1.10, 1.0, 0.84), tint);
}

// Light that a leaf or stem sends to the eye, per unit of colour. `open`: baked share of open sky; `sun`: 0 in the shadow of a mountain.
vec3 foliage_light(vec3 normal, vec3 view, float open, float sun) {
  float facing = dot(normal, frame.light_direction.xyz);
  float direct = max((facing + 0.22) / 1.22, 0.0) * open * (0.70 + 0.30 * open);
  // Light through leaves, seen toward the sun.
  // Most of it where one looks against the light, some wherever one looks up into a crown.
  float against = max(dot(view, frame.light_direction.xyz), 0.0);
  float high = max(frame.light_direction.z, 0.0);
  float through = (0.50 * against * max(0.45 - facing, 0.0) + 0.30 * max(view.z, 0.0) * high) * (0.35 + 0.65 * open);
  // What came through the leaves above is green, and is all the sun there is inside a crown.
  vec3 filtered = vec3(0.050, 0.072, 0.020) * high * (1.0 - open);
  // Sky light comes through from above, most where one looks up through the leaves.
  vec3 ambient = mix(frame.ambient_ground.rgb, frame.ambient_sky.rgb, 0.60 + 0.40 * normal.z) * (0.50 + 0.50 * open) +
                 frame.ambient_sky.rgb * vec3(0.22, 0.26, 0.12) * max(view.z, 0.0);
  return frame.light_colour.rgb * sun * (direct + through * vec3(1.15, 1.05, 0.45) + filtered) + ambient;
}

// Leaves of one spray differ: `yellowed` 0..1, of mean one half.
vec3 yellowed_leaf(float yellowed) { return mix(vec3(0.84, 0.95, 1.08), vec3(1.16, 1.05, 0.92), yellowed); }

// How a plant stands: metres it leans aside per metre of height, and how much higher or lower it is than it is wide.
vec3 own_stand(float tint) {
  float way = 6.2832 * fract(tint * 91.7);
  return vec3(0.055 * fract(tint * 43.3) * vec2(cos(way), sin(way)), 0.88 + 0.24 * fract(tint * 37.7));
}

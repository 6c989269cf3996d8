// The brush's ring on the ground.
uniform vec4 brush;  // x, y, radius in metres; w: 1 when there is one

vec3 with_brush(vec3 lit, vec2 place, float to_eye) {
  if (brush.w <= 0.0) return lit;
  float ring = abs(distance(place, brush.xy) - brush.z);
  float width = max(0.004 * to_eye, 0.3);
  lit = mix(lit, vec3(0.21, 0.43, 0.14) * 1.8, smoothstep(width, 0.4 * width, ring) * 0.9);
  return mix(lit, vec3(0.21, 0.43, 0.14), 0.12 * step(distance(place, brush.xy), brush.z));
}

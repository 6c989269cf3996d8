// Clouds: one layer over the land, the same for the sky and for the shadows on the ground. Needs frame.glsl and `detail`, the
// tileable noise on unit 3 (declared here).
layout(binding = 3) uniform sampler2D detail;

// Form of the clouds over a place (metres), about 0.2 .. 0.8. `lod`: detail to leave out.
float cloud_form(vec2 place, float lod) {
  vec2 at = place - frame.clouds.xy;
  return 0.70 * textureLod(detail, at * 0.00017 + 0.31, lod).a + 0.30 * textureLod(detail, at.yx * 0.00061, lod).a;
}

// How thick clouds of a form are, 0 where there are none .. 1.
float cloud_thickness(float form) {
  float clear = 1.0 - frame.clouds.w;
  float edge = 0.16 + 0.84 * clear * sqrt(clear);
  return smoothstep(edge, edge + 0.30, form);
}

// Share of direct light that passing clouds let through to a place (metres) at a height.
float cloud_light(vec2 place, float height) {
  vec2 aslant = frame.light_direction.xy / max(frame.light_direction.z, 0.25);
  return 1.0 - frame.glow.w * cloud_thickness(cloud_form(place + aslant * max(frame.clouds.z - height, 0.0), 2.0));
}

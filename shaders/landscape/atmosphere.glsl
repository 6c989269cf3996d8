// Sky, haze and the last step from light to screen colour. Needs frame.glsl.

// Sky without clouds or sun disc in a direction (unit vector, z up).
vec3 sky_colour(vec3 direction) {
  float height = max(direction.z, 0.0);
  float low = exp(-height * 5.5);
  vec3 colour = mix(frame.zenith.rgb * 1.15, frame.horizon.rgb * 1.3, low);
  // A whitish veil right at the horizon, and the warm glow on the sun's side when it is low.
  float toward = max(dot(direction, frame.sun_direction.xyz), 0.0);
  float sun_low = 1.0 - smoothstep(0.05, 0.5, abs(frame.sun_direction.z));
  colour += frame.light_colour.rgb * (1.0 - frame.light_direction.w) *
            (0.045 * pow(toward, 6.0) + 0.10 * sun_low * pow(toward, 3.0) * low + 0.10 * pow(toward, 60.0));
  return colour;
}

// Share of light lost to haze between the eye and a point (relative to the eye), denser in the lowlands.
float haze(vec3 offset) {
  float distance_to = length(offset);
  float falloff = frame.fog.y;
  float from = (frame.eye.z - frame.fog.z) * falloff;
  float rise = offset.z * falloff;
  float mean_density = exp(-max(from, -1.0)) * (abs(rise) > 0.001 ? (1.0 - exp(-rise)) / rise : 1.0);
  return 1.0 - exp(-frame.fog.x * distance_to * min(mean_density, 1.6));
}

vec3 apply_haze(vec3 colour, vec3 offset, float amount) {
  vec3 direction = normalize(offset);
  vec3 veil = sky_colour(normalize(vec3(direction.xy, 0.02 + 0.25 * max(direction.z, 0.0))));
  return mix(colour, veil, amount);
}

// Linear light to screen: a gentle shoulder (Reinhard on luminance, extended), slightly desaturated, sRGB gamma.
vec3 to_screen(vec3 light) {
  light *= mix(0.82, 1.9, frame.light_direction.w);
  float luminance = dot(light, vec3(0.2126, 0.7152, 0.0722));
  float mapped = luminance * (1.0 + luminance / 6.0) / (1.0 + luminance);
  vec3 colour = light * (mapped / max(luminance, 1e-4));
  colour = mix(vec3(mapped), colour, mix(0.94, 0.75, frame.light_direction.w));
  return pow(clamp(colour * 1.12, 0.0, 1.0), vec3(1.0 / 2.2));
}

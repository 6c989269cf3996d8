// Sky, haze and the last step from light to screen colour. Needs frame.glsl.

// Sky without clouds or sun disc in a direction (unit vector, z up).
vec3 sky_colour(vec3 direction) {
  float height = max(direction.z, 0.0);
  float low = exp2(-height * 7.0);
  // Overhead one looks through the least air: deeper and purer.
  vec3 above = frame.zenith.rgb * mix(vec3(1.0), vec3(0.74, 0.86, 1.0), min(1.0, 1.5 * height) * frame.stars.w);
  vec3 colour = mix(above, frame.horizon.rgb, low * (1.0 - 0.2 * height));
  // The air around the sun glows, more along the horizon when it is low.
  float toward = 0.5 + 0.5 * dot(direction, frame.sun_direction.xyz);
  float toward2 = toward * toward;
  float toward8 = toward2 * toward2 * toward2 * toward2;
  float toward64 = toward8 * toward8;
  toward64 *= toward64;
  toward64 *= toward64;
  return colour + frame.glow.rgb * (0.10 * toward2 + low * low * (0.55 * toward8 + 0.40 * toward2 * toward2) + 0.28 * toward64);
}

// Share of light lost to haze between the eye and a point (relative to the eye), denser in the lowlands.
float haze(vec3 offset) {
  float distance_to = length(offset);
  float falloff = frame.fog.y;
  float from = (frame.eye.z - frame.fog.z) * falloff;
  float rise = offset.z * falloff;
  float mean_density = exp(-max(from, -1.0)) * (abs(rise) > 0.001 ? (1.0 - exp(-rise)) / rise : 1.0);
  float depth = frame.fog.x * distance_to * min(mean_density, 1.6);
  // In clean air the middle distance keeps its contrast and only the far land pales.
  return 1.0 - exp(-depth * (depth + 0.13) / (depth + 0.26));
}

// Colour of the haze in a direction (need not be a unit vector).
vec3 haze_colour(vec3 offset) {
  vec3 direction = normalize(offset);
  return sky_colour(normalize(vec3(direction.xy, 0.03 + 0.25 * max(direction.z, 0.0))));
}

vec3 apply_haze(vec3 colour, vec3 offset, float amount) { return mix(colour, haze_colour(offset), amount); }

// What to_screen made of light, back again.
vec3 from_screen(vec3 colour) {
  vec3 y = min(colour, 0.985);
  vec3 a = 6.2 * (1.0 - y);
  vec3 b = 0.5 - 1.7 * y;
  vec3 x = (sqrt(b * b + 0.24 * a * y) - b) / (2.0 * a);
  vec3 light = (x + 0.003) / 0.92;
  const vec3 brightness = vec3(0.2126, 0.7152, 0.0722);
  vec3 tint = mix(vec3(1.0), vec3(0.80, 0.98, 1.25), frame.light_direction.w);
  float colourful = mix(1.11, 0.58, frame.light_direction.w);
  float luminance = dot(light, brightness) / (colourful + (1.0 - colourful) * dot(tint, brightness));
  light = max((light - (1.0 - colourful) * luminance * tint) / colourful, 0.0);
  return light / (frame.fall.w * mix(1.04, 0.95, frame.light_direction.w));
}

// Linear light to screen. The curve is Hejl and Burgess-Dawson's filmic one (2010), gamma included: dark tones keep their contrast
// and lights roll off softly.
vec3 to_screen(vec3 light) {
  light *= frame.fall.w * mix(1.04, 0.95, frame.light_direction.w);
  float luminance = dot(light, vec3(0.2126, 0.7152, 0.0722));
  // At night the eye sees less colour, and what there is bluish.
  vec3 tint = mix(vec3(1.0), vec3(0.80, 0.98, 1.25), frame.light_direction.w);
  light = max(mix(luminance * tint, light, mix(1.11, 0.58, frame.light_direction.w)), 0.0);
  vec3 x = max(light * 0.92 - 0.003, 0.0);
  return (x * (6.2 * x + 0.5)) / (x * (6.2 * x + 1.7) + 0.06);
}

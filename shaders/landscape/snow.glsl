// Snow on the ground and on what stands on it. Needs frame.glsl.

// Share of a surface that snow covers, 0..1. `height` above the sea in metres, `normal` its unit normal (z up), `noise` 0..1: what
// differs from place to place (or from plant to plant): snow lies in patches before it closes. Steep surfaces shed it.
float snow_share(float height, vec3 normal, float noise) {
  float lower = frame.snow.z * clamp(normal.y * 1.8, -1.0, 1.0);
  float above = (height + lower - frame.snow.x) / max(frame.snow.y, 1.0);
  // Cover 0 at one spread below the line, 1 at one above it.
  float cover = clamp(0.5 + 0.5 * above, 0.0, 1.0);
  float patches = smoothstep(-0.16, 0.16, cover * 1.32 - 0.16 - (1.0 - noise));
  float holds = smoothstep(0.48, 0.78, normal.z + 0.26 * (noise - 0.5));
  return patches * holds * frame.snow.w;
}

// Snow sends nearly all light back, bluish from its depth; a little less here, so that its forms show in full sun.
const vec3 snow_albedo = vec3(0.64, 0.68, 0.74);

// Share of what falls that is rain at a height, 0..1.
float rain_share(float height) {
  return clamp(0.5 - 0.5 * (height - frame.fall.x) / max(frame.fall.y, 1.0), 0.0, 1.0);
}

// Snow on plants. Needs plant_kinds.glsl and snow.glsl.

// Share of what a crown turns up that snow covers: less where there are no leaves to hold it.
float crown_snow(float height, vec3 normal, int plant, float tint) {
  return 0.62 * (1.0 - 0.6 * kinds.fresh[plant].w) * snow_share(height, normal, 0.25 + 0.6 * tint);
}

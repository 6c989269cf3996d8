// Levels of detail and how they give way to each other, dot by dot. The same sums as in render/plant_selection.cpp. Needs frame.glsl.
uniform vec4 lod;  // pixels from which a plant is a near mesh and a mesh at all; metres from which far plants thin out, and none is left

float seen_pixels(vec3 offset, float height, float rank) {
  return 579.0 * height / max(length(offset), 0.5) * (0.88 + 0.24 * rank);
}
// Share of a level of detail that begins at a height on the screen.
float level_share(float begins, float pixels) { return smoothstep(0.93 * begins, begins, pixels); }
float mesh_share(float pixels) { return smoothstep(0.93 * lod.y, lod.y, pixels); }
// Where fewer plants are shown, those of the lowest rank stay; each fades out over a tenth of the ranks.
float far_share(float distance_to, float rank) {
  float share = 1.0 - smoothstep(lod.z, lod.w, distance_to);
  return clamp((share * 1.1 - rank) * 10.0, 0.0, 1.0);
}

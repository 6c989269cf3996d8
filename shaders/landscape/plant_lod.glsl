// Levels of detail and how they give way to each other, card by card of their leaves. The same sums as in render/plant_selection.cpp. Needs frame.glsl.
uniform vec4 lod;  // pixels from which a plant is a near mesh and a mesh at all; metres from which far plants thin out, and none is left

float seen_pixels(vec3 offset, float height, float rank) {
  return 579.0 * height / max(length(offset), 0.5) * (0.88 + 0.24 * rank);
}
// Where in the change from one level of detail to the next a card of leaves goes over, 0..1: as evenly spread in one level as in the
// other, so that a crown is as dense all along. `fall`: the card's own (above 1: wood, which goes over at once).
float turn_of_card(float fall, float tint) { return fall > 1.0 ? 0.5 : fract(fall * 5.37 + tint * 3.1); }
// Share of a level of detail that begins at a height on the screen.
float level_share(float begins, float pixels) { return smoothstep(0.95 * begins, begins, pixels); }
float mesh_share(float pixels) { return smoothstep(0.95 * lod.y, lod.y, pixels); }
// Where fewer plants are shown, those of the lowest rank stay; each fades out over a twentieth of the ranks.
float far_share(float distance_to, float rank) {
  float share = 1.0 - smoothstep(lod.z, lod.w, distance_to);
  return clamp((share * 1.05 - rank) * 20.0, 0.0, 1.0);
}

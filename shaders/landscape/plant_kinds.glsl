// What the plant shaders know of every species: KindUniforms of render/plant_kinds.cpp.
layout(std140, binding = 1) uniform Kinds {
  vec4 form[256];    // radius and height of the grown plant in m (0: not shown), foot of the crown / height, how dense its shade is
  vec4 fresh[256];   // leaf colour before it turns; w: share of leaves fallen
  vec4 turned[256];  // leaf colour when turned; w: how far the month has turned it
} kinds;

// Leaves of one plant: some turn before the others, and not to quite the same colour. `tint` 0..1.
vec3 own_leaf(int plant, float tint) {
  float turn = kinds.turned[plant].w;
  float early = fract(tint * 7.31) - 0.5;
  float own = clamp(turn + early * 0.9 * min(1.0, 6.0 * turn * (1.0 - turn)), 0.0, 1.0);
  vec3 shade = 1.0 + (fract(tint * 23.7) - 0.5) * vec3(0.30, -0.42, -0.35) * turn;
  return mix(kinds.fresh[plant].rgb, kinds.turned[plant].rgb * shade, own);
}

// Share of its leaves that one plant has lost.
float own_bare(int plant, float tint) {
  float bare = kinds.fresh[plant].w;
  return bare + (fract(tint * 11.9) - 0.5) * 2.4 * bare * (1.0 - bare);
}

// Which of the two models of its kind a plant is.
int own_model(float tint) { return int(fract(tint * 61.0) * 2.0); }

// What lies under trees: fallen leaves, needles, twigs and moss. The ground's colour map has their mean colour already
// (render/ground_colours.cpp); here are the single leaves near the eye. Needs frame.glsl.

// One leaf in a cell of `size` metres, or none; x: 1 on the leaf, y: its shade, z: 0..1 its own, w: bend of its surface.
vec4 leaf_on_ground(vec2 place, float size, float share) {
  vec2 at = place / size;
  vec2 cell = floor(at);
  vec3 p = fract(mod(cell.xyx, 4093.0) * vec3(0.1031, 0.1030, 0.0973));
  p += dot(p, p.yzx + 33.33);
  vec3 random = fract((p.xxy + p.yzz) * p.zyx);
  vec2 within = fract(at) - 0.5 - (random.xy - 0.5) * 0.34;
  float turn = 40.0 * random.z;
  vec2 along = vec2(cos(turn), sin(turn));
  vec2 leaf = vec2(dot(within, along), dot(within, vec2(-along.y, along.x)));
  float reach = 0.30 + 0.10 * random.y;
  float wide = (0.56 + 0.2 * random.x) * (reach * reach - leaf.x * leaf.x) / reach;
  float on = smoothstep(0.0, 0.05, wide - abs(leaf.y)) * step(random.z, share);
  float rib = smoothstep(0.030, 0.010, abs(leaf.y));
  return vec4(on, 0.80 + 0.40 * random.x + 0.25 * rib - 0.35 * step(0.0, leaf.y) * random.y, random.y, leaf.y * 3.0);
}

// Lays litter on the ground's colour. `wood`: mean colour (square root) and cover of the crowns above; `fine`, `middle`: detail noise;
// `kept` 0..1: what feet and rock leave of it.
vec3 with_litter(vec3 albedo, vec2 place, vec4 wood, vec4 fine, vec4 middle, float to_eye, float kept, inout vec2 bumps) {
  vec3 crowns = wood.rgb * wood.rgb;
  // Bare crowns hide half of what they did (render/ground_colours.cpp), and are grey.
  float bare_crowns = smoothstep(0.80, 0.95, crowns.b / max(crowns.r, 0.01)) * smoothstep(1.15, 1.0, crowns.g / max(crowns.r, 0.01));
  float cover = wood.a * (1.0 + bare_crowns);
  float amount = smoothstep(0.14, 0.66, cover + 0.45 * (middle.a - 0.5)) * kept;
  // Conifers are bluish in green, woods that turn are redder than green: what lies below them is theirs.
  float needles = smoothstep(0.58, 0.68, crowns.b / max(crowns.r, 0.01)) * smoothstep(1.25, 1.7, crowns.g / max(crowns.r, 0.01));
  float turned = smoothstep(-0.01, 0.05, crowns.r - crowns.g) * (1.0 - needles);
  vec3 brown = mix(mix(vec3(0.078, 0.050, 0.028), vec3(0.150, 0.102, 0.058), fine.b), mix(vec3(0.062, 0.040, 0.025), vec3(0.118, 0.078, 0.050), fine.b), needles);
  brown = mix(brown, 0.9 * crowns * (0.7 + 0.6 * fine.b), 0.55 * turned);
  // Leaves by twos, the upper ones over the lower; from afar only their mean is left.
  float near = exp(-to_eye * 0.035);
  float share = smoothstep(0.0, 0.75, amount);
  vec4 low = leaf_on_ground(place + 0.31, 0.105, 0.9 * share);
  vec4 top = leaf_on_ground(vec2(0.8 * place.x + 0.6 * place.y, 0.8 * place.y - 0.6 * place.x), 0.125, 0.7 * share);
  vec4 leaf = mix(low, top, top.x);
  float covered = max(low.x, top.x) * (1.0 - needles) * near * kept;
  vec3 dry = mix(vec3(0.105, 0.060, 0.032), vec3(0.330, 0.230, 0.130), leaf.z * leaf.z);
  dry = mix(dry, mix(crowns * 2.6, vec3(0.34, 0.15, 0.045), 0.6 * fract(leaf.z * 3.7)), min(1.0, 2.0 * turned) * step(0.3, fract(leaf.z * 7.3)));
  vec3 litter = brown * mix(1.0, 0.62, near * (1.0 - needles));
  // Needles lie crosswise in short strokes.
  vec4 strokes = texture(detail, vec2(place.x * 1.9 + place.y * 0.7, place.y * 1.1 - place.x * 0.4));
  litter *= 1.0 + needles * near * (strokes.b - 0.5) * 1.3;
  bumps += covered * vec2(leaf.w, leaf.z - 0.5) * 0.7;
  // Moss on what stays damp.
  float moss = smoothstep(0.56, 0.70, middle.b * 0.6 + middle.a * 0.4 + 0.10 * (fine.b - 0.5)) * smoothstep(0.3, 0.7, cover);
  litter = mix(litter, vec3(0.062, 0.085, 0.022) * (0.6 + 0.9 * fine.b), 0.8 * moss);
  // Herbs come up through it in patches.
  float bare = 0.72 + 0.28 * smoothstep(0.62, 0.36, middle.a + 0.25 * (fine.a - 0.5));
  // Single leaves lie in the grass too.
  return mix(mix(albedo, litter, amount * bare * 0.94), dry * leaf.y, covered);
}

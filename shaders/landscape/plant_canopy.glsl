// A wood from where its trees are not drawn one by one: of the same mean colour as they, in clumps. Needs frame.glsl.

// Crowns as spots of their size, one in a cell here and there: -0.5 between them .. 0.5 on one, of mean zero; y: how light a crown is
// beside its neighbours, z: its sunny side. `astray` bends their rows. Nothing where spots would be smaller than `pixel` (m).
vec3 crown_spots(vec2 place, vec2 astray, float pixel) {
  const float side = 9.0;
  vec2 at = (vec2(0.8 * place.x + 0.6 * place.y, 0.8 * place.y - 0.6 * place.x) + astray) / side;
  vec2 cell = floor(at);
  vec3 p = fract(cell.xyx * vec3(0.1031, 0.1030, 0.0973));
  p += dot(p, p.yzx + 33.33);
  vec3 random = fract((p.xxy + p.yzz) * p.zyx);
  vec2 within = fract(at) - 0.5 - (random.xy - 0.5) * 0.5;
  float radius = random.z < 0.58 ? 0.36 + 0.3 * random.z : -0.4;
  float soft = 0.12 + 0.5 * pixel / side;
  float spot = 1.0 - smoothstep(radius - soft, radius + soft, length(within));
  float seen = clamp(1.7 - 1.5 * pixel / side, 0.0, 1.0);
  return vec3(spot - 0.31, (random.x - 0.5) * spot, dot(within, frame.light_direction.xy) * 2.0 * spot) * seen;
}

// Share of the ground that crowns hide from the eye. `cover`: share they hide from above; `spot` -0.5..0.5, of mean zero.
float crowns_seen(float cover, vec3 offset, vec3 ground_normal, float to_eye, float spot) {
  // Crowns as ellipsoids that are 1.2 times as high as wide, seen at the angle between view and ground.
  float sine = clamp(-dot(offset, ground_normal) / to_eye, 0.12, 1.0);
  float aslant = sqrt(1.0 + 1.45 * (1.0 / (sine * sine) - 1.0));
  float hidden = 1.0 - pow(1.0 - min(cover, 0.98), aslant);
  return clamp(hidden + spot * 3.6 * hidden * (1.0 - hidden), 0.0, 1.0);
}

// Direct light that crowns send to the eye: a sphere's phases, a little less where the slope turns away. `on_ground`: light on the
// ground under them.
float crown_light(vec3 offset, float to_eye, float on_ground) {
  float towards = clamp(-dot(offset, frame.light_direction.xyz) / to_eye, -1.0, 1.0);
  float angle = acos(towards);
  float lit = (sin(angle) + (3.14159 - angle) * towards) / 3.14159;
  return (0.10 + 0.62 * lit) * (0.6 + 0.4 * on_ground / max(frame.light_direction.z, 0.2));
}

// How near a vertex of the ground is to water. Needs frame.glsl and `lines`.

// Below 0 where nothing that meets the vertex can be wet. `quad`: side of its squares, m.
float nearness_of_water(vec2 uv, float quad, float to_eye) {
  const float told = 8.0;  // m from the shore to which distances are told
  float inside = (textureLod(lines, uv, 0.0).r * 255.0 - 128.0) * (told / 127.0);
  // No point of a triangle is farther from all its corners than this; and shores are drawn wider from afar (shore.glsl).
  float reach = 0.75 * quad + 0.9 + min(2.4 * to_eye / frame.eye.w, 2.2);
  // Of large squares: whether there is none as far as they reach.
  float cell = frame.terrain.x / float(textureSize(lines, 0).x);
  float around = (textureLod(lines, uv, log2(max(quad / cell, 1.0)) + 1.0).r * 255.0 - 128.0) * (told / 127.0);
  return reach < told ? inside + reach : around + told - 0.1;
}

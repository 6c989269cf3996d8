#version 450 core
#include "landscape/frame.glsl"
#include "landscape/atmosphere.glsl"
#include "landscape/plant_light.glsl"
#ifdef WITH_SHADOWS
#include "landscape/plant_dither.glsl"
#include "landscape/shadow_view.glsl"
#include "landscape/shadow.glsl"
in vec3 light;
in vec3 direct;
in vec4 in_shadow;
flat in float nearer;
#endif
layout(binding = 8) uniform sampler2DArray leaves;
in vec3 card;
in vec3 leaf_tone;  // without shadows: of what is lit already
in vec3 wood_tone;
in vec4 veil;
out vec4 colour;

void main() {
  // Sharper than a mean would be: leaves stay leaves.
  vec4 leaf = texture(leaves, card, -0.5);
  if (leaf.a < 0.5) discard;
#ifdef WITH_SHADOWS
  // Leaves pass light on to each other.
  vec3 all_light = light + direct * mix(1.0, light_past_plants(in_shadow.xyz, nearer, in_shadow.w, dither()), mix(1.0 - 0.32 * smoothstep(0.4, 1.2, nearer), 1.0, leaf.b));
#else
  const float all_light = 1.0;
#endif
  vec3 lit = mix(leaf_tone * yellowed_leaf(leaf.g), wood_tone, leaf.b) * all_light * (2.0 * leaf.r);
  colour = vec4(to_screen(mix(lit, veil.rgb, veil.a)), 1.0);
}

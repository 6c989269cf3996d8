#version 450 core
#include "landscape/frame.glsl"
#include "landscape/atmosphere.glsl"
#include "landscape/ground.glsl"
#include "landscape/clouds.glsl"
#include "landscape/shade.glsl"
layout(binding = 6) uniform sampler2D sunlit;
in vec3 offset;
in vec2 within;
uniform float strength;
out vec4 colour;

void main() {
  vec2 place = offset.xy + frame.eye.xy;
  float light_share = texture(sunlit, ground_uv(place)).r * (1.0 - drawn_shade(place).x);
  float dark = smoothstep(1.2, 0.4, length(within)) * strength * mix(0.2, 0.5, light_share) * exp(-0.004 * length(offset));
  colour = vec4(0.02, 0.025, 0.035, dark);
}

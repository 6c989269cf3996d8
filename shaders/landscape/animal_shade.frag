#version 450 core
#include "landscape/frame.glsl"
#include "landscape/ground.glsl"
layout(binding = 6) uniform sampler2D sunlit;
in vec3 offset;
in vec2 within;
out vec4 colour;

void main() {
  float light_share = texture(sunlit, ground_uv(offset.xy + frame.eye.xy)).r;
  float dark = smoothstep(1.2, 0.55, length(within)) * mix(0.22, 0.52, light_share) * exp(-0.004 * length(offset));
  colour = vec4(0.02, 0.025, 0.035, dark);
}

#version 450 core
#include "landscape/frame.glsl"
#include "landscape/atmosphere.glsl"
#include "landscape/ground.glsl"
layout(binding = 6) uniform sampler2D sunlit;
in vec3 offset;
in vec3 normal;
in vec3 coat;
in float above_ground;
out vec4 colour;

void main() {
  vec3 n = normalize(normal);
  vec3 albedo = coat * coat;
  float light_share = texture(sunlit, ground_uv(offset.xy + frame.eye.xy)).r;
  float toward = max(dot(n, frame.light_direction.xyz), 0.0);
  // Bellies and legs see less sky the nearer they are to the ground.
  float open = mix(0.55, 1.0, smoothstep(0.0, 0.8, above_ground)) * (0.7 + 0.3 * n.z);
  vec3 light = frame.light_colour.rgb * toward * light_share +
               mix(frame.ambient_ground.rgb, frame.ambient_sky.rgb, 0.5 + 0.5 * n.z) * open;
  colour = vec4(to_screen(apply_haze(albedo * light, offset, haze(offset))), 1.0);
}

#version 450 core
#include "landscape/frame.glsl"
#include "landscape/atmosphere.glsl"
layout(binding = 3) uniform sampler2D detail;
in vec3 direction;
out vec4 colour;

void main() {
  vec3 toward = normalize(direction);
  vec3 light = sky_colour(vec3(toward.xy, max(toward.z, 0.0)));
  float night = frame.light_direction.w;
  if (toward.z > 0.01) {
    // Fair-weather clouds: two scales of the tileable noise on a plane far above, thinning toward the horizon.
    vec2 plane = toward.xy / (toward.z + 0.12);
    float shape = texture(detail, plane * 0.043 + 0.17).a * 0.62 + texture(detail, plane * 0.13 + 0.61).a * 0.26 +
                  texture(detail, plane * 0.41).b * 0.12;
    float cloud = smoothstep(0.53, 0.72, shape) * smoothstep(0.015, 0.16, toward.z);
    float toward_sun = max(dot(toward, frame.light_direction.xyz), 0.0);
    vec3 lit = frame.ambient_sky.rgb * 1.25 + frame.light_colour.rgb * (0.19 + 0.16 * pow(toward_sun, 4.0)) * (1.15 - 0.5 * shape);
    light = mix(light, lit, cloud * 0.62);
    // Stars.
    if (night > 0.3) {
      vec3 cell = floor(toward * 220.0);
      float star = fract(sin(dot(cell, vec3(12.9898, 78.233, 37.719))) * 43758.5453);
      light += step(0.9985, star) * 0.25 * (night - 0.3) * (1.0 - cloud) * smoothstep(0.02, 0.3, toward.z);
    }
  }
  float sun = dot(toward, frame.sun_direction.xyz);
  float above = smoothstep(-0.03, 0.01, frame.sun_direction.z);
  light += frame.light_colour.rgb * above * (smoothstep(0.99985, 0.99996, sun) * 6.0 + 0.35 * smoothstep(0.9985, 0.99996, sun));
  float moon = dot(toward, frame.light_direction.xyz);
  light += vec3(0.5, 0.55, 0.6) * night * smoothstep(0.99988, 0.99994, moon);
  colour = vec4(to_screen(light), 1.0);
}

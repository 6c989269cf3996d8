#version 450 core
#include "landscape/frame.glsl"
#include "landscape/atmosphere.glsl"
#include "landscape/snow.glsl"
// What falls through the air around the eye: one drop or flake an instance, in a box that goes along with the eye and repeats.
// Where it is follows from its number and the time alone.
uniform vec4 box;  // half side (m), brightness, size
out vec2 within;
flat out vec4 tone;
flat out float flake;

uint hashed(uint value) {
  value = (value ^ (value >> 16)) * 0x7feb352du;
  value = (value ^ (value >> 15)) * 0x846ca68bu;
  return value ^ (value >> 16);
}
float unit(uint key) { return float(key >> 8) / 16777216.0; }

void main() {
  uint key = hashed(uint(gl_InstanceID) + 1u);
  vec3 start = vec3(unit(key), unit(hashed(key + 1u)), unit(hashed(key + 2u)));
  float own = unit(hashed(key + 3u));
  float side = 2.0 * box.x;
  // Rain or snow: by the height, drop by drop.
  flake = own > rain_share(frame.eye.z) ? 1.0 : 0.0;
  float speed = mix(7.5 + 2.5 * start.x, 0.9 + 0.5 * start.x, flake);
  vec3 velocity = vec3(frame.wind.xy * mix(0.75, 0.9, flake), -speed);
  // Flakes flutter.
  vec3 flutter = flake * 0.35 * vec3(sin(frame.wind.z * 1.7 + 40.0 * start.y), cos(frame.wind.z * 1.3 + 40.0 * start.z), 0.0);
  vec3 eye_in_box = fract(frame.eye.xyz / side);
  vec3 moved = fract(velocity * (frame.wind.z / side));
  vec3 at = (fract(start + moved - eye_in_box) - 0.5) * side + flutter;
  float away = max(length(at), 0.05);
  vec2 corner = vec2(gl_VertexID & 1, gl_VertexID >> 1) * 2.0 - 1.0;
  within = corner;
  // A drop is drawn as long as it falls in a fiftieth of a second, never thinner than a pixel; a flake is round.
  float pixel = away / frame.eye.w;
  float half_width = max(mix(0.0016, 0.010 + 0.006 * start.z, flake) * box.z, 0.55 * pixel);
  vec3 along = normalize(velocity);
  vec3 across = normalize(cross(along, at / away) + vec3(1e-5));
  vec3 rain_corner = at + across * corner.x * half_width + along * corner.y * speed * 0.018 * box.z;
  vec3 snow_corner = at + (frame.camera_right.xyz * corner.x + frame.camera_up.xyz * corner.y) * half_width;
  vec3 offset = mix(rain_corner, snow_corner, flake);
  // Thin things cover only a part of the pixel they are drawn on.
  float thin = min(1.0, mix(0.0022, 0.016, flake) * box.z / half_width);
  float fade = smoothstep(0.5, 0.30, max(max(abs(at.x), abs(at.y)), abs(at.z)) / side) * smoothstep(0.25, 1.2, away);
  vec3 light = mix(haze_colour(at) * 1.25 + frame.light_colour.rgb * 0.03, frame.ambient_sky.rgb * 1.35 + 0.5 * frame.light_colour.rgb, flake);
  tone = vec4(to_screen(light), fade * thin * mix(0.42, 0.95, flake) * box.y);
  gl_Position = frame.view_projection * vec4(offset, 1.0);
}

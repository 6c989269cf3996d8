#version 450 core
#include "landscape/frame.glsl"
#include "landscape/ground.glsl"
#include "landscape/plant_kinds.glsl"
layout(location = 4) in vec4 stands;
layout(location = 5) in vec4 own;

uniform vec4 area;  // west, south, side
out vec2 within;
flat out float density;

void main() {
  int plant = int(own.w + 0.5);
  vec4 form = kinds.form[plant];
  float radius = 0.86 * form.x * stands.w;
  float height = form.y * stands.w;
  vec2 corner = vec2(gl_VertexID & 1, gl_VertexID >> 1) * 2.0 - 1.0;
  // A crown's shadow is an ellipse, drawn out away from the light; its middle lies where the crown's centre falls.
  vec3 to_light = frame.light_direction.xyz;
  float level = length(to_light.xy);
  vec2 along = level > 1e-4 ? to_light.xy / level : vec2(1.0, 0.0);
  float slant = level / max(to_light.z, 0.14);
  float middle = 0.5 * (1.0 + form.z) * height;
  float half_crown = 0.5 * (1.0 - form.z) * height;
  // Where it meets the ground: nearer on a slope that faces the light, farther on one that turns away.
  vec2 centre = stands.xy - along * slant * middle;
  float drop = middle;
  for (int step = 0; step < 2; ++step) {
    float below = stands.z + middle - textureLod(heights, ground_uv(centre), 0.0).r;
    drop = clamp(mix(drop, below, 0.7), 0.35 * middle, 2.5 * middle);
    centre = stands.xy - along * slant * drop;
  }
  half_crown *= drop / middle;
  float reach = sqrt(radius * radius + half_crown * half_crown * slant * slant);
  vec2 at = centre + along * corner.x * reach + vec2(-along.y, along.x) * corner.y * radius;
  within = corner;
  density = form.w;
  gl_Position = vec4((at - area.xy) / area.z * 2.0 - 1.0, 0.0, 1.0);
}

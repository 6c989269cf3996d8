#version 450 core
#include "landscape/frame.glsl"
#include "landscape/atmosphere.glsl"
#include "landscape/clouds.glsl"
#include "landscape/ground.glsl"
#include "landscape/shade.glsl"
#include "landscape/plant_kinds.glsl"
#include "landscape/plant_light.glsl"
#include "landscape/plant_lod.glsl"
#include "landscape/snow.glsl"
#include "landscape/plant_snow.glsl"
layout(location = 4) in vec4 stands;
layout(location = 5) in vec4 own;
layout(binding = 6) uniform sampler2D sunlit;
out vec3 picture;         // z: the first of the plant's views
flat out float view;      // from the first, 0, to the last, 2
flat out vec3 sun;        // light direction in the picture's frame
flat out vec2 skyward;    // up and toward components of the zenith
flat out float shaded;    // share of light that other crowns take from its foot, seen from the side
flat out vec4 tone;       // w: sunlit
flat out float back;      // how much one looks toward the light
flat out vec2 shown;
flat out vec4 clumps;     // of leaves across and up, where the crown begins, the plant's own
flat out float bare;      // share of leaves fallen
flat out float snow;      // on what looks up
out vec4 veil;

void main() {
  int plant = int(own.w + 0.5);
  float radius = kinds.form[plant].x * stands.w;
  float height = kinds.form[plant].y * stands.w;
  vec3 foot = stands.xyz - frame.eye.xyz;
  shown = vec2(mesh_share(seen_pixels(foot, height, own.z)), far_share(length(foot), own.z));
  if (radius <= 0.0 || shown.x >= shown.y) {
    gl_Position = vec4(2.0, 2.0, 2.0, 1.0);
    return;
  }
  float across = 9.0;
  clumps = vec4(across, across * clamp(0.5 * height / radius, 0.5, 3.0), kinds.form[plant].z, fract(own.y * 57.3));
  vec3 stand = own_stand(own.y);
  height *= stand.z;
  vec3 centre = foot + vec3(0.0, 0.0, 0.5 * height);
  vec3 away = normalize(centre);
  // Not all plants change to the next view at once. Views are taken from 10, 45 and 75 degrees (render/plant_kinds.cpp).
  float sine = clamp(-away.z, -1.0, 1.0);
  float elevation = asin(sine) + (own.z - 0.5) * 0.12;
  view = smoothstep(0.30, 0.66, elevation) + smoothstep(0.86, 1.22, elevation);
  vec3 right = normalize(vec3(away.y, -away.x, 0.0) + vec3(1e-5, 0.0, 0.0));
  vec3 up = cross(right, away);
  vec2 corner = vec2(gl_VertexID & 1, gl_VertexID >> 1) * 2.0 - 1.0;
  float half_height = 0.5 * height * sqrt(1.0 - sine * sine) + radius * abs(sine);
  vec3 offset = centre + right * corner.x * radius + up * corner.y * half_height + vec3(stand.xy * (0.5 + 0.5 * corner.y) * height, 0.0);
  float mirrored = own.x > 3.14159 ? -1.0 : 1.0;
  picture = vec3(vec2(corner.x * mirrored, corner.y) * 0.5 + 0.5, float((plant * 2 + own_model(own.y)) * 3));
  vec3 to_light = frame.light_direction.xyz;
  sun = vec3(dot(to_light, right) * mirrored, dot(to_light, up), -dot(to_light, away));
  skyward = vec2(up.z, -away.z);
  back = max(dot(away, to_light), 0.0);
  // The picture has the mean colour of its kind.
  vec3 mean = mix(kinds.fresh[plant].rgb, kinds.turned[plant].rgb, kinds.turned[plant].w);
  vec3 ratio = own_leaf(plant, own.y) / max(mean, vec3(0.01));
  float sunny = textureLod(sunlit, ground_uv(stands.xy), 0.0).r * cloud_light(stands.xy, stands.z);
  shaded = drawn_shade(stands.xy).x * 0.85 * (1.0 - 0.5 * view);
  tone = vec4(own_tone(own.y) * ratio, sunny);
  bare = step(0.5, kinds.fresh[plant].w);
  snow = crown_snow(stands.z, vec3(0.0, 0.0, 1.0), plant, own.y);
  // Through twigs one sees what is behind them.
  veil = vec4(haze_colour(centre), mix(haze(centre), 1.0, 0.08 * bare));
  gl_Position = frame.view_projection * vec4(offset, 1.0);
}

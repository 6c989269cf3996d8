#version 450 core
// A plant's picture from afar turned toward the light: its outline is the outline of its shadow.
#include "landscape/frame.glsl"
#include "landscape/plant_kinds.glsl"
#include "landscape/plant_light.glsl"
#include "landscape/shadow_view.glsl"
layout(location = 4) in vec4 stands;
layout(location = 5) in vec4 own;
uniform int cascade;
uniform vec3 origin;  // place of the land, m
uniform vec4 square;  // from there: middle, half side, depth of the middle
const float texels = 2048.0;
const float elevations[3] = float[](0.17453, 0.78540, 1.30900);
out vec3 picture;

void main() {
  int plant = int(own.w + 0.5);
  float radius = kinds.form[plant].x * stands.w;
  vec3 stand = own_stand(own.y);
  float height = kinds.form[plant].y * stands.w * stand.z;
  // What is smaller than a texel is not seen.
  if (radius * texels <= square.z) {
    gl_Position = vec4(2.0, 2.0, 2.0, 1.0);
    return;
  }
  vec3 toward = shadows.toward[cascade].xyz;
  float elevation = asin(clamp(toward.z, 0.0, 1.0));
  int view = elevation < 0.45 ? 0 : elevation < 1.03 ? 1 : 2;
  vec2 corner = vec2(gl_VertexID & 1, gl_VertexID >> 1) * 2.0 - 1.0;
  // Metres up across the light from the plant's middle: as the picture holds them, stretched so that foot and top are where the light
  // sees them.
  float foot_pictured = 0.5 * height * cos(elevations[view]);
  float top_pictured = foot_pictured + radius * sin(elevations[view]);
  float foot_seen = 0.5 * height * cos(elevation);
  float top_seen = foot_seen + radius * sin(elevation);
  float up = (corner.y * top_pictured + foot_pictured) * (top_seen + foot_seen) / (top_pictured + foot_pictured) - foot_seen;
  vec3 lean = vec3(stand.xy * (0.5 + 0.5 * corner.y) * height, 0.0);
  vec3 seen = in_light(cascade, stands.xyz - origin + vec3(0.0, 0.0, 0.5 * height) + lean);
  // Along the light it lies where the stem is.
  vec3 at = seen + vec3(corner.x * radius, up, corner.y * 0.5 * height * toward.z);
  picture = vec3(vec2(corner.x * (own.x > 3.14159 ? -1.0 : 1.0), corner.y) * 0.5 + 0.5, float((plant * 2 + own_model(own.y)) * 3 + view));
  gl_Position = vec4((at.xy - square.xy) / square.z, (square.w - at.z) * shadows.right[cascade].w, 1.0);
}

#version 450 core
#include "landscape/frame.glsl"
layout(location = 0) in vec2 corner;  // -1..1
layout(location = 4) in vec4 place;
layout(location = 5) in vec4 motion;
layout(location = 6) in vec4 pose;
layout(location = 7) in vec4 stand;
#include "landscape/animal_skeleton.glsl"
uniform float strength;
out vec3 offset;
out vec2 within;

// The shadow of a trunk on legs is an ellipse about, from the feet to where the back's shadow ends.
void main() {
  float height = skeleton.body.w;
  vec3 light = frame.light_direction.xyz;
  // Where shadows are drawn, what is left lies right under the animal.
  vec2 slant = -light.xy / max(light.z, 0.22) * smoothstep(0.5, 0.9, strength);
  float half_height = mix(0.46, 0.25, pose.y) * height;
  // Half axes squared of the ellipse: the trunk's from above, drawn out along the light.
  vec2 ahead = motion.xy;
  vec2 left = vec2(-ahead.y, ahead.x);
  float a = skeleton.look.y * skeleton.look.y;
  float b = skeleton.look.z * skeleton.look.z;
  float c = half_height * half_height;
  float xx = a * ahead.x * ahead.x + b * left.x * left.x + c * slant.x * slant.x;
  float xy = a * ahead.x * ahead.y + b * left.x * left.y + c * slant.x * slant.y;
  float yy = a * ahead.y * ahead.y + b * left.y * left.y + c * slant.y * slant.y;
  // A unit circle becomes that ellipse by the square root (Cholesky) of the matrix.
  float l11 = sqrt(xx);
  float l21 = xy / l11;
  float l22 = sqrt(max(yy - l21 * l21, 1e-6));
  vec2 out_to = corner * 1.25;
  vec2 at = vec2(l11 * out_to.x, l21 * out_to.x + l22 * out_to.y) + slant * half_height;
  at *= place.w;
  float rise = stand.x * dot(at, ahead) + stand.y * dot(at, left);
  offset = place.xyz + vec3(at, rise + 0.03);
  within = out_to;
  gl_Position = frame.view_projection * vec4(offset, 1.0);
}

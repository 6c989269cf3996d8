#version 450 core
// A map laid over the finished picture, on the ground and on what stands on it: render/map_drape.hpp.
in vec2 place;  // 0..1 from the lower left corner
uniform vec3 eye;      // m
uniform vec3 forward;  // to the middle of the picture; `right` and `up` to its edges
uniform vec3 right;
uniform vec3 up;
uniform vec2 planes;   // 1 / near, 1 / far
uniform vec2 ground;   // m, east and north
uniform vec2 covered;  // share of the texture that holds the map
layout(binding = 0) uniform sampler2D depths;
layout(binding = 1) uniform sampler2D picture;
layout(binding = 2) uniform sampler2D map_colours;  // premultiplied; the north-west corner first
out vec4 seen;

void main() {
  float depth = texture(depths, place).r;
  if (depth >= 1.0) discard;  // the sky
  vec2 towards = place * 2.0 - 1.0;
  vec3 at = eye + (forward + right * towards.x + up * towards.y) / mix(planes.x, planes.y, depth);
  vec2 share = vec2(at.x, ground.y - at.y) / ground;
  if (any(lessThan(share, vec2(0.0))) || any(greaterThan(share, vec2(1.0)))) discard;
  vec4 colour = texture(map_colours, share * covered);
  // Relief and light show through.
  float light = dot(texture(picture, place).rgb, vec3(0.30, 0.59, 0.11));
  seen = vec4(min(colour.rgb * (0.55 + 1.1 * light), vec3(colour.a)), colour.a);
}

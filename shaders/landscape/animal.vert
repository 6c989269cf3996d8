#version 450 core
#include "landscape/frame.glsl"
layout(location = 0) in vec3 position;
layout(location = 1) in vec3 normal_in;
layout(location = 2) in vec3 colour_in;
layout(location = 3) in vec4 rig;
layout(location = 4) in vec4 place;   // relative to the eye; w: size
layout(location = 5) in vec4 motion;  // sine and cosine of the heading, phase, speed
layout(location = 6) in vec4 pose;    // head down, pitch of the ground, shade
out vec3 offset;
out vec3 normal;
out vec3 coat;
out float above_ground;

// Turns p and n about a joint in the plane of symmetry; positive lifts what lies ahead.
void turn(inout vec3 p, inout vec3 n, vec2 joint, float angle) {
  float s = sin(angle);
  float c = cos(angle);
  vec2 q = p.xz - joint;
  p.xz = joint + vec2(c * q.x - s * q.y, s * q.x + c * q.y);
  n.xz = vec2(c * n.x - s * n.z, s * n.x + c * n.z);
}

void main() {
  vec3 p = position;
  vec3 n = normal_in;
  float walk = clamp(motion.w / 0.6, 0.0, 1.0);
  if (rig.x > 1.5) {
    turn(p, n, rig.zw, -pose.x * 1.15 + 0.05 * walk * sin(motion.z * 12.566));
  } else if (rig.x > 0.5) {
    float swing = sin((motion.z + rig.y) * 6.2832);
    turn(p, n, rig.zw, 0.38 * walk * swing);
    // The foot that comes forward is lifted.
    p.z += 0.10 * walk * rig.w * max(cos((motion.z + rig.y) * 6.2832), 0.0) * (1.0 - position.z / rig.w);
  }
  turn(p, n, vec2(0.0), pose.y);
  p *= place.w;
  above_ground = p.z;
  vec2 ahead = motion.xy;
  vec2 left = vec2(-ahead.y, ahead.x);
  offset = place.xyz + vec3(ahead * p.x + left * p.y, p.z);
  normal = vec3(ahead * n.x + left * n.y, n.z);
  coat = colour_in * pose.z;
  gl_Position = frame.view_projection * vec4(offset, 1.0);
}

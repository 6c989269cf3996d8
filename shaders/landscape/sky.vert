#version 450 core
#include "landscape/frame.glsl"
out vec3 direction;
void main() {
  vec2 corner = vec2((gl_VertexID << 1) & 2, gl_VertexID & 2) * 2.0 - 1.0;
  float tangent = frame.camera_forward.w;
  direction = frame.camera_forward.xyz + frame.camera_right.xyz * corner.x * tangent * frame.camera_right.w +
              frame.camera_up.xyz * corner.y * tangent;
  gl_Position = vec4(corner, 1.0, 1.0);
}

// What the light sees: ShadowUniforms of render/shadow_map.cpp.
layout(std140, binding = 3) uniform Shadows {
  vec4 right;        // w: 1 / metres from the middle of the depth to its ends
  vec4 up;
  vec4 toward;       // toward the light; w: strength
  vec4 cascades[3];  // centre, half side, softness of edges (m)
  vec4 depths;       // of each: metres toward the light where depth is one half
} shadows;

// Metres to the light's right and up, and toward it, from the eye.
vec3 in_light(vec3 offset) { return vec3(dot(shadows.right.xyz, offset), dot(shadows.up.xyz, offset), dot(shadows.toward.xyz, offset)); }

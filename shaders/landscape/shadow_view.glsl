// What the light sees: ShadowUniforms of render/shadow_map.cpp, three squares. Each has a light of its own: that of when it was drawn.
layout(std140, binding = 3) uniform Shadows {
  vec4 right[3];     // w: 1 / metres from the middle of the depth to its ends
  vec4 up[3];        // w: metres toward the light where depth is one half
  vec4 toward[3];    // toward the light; w: strength
  vec4 cascades[3];  // centre, half side, softness of edges (m)
} shadows;

// Metres to the light's right and up, and toward it, from the eye.
vec3 in_light(int cascade, vec3 offset) {
  return vec3(dot(shadows.right[cascade].xyz, offset), dot(shadows.up[cascade].xyz, offset), dot(shadows.toward[cascade].xyz, offset));
}

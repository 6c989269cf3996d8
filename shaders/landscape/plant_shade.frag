#version 450 core
in vec2 within;
flat in float density;
out vec4 shade;
// Thinner toward the rim, where light comes past fewer leaves.
void main() { shade = vec4(density * (1.0 - smoothstep(0.45, 1.0, length(within)))); }

#version 450 core
in vec2 within;
flat in float density;
out vec4 shade;
void main() { shade = vec4(density * (1.0 - smoothstep(0.62, 1.0, length(within)))); }

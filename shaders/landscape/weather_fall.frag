#version 450 core
in vec2 within;
flat in vec4 tone;
flat in float flake;
out vec4 colour;

void main() {
  float drop = (1.0 - within.x * within.x) * (1.0 - within.y * within.y);
  float round_one = smoothstep(1.0, 0.35, length(within));
  colour = vec4(tone.rgb, tone.a * mix(drop, round_one, flake));
}

// Depth of a picture that is drawn: render/screen_effects.hpp.
layout(binding = 1) uniform sampler2D depths;
uniform vec2 planes;  // nearest and farthest, m

// Metres along the view.
float metres(float depth) { return planes.x * planes.y / (planes.y - depth * (planes.y - planes.x)); }

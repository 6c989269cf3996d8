// Where the ground is: height texture over the terrain, mirrored beyond its border. Needs frame.glsl.
layout(binding = 0) uniform sampler2D heights;

vec2 ground_uv(vec2 place) { return vec2(place.x / frame.terrain.x, 1.0 - place.y / frame.terrain.y); }

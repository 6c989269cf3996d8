#version 450 core
// Shaded relief at the terrain's own resolution: rgb is a muted hypsometric tint, a is the shade (0.5 on flat ground).
layout(location = 0) out vec4 relief;
uniform sampler2D height_map;
uniform vec2 height_range;   // lowest, highest, m
uniform float cell_size;     // m
uniform float exaggeration;

float height_at(ivec2 cell) {
  return texelFetch(height_map, clamp(cell, ivec2(0), textureSize(height_map, 0) - 1), 0).r;
}

vec3 tint(float height) {
  if (height < 0.0 && height_range.x < 0.0) {
    return mix(vec3(0.62, 0.71, 0.74), vec3(0.30, 0.42, 0.52), clamp(height / min(height_range.x, -1.0), 0.0, 1.0));
  }
  float low = max(height_range.x, min(0.0, height_range.y));
  float t = clamp((height - low) / max(height_range.y - low, 1.0), 0.0, 1.0);
  const vec3 stops[5] = vec3[5](vec3(0.560, 0.608, 0.478), vec3(0.690, 0.690, 0.545), vec3(0.745, 0.690, 0.560),
                                vec3(0.690, 0.615, 0.535), vec3(0.865, 0.850, 0.825));
  float position = t * 4.0;
  int stop = min(int(position), 3);
  return mix(stops[stop], stops[stop + 1], smoothstep(0.0, 1.0, position - float(stop)));
}

void main() {
  ivec2 cell = ivec2(gl_FragCoord.xy);
  float nw = height_at(cell + ivec2(-1, -1)), n = height_at(cell + ivec2(0, -1)), ne = height_at(cell + ivec2(1, -1));
  float w = height_at(cell + ivec2(-1, 0)), e = height_at(cell + ivec2(1, 0));
  float sw = height_at(cell + ivec2(-1, 1)), s = height_at(cell + ivec2(0, 1)), se = height_at(cell + ivec2(1, 1));
  float east = (ne + 2.0 * e + se - nw - 2.0 * w - sw) / (8.0 * cell_size) * exaggeration;
  float north = (nw + 2.0 * n + ne - sw - 2.0 * s - se) / (8.0 * cell_size) * exaggeration;
  vec3 normal = normalize(vec3(-east, -north, 1.0));
  // Four lights around the north-west, so that no valley lies in one flat shadow.
  const float altitude = 0.74;
  const vec4 azimuth = radians(vec4(225.0, 270.0, 315.0, 360.0));
  const vec4 weight = vec4(0.14, 0.22, 0.44, 0.20);
  float light = 0.0;
  for (int i = 0; i < 4; ++i) {
    vec3 sun = vec3(sin(azimuth[i]) * cos(altitude), cos(azimuth[i]) * cos(altitude), sin(altitude));
    light += weight[i] * max(dot(normal, sun), 0.0);
  }
  float shade = 0.5 * light / sin(altitude);
  // Hollows a little darker, crests a little lighter: texture that one light direction cannot give.
  float laplacian = (n + s + e + w - 4.0 * height_at(cell)) / cell_size;
  shade -= clamp(laplacian * 0.10 * exaggeration, -0.05, 0.07);
  relief = vec4(tint(height_at(cell)), clamp(shade, 0.0, 1.0));
}

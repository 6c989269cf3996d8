#version 450 core
// The map's ground: relief, a map over it, water, contours and the hatch of what was painted.
layout(location = 0) out vec4 colour;
uniform sampler2D relief_map;
uniform sampler2D height_map;
uniform sampler2D water_map;    // r: wet, g: depth on a square-root scale
uniform sampler2D overlay_map;
uniform sampler2D colour_table; // a row a colour map
uniform sampler2D hatch_map;    // coverage of paint
uniform sampler2D beyond_map;   // 1 where paint asks for more than there is

uniform vec2 viewport;
uniform vec2 centre;            // cells
uniform float cells_per_pixel;
uniform vec2 map_size;          // cells
uniform float cells_per_texel;  // of relief and heights, more than 1 while they are coarse
uniform vec3 background;
uniform float brightness;
uniform bool show_water;
uniform float contour_step;     // m, 0: none
uniform bool show_overlay;
uniform vec2 overlay_range;
uniform float overlay_clear;    // values at or below are clear
uniform float overlay_opacity;
uniform int overlay_colours;    // row of the colour table
uniform bool overlay_categorical;
uniform float line_step;        // between iso-lines of the map, 0: none
uniform bool show_hatch;
uniform bool show_beyond;
uniform float pixel_scale;

float overlay_value(vec2 cell) { return texture(overlay_map, (cell + 0.5) / map_size).r; }

// Colour and presence of the map at one place.
vec4 overlay_colour(vec2 cell) {
  float value = overlay_categorical ? texelFetch(overlay_map, clamp(ivec2(floor(cell + 0.5)), ivec2(0), ivec2(map_size) - 1), 0).r
                                    : overlay_value(cell);
  if (isnan(value) || value <= overlay_clear) return vec4(0.0);
  float rows = float(textureSize(colour_table, 0).y);
  float row = (float(overlay_colours) + 0.5) / rows;
  float t;
  if (overlay_categorical) {
    t = (mod(floor(value + 0.5), 12.0) + 0.5) / 12.0;
    return vec4(texture(colour_table, vec2(t, row)).rgb, 1.0);
  }
  t = clamp((value - overlay_range.x) / max(overlay_range.y - overlay_range.x, 1e-9), 0.0, 1.0);
  float soft = 1.0;
  if (!isnan(overlay_clear)) {
    soft = smoothstep(0.0, 0.06, (value - overlay_clear) / max(overlay_range.y - overlay_range.x, 1e-9));
  }
  return vec4(texture(colour_table, vec2(mix(0.5 / 256.0, 255.5 / 256.0, t), row)).rgb, soft);
}

// How much of an iso-line of the map covers the pixel. The map is smoothed over a few pixels, or its grain would draw crumbs.
float iso_line(vec2 cell) {
  float reach = max(cells_per_pixel * 2.0, 0.75);
  float sum = 0.0;
  for (int y = -1; y <= 1; ++y) {
    for (int x = -1; x <= 1; ++x) sum += overlay_value(cell + vec2(x, y) * reach) * (2.0 - abs(x)) * (2.0 - abs(y));
  }
  if (isnan(sum)) return 0.0;
  float level = sum / 16.0 / line_step;
  float spread = max(fwidth(level), 1e-6);
  float away = abs(fract(level - 0.5) - 0.5) / spread;
  return (1.0 - smoothstep(0.4, 1.3, away / pixel_scale)) * (1.0 - smoothstep(0.15, 0.40, spread)) * step(0.5, level);
}

void main() {
  vec2 pixel = vec2(gl_FragCoord.x, viewport.y - gl_FragCoord.y);
  vec2 cell = centre + (pixel - 0.5 * viewport) * cells_per_pixel;
  vec2 where = (cell + 0.5) / map_size;
  vec2 beyond = max(max(-where, where - 1.0), 0.0) * map_size / cells_per_pixel;
  float outside = max(beyond.x, beyond.y);
  if (outside > 0.0) {
    // A soft edge lifts the sheet from the table.
    float shadow = exp(-outside / (7.0 * pixel_scale)) * 0.35;
    colour = vec4(background * (1.0 - shadow), 1.0);
    return;
  }
  float water_lod = log2(max(cells_per_pixel, 1.0));
  float lod = log2(max(cells_per_pixel / cells_per_texel, 1.0));
  vec4 relief = textureLod(relief_map, where, max(lod - 0.35, 0.0));
  float shade = relief.a * 2.0;
  vec3 ground = relief.rgb * mix(0.35, 1.0, clamp(shade, 0.0, 1.0)) + 0.30 * max(shade - 1.0, 0.0);
  vec3 result = ground * brightness;

  if (show_overlay) {
    vec4 over = vec4(0.0);
    if (cells_per_pixel > 1.4 && !overlay_categorical) {
      float step_size = 0.25 * cells_per_pixel;
      over += overlay_colour(cell + vec2(-step_size, -step_size));
      over += overlay_colour(cell + vec2(step_size, -step_size));
      over += overlay_colour(cell + vec2(-step_size, step_size));
      over += overlay_colour(cell + vec2(step_size, step_size));
      over.rgb /= 4.0;
      over.a /= 4.0;
    } else {
      over = overlay_colour(cell);
    }
    if (over.a > 0.0) {
      // The map keeps a little of the shade so that the land stays readable beneath it.
      vec3 lit = over.rgb * mix(0.62, 1.06, clamp(shade * 0.72, 0.0, 1.0));
      result = mix(result, lit, over.a * overlay_opacity);
    }
  }

  if (show_water) {
    vec2 wet = textureLod(water_map, where, max(water_lod - 0.5, 0.0)).rg;
    float mask = smoothstep(0.32, 0.62, wet.r);
    vec3 water = mix(vec3(0.42, 0.62, 0.74), vec3(0.13, 0.30, 0.46), clamp(wet.g, 0.0, 1.0));
    result = mix(result, water * brightness * 1.04, mask * (show_overlay ? 0.80 : 0.92));
  }

  if (contour_step > 0.0) {
    float level = textureLod(height_map, where, max(lod, 0.0)).r / contour_step;
    float spread = max(fwidth(level), 1e-6);
    float thin = abs(fract(level - 0.5) - 0.5) / spread;
    float thick = abs(fract(level / 5.0 - 0.5) - 0.5) / (spread / 5.0);
    float crowded = 1.0 - smoothstep(0.18, 0.42, spread);
    float line = 0.30 * crowded * (1.0 - smoothstep(0.35, 1.05, thin / pixel_scale));
    line = max(line, 0.50 * (1.0 - smoothstep(0.5, 1.5, thick / pixel_scale)) * (1.0 - smoothstep(0.9, 2.0, spread)));
    result = mix(result, vec3(0.27, 0.19, 0.12), line * (show_overlay ? 0.6 : 1.0));
  }

  if (line_step > 0.0 && !overlay_categorical) result = mix(result, vec3(0.05, 0.05, 0.06), 0.7 * iso_line(cell));

  if (show_hatch) {
    float paint = texture(hatch_map, where).r;
    if (paint > 0.02) {
      float across = (pixel.x + pixel.y) / (7.0 * pixel_scale);
      float line = 1.0 - smoothstep(0.10, 0.10 + 0.2 / pixel_scale, abs(fract(across) - 0.5));
      result = mix(result, vec3(1.0), 0.38 * line * smoothstep(0.02, 0.25, paint));
      float edge = 1.0 - smoothstep(0.0, 1.2 * pixel_scale * max(fwidth(paint), 1e-4), abs(paint - 0.06));
      result = mix(result, vec3(1.0), 0.35 * edge);
    }
  }
  if (show_beyond) {
    float across = (pixel.x - pixel.y) / (9.0 * pixel_scale);
    float line = 1.0 - smoothstep(0.12, 0.12 + 0.2 / pixel_scale, abs(fract(across) - 0.5));
    result = mix(result, vec3(0.86, 0.20, 0.16), 0.55 * line * texture(beyond_map, where).r);
  }
  colour = vec4(result, 1.0);
}

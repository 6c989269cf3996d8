// Water of rivers, lakes and the sea. Needs frame.glsl, atmosphere.glsl, clouds.glsl and `with_detail`.
layout(binding = 11) uniform sampler2D currents;  // flow to the east and north, depth, roughness (render/water_flow.hpp)
const float fastest_flow = 3.0;
const float deepest_water = 6.0;

struct WaterSurface {
  vec3 normal;
  float foam;
};

// What flows is noise carried along: two copies that start anew in turn, each while the other is in full sight.
WaterSurface flowing_surface(vec2 place, vec2 flow, float rough, float to_eye, float grazing, float lake) {
  const float renewal = 2.6;
  float turn = frame.wind.z / renewal;
  float first = fract(turn);
  float second = fract(turn + 0.5);
  float weight = abs(2.0 * first - 1.0);
  vec2 carried = flow * renewal;
  // Detail that a pixel holds, seen at half the slant it is: mipmaps by the full slant would smooth all waves away.
  float lod = log2(to_eye / frame.eye.w * 512.0 * inversesqrt(grazing)) + 0.8;
  vec4 a = textureLod(detail, (place - carried * (first - 0.5)) * 0.105, max(lod - 3.25, 2.3));
  vec4 b = textureLod(detail, (place - carried * (second - 0.5)) * 0.105 + 0.43, max(lod - 3.25, 2.3));
  vec4 ripples = mix(a, b, weight);
  // Wind waves run across lakes, in two directions that differ a little.
  float wind = min(length(frame.wind.xy), 16.0);
  vec2 blown = frame.wind.xy * frame.wind.z;
  vec4 waves = textureLod(detail, place * 0.037 - blown * 0.010, max(lod - 4.76, 1.6));
  float near = exp(-to_eye * 0.010);
  vec2 slope = (ripples.rg - 0.502) * (0.50 + 0.70 * rough + 0.20 * min(length(flow), 2.0)) * (0.5 + 0.5 * near) +
               (waves.rg - 0.502) * (0.05 + 0.045 * wind) * mix(0.5, 1.0, lake) * exp(-to_eye * 0.002);
  if (with_detail) {
    vec4 large = textureLod(detail, vec2(place.x * 0.8 - place.y * 0.6, place.x * 0.6 + place.y * 0.8) * 0.011 - blown * 0.0022, max(lod - 6.51, 1.0));
    vec4 small = textureLod(detail, (place - carried * (first - 0.5)) * 0.33 + 0.2, max(lod - 1.6, 2.4));
    vec4 small_next = textureLod(detail, (place - carried * (second - 0.5)) * 0.33 + 0.71, max(lod - 1.6, 2.4));
    slope += (large.rg - 0.502) * (0.03 + 0.03 * wind) * lake * exp(-to_eye * 0.0012);
    slope += (mix(small, small_next, weight).rg - 0.502) * (0.30 + 0.50 * rough) * near;
  }
  WaterSurface surface;
  surface.normal = normalize(vec3(slope, 1.0));
  float crest = mix(a.b * a.a, b.b * b.a, weight);
  surface.foam = smoothstep(0.74 - 0.34 * rough, 1.02 - 0.34 * rough, crest + 0.22 * waves.b) * smoothstep(0.12, 0.7, rough);
  surface.foam *= clamp(0.25 + 7.0 * (slope.x + slope.y), 0.15, 1.0);
  return surface;
}

#ifdef WITH_SHADOWS
layout(binding = 13) uniform sampler2D mirrored_picture;
layout(binding = 14) uniform sampler2D mirrored_depths;
uniform vec3 mirror;  // nearest and farthest depth of these, m; z: 1 when there are any

// What stands in the way of a ray from the water, as the picture shows it so far; a: how surely.
vec4 mirrored_scene(vec3 offset, vec3 ray, float start) {
  float stride = 0.25 + 0.012 * length(offset);
  vec3 at = offset + ray * stride * start;
  vec3 last = at;
  float found = 0.0;
  for (int i = 0; i < 26 && found < 0.5; ++i) {
    last = at;
    at += ray * stride;
    vec4 seen = frame.view_projection * vec4(at, 1.0);
    vec2 uv = seen.xy / seen.w * 0.5 + 0.5;
    float depth = textureLod(mirrored_depths, uv, 0.0).r;
    float behind = seen.w - mirror.x * mirror.y / (mirror.y - depth * (mirror.y - mirror.x));
    // What is hidden behind a near plant is taken to look like it.
    found = step(0.0, behind) * step(0.1, seen.w);
    stride *= 1.17;
  }
  for (int i = 0; i < 4; ++i) {
    vec3 middle = 0.5 * (at + last);
    vec4 seen = frame.view_projection * vec4(middle, 1.0);
    float depth = textureLod(mirrored_depths, seen.xy / seen.w * 0.5 + 0.5, 0.0).r;
    bool behind = seen.w > mirror.x * mirror.y / (mirror.y - depth * (mirror.y - mirror.x));
    at = behind ? middle : at;
    last = behind ? last : middle;
  }
  vec4 seen = frame.view_projection * vec4(at, 1.0);
  vec2 uv = seen.xy / seen.w * 0.5 + 0.5;
  vec2 edge = smoothstep(vec2(0.0), vec2(0.08), uv) * (1.0 - smoothstep(vec2(0.92), vec2(1.0), uv));
  return vec4(from_screen(textureLod(mirrored_picture, uv, 0.0).rgb), found * edge.x * edge.y * mirror.z);
}
#endif

// Rings that drops draw: one in every cell of half a metre, each with its own time.
vec2 rain_rings(vec2 place, float rain) {
  vec2 at = place * 2.2;
  vec2 cell = floor(at);
  vec2 random = fract(sin(vec2(dot(cell, vec2(12.99, 78.23)), dot(cell, vec2(39.35, 11.14)))) * 43758.55);
  float age = fract(frame.wind.z * 1.3 + random.x * 7.0);
  vec2 from = fract(at) - 0.3 - 0.4 * random;
  float away = length(from);
  float wave = sin(34.0 * (away - 0.45 * age)) * smoothstep(0.14, 0.0, abs(away - 0.42 * age)) * (1.0 - age);
  return from / max(away, 0.02) * wave * step(random.y, rain);
}

// `bed`: colour of the ground under water; `inside`: metres to the shore; `sun`: share of direct light; `trees`: colour of crowns
// nearby and their cover.
vec3 water_colour(vec3 offset, vec2 place, vec2 uv, vec3 bed, float inside, float sun, vec4 trees, float to_eye) {
  vec3 view = offset / to_eye;
  vec4 coded = texture(currents, uv);
  vec2 flow = (coded.rg * (255.0 / 127.0) - 128.0 / 127.0) * fastest_flow;
  float lake = 1.0 - smoothstep(0.02, 0.2, length(flow));
  WaterSurface surface = flowing_surface(place, flow, coded.a, to_eye, clamp(-view.z, 0.02, 1.0), lake);
  if (with_detail) {
    float rain = frame.weather.y * rain_share(frame.eye.z + offset.z);
    surface.normal = normalize(surface.normal + vec3(rain_rings(place, rain) * 0.22 * exp(-to_eye * 0.05), 0.0));
  }
  // Waves that face away are not seen.
  surface.normal = normalize(surface.normal - view * max(dot(surface.normal, view) + 0.03, 0.0));
  float facing = max(dot(-view, surface.normal), 0.0);
  float away = 1.0 - facing;
  float fresnel = 0.02 + 0.98 * away * away * away * away * away;
  vec3 bounced = reflect(view, surface.normal);
  bounced.z = max(bounced.z, 0.03);
  bounced = normalize(bounced);
  vec3 mirrored = sky_colour(bounced);
  // Trees on the banks stand before the low sky.
  vec3 shade_light = frame.ambient_sky.rgb * 0.75 + frame.light_colour.rgb * 0.16 * sun;
  float reach = mix(0.62, 0.20, clamp(inside / 8.0, 0.0, 1.0) * lake);
  float silhouette = trees.a * smoothstep(reach, reach * 0.45, bounced.z);
  mirrored = mix(mirrored, trees.rgb * shade_light, 0.92 * silhouette);
#ifdef WITH_SHADOWS
  vec4 scene = mirrored_scene(offset, bounced, dither());
  mirrored = mix(mirrored, scene.rgb, scene.a);
#endif
  mirrored *= 1.0 - 0.35 * exp2(-bounced.z * 14.0) * (1.0 - lake);

  float depth = min(0.06 + 0.40 * inside, coded.b * deepest_water + 0.12) ;
  float path = depth * (1.0 + 0.5 * away);
  vec3 clear = exp2(-path * vec3(1.7, 0.95, 1.15));
  vec3 light = frame.light_colour.rgb * sun * max(frame.light_direction.z, 0.0) + frame.ambient_sky.rgb;
  // Light that waves gather on the bed.
  float caustics = 1.0 + (surface.normal.x - surface.normal.y) * 2.4 * exp(-depth * 0.8);
  vec3 body = mix(vec3(0.010, 0.026, 0.023), bed * 0.62 * caustics, clear) * light;
  vec3 half_way = normalize(frame.light_direction.xyz - view);
  float glint = max(dot(half_way, surface.normal), 0.0);
  glint *= glint; glint *= glint; glint *= glint; glint *= glint; glint *= glint; glint *= glint; glint *= glint;
  vec3 result = mix(body, mirrored, fresnel) + frame.light_colour.rgb * glint * glint * glint * 1.1 * sun * frame.stars.w;
  result = mix(result, light * 0.50, surface.foam * 0.62);
  // Well below freezing, ice: all over a lake, along the banks of a river.
  float cold = 1.0 - 2.0 * (frame.eye.z + offset.z - frame.fall.x) / max(frame.fall.y, 1.0);
  float patches = texture(detail, place * 0.0037).a;
  float ice = smoothstep(-1.5, -5.0, cold + 3.0 * (patches - 0.5)) * mix(1.0 - smoothstep(0.2, 1.8, inside + 1.5 * (patches - 0.5)), 1.0, lake);
  vec3 ice_light = mix(mirrored, frame.light_colour.rgb * sun * max(frame.light_direction.z, 0.0) + frame.ambient_sky.rgb, 0.8);
  return mix(result, vec3(0.52, 0.60, 0.66) * (0.75 + 0.5 * patches) * ice_light, ice * 0.92);
}

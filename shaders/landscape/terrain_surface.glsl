// The ground's colour. A file that includes this says first whether water may be near (`with_water`), whether crowns are painted on
// the ground (`with_canopy`) and whether there is time for small things (`with_detail`): software renderers run both sides of every
// branch, so what a patch cannot need must be compiled out.
#ifdef WITH_SHADOWS
#include "landscape/shadow_view.glsl"
#include "landscape/shadow.glsl"
#endif
layout(binding = 1) uniform sampler2D normals;
layout(binding = 2) uniform sampler2D ground_colours;
layout(binding = 4) uniform sampler2D canopy_colours;
layout(binding = 5) uniform sampler2D lines;        // red: distance to the shore, green: worn earth
layout(binding = 6) uniform sampler2D sunlit;
uniform vec4 canopy_range;  // metres from which the canopy is painted on the ground, and where wholly; z: strength
uniform vec4 show;          // water, trails
in vec3 offset;
in vec2 place;
in vec4 veil;        // colour of the haze before it, and its share
in float clear_sky;  // share of direct light that clouds let through
#ifdef WITH_LESS
// What changes slowly from place to place comes from the vertices.
in vec2 on_map;         // where the place is on the ground's textures
in vec3 early;          // broad noise, cover of crowns toward the light, and how much of the light these take
flat in vec4 reflected; // of a place beyond the border: signs of its slopes, and how they are sheared
#endif
out vec4 colour;

#include "landscape/shore.glsl"
#include "landscape/brush_ring.glsl"

vec3 ambient(vec3 normal, float open) {
  return mix(frame.ambient_ground.rgb, frame.ambient_sky.rgb, 0.5 + 0.5 * normal.z) * open;
}

// Share of crowns that are painted on the ground: those that are not drawn as plants. Beyond the border there are no plants.
float painted_share(float to_eye) {
  vec2 inside = step(vec2(0.0), place) * step(place, frame.terrain.xy);
  return max(smoothstep(canopy_range.x, canopy_range.y, to_eye), 1.0 - inside.x * inside.y);
}

// Share of direct light that crowns let through to the ground, and (y) of the sky's. `cover`: share of ground under crowns around.
vec2 light_under_crowns(float cover, float painted) {
  vec2 drawn = drawn_shade(place);
#ifdef WITH_LESS
  float around = early.z * (1.0 - 0.4 * painted);
#else
  float around = shade_of_cover(cover) * (1.0 - 0.4 * painted);
#endif
  drawn *= 1.0 - painted;
  float shade = around * (1.0 - drawn.y) + drawn.x;
  float sky = 1.0 - 0.45 * cover * cover * (1.0 - painted);
  return vec2(light_in_flecks(shade, fleck_at(place)), sky);
}

void main() {
  float to_eye = length(offset);
  float height = frame.eye.z + offset.z;
#ifdef WITH_LESS
  vec2 uv = on_map;
  vec4 coded_normal = texture(normals, uv);
  vec3 unit_normal = coded_normal.xyz * 255.0 / 127.0 - 128.0 / 127.0;
  unit_normal.xy *= reflected.xy;
  vec3 ground_normal = normalize(unit_normal + vec3(reflected.zw * unit_normal.yx, 0.0));
#else
  vec2 uv = ground_uv(ground_source(place));
  vec4 coded_normal = texture(normals, uv);
  vec3 ground_normal = ground_normal_at(coded_normal.xyz * 255.0 / 127.0 - 128.0 / 127.0, place);
#endif
  vec3 normal = ground_normal;

  vec4 ground = texture(ground_colours, uv);
  vec3 albedo = ground.rgb * ground.rgb;
  float rock = ground.a;
  vec4 fine = texture(detail, place * 0.37, -1.3);
  vec4 middle = texture(detail, place * 0.043 + 0.13, -0.7);
#ifdef WITH_LESS
  float broad = early.x;
#else
  float broad = texture(detail, place * 0.0067).a;
#endif
  // From far above, what repeats must not be seen to repeat.
  float close = exp(-to_eye * 0.0006);
  float grain = (fine.b - 0.5) * 0.55 + ((middle.b - 0.5) * 0.42 + (middle.a - 0.5) * 0.35 + (broad - 0.5) * 0.35) * close;
  // Tussocks: what keeps the middle ground from looking smooth.
  vec4 sward = texture(detail, sward_place(place), -1.0);
  float grassy = exp(-to_eye * 0.007) * (1.0 - rock);
  grain += (sward.b - 0.5) * 0.75 * grassy;
  albedo *= mix(vec3(1.0), sward_patch(sward.a), grassy);
  albedo *= 1.0 + grain;
  albedo *= mix(vec3(1.0), mix(vec3(1.10, 1.0, 0.80), vec3(0.88, 1.03, 0.98), middle.a), 0.6 * (1.0 - rock));
  // Beds of rock show as bands of height.
#ifdef WITH_LESS
  float bent = height + 5.0 * middle.a;
  float bands = 0.5 + 0.22 * sin(0.55 * bent) + 0.16 * sin(1.7 * bent);
#else
  float bands = texture(detail, vec2(0.37 + (place.x + place.y) * 0.0011, height * 0.021)).a;
#endif
  albedo *= 1.0 + rock * (bands - 0.5) * 0.8;
  vec2 bumps = (fine.rg - 0.502) * 0.55 * exp(-to_eye * 0.02) + (middle.rg - 0.502) * (0.45 + 0.75 * rock);
  if (with_detail) {
    // Steep rock is looked at from the side: its texture lies on the walls, not on the map.
    float facing_east = smoothstep(-0.2, 0.2, abs(ground_normal.x) - abs(ground_normal.y) + 0.2 * (middle.a - 0.5));
    vec2 on_wall = vec2(mix(place.x, place.y + 331.0, step(0.5, facing_east)), height * 1.7);
    vec4 wall = texture(detail, on_wall * 0.0059);
    vec4 wall_near = texture(detail, on_wall.yx * 0.043, -0.5);
    wall = mix(wall, 0.5 * (wall + wall_near), exp(-to_eye * 0.0025));
    float steep = rock * smoothstep(0.86, 0.70, ground_normal.z);
    albedo *= 1.0 + steep * ((wall.a - 0.5) * 0.9 + (wall.b - 0.5) * 0.5);
    bumps = mix(bumps, (wall.rg - 0.502) * 1.7, steep * 0.8);
    // Stones on scree and thin soil.
    float stones = smoothstep(0.60, 0.75, fine.a * 0.55 + middle.b * 0.45) * smoothstep(0.03, 0.25, rock) * (1.0 - rock) * exp(-to_eye * 0.006);
    albedo = mix(albedo, vec3(0.26, 0.25, 0.225) * (0.6 + 0.8 * fine.b), stones * 0.8);
  }
  normal.xy += bumps * (0.6 + 0.8 * rock);

  vec2 line = texture(lines, uv).rg;
  float worn = line.g * show.y;
  // Feet have worn the edges of a trail to tongues.
  float trodden = smoothstep(0.12, 0.62, worn * (0.70 + 0.85 * fine.a) + 0.35 * worn * (middle.b - 0.5));
  if (with_detail) albedo = with_litter(albedo, place, texture(canopy_colours, uv, 1.0), fine, middle, to_eye, (1.0 - trodden) * (1.0 - rock), bumps);
  // Earth that feet have bared; over rock it is gravel.
  vec3 trail = mix(vec3(0.132, 0.101, 0.071), vec3(0.235, 0.222, 0.195), 0.8 * rock);
  albedo = mix(albedo, trail * (0.75 + 0.6 * fine.b), 0.92 * trodden);
  if (with_detail) {
    // Sunken: its sides lean inward.
    vec2 texel = 1.0 / vec2(textureSize(lines, 0));
    vec2 rise = vec2(texture(lines, uv + vec2(texel.x, 0.0)).g, texture(lines, uv - vec2(0.0, texel.y)).g) - line.g;
    normal.xy += rise * show.y * 1.6 * exp(-to_eye * 0.012);
  }

  float open = coded_normal.a;
  float patchy = clamp(0.50 * middle.a + 0.22 * fine.b + 0.28 * broad + 0.7 * (0.90 - open), 0.0, 1.0);
  float snow = snow_share(height, ground_normal, patchy) * (1.0 - 0.55 * trodden);
  float wet_ground = frame.weather.w * rain_share(height) * (1.0 - snow);

  vec4 canopy = vec4(0.0);
  float crowns = 0.0;
  if (with_canopy || (with_water && with_detail)) canopy = texture(canopy_colours, uv, with_canopy ? 0.0 : 3.0);
  if (with_canopy) {
    vec4 clumps = texture(detail, place * 0.0052);
    float painted = painted_share(to_eye);
    vec3 spots = crown_spots(place, (clumps.rg + middle.rg) * 13.0, to_eye / frame.eye.w);
    crowns = crowns_seen(canopy.a, offset, ground_normal, to_eye, spots.x + 0.7 * (clumps.b - 0.5)) * canopy_range.z *
             painted;
    vec3 leaves = canopy.rgb * canopy.rgb * (0.45 + 1.0 * clumps.b) * (1.0 + 0.9 * spots.y + 1.2 * spots.z);
    if (with_detail) {
      // From high up single crowns are lost; groups of them are not.
      vec4 groups = texture(detail, place.yx * 0.0027 + 0.2);
      leaves *= 0.72 + 0.56 * groups.b;
      normal.xy += (groups.rg - 0.502) * 1.3 * crowns;
    }
    // Crowns hold less snow than the ground.
    leaves = mix(leaves, snow_albedo * 0.9, snow_share(height, vec3(0.0, 0.0, 1.0), clumps.b * 0.8) * 0.16);
    // Between crowns snow lies in their shade.
    snow *= (1.0 - crowns) * (1.0 - 0.55 * min(1.0, 1.6 * crowns));
    // Aslant one looks into the shade between crowns, and the ground between them lies in it.
    float down = clamp(-offset.z / to_eye, 0.0, 1.0);
    down *= down;
    leaves = mix(leaves, dot(leaves, vec3(0.3, 0.55, 0.15)) * vec3(1.22, 0.98, 0.85), 0.30) * (0.60 + 0.42 * down * down);
    albedo *= 1.0 - vec3(1.0, 1.0, 0.8) * (0.72 - 0.50 * down * down) * min(1.0, 1.3 * canopy.a) * canopy_range.z * sqrt(painted);
    albedo = mix(albedo, leaves, crowns);
    normal.xy += (clumps.rg - 0.502) * 1.7 * crowns;
  }
  albedo = mix(albedo, snow_albedo, snow);
  normal = normalize(mix(normal, ground_normal + vec3(bumps * 0.22, 0.0), snow));
  // Wet earth is darker: water fills what scattered the light.
  albedo *= 1.0 - 0.42 * wet_ground * (1.0 - 0.6 * crowns);

  // Crowns that stand toward the light.
#ifdef WITH_LESS
  float shading = early.y;
#else
  float shading = texture(canopy_colours, ground_uv(ground_source(place + 8.0 * toward_light_on_ground())), 1.5).a;
#endif
  vec2 under_crowns = light_under_crowns(shading * canopy_range.z, with_canopy ? painted_share(to_eye) : 0.0);
#ifdef WITH_SHADOWS
  under_crowns.x = light_past_plants(offset, 0.0, under_crowns.x, dither());
#endif
#ifdef WITH_LESS
  float light_share = under_crowns.x * clear_sky;
#else
  float light_share = texture(sunlit, uv).r * under_crowns.x * clear_sky;
#endif
  open *= under_crowns.y;
  float toward_light = max(dot(normal, frame.light_direction.xyz), 0.0);
  if (with_canopy) toward_light = mix(toward_light, crown_light(offset, to_eye, max(dot(ground_normal, frame.light_direction.xyz), 0.0)), crowns);
  vec3 light = frame.light_colour.rgb * toward_light * light_share + ambient(normal, open);
  vec3 lit = albedo * light;
  if (with_detail) {
    // Snow glitters and wet ground shines.
    vec3 view = offset / to_eye;
    vec3 half_way = normalize(frame.light_direction.xyz - view);
    float crystals = smoothstep(0.80, 0.92, texture(detail, place * 3.1).b * (0.6 + 0.4 * fine.a) + 0.25 * max(dot(normal, half_way), 0.0));
    lit += frame.light_colour.rgb * light_share * crystals * snow * 0.35 * exp(-to_eye * 0.03);
    float grazing = 1.0 - max(dot(-view, normal), 0.0);
    float puddles = smoothstep(0.60, 0.30, middle.a) * smoothstep(0.93, 0.99, ground_normal.z) * max(trodden, 0.10);
    float sheen = wet_ground * (0.03 + 0.24 * puddles) * (0.04 + grazing * grazing * grazing * grazing) * open * (1.0 - crowns);
    lit += sheen * sky_colour(reflect(view, normalize(ground_normal + vec3(0.0, 0.0, 2.0))));
  }

  if (with_water) {
    float pixel = to_eye / frame.eye.w;
    float inside = (line.r * 255.0 - 128.0) * (shore_reach / 127.0);
    // Banks: gravel that floods left here and there, then a damp margin before the water.
    vec3 gravel = mix(vec3(0.085, 0.078, 0.062), vec3(0.235, 0.222, 0.190), fine.b * (0.4 + fine.a));
    float bared = smoothstep(-2.6, -0.2, inside + 3.4 * (middle.a - 0.56) + 1.2 * (fine.b - 0.5)) * show.x * (1.0 - 0.8 * snow);
    float damp = smoothstep(-1.5, -0.1, inside + 0.8 * (fine.b - 0.5)) * show.x;
    lit = mix(lit, gravel * light, bared * 0.85 * (1.0 - smoothstep(200.0, 900.0, to_eye) * 0.5));
    lit *= 1.0 - 0.45 * damp;
#ifndef WITH_LESS
    float wet = wet_share(inside, fine, middle, to_eye, pixel);
    if (wet > 0.0) {
      vec4 trees = vec4(canopy.rgb * canopy.rgb * 0.75, min(1.0, canopy.a * 1.8));
      lit = mix(lit, water_colour(offset, place, uv, bed_colour(fine, middle), max(inside, 0.0), light_share, trees, to_eye), wet);
      vec4 stone = stone_seen(place, offset / to_eye, riffle_at(uv) * exp(-to_eye * 0.008), pixel);
      vec3 grey = stone_colour(fine, middle) * (0.30 + 0.80 * clamp(stone.z, 0.0, 1.0));
      vec3 shone = frame.light_colour.rgb * max(dot(stone.xyz, frame.light_direction.xyz), 0.0) * light_share;
      lit = mix(lit, grey * (shone + ambient(stone.xyz, open)), stone.w * wet);
    }
#endif
  }

  lit = with_brush(lit, place, to_eye);
#ifdef WITH_LESS
  colour = vec4(to_screen(mix(lit, veil.rgb, veil.a)), 1.0);
#else
  // Land beyond the border is only scenery: it fades into the haze.
  vec2 beyond = max(max(-place, place - frame.terrain.xy), vec2(0.0)) / frame.terrain.xy;
  float outside = max(beyond.x, beyond.y);
  lit = mix(lit, vec3(dot(lit, vec3(0.3, 0.5, 0.2))), smoothstep(0.0, 0.15, outside) * 0.25);
  float haziness = max(veil.a, smoothstep(0.0, 0.85, outside));
  colour = vec4(to_screen(mix(lit, veil.rgb, haziness)), 1.0);
#endif
}

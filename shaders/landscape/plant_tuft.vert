#version 450 core
#include "landscape/frame.glsl"
#include "landscape/atmosphere.glsl"
#include "landscape/clouds.glsl"
#include "landscape/ground.glsl"
#include "landscape/shade.glsl"
#include "landscape/plant_kinds.glsl"
#include "landscape/plant_light.glsl"
#include "landscape/plant_wind.glsl"
#include "landscape/snow.glsl"
#ifdef WITH_SHADOWS
#include "landscape/shadow_view.glsl"
#include "landscape/shadow.glsl"
#endif
layout(location = 0) in vec3 position;
layout(location = 2) in vec2 card_uv;
layout(location = 3) in vec4 material;  // picture, open, fall, leaf
layout(location = 4) in vec4 stands;    // foot, scale
layout(location = 5) in vec4 own;       // turn, tint, rank, plant
layout(binding = 2) uniform sampler2D ground_colours;
layout(binding = 6) uniform sampler2D sunlit;
uniform vec3 flower_colour;
uniform float bloom;
uniform vec2 fade;   // metres over which tufts sink into the colour of the ground
uniform vec2 given;  // metres over which these models give way to the next; x negative: from the ones before
out vec3 card;
out vec3 tone;
out vec3 flower_tone;
out vec4 veil;

void main() {
  int plant = int(own.w + 0.5);
  vec3 foot = stands.xyz - frame.eye.xyz;
  float distance_to = length(foot);
  float given_share = smoothstep(abs(given.x), given.y, distance_to);
  // Blade by blade.
  float turn = fract(material.z * 5.37 + own.y * 3.1);
  bool shown = given.x < 0.0 ? turn >= 1.0 - given_share : turn < 1.0 - given_share;

  float c = cos(own.x);
  float s = sin(own.x);
  // Grazed plants are short, but hardly narrower.
  float snow = snow_share(stands.z, vec3(0.0, 0.0, 1.0), 0.4 + 0.5 * own.y);
  // Deep snow buries all but the tips.
  // Where fewer stand for all, each is wider.
  float wider = given.x < 0.0 ? 1.0 + 1.3 * smoothstep(abs(given.x), 40.0, distance_to) : 1.0;
  vec3 at = position * vec3(vec2(0.55 + 0.45 * stands.w) * wider, stands.w * (1.0 - 0.8 * snow));
  at.xy = mat2(c, s, -s, c) * at.xy;
  float strength = gust(stands.xy);
  vec2 way = frame.wind.xy / max(length(frame.wind.xy), 1e-3);
  float shiver = 1.0 + 0.35 * sin(frame.wind.z * (3.1 + 2.0 * own.y) + own.y * 50.0 + material.z * 6.0);
  float lean = min(0.055 * strength * shiver, 1.1) * at.z * at.z / (0.35 + at.z);
  at += vec3(way * lean, -0.35 * lean * lean / (0.15 + at.z));
  vec3 offset = foot + at;

  // Lit as the ground is, so that tufts do not stand out of it.
  vec2 uv = ground_uv(stands.xy);
  float sun = textureLod(sunlit, uv, 0.0).r * cloud_light(stands.xy, stands.z);
  // Sun comes through crowns in flecks, the same as on the ground.
  float past_crowns = light_in_flecks(drawn_shade(stands.xy).x, 0.7 * fleck_at(stands.xy) + 0.3 * fract(own.y * 17.3));
#ifdef WITH_SHADOWS
  past_crowns = light_past_plants(foot + vec3(0.0, 0.0, 0.6 * at.z), 0.0, past_crowns, 0.5);
#endif
  sun *= past_crowns;
  vec3 view = offset / max(distance_to, 0.1);
  float through = 0.3 * material.y * max(dot(view, frame.light_direction.xyz), 0.0);
  vec3 light = frame.light_colour.rgb * sun * (max(frame.light_direction.z, 0.0) * 0.92 + through) +
               mix(frame.ambient_ground.rgb, frame.ambient_sky.rgb, 0.95);

  vec4 coded = textureLod(ground_colours, uv, 0.0);
  vec3 ground = coded.rgb * coded.rgb;
  // Roots are dark and have the colour of the ground; tips their own. Waves of wind show their pale sides.
  float up = clamp(position.z / kinds.form[plant].y, 0.0, 1.0);
  float far = smoothstep(fade.x, fade.y, distance_to);
  // As light as the sward around it on the whole, so that a meadow has no holes.
  vec3 blade = own_leaf(plant, own.y);
  const vec3 brightness = vec3(0.3, 0.55, 0.15);
  blade *= mix(1.0, clamp(dot(ground, brightness) / max(dot(blade, brightness), 0.01), 0.5, 2.0), 0.75);
  blade *= sward_patch(textureLod(detail, sward_place(stands.xy), 0.0).a);
  vec3 own_colour = blade * own_tone(own.y) * (0.80 + 0.40 * fract(own.y * 29.3)) * (1.0 + 0.022 * (strength - 0.62 * length(frame.wind.xy)) * up);
  vec3 leaf = mix(ground, own_colour, (0.30 + 0.6 * up) * (1.0 - 0.55 * far));
  leaf = mix(leaf, snow_albedo, snow * (1.0 - 0.6 * up) * 0.9) * (1.0 - 0.25 * frame.weather.w * rain_share(stands.z));
  // Cards have their own shades from root to tip, blades only those of the vertex.
  float shade = material.x > 0.5 ? 0.86 + 0.46 * up : 0.20 + 1.06 * material.y;
  tone = leaf * light * mix(shade, 1.0, 0.45 * far);
  // Flowers that are smaller than a pixel leave only a part of their colour: they would sparkle.
  flower_tone = mix(0.86 * flower_colour, leaf, 0.62 * smoothstep(9.0, 38.0, distance_to)) * light;
  card = vec3(card_uv, material.x);
  veil = vec4(haze_colour(offset), haze(offset));
  gl_Position = shown ? frame.view_projection * vec4(offset, 1.0) : vec4(2.0, 2.0, 2.0, 1.0);
  // Under snow only some tall ones look out.
  if (snow > 0.4 && stands.w < 0.75 + fract(own.y * 3.3)) gl_Position = vec4(2.0, 2.0, 2.0, 1.0);
  // Flowers (pictures 7 and 10) that are not out are not drawn.
  bool flower = abs(material.x - 7.0) < 0.5 || abs(material.x - 10.0) < 0.5;
  // What was grazed short has none.
  if (flower && fract(own.y * 13.7) >= bloom * smoothstep(0.4, 0.7, stands.w)) gl_Position = vec4(2.0, 2.0, 2.0, 1.0);
}

// An animal's coat in the light. Needs frame.glsl, atmosphere.glsl, ground.glsl, clouds.glsl, shade.glsl, snow.glsl. A file that includes this says first whether
// one is near enough to see fur (`with_fur`).
layout(binding = 6) uniform sampler2D sunlit;
#include "landscape/animal_skeleton.glsl"
#ifdef WITH_SHADOWS
#include "landscape/shadow_view.glsl"
#include "landscape/shadow.glsl"
#include "landscape/plant_dither.glsl"
#endif
in vec3 offset;
in vec3 normal;
in vec3 coat;
in vec3 on_body;
in vec4 veil;
in float spotted;
in float above_ground;
out vec4 colour;

void main() {
  vec3 n = normalize(normal);
  vec3 albedo = coat * (0.24 + 0.42 * coat);
  if (with_fur) {
    // Hair lies along the body: fine streaks, and broader tufts that catch the light.
    vec2 along = vec2(on_body.x * 0.8 + on_body.z * 0.3, on_body.z * 1.9 + on_body.y * 1.4);
    vec4 fine = texture(detail, along * 1.9);
    vec4 tufts = texture(detail, along * 0.53 + 0.37);
    albedo *= 1.0 + 0.65 * (fine.b - 0.5) + 0.55 * (tufts.b - 0.5) + 0.35 * (tufts.a - 0.5);
    n = normalize(n + vec3((fine.rg - 0.5) * 0.55 + (tufts.rg - 0.5) * 0.45, (fine.a - 0.5) * 0.3));
    // Shoulder and haunch stand out from the trunk: a soft fold around each.
    vec2 hind = (on_body.xz - skeleton.joints[0].xz / skeleton.body.w) / vec2(0.20, 0.27);
    vec2 fore = (on_body.xz - skeleton.joints[3].xz / skeleton.body.w) / vec2(0.17, 0.27);
    vec2 around = vec2(length(hind) - 1.05, length(fore) - 1.05) / 0.24;
    vec2 inside = vec2(dot(hind, hind), dot(fore, fore));
    albedo *= 1.0 - 0.20 * (exp(-around.x * around.x) + exp(-around.y * around.y)) + 0.09 * (exp(-1.4 * inside.x) + exp(-1.4 * inside.y));
    // Spots in rows along the flanks.
    vec2 grid = vec2(on_body.x * 15.0, on_body.z * 17.0);
    grid.x += 0.5 * mod(floor(grid.y), 2.0);
    vec2 cell = floor(grid);
    vec2 shift = fract(sin(vec2(dot(cell, vec2(12.9, 78.2)), dot(cell, vec2(39.3, 11.1)))) * 437.5) - 0.5;
    float spot = smoothstep(0.27, 0.15, length(fract(grid) - 0.5 - 0.35 * shift));
    float flank = smoothstep(0.58, 0.66, on_body.z) * smoothstep(1.04, 0.9, on_body.z) * smoothstep(0.62, 0.5, abs(on_body.x));
    // Pale on deer, dark on cats.
    vec3 of_spots = spotted > 0.0 ? vec3(0.62, 0.55, 0.44) : 0.22 * albedo;
    albedo = mix(albedo, of_spots, 0.75 * spot * flank * abs(spotted));
  }
  // What falls lies on backs, or soaks in.
  float height = offset.z + frame.eye.z;
  float snows = smoothstep(0.0, 0.5, frame.weather.y * (1.0 - rain_share(height)));
  float wet = frame.weather.w * rain_share(height);
  float tuft = with_fur ? texture(detail, on_body.xz * 0.9 + 0.5 * on_body.y).b - 0.5 : 0.0;
  albedo *= 1.0 - wet * (0.14 + 0.5 * max(tuft, 0.0));
  albedo = mix(albedo, snow_albedo, 0.8 * snows * smoothstep(0.42, 0.88, n.z + 0.9 * tuft));
  vec2 at = offset.xy + frame.eye.xy;
  // The ray that passes here meets the ground farther on.
  vec2 lands = at - toward_light_on_ground() * above_ground * skeleton.body.w;
  float past_crowns = light_in_flecks(drawn_shade(lands).x, fleck_at(lands));
#ifdef WITH_SHADOWS
  past_crowns = light_past_plants(offset, 0.35, past_crowns, dither());
#endif
  float light_share = texture(sunlit, ground_uv(at)).r * cloud_light(at, offset.z + frame.eye.z) * past_crowns;
  float facing = dot(n, frame.light_direction.xyz);
  // Hair scatters light around the edge of its shade.
  float toward = max((facing + 0.12) / 1.12, 0.0);
  float rim = pow(1.0 - max(dot(n, -normalize(offset)), 0.0), 3.0) * max(dot(normalize(offset), frame.light_direction.xyz) * 0.5 + 0.5, 0.0);
  // Bellies and legs see less sky the nearer they are to the ground, and more of the ground's light.
  float open = mix(0.45, 1.0, smoothstep(0.0, 0.7, above_ground)) * (0.72 + 0.28 * n.z);
  // Snow on the ground lights what stands on it from below.
  vec3 from_snow = 0.75 * frame.ambient_sky.rgb + 0.3 * frame.light_colour.rgb * light_share * frame.light_direction.z;
  float snowy = snow_share(height - above_ground * skeleton.body.w, vec3(0.0, 0.0, 1.0), 0.5);
  vec3 from_ground = mix(frame.ambient_ground.rgb, from_snow, snowy);
  vec3 light = frame.light_colour.rgb * light_share * (toward + 0.22 * rim) +
               mix(from_ground, frame.ambient_sky.rgb, 0.5 + 0.5 * n.z) * mix(open, 1.0, 0.7 * snowy);
  colour = vec4(to_screen(mix(albedo * light, veil.rgb, veil.a)), 1.0);
}

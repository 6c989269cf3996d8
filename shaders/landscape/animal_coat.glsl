// An animal's coat in the light. Needs frame.glsl, atmosphere.glsl, ground.glsl, clouds.glsl. A file that includes this says first whether
// one is near enough to see fur (`with_fur`).
layout(binding = 6) uniform sampler2D sunlit;
layout(binding = 7) uniform sampler2D canopy_shade;
layout(std140, binding = 2) uniform Skeleton {
  vec4 joints[12];
  vec4 neck_head;
  vec4 graze;
  vec4 body;
  vec4 look;
} skeleton;
in vec3 offset;
in vec3 normal;
in vec3 coat;
in vec3 on_body;
in vec4 veil;
in float above_ground;
out vec4 colour;

float shade_of_crowns(vec2 at) {
  if (frame.shade_area.w <= 0.0) return 1.0;
  vec2 within = (at - frame.shade_area.xy) / frame.shade_area.z;
  vec2 edge = smoothstep(vec2(0.0), vec2(0.06), within) * (1.0 - smoothstep(vec2(0.94), vec2(1.0), within));
  return 1.0 - frame.shade_area.w * edge.x * edge.y * texture(canopy_shade, within).r;
}

void main() {
  vec3 n = normalize(normal);
  vec3 albedo = coat * (0.13 + 0.52 * coat);
  if (with_fur) {
    // Hair lies along the body: fine streaks, and broader tufts that catch the light.
    vec2 along = vec2(on_body.x * 0.8 + on_body.z * 0.3, on_body.z * 1.9 + on_body.y * 1.4);
    vec4 fine = texture(detail, along * 1.9);
    vec4 tufts = texture(detail, along * 0.53 + 0.37);
    albedo *= 1.0 + 0.65 * (fine.b - 0.5) + 0.55 * (tufts.b - 0.5) + 0.35 * (tufts.a - 0.5);
    n = normalize(n + vec3((fine.rg - 0.5) * 0.55 + (tufts.rg - 0.5) * 0.45, (fine.a - 0.5) * 0.3));
    // Spots in rows along the flanks.
    vec2 grid = vec2(on_body.x * 15.0, on_body.z * 17.0);
    grid.x += 0.5 * mod(floor(grid.y), 2.0);
    vec2 cell = floor(grid);
    vec2 shift = fract(sin(vec2(dot(cell, vec2(12.9, 78.2)), dot(cell, vec2(39.3, 11.1)))) * 437.5) - 0.5;
    float spot = smoothstep(0.27, 0.15, length(fract(grid) - 0.5 - 0.35 * shift));
    float flank = smoothstep(0.58, 0.66, on_body.z) * smoothstep(1.04, 0.9, on_body.z) * smoothstep(0.62, 0.5, abs(on_body.x));
    // Pale on deer, dark on cats.
    vec3 spotted = skeleton.look.x > 0.0 ? vec3(0.62, 0.55, 0.44) : 0.22 * albedo;
    albedo = mix(albedo, spotted, 0.75 * spot * flank * abs(skeleton.look.x));
  }
  vec2 at = offset.xy + frame.eye.xy;
  float light_share = texture(sunlit, ground_uv(at)).r * cloud_light(at, offset.z + frame.eye.z) * shade_of_crowns(at);
  float facing = dot(n, frame.light_direction.xyz);
  // Hair scatters light around the edge of its shade.
  float toward = max((facing + 0.12) / 1.12, 0.0);
  float rim = pow(1.0 - max(dot(n, -normalize(offset)), 0.0), 3.0) * max(dot(normalize(offset), frame.light_direction.xyz) * 0.5 + 0.5, 0.0);
  // Bellies and legs see less sky the nearer they are to the ground, and more of the ground's light.
  float open = mix(0.45, 1.0, smoothstep(0.0, 0.7, above_ground)) * (0.72 + 0.28 * n.z);
  vec3 light = frame.light_colour.rgb * light_share * (toward + 0.22 * rim) +
               mix(frame.ambient_ground.rgb, frame.ambient_sky.rgb, 0.5 + 0.5 * n.z) * open;
  colour = vec4(to_screen(mix(albedo * light, veil.rgb, veil.a)), 1.0);
}

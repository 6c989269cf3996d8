// The ground's colour. A file that includes this says first whether water may be near (`with_water`) and whether crowns are painted on the
// ground (`with_canopy`): software renderers run both sides of every branch, so what a patch cannot need must be compiled out.
layout(binding = 1) uniform sampler2D normals;
layout(binding = 2) uniform sampler2D ground_colours;
layout(binding = 3) uniform sampler2D detail;
layout(binding = 4) uniform sampler2D canopy_colours;
layout(binding = 5) uniform sampler2D lines;        // red: distance to the shore, green: worn earth
layout(binding = 6) uniform sampler2D sunlit;
layout(binding = 7) uniform sampler2D canopy_shade;
uniform vec4 canopy_range;  // metres from which the canopy is painted on the ground, and where wholly; z: strength
uniform vec4 show;          // water, trails
uniform vec4 brush;         // x, y, radius in metres; w: 1 when there is one
in vec3 offset;
in vec2 place;
in vec4 veil;  // colour of the haze before it, and its share
out vec4 colour;

const float shore_reach = 8.0;

vec3 ambient(vec3 normal, float open) {
  return mix(frame.ambient_ground.rgb, frame.ambient_sky.rgb, 0.5 + 0.5 * normal.z) * open;
}

float shade_of_crowns() {
  if (frame.shade_area.w <= 0.0) return 1.0;
  vec2 at = (place - frame.shade_area.xy) / frame.shade_area.z;
  vec2 edge = smoothstep(vec2(0.0), vec2(0.06), at) * (1.0 - smoothstep(vec2(0.94), vec2(1.0), at));
  return 1.0 - frame.shade_area.w * edge.x * edge.y * texture(canopy_shade, at).r;
}

vec3 water(vec3 bed, vec3 ground_normal, float inside, float light_share, float to_eye) {
  vec3 view = offset / to_eye;
  float near = exp(-to_eye * 0.006);
  // Ripples on three scales; the small ones are lost with distance and leave a broader glitter.
  vec2 wave = (texture(detail, place * 0.031 + 0.3).rg - 0.5) * 0.30 + (texture(detail, place.yx * 0.087).rg - 0.5) * 0.45 +
              (texture(detail, place * 0.29 + 0.7).rg - 0.5) * 0.55 * near;
  float steep = 1.0 - ground_normal.z;
  vec3 up = normalize(mix(vec3(0.0, 0.0, 1.0), ground_normal, 0.35));
  vec3 normal = normalize(up + vec3(wave * (0.07 + 0.10 * near), 0.0));
  float fresnel = 0.02 + 0.98 * pow(1.0 - max(dot(-view, normal), 0.0), 5.0);
  vec3 bounced = reflect(view, normal);
  bounced.z = abs(bounced.z) + 0.02;
  vec3 mirrored = sky_colour(normalize(bounced));
  // Low rays meet banks and trees before the sky, more so near the shore.
  float banks = exp(-bounced.z * 7.0) * (0.25 + 0.45 * exp(-max(inside, 0.0) * 0.35));
  mirrored = mix(mirrored, mirrored * vec3(0.30, 0.36, 0.30), banks);
  float depth = clamp(inside, 0.0, shore_reach) * 0.35;
  float clear = exp(-depth * 1.3);
  vec3 light = frame.light_colour.rgb * light_share * max(frame.light_direction.z, 0.0) + frame.ambient_sky.rgb;
  vec3 body = mix(vec3(0.016, 0.050, 0.050), bed * vec3(0.50, 0.56, 0.46), clear) * light;
  vec3 half_way = normalize(frame.light_direction.xyz - view);
  float glint = pow(max(dot(half_way, normal), 0.0), mix(160.0, 500.0, near)) * 4.0 * light_share;
  float foam = smoothstep(0.012, 0.07, steep) * smoothstep(0.42, 0.75, texture(detail, place * 0.19).b + 0.35 * steep);
  vec3 out_colour = mix(body, mirrored, fresnel) + frame.light_colour.rgb * glint * 0.4;
  return mix(out_colour, light * 0.42, foam * 0.55);
}

void main() {
  float to_eye = length(offset);
  vec2 uv = ground_uv(place);
  vec4 coded_normal = texture(normals, uv);
  vec3 ground_normal = normalize(coded_normal.xyz * 255.0 / 127.0 - 128.0 / 127.0);
  // Beyond the border the ground is mirrored: so is its slope.
  vec2 tile = floor(place / frame.terrain.xy);
  ground_normal.xy *= 1.0 - 2.0 * mod(abs(tile), 2.0);
  vec3 normal = ground_normal;

  vec4 ground = texture(ground_colours, uv);
  vec3 albedo = ground.rgb * ground.rgb;
  float rock = ground.a;
  vec4 fine = texture(detail, place * 0.37, -1.3);
  vec4 middle = texture(detail, place * 0.043 + 0.13, -0.7);
  float broad = texture(detail, place * 0.0067).a;
  // From far above, what repeats must not be seen to repeat.
  float close = exp(-to_eye * 0.0006);
  float grain = (fine.b - 0.5) * 0.55 + ((middle.b - 0.5) * 0.42 + (middle.a - 0.5) * 0.35 + (broad - 0.5) * 0.35) * close;
  // Tussocks: what keeps the middle ground from looking smooth.
  float tussocks = texture(detail, vec2(place.x * 0.8 + place.y * 0.6, place.y * 0.8 - place.x * 0.6) * 0.12, -1.0).b - 0.5;
  grain += tussocks * 0.5 * exp(-to_eye * 0.008) * (1.0 - rock);
  albedo *= 1.0 + grain;
  albedo *= mix(vec3(1.0), mix(vec3(1.10, 1.0, 0.82), vec3(0.92, 1.02, 1.0), middle.a), 0.55 * (1.0 - rock));
  // Beds of rock show as bands of height.
  float bands = texture(detail, vec2(0.37, (place.x + place.y) * 0.0011 + (frame.eye.z + offset.z) * 0.021)).a;
  albedo *= 1.0 + rock * (bands - 0.5) * 0.55;
  normal.xy += ((fine.rg - 0.5) * 0.55 * exp(-to_eye * 0.02) + (middle.rg - 0.5) * (0.45 + 0.75 * rock)) * (0.6 + 0.8 * rock);

  vec2 line = texture(lines, uv).rg;
  float worn = line.g * show.y;
  albedo = mix(albedo, vec3(0.155, 0.108, 0.066) * (0.8 + 0.5 * fine.b), clamp(worn * (0.75 + 0.5 * fine.a), 0.0, 0.9));

  float open = coded_normal.a;
  if (with_canopy) {
    vec4 canopy = texture(canopy_colours, uv);
    // Seen aslant, crowns hide more of the ground than from above.
    float aslant = 1.0 + 1.1 * (1.0 - clamp(-offset.z / to_eye, 0.0, 1.0));
    float crowns = (1.0 - pow(1.0 - min(canopy.a, 0.98), aslant)) * canopy_range.z * smoothstep(canopy_range.x, canopy_range.y, to_eye);
    vec4 clumps = texture(detail, place * 0.021);
    float crown_edge = smoothstep(-0.12, 0.12, crowns - 0.25 - 0.5 * clumps.b * (1.0 - crowns));
    crowns = mix(crowns, crown_edge, 0.55) * step(0.004, crowns);
    float stands = 0.87 + 0.5 * (texture(detail, place.yx * 0.00113 + 0.4).a - 0.5) + 0.3 * (broad - 0.5) * close;
    albedo = mix(albedo, canopy.rgb * canopy.rgb * (0.4 + 1.0 * clumps.b) * stands, crowns);
    normal.xy += (clumps.rg - 0.5) * 1.3 * crowns;
  }
  normal = normalize(normal);

  float light_share = texture(sunlit, uv).r * shade_of_crowns();
  float toward_light = max(dot(normal, frame.light_direction.xyz), 0.0);
  vec3 light = frame.light_colour.rgb * toward_light * light_share + ambient(normal, open);
  vec3 lit = albedo * light;

  if (with_water) {
    // Water: as wide as it is, but never narrower than a good part of a pixel, so that a river stays one line from afar.
    float pixel = to_eye / frame.eye.w;
    float inside = (line.r * 255.0 - 128.0) * (shore_reach / 127.0);
    float grazing = max(-offset.z / to_eye, 0.12);
    float soft = max(pixel * 0.6, 0.12);
    float wet = smoothstep(-soft, soft, inside + min(0.28 * pixel / grazing, 2.2)) * show.x;
    // Banks: pebbles laid bare by floods, then a damp margin before the water.
    float pebbles = smoothstep(-4.5, -1.0, inside + 2.4 * (middle.b - 0.5)) * smoothstep(0.0, 0.4, show.x) * (1.0 - smoothstep(30.0, 400.0, to_eye) * 0.6);
    lit = mix(lit, vec3(0.26, 0.245, 0.21) * (0.65 + 0.7 * fine.b) * light, pebbles * 0.6);
    lit *= 1.0 - 0.42 * smoothstep(-1.3, 0.0, inside) * show.x;
    if (wet > 0.0) lit = mix(lit, water(albedo, ground_normal, inside, light_share, to_eye), wet);
  }

  if (brush.w > 0.0) {
    float ring = abs(distance(place, brush.xy) - brush.z);
    float width = max(0.004 * to_eye, 0.3);
    lit = mix(lit, vec3(0.21, 0.43, 0.14) * 1.8, smoothstep(width, 0.4 * width, ring) * 0.9);
    lit = mix(lit, vec3(0.21, 0.43, 0.14), 0.12 * step(distance(place, brush.xy), brush.z));
  }

  // Land beyond the border is only scenery: it fades into the haze.
  vec2 beyond = max(max(-place, place - frame.terrain.xy), vec2(0.0)) / frame.terrain.xy;
  float outside = max(beyond.x, beyond.y);
  lit = mix(lit, vec3(dot(lit, vec3(0.3, 0.5, 0.2))), smoothstep(0.0, 0.02, outside) * 0.35);
  float haziness = max(veil.a, smoothstep(0.0, 0.85, outside));
  colour = vec4(to_screen(mix(lit, veil.rgb, haziness)), 1.0);
}

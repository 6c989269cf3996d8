// The sky. A file that includes this says first whether stars may be seen (`with_stars`) and whether clouds are lit in full
// (`with_lit_clouds`): software renderers run both sides of every branch.
in vec3 direction;
out vec4 colour;

uint hashed(uint value) {
  value = (value ^ (value >> 16)) * 0x7feb352du;
  value = (value ^ (value >> 15)) * 0x846ca68bu;
  return value ^ (value >> 16);
}

// Stars turn about the pole: a fixed pattern in a frame that turns with the sidereal angle. `pixel`: its size in radians.
vec3 stars(vec3 toward, float pixel) {
  float along = frame.stars.z * toward.z - frame.stars.y * toward.y;
  vec2 turn = vec2(cos(frame.stars.x), sin(frame.stars.x));
  vec3 fixed_to_sky = vec3(turn.x * along - turn.y * toward.x, turn.y * along + turn.x * toward.x,
                           frame.stars.z * toward.y + frame.stars.y * toward.z);
  vec3 at = fixed_to_sky * 110.0;
  vec3 cell = floor(at);
  uint key = hashed(uint(int(cell.x) + 512) + 1024u * uint(int(cell.y) + 512) + 1048576u * uint(int(cell.z) + 512));
  if (key % 1000u > 85u) return vec3(0.0);
  uint more = hashed(key);
  vec3 within = 0.3 + 0.4 * vec3(more & 255u, (more >> 8) & 255u, (more >> 16) & 255u) / 255.0;
  vec3 star = normalize(cell + within);
  float off = length(fixed_to_sky - star) / max(pixel * 0.85, 0.0006);
  float magnitude = float(more >> 24) / 255.0;
  float bright = 0.02 + 0.55 * pow(magnitude, 9.0);
  vec3 tint = mix(vec3(1.0, 0.86, 0.70), vec3(0.78, 0.88, 1.0), float((key >> 10) & 255u) / 255.0);
  return tint * bright * exp(-off * off);
}

// The moon's disc, a little larger than it is (0.4 degrees of radius), lit by the sun where it stands.
float moon_disc(vec3 toward) {
  const float radius = 0.007;
  vec3 across = (toward - frame.moon.xyz * dot(toward, frame.moon.xyz)) / radius;
  float squared = dot(across, across);
  if (dot(toward, frame.moon.xyz) < 0.0 || squared > 1.3) return 0.0;
  vec3 surface = across - frame.moon.xyz * sqrt(max(1.0 - squared, 0.0));
  float lit = smoothstep(-0.02, 0.25, dot(surface, frame.sun_direction.xyz));
  float seas = 0.75 + 0.5 * textureLod(detail, surface.xz * 0.05 + 0.2, 1.0).a;
  return lit * seas * smoothstep(1.08, 0.92, squared);
}

void main() {
  vec3 toward = normalize(direction);
  toward = normalize(vec3(toward.xy, max(toward.z, 0.0)));
  vec3 light = sky_colour(toward);
  float pixel = 1.0 / frame.eye.w;
  float through = 1.0;
  float toward_light = max(dot(toward, frame.light_direction.xyz), 0.0);
  // Clouds on a shell that bends down toward the horizon.
  float up = toward.z + 0.10;
  vec2 over = frame.eye.xy + toward.xy / up * max(frame.clouds.z - frame.eye.z, 300.0);
  float lod = max(0.0, 0.6 - 3.2 * log2(up + 0.12) * 0.4);
  float form = cloud_form(over, lod);
  float thick = cloud_thickness(form) * smoothstep(0.0, 0.10, toward.z);
  float silver = toward_light * toward_light;
  silver *= silver;
  silver *= silver;
  vec3 bright = frame.light_colour.rgb * (0.26 + 0.50 * silver * (1.0 - thick)) + frame.ambient_sky.rgb * 0.80 +
                frame.glow.rgb * (0.16 + 0.34 * toward_light * toward_light);
  vec3 dull = frame.ambient_sky.rgb * 0.98 + frame.light_colour.rgb * 0.055 + frame.glow.rgb * 0.10;
  float shaded = thick;
  if (with_lit_clouds) {
    // Toward the light there is more cloud: this part lies in its shade; less: it is a lit edge.
    vec2 step_to_light = frame.light_direction.xy / max(length(frame.light_direction.xy), 0.05) * 210.0;
    float nearer = cloud_thickness(cloud_form(over + step_to_light, lod + 0.5));
    shaded = clamp(0.30 + 0.85 * nearer * thick + 0.9 * (nearer - thick) - 0.12 * (1.0 - thick), 0.0, 1.0);
  }
  vec3 cloud = mix(bright, dull, 0.85 * shaded);
  // Under a closed sky the clouds are the light: only their thickness varies.
  vec3 closed = mix(frame.zenith.rgb, frame.horizon.rgb, 0.4) * (1.30 - (0.55 + 0.25 * frame.weather.y) * smoothstep(0.30, 0.72, form));
  cloud = mix(closed, cloud, frame.stars.w);
  float cover = mix(thick, 0.92 * thick, frame.stars.w);
  // Far clouds lose their light to the air before them.
  cloud = mix(light, cloud, smoothstep(0.0, 0.22, toward.z) * 0.75 + 0.25);
  light = mix(light, cloud, cover);
  through = 1.0 - cover;
  if (with_stars) {
    // The moon outshines the faint ones.
    float seen = max(frame.light_direction.w - 0.25, 0.0) * through * smoothstep(0.0, 0.25, toward.z) *
                 (1.0 - 0.6 * frame.moon.w * smoothstep(-0.05, 0.3, frame.moon.z));
    // The band of the Milky Way, fixed to the stars as they are.
    light += stars(toward, pixel) * seen;
    float near_moon = max(dot(toward, frame.moon.xyz), 0.0);
    float halo = near_moon * near_moon;
    halo *= halo * halo;
    halo *= halo * halo * halo;
    light += vec3(0.55, 0.60, 0.70) * frame.moon.w * frame.light_direction.w *
             (0.02 * halo + 0.10 * pow(near_moon, 900.0)) * (0.3 + 0.7 * frame.stars.w);
  }
  light += vec3(0.95, 0.93, 0.86) * moon_disc(toward) * mix(0.25, 0.75, frame.light_direction.w) * through * frame.stars.w;
  float sun = dot(toward, frame.sun_direction.xyz);
  float above = smoothstep(-0.02, 0.01, frame.sun_direction.z);
  light += frame.light_colour.rgb * above * frame.stars.w * (1.0 - 0.9 * cover) *
           (smoothstep(0.99986, 0.99994, sun) * 9.0 + 0.5 * smoothstep(0.9980, 0.99994, sun));
  // Fog and rain hide the sky from the ground up.
  float above_base = max(frame.eye.z - frame.fog.z, 0.0) * frame.fog.y;
  float air = frame.fog.x * exp(-above_base) / (frame.fog.y * max(toward.z, 0.02));
  light = mix(light, haze_colour(toward), 1.0 - exp(-air * frame.weather.z));
  // Half a step of the screen's colours up or down (Jimenez' gradient noise, 2014): wide gradients show no bands.
  float dither = fract(52.9829189 * fract(dot(gl_FragCoord.xy + vec2(frame.horizon.w, frame.zenith.w), vec2(0.06711056, 0.00583715)))) - 0.5;
  colour = vec4(to_screen(light) + dither / 255.0, 1.0);
}

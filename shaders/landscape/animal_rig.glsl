// How an animal's mesh is posed: render/animal_mesh.hpp tells what its vertices carry. Needs frame.glsl, atmosphere.glsl. A file that includes
// this says first whether legs are bent at their joints (`posed`), or only swung.
layout(location = 0) in vec3 position;
layout(location = 1) in vec3 normal_in;
layout(location = 2) in vec3 colour_in;
layout(location = 3) in vec4 rig;
layout(location = 4) in vec4 place;   // relative to the eye; w: size
layout(location = 5) in vec4 motion;  // sine and cosine of the heading, strides walked, length of a stride
layout(location = 6) in vec4 pose;    // head down, lying, alarm, gait: 0 walk, 1 trot, 2 gallop
layout(location = 7) in vec4 stand;   // rise of the ground ahead and to the left, shade of the coat, headgear (negative: young; 2 more: velvet)
#include "landscape/animal_skeleton.glsl"
#ifdef SHADOW_CASTER
#include "landscape/shadow_view.glsl"
uniform int cascade;
#endif
out vec3 offset;
out vec3 normal;
out vec3 coat;
out vec3 on_body;
out vec4 veil;
out float spotted;
out float above_ground;

const float turn_round = 6.2831853;

// Turns p and n about a joint in the plane of symmetry; positive lifts what lies ahead.
void turn(inout vec3 p, inout vec3 n, vec2 joint, float angle) {
  float s = sin(angle);
  float c = cos(angle);
  vec2 q = p.xz - joint;
  p.xz = joint + vec2(c * q.x - s * q.y, s * q.x + c * q.y);
  n.xz = vec2(c * n.x - s * n.z, s * n.x + c * n.z);
}

vec4 beat(float walk, float trot, float gallop) {
  float to_trot = clamp(pose.w, 0.0, 1.0);
  float to_gallop = clamp(pose.w - 1.0, 0.0, 1.0);
  return vec4(mix(mix(walk, trot, to_trot), gallop, to_gallop));
}

// The trunk's bob: two to a stride of walk or trot, one to a leap of a gallop.
float moving() { return clamp(motion.w / (0.4 * skeleton.body.x), 0.0, 1.0); }
float trunk_lift() {
  float to_trot = clamp(pose.w, 0.0, 1.0);
  float to_gallop = clamp(pose.w - 1.0, 0.0, 1.0);
  float twice = 0.008 + 0.022 * to_trot * (1.0 - to_gallop);
  return skeleton.body.w * moving() *
         (-0.018 + twice * sin(2.0 * turn_round * motion.z) * (1.0 - to_gallop) + 0.035 * to_gallop * sin(turn_round * (motion.z + 0.15)));
}
float trunk_turn() {
  float to_gallop = clamp(pose.w - 1.0, 0.0, 1.0);
  return skeleton.graze.z * pose.x + 0.075 * to_gallop * sin(turn_round * (motion.z + 0.45));
}
void move_trunk(inout vec3 p, inout vec3 n) {
  turn(p, n, skeleton.joints[0].xz, trunk_turn());
  p.z += trunk_lift() - skeleton.graze.w * pose.y + stand.x * 0.92 * p.x;
  n.x -= stand.x * 0.92 * n.z;
}

// Where in its stride a leg's foot is: x ahead of where it stands, y above the ground.
vec2 foot_motion(int leg) {
  float offset_of = leg == 0 ? 0.0 : leg == 1 ? beat(0.25, 0.5, 0.5).x : leg == 2 ? beat(0.5, 0.5, 0.1).x : beat(0.75, 1.0, 0.6).x;
  float duty = beat(0.66, 0.45, 0.27).x;
  float phase = fract(motion.z - offset_of);
  float reach = duty * motion.w;
  if (phase < duty) return vec2(reach * (0.5 - phase / duty), 0.0);
  float u = (phase - duty) / (1.0 - duty);
  float lift = beat(0.10, 0.17, 0.26).x * skeleton.body.x * moving();
  return vec2(reach * (-0.5 + u - 0.16 * sin(turn_round * u) * (1.0 - duty)), lift * sin(0.5 * turn_round * u) * (1.15 - 0.3 * u));
}

void bend_leg(inout vec3 p, inout vec3 n) {
  int leg = int(rig.x + 0.5) - 1;
  bool hind = leg == 0 || leg == 2;
  vec3 hip = skeleton.joints[3 * leg].xyz;
  vec3 knee = skeleton.joints[3 * leg + 1].xyz;
  vec3 foot = skeleton.joints[3 * leg + 2].xyz;
  vec2 step = foot_motion(leg);
  vec3 target = foot + vec3(step.x, 0.0, step.y);
  vec3 moved_hip = hip;
  vec3 unused = vec3(0.0);
  move_trunk(moved_hip, unused);
  // The shoulder blade and the pelvis swing along.
  moved_hip.x += 0.38 * step.x;
  target.z += stand.x * target.x + stand.y * target.y;
  // Lying, feet are drawn up under the trunk.
  // One foreleg is stretched out, the other one folded; hind feet lie along the flank.
  float stretched = hind ? 0.27 : leg == 1 ? 0.58 : -0.02;
  vec3 folded = vec3(hip.x + stretched * skeleton.body.w, foot.y * (hind ? 1.9 : 1.5), 0.03 * skeleton.body.w);
  folded.z += stand.x * folded.x + stand.y * folded.y;
  target = mix(target, folded, pose.y);

  vec2 upper = (knee - hip).xz;
  vec2 lower = (foot - knee).xz;
  float a = length(upper);
  float b = length(lower);
  vec2 along = target.xz - moved_hip.xz;
  float reach = clamp(length(along), abs(a - b) + 0.01 * a, 0.999 * (a + b));
  along = normalize(along + vec2(0.0, -1e-5));
  float cosine = clamp((a * a + reach * reach - b * b) / (2.0 * a * reach), -1.0, 1.0);
  float sine = sqrt(1.0 - cosine * cosine) * (hind ? -1.0 : 1.0);
  vec2 new_upper = cosine * along + sine * vec2(-along.y, along.x);
  vec2 new_knee = moved_hip.xz + a * new_upper;
  vec2 new_foot = moved_hip.xz + reach * along;
  vec2 new_lower = (new_foot - new_knee) / b;

  vec2 old_upper = upper / a;
  vec2 old_lower = lower / b;
  // Turning one unit vector into another, as a complex number.
  vec2 turn_upper = vec2(dot(old_upper, new_upper), old_upper.x * new_upper.y - old_upper.y * new_upper.x);
  vec2 turn_lower = vec2(dot(old_lower, new_lower), old_lower.x * new_lower.y - old_lower.y * new_lower.x);
  vec2 q = p.xz - hip.xz;
  vec2 by_upper = moved_hip.xz + vec2(turn_upper.x * q.x - turn_upper.y * q.y, turn_upper.y * q.x + turn_upper.x * q.y);
  q = p.xz - knee.xz;
  vec2 by_lower = new_knee + vec2(turn_lower.x * q.x - turn_lower.y * q.y, turn_lower.y * q.x + turn_lower.x * q.y);
  vec2 by_foot = new_foot + p.xz - foot.xz;
  float low = clamp(rig.y, 0.0, 1.0);
  float hoof = clamp(rig.y - 1.0, 0.0, 1.0);
  p.xz = mix(mix(by_upper, by_lower, low), by_foot, hoof);
  p.y += (target.y - foot.y) * clamp(rig.y, 0.0, 1.0);
  vec2 turned = mix(turn_upper, turn_lower, low);
  n.xz = vec2(turned.x * n.x - turned.y * n.z, turned.y * n.x + turned.x * n.z);
}

void swing_leg(inout vec3 p, inout vec3 n) {
  int leg = int(rig.x + 0.5) - 1;
  vec3 hip = skeleton.joints[3 * leg].xyz;
  vec2 step = foot_motion(leg);
  p.x += step.x * clamp((hip.z - p.z) / hip.z, 0.0, 1.0);
  p.z = mix(p.z, 0.25 * p.z, pose.y) + step.y * (1.0 - p.z / hip.z) + stand.x * p.x;
}

// The coat of the month; headgear is bone or velvet.
vec3 coat_of_month(float velvet) {
  if (rig.x > 6.5) return mix(colour_in, vec3(0.30, 0.22, 0.155), 0.9 * velvet);
  vec3 dull = mix(colour_in, vec3(dot(colour_in, vec3(0.30, 0.55, 0.15))), skeleton.winter.x);
  return mix(dull, vec3(0.82, 0.755, 0.65), skeleton.winter.y) * skeleton.winter.z;
}

void main() {
  vec3 p = position;
  vec3 n = normal_in;
  float velvet = step(1.5, stand.w);
  // Long hair on trunk, neck and thighs.
  float hairy = rig.x < 0.5 ? 1.0 - 0.8 * rig.z : rig.x < 4.5 ? 0.6 * clamp(1.0 - 2.0 * rig.y, 0.0, 1.0) : rig.x < 5.5 ? 0.5 : 0.0;
  p += n * (skeleton.winter.w * hairy + (rig.x > 6.5 ? 0.006 * velvet : 0.0));
  float seed = fract(stand.z * 57.31);
  float seconds = frame.wind.z + 40.0 * seed;
  if (rig.x > 0.5 && rig.x < 4.5) {
    if (posed) bend_leg(p, n);
    else swing_leg(p, n);
  } else {
    float gallop = clamp(pose.w - 1.0, 0.0, 1.0);
    if (rig.x > 6.5) {
      // Headgear that this one has less of, or not, shrinks into the head.
      p = mix(vec3(skeleton.neck_head.z, 0.0, skeleton.neck_head.w), p, max(stand.w, 0.0) - 2.0 * velvet);
    } else if (rig.x > 5.5) {
      // Ears flick now and then.
      float flick = smoothstep(0.93, 1.0, sin(seconds * 0.9 + rig.w * 2.1)) * sin(seconds * 19.0);
      p.y += rig.w * 0.02 * skeleton.body.w * flick;
    } else if (rig.x > 4.5) {
      float free = rig.z * rig.z;
      p.y += free * skeleton.body.w * (0.05 * sin(seconds * 1.7) + 0.10 * smoothstep(0.8, 1.0, sin(seconds * 0.43)) * sin(seconds * 7.0));
      turn(p, n, skeleton.body.yz, -(0.55 * pose.z + 0.5 * gallop) * smoothstep(0.0, 0.3, rig.z));
    }
    if (stand.w < 0.0 && rig.z > 0.0 && rig.x < 0.5) {
      // The young have rounder heads with short muzzles.
      vec2 head = skeleton.neck_head.zw;
      p.xz = head + (p.xz - head) * mix(1.0, p.x > head.x + 0.12 * skeleton.body.w ? 0.92 : 1.12, rig.z);
      p.y *= 1.0 + 0.2 * rig.z;
    }
    float on_neck = rig.y;
    float on_head = rig.x > 4.5 && rig.x < 5.5 ? 0.0 : rig.z;
    if (on_neck > 0.0) {
      float tear = 0.05 * pose.x * sin(seconds * 2.3);
      turn(p, n, skeleton.neck_head.zw, on_head * (skeleton.graze.y * pose.x + 2.0 * tear - 0.10 * pose.z + 0.25 * gallop));
      float nod = 0.035 * moving() * (1.0 - gallop) * sin(2.0 * turn_round * motion.z + 0.8) + 0.07 * gallop * sin(turn_round * (motion.z + 0.1));
      turn(p, n, skeleton.neck_head.xy, on_neck * (skeleton.graze.x * pose.x - tear + 0.22 * pose.z * (1.0 - pose.x) + nod - 0.28 * gallop));
    }
    move_trunk(p, n);
  }
  on_body = position / skeleton.body.w;
  p *= place.w;
  above_ground = (p.z - stand.x * p.x) / skeleton.body.w;
  vec2 ahead = motion.xy;
  vec2 left = vec2(-ahead.y, ahead.x);
  offset = place.xyz + vec3(ahead * p.x + left * p.y, p.z);
  normal = vec3(ahead * n.x + left * n.y, n.z);
  // No two are of one colour.
  coat = coat_of_month(velvet) * stand.z * mix(vec3(1.05, 1.0, 0.94), vec3(0.95, 1.0, 1.06), fract(stand.z * 913.7));
  spotted = stand.w < 0.0 && abs(skeleton.look.x) < skeleton.look.w ? skeleton.look.w : skeleton.look.x;
  veil = vec4(apply_haze(vec3(0.0), offset, 1.0), haze(offset));
#ifdef SHADOW_CASTER
  vec3 seen = in_light(cascade, offset);
  vec4 square = shadows.cascades[cascade];
  gl_Position = vec4((seen.xy - square.xy) / square.z, (shadows.up[cascade].w - seen.z) * shadows.right[cascade].w, 1.0);
#else
  gl_Position = frame.view_projection * vec4(offset, 1.0);
#endif
}

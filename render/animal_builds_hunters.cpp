#include "render/animal_builds.hpp"

namespace biotope::animal_builds {

AnimalBuild wolf() {
  AnimalBuild b;
  b.trunk = 1.05F;
  b.rump = 0.95F;
  b.back = 0.95F;
  b.chest = 0.49F;
  b.belly = 0.54F;
  b.groin = 0.63F;
  b.rump_width = 0.10F;
  b.belly_width = 0.125F;
  b.shoulder_width = 0.125F;
  b.neck_length = 0.26F;
  b.neck_angle = 28;
  b.neck_base = 0.165F;
  b.neck_top = 0.115F;
  b.neck_width = 0.10F;
  b.neck_top_width = 0.085F;
  b.head_length = 0.44F;
  b.head_angle = 16;
  b.head_depth = 0.108F;
  b.muzzle_depth = 0.048F;
  b.head_width = 0.098F;
  b.muzzle_width = 0.036F;
  b.shank = 0.034F;
  b.thigh = 0.13F;
  b.upper_arm = 0.085F;
  b.hock = 0.27F;
  b.knee = 0.24F;
  b.paws = true;
  b.ear_length = 0.13F;
  b.ear_width = 0.045F;
  b.ear_out = 14;
  b.tail_length = 0.60F;
  b.tail_radius = 0.075F;
  b.tail_angle = -62;
  b.dorsal_stripe = 0.9F;
  b.dark_legs = -0.3F;
  b.pale_muzzle = 0.6F;
  b.dark_tail_tip = 1;
  b.throat_mane = 0.045F;
  return b;
}

AnimalBuild fox() {
  AnimalBuild b = wolf();
  b.trunk = 1.16F;
  b.neck_length = 0.20F;
  b.head_length = 0.46F;
  b.head_depth = 0.115F;
  b.muzzle_depth = 0.034F;
  b.muzzle_width = 0.028F;
  b.ear_length = 0.20F;
  b.ear_width = 0.065F;
  b.tail_length = 1.0F;
  b.tail_radius = 0.105F;
  b.tail_angle = -34;
  b.dark_tail_tip = 0;
  b.pale_tail_tip = 1;
  b.dorsal_stripe = 0.1F;
  b.dark_legs = 0.95F;
  b.pale_muzzle = 0.8F;
  b.belly_share = 0.8F;
  b.head_width = 0.105F;
  return b;
}

AnimalBuild cat() {
  AnimalBuild b = wolf();
  b.belly_share = 0.8F;
  b.trunk = 1.18F;
  b.rump = 1.0F;
  b.chest = 0.52F;
  b.neck_length = 0.20F;
  b.neck_angle = 26;
  b.neck_base = 0.15F;
  b.head_length = 0.34F;
  b.head_angle = 12;
  b.head_depth = 0.125F;
  b.muzzle_depth = 0.07F;
  b.muzzle_width = 0.068F;
  b.head_width = 0.11F;
  b.shank = 0.04F;
  b.thigh = 0.15F;
  b.ear_length = 0.09F;
  b.tail_length = 0.75F;
  b.tail_radius = 0.035F;
  b.tail_angle = -42;
  b.dorsal_stripe = 0.15F;
  b.dark_legs = 0;
  b.dark_tail_tip = 1;
  b.throat_mane = 0;
  return b;
}

AnimalBuild lynx() {
  AnimalBuild b = cat();
  b.trunk = 0.95F;
  b.rump = 1.04F;
  b.shank = 0.05F;
  b.ear_length = 0.17F;
  b.ear_width = 0.055F;
  b.ear_tufts = true;
  b.tail_length = 0.17F;
  b.tail_radius = 0.05F;
  b.tail_angle = -50;
  b.beard = 0.08F;
  b.throat_mane = 0.05F;
  b.spots = -0.8F;
  b.neck_length = 0.16F;
  b.neck_angle = 32;
  b.head_length = 0.35F;
  return b;
}

AnimalBuild bear() {
  AnimalBuild b;
  b.pale_chin = 0;
  b.eye_rings = 0;
  b.trunk = 1.24F;
  b.rump = 0.93F;
  b.back = 0.93F;
  b.hump = 0.07F;
  b.chest = 0.34F;
  b.belly = 0.34F;
  b.groin = 0.42F;
  b.rump_width = 0.23F;
  b.belly_width = 0.25F;
  b.shoulder_width = 0.22F;
  b.neck_length = 0.24F;
  b.neck_angle = 4;
  b.neck_base = 0.25F;
  b.neck_top = 0.165F;
  b.neck_width = 0.18F;
  b.neck_top_width = 0.125F;
  b.head_length = 0.46F;
  b.head_angle = 14;
  b.head_depth = 0.155F;
  b.muzzle_depth = 0.06F;
  b.head_width = 0.15F;
  b.muzzle_width = 0.055F;
  b.shank = 0.07F;
  b.thigh = 0.22F;
  b.upper_arm = 0.15F;
  b.hock = 0.15F;
  b.knee = 0.19F;
  b.paws = true;
  b.ear_length = 0.095F;
  b.ear_width = 0.055F;
  b.ear_out = 25;
  b.tail_length = 0.07F;
  b.tail_radius = 0.035F;
  b.tail_angle = -40;
  b.dark_legs = 0.55F;
  b.dorsal_stripe = 0;
  b.pale_muzzle = 0.4F;
  b.belly_share = 0.5F;
  return b;
}

AnimalBuild boar() {
  AnimalBuild b;
  b.pale_chin = 0;
  b.eye_rings = 0;
  b.trunk = 1.22F;
  b.rump = 0.86F;
  b.back = 0.95F;
  b.hump = 0.05F;
  b.chest = 0.40F;
  b.belly = 0.42F;
  b.groin = 0.48F;
  b.neck_length = 0.20F;
  b.neck_angle = -6;
  b.neck_base = 0.25F;
  b.neck_top = 0.175F;
  b.neck_width = 0.15F;
  b.neck_top_width = 0.10F;
  b.head_length = 0.54F;
  b.head_angle = 26;
  b.head_depth = 0.145F;
  b.muzzle_depth = 0.05F;
  b.head_width = 0.095F;
  b.muzzle_width = 0.045F;
  b.shank = 0.032F;
  b.hock = 0.24F;
  b.knee = 0.22F;
  b.ear_length = 0.14F;
  b.ear_width = 0.05F;
  b.ear_out = 25;
  b.tail_length = 0.26F;
  b.tail_radius = 0.014F;
  b.tail_angle = -75;
  b.hair_tail = true;
  b.mane = 0.06F;
  b.dark_legs = 0.8F;
  b.belly_share = 0.4F;
  return b;
}

AnimalBuild rhino() {
  AnimalBuild b = bison();
  b.trunk = 1.42F;
  b.rump = 0.95F;
  b.back = 0.90F;
  b.hump = 0.03F;
  b.belly_width = 0.27F;
  b.shoulder_width = 0.24F;
  b.rump_width = 0.22F;
  b.neck_angle = -10;
  b.neck_length = 0.28F;
  b.neck_base = 0.22F;
  b.head_length = 0.52F;
  b.head_angle = 36;
  b.head_depth = 0.13F;
  b.muzzle_depth = 0.085F;
  b.head_width = 0.11F;
  b.muzzle_width = 0.085F;
  b.shank = 0.075F;
  b.thigh = 0.2F;
  b.upper_arm = 0.15F;
  b.ear_length = 0.11F;
  b.ear_out = 20;
  b.beard = 0;
  b.throat_mane = 0;
  b.headgear = Headgear::nose_horns;
  b.headgear_size = 0.42F;
  b.female_headgear = 1;
  b.dark_front = 0;
  b.saddle = 0;
  b.dorsal_stripe = 0;
  b.dark_legs = 0.3F;
  return b;
}

}  // namespace biotope::animal_builds

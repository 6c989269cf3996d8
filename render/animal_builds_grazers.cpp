#include "render/animal_builds.hpp"

namespace biotope::animal_builds {

AnimalBuild red_deer() {
  AnimalBuild b;
  b.headgear = Headgear::red_antlers;
  b.headgear_size = 0.68F;
  b.throat_mane = 0.035F;
  b.pale_rump = 0.8F;
  b.dark_front = 0.25F;
  b.trunk = 1.0F;
  b.neck_base = 0.135F;
  b.head_length = 0.37F;
  b.muzzle_depth = 0.054F;
  b.muzzle_width = 0.043F;
  b.head_depth = 0.095F;
  b.head_width = 0.07F;
  b.groin = 0.60F;
  b.neck_length = 0.46F;
  b.neck_angle = 56;
  return b;
}

AnimalBuild fallow_deer() {
  AnimalBuild b;
  b.trunk = 1.04F;
  b.neck_length = 0.42F;
  b.neck_angle = 48;
  b.rump = 1.0F;
  b.headgear = Headgear::palmate_antlers;
  b.headgear_size = 0.72F;
  b.spots = 1;
  b.pale_rump = 1;
  b.tail_length = 0.2F;
  b.dark_tail_tip = 1;
  b.dark_legs = 0.05F;
  b.dorsal_stripe = 0.6F;
  b.neck_base = 0.13F;
  b.head_length = 0.37F;
  b.muzzle_depth = 0.054F;
  b.muzzle_width = 0.043F;
  b.head_depth = 0.095F;
  b.head_width = 0.07F;
  b.groin = 0.60F;
  return b;
}

AnimalBuild reindeer() {
  AnimalBuild b;
  b.trunk = 1.1F;
  b.chest = 0.43F;
  b.belly = 0.45F;
  b.groin = 0.52F;
  b.belly_width = 0.185F;
  b.shoulder_width = 0.165F;
  b.neck_angle = 22;
  b.neck_length = 0.40F;
  b.neck_base = 0.17F;
  b.neck_top = 0.10F;
  b.head_length = 0.42F;
  b.head_angle = 30;
  b.muzzle_depth = 0.062F;
  b.muzzle_width = 0.05F;
  b.shank = 0.03F;
  b.ear_length = 0.11F;
  b.throat_mane = 0.10F;
  b.headgear = Headgear::caribou_antlers;
  b.headgear_size = 0.95F;
  b.female_headgear = 0.6F;
  b.pale_front = 0.95F;
  b.pale_rump = 0.6F;
  b.dark_legs = 0.45F;
  b.socks = 0.5F;
  b.saddle = 0.3F;
  b.dark_face = 0.5F;
  b.head_depth = 0.10F;
  b.head_width = 0.075F;
  return b;
}

AnimalBuild moose() {
  AnimalBuild b = red_deer();
  b.trunk = 1.05F;
  b.hump = 0.07F;
  b.rump = 0.9F;
  b.back = 0.93F;
  b.chest = 0.52F;
  b.groin = 0.6F;
  b.neck_length = 0.30F;
  b.neck_angle = 25;
  b.head_length = 0.42F;
  b.head_angle = 28;
  b.muzzle_depth = 0.078F;
  b.muzzle_width = 0.06F;
  b.ear_length = 0.15F;
  b.beard = 0.12F;
  b.throat_mane = 0.05F;
  b.headgear = Headgear::palmate_antlers;
  b.headgear_size = 0.85F;
  b.pale_rump = 0;
  b.dark_front = 0.3F;
  b.dark_legs = -0.4F;
  b.tail_length = 0.06F;
  return b;
}

AnimalBuild mule_deer() {
  AnimalBuild b;
  b.headgear = Headgear::forked_antlers;
  b.headgear_size = 0.7F;
  b.ear_length = 0.25F;
  b.ear_width = 0.055F;
  b.ear_out = 62;
  b.pale_rump = 1;
  b.dark_tail_tip = 1;
  b.tail_length = 0.17F;
  b.pale_muzzle = 0.4F;
  b.neck_base = 0.13F;
  b.head_length = 0.37F;
  b.muzzle_depth = 0.054F;
  b.muzzle_width = 0.043F;
  b.head_depth = 0.095F;
  b.head_width = 0.07F;
  b.trunk = 1.0F;
  return b;
}

AnimalBuild bison() {
  AnimalBuild b;
  b.pale_chin = 0;
  b.eye_rings = 0;
  b.trunk = 1.2F;
  b.rump = 0.80F;
  b.back = 0.85F;
  b.hump = 0.13F;
  b.chest = 0.32F;
  b.belly = 0.38F;
  b.groin = 0.44F;
  b.rump_width = 0.145F;
  b.belly_width = 0.205F;
  b.shoulder_width = 0.215F;
  b.neck_length = 0.24F;
  b.neck_angle = -22;
  b.neck_base = 0.27F;
  b.neck_top = 0.165F;
  b.neck_width = 0.18F;
  b.neck_top_width = 0.125F;
  b.head_length = 0.48F;
  b.head_angle = 58;
  b.head_depth = 0.17F;
  b.muzzle_depth = 0.085F;
  b.head_width = 0.145F;
  b.muzzle_width = 0.08F;
  b.shank = 0.034F;
  b.thigh = 0.16F;
  b.upper_arm = 0.15F;
  b.hock = 0.24F;
  b.knee = 0.20F;
  b.ear_length = 0.08F;
  b.ear_out = 85;
  b.tail_length = 0.36F;
  b.tail_radius = 0.022F;
  b.tail_angle = -78;
  b.hair_tail = true;
  b.beard = 0.24F;
  b.throat_mane = 0.10F;
  b.headgear = Headgear::bison_horns;
  b.headgear_size = 0.28F;
  b.female_headgear = 0.8F;
  b.dark_front = 0.75F;
  b.dark_legs = 0.6F;
  b.belly_share = 0.4F;
  b.saddle = 0.25F;
  return b;
}

AnimalBuild horse() {
  AnimalBuild b;
  b.pale_chin = 0.2F;
  b.eye_rings = 0.15F;
  b.trunk = 1.04F;
  b.rump = 1.0F;
  b.back = 0.94F;
  b.chest = 0.48F;
  b.belly = 0.49F;
  b.groin = 0.57F;
  b.rump_width = 0.165F;
  b.belly_width = 0.185F;
  b.shoulder_width = 0.155F;
  b.neck_length = 0.48F;
  b.neck_angle = 50;
  b.neck_base = 0.175F;
  b.neck_top = 0.105F;
  b.neck_width = 0.10F;
  b.neck_top_width = 0.055F;
  b.head_length = 0.48F;
  b.head_angle = 44;
  b.head_depth = 0.112F;
  b.muzzle_depth = 0.058F;
  b.muzzle_width = 0.048F;
  b.shank = 0.028F;
  b.thigh = 0.16F;
  b.upper_arm = 0.095F;
  b.ear_length = 0.11F;
  b.ear_width = 0.028F;
  b.ear_out = 18;
  b.tail_length = 0.62F;
  b.tail_radius = 0.07F;
  b.tail_angle = -74;
  b.hair_tail = true;
  b.mane = 0.10F;
  b.dark_legs = 0.85F;
  b.dorsal_stripe = 0.7F;
  b.pale_muzzle = 0.35F;
  b.belly_share = 0.7F;
  return b;
}

AnimalBuild goat() {
  AnimalBuild b;
  b.trunk = 1.0F;
  b.chest = 0.43F;
  b.belly = 0.44F;
  b.groin = 0.50F;
  b.belly_width = 0.19F;
  b.shoulder_width = 0.165F;
  b.rump_width = 0.15F;
  b.neck_length = 0.33F;
  b.neck_angle = 45;
  b.neck_base = 0.15F;
  b.neck_top = 0.085F;
  b.head_length = 0.37F;
  b.head_angle = 38;
  b.head_depth = 0.09F;
  b.shank = 0.034F;
  b.upper_arm = 0.09F;
  b.ear_length = 0.12F;
  b.ear_width = 0.03F;
  b.tail_length = 0.11F;
  b.tail_angle = 20;
  b.beard = 0.10F;
  b.headgear = Headgear::ibex_horns;
  b.headgear_size = 0.72F;
  b.female_headgear = 0.4F;
  b.dark_legs = 0.6F;
  b.dorsal_stripe = 0.6F;
  b.head_width = 0.07F;
  return b;
}

AnimalBuild tahr() {
  AnimalBuild b = goat();
  b.throat_mane = 0.11F;
  b.beard = 0;
  b.mane = 0.04F;
  b.headgear_size = 0.36F;
  b.female_headgear = 0.6F;
  b.dark_front = 0.35F;
  return b;
}

AnimalBuild pronghorn() {
  AnimalBuild b;
  b.neck_length = 0.42F;
  b.headgear = Headgear::prong_horns;
  b.headgear_size = 0.36F;
  b.female_headgear = 0.3F;
  b.pale_rump = 1;
  b.dark_face = 0.7F;
  b.pale_muzzle = 0.3F;
  b.tail_length = 0.09F;
  b.belly_share = 1.4F;
  b.dark_legs = 0;
  b.neck_base = 0.13F;
  b.head_length = 0.38F;
  b.head_depth = 0.095F;
  b.head_width = 0.07F;
  b.trunk = 1.0F;
  b.neck_angle = 55;
  return b;
}

AnimalBuild chamois() {
  AnimalBuild b = goat();
  b.beard = 0;
  b.headgear = Headgear::prong_horns;
  b.headgear_size = 0.26F;
  b.female_headgear = 0.9F;
  b.dark_legs = 0.9F;
  return b;
}

AnimalBuild sheep() {
  AnimalBuild b = goat();
  b.trunk = 1.03F;
  b.neck_length = 0.29F;
  b.neck_angle = 40;
  b.neck_base = 0.15F;
  b.neck_top = 0.10F;
  b.beard = 0;
  b.shank = 0.028F;
  b.head_length = 0.38F;
  b.headgear = Headgear::curled_horns;
  b.headgear_size = 0.36F;
  b.female_headgear = 0;
  b.saddle = 0.75F;
  b.pale_rump = 0.9F;
  b.socks = 0.9F;
  b.pale_muzzle = 0.7F;
  b.dark_muzzle = 0.2F;
  b.dark_front = 0.25F;
  b.tail_angle = -60;
  b.throat_mane = 0.03F;
  b.head_depth = 0.095F;
  b.head_width = 0.075F;
  return b;
}

}  // namespace biotope::animal_builds

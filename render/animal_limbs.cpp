#include <algorithm>
#include <cmath>
#include <numbers>

#include "render/animal_body.hpp"

namespace biotope {

namespace {

using Joint = AnimalMeshBuilder::Joint;

glm::vec3 leg_colour(const AnimalFrame& f, float share_down) {
  const AnimalBuild& b = f.build;
  const glm::vec3 dark = b.dark_legs > 0.9F ? glm::vec3(0.14F, 0.11F, 0.10F) : f.dark;
  glm::vec3 colour = b.dark_legs >= 0
                         ? glm::mix(f.coat, dark, b.dark_legs * std::clamp(share_down * 1.4F - 0.15F, 0.0F, 1.0F))
                         : glm::mix(f.coat, f.pale, -b.dark_legs * std::clamp(share_down * 1.4F - 0.15F, 0.0F, 1.0F));
  if (share_down > 0.6F) colour = glm::mix(colour, f.pale, b.socks);
  return colour;
}

/// A hoof, or a paw that lies on the ground.
std::vector<Joint> with_foot(const AnimalFrame& f, const AnimalLeg& leg, float number, std::vector<Joint> joints) {
  const float h = f.height;
  const float r = f.build.shank * h;
  const glm::vec4 rig(number, 2, 0, 0);
  if (f.build.paws) {
    const glm::vec3 colour = leg_colour(f, 1);
    joints.push_back({leg.foot + glm::vec3(-0.005F * h, 0, 1.15F * r), 1.12F * r, colour, rig, 1.1F});
    joints.push_back({leg.foot + glm::vec3(1.1F * r, 0, 0.85F * r), 1.15F * r, colour, rig, 0.72F});
    joints.push_back({leg.foot + glm::vec3(2.2F * r, 0, 0.55F * r), 0.75F * r, colour * 0.85F, rig, 0.66F});
    return joints;
  }
  joints.push_back({leg.foot + glm::vec3(0.012F * h, 0, 0.045F * h), 1.05F * r, glm::vec3(0.15F, 0.13F, 0.11F), rig, 1.1F});
  joints.push_back({leg.foot + glm::vec3(0.024F * h, 0, 0.012F * h), 1.28F * r, glm::vec3(0.11F, 0.10F, 0.09F), rig, 1.15F});
  joints.push_back({leg.foot + glm::vec3(0.024F * h, 0, 0), 1.1F * r, glm::vec3(0.09F, 0.08F, 0.07F), rig, 1.15F});
  return joints;
}

/// Foreleg: shoulder and upper arm within the trunk, knee, shank, fetlock, hoof.
std::vector<Joint> foreleg(const AnimalFrame& f, const AnimalLeg& leg, float number) {
  const AnimalBuild& b = f.build;
  const float h = f.height;
  const auto rig = [&](float y) { return glm::vec4(number, y, 0, 0); };
  const glm::vec3 elbow = glm::mix(leg.hip, leg.knee, 0.42F) + glm::vec3(-0.025F * h, 0, 0);
  const glm::vec3 fetlock = glm::mix(leg.knee, leg.foot, b.paws ? 0.82F : 0.74F);
  return with_foot(f, leg, number,
                   {{leg.hip + glm::vec3(0.01F * h, 0, 0.05F * h), 0.40F * b.upper_arm * h, f.coat, rig(0), 2.2F},
                    {leg.hip + glm::vec3(0, 0, -0.06F * h), 0.58F * b.upper_arm * h, leg_colour(f, 0.05F), rig(0), 1.8F},
                    {elbow, 0.56F * b.upper_arm * h, leg_colour(f, 0.25F), rig(0), 1.35F},
                    {glm::mix(elbow, leg.knee, 0.6F), std::max(1.35F * b.shank, 0.42F * b.upper_arm) * h, leg_colour(f, 0.4F),
                     rig(0.12F), 1.15F},
                    {leg.knee, 1.28F * b.shank * h, leg_colour(f, 0.6F), rig(0.5F)},
                    {glm::mix(leg.knee, fetlock, 0.4F), b.shank * h, leg_colour(f, 0.75F), rig(1)},
                    {fetlock, 1.12F * b.shank * h, leg_colour(f, 0.9F), rig(1.3F)}});
}

/// Hind leg: thigh, stifle, hock, shank, hoof.
std::vector<Joint> hind_leg(const AnimalFrame& f, const AnimalLeg& leg, float number) {
  const AnimalBuild& b = f.build;
  const float h = f.height;
  const auto rig = [&](float y) { return glm::vec4(number, y, 0, 0); };
  const glm::vec3 stifle = glm::mix(leg.hip, leg.knee, 0.45F) + glm::vec3(0.055F * h, 0, 0.0F);
  const glm::vec3 fetlock = glm::mix(leg.knee, leg.foot, b.paws ? 0.84F : 0.76F);
  return with_foot(
      f, leg, number,
      {{leg.hip + glm::vec3(-0.005F * h, 0, 0.06F * h), 0.32F * b.thigh * h, f.coat, rig(0), 2.2F},
       {leg.hip + glm::vec3(0.01F * h, 0, -0.06F * h), 0.46F * b.thigh * h, leg_colour(f, 0.03F), rig(0), 2.0F},
       {stifle, 0.42F * b.thigh * h, leg_colour(f, 0.2F), rig(0), 1.7F},
       {glm::mix(stifle, leg.knee, 0.55F), std::max(1.4F * b.shank, 0.26F * b.thigh) * h, leg_colour(f, 0.4F), rig(0.08F), 1.35F},
       {leg.knee, 1.25F * b.shank * h, leg_colour(f, 0.6F), rig(0.5F), 1.25F},
       {glm::mix(leg.knee, fetlock, 0.45F), 1.02F * b.shank * h, leg_colour(f, 0.75F), rig(1)},
       {fetlock, 1.15F * b.shank * h, leg_colour(f, 0.9F), rig(1.3F)}});
}

void add_ears(AnimalMeshBuilder& builder, const AnimalFrame& f) {
  const AnimalBuild& b = f.build;
  const float h = f.height;
  for (const float side : {-1.0F, 1.0F}) {
    const glm::vec3 base = f.on_head(0.05F * b.head_length, side * 0.62F * b.head_width, 0.80F * b.head_depth);
    const float out = b.ear_out * std::numbers::pi_v<float> / 180;
    const glm::vec3 axis = glm::normalize(f.up * std::cos(out) + glm::vec3(0, side * std::sin(out), 0) - f.forward * 0.35F);
    const glm::vec3 tip = base + axis * (b.ear_length * h);
    const glm::vec4 rig{6, 1, 1, side};
    const glm::vec3 inner = glm::mix(f.coat, f.pale, 0.35F);
    std::vector<Joint> joints{{base - axis * (0.1F * b.ear_length * h), 0.5F * b.ear_width * h, f.coat, rig, 0.6F},
                              {glm::mix(base, tip, 0.4F), b.ear_width * h, f.coat, rig, 0.38F},
                              {glm::mix(base, tip, 0.75F), 0.62F * b.ear_width * h, inner, rig, 0.38F},
                              {tip, 0.1F * b.ear_width * h, b.ear_tufts ? f.dark * 0.4F : f.dark, rig, 0.5F}};
    if (b.ear_tufts) joints.push_back({tip + axis * (0.4F * b.ear_length * h), 0.03F * b.ear_width * h, glm::vec3(0.06F), rig});
    builder.limb(joints, builder.sides(5));
  }
}

void add_tail(AnimalMeshBuilder& builder, const AnimalFrame& f, const AnimalSkeleton& skeleton) {
  const AnimalBuild& b = f.build;
  const float h = f.height;
  const float angle = b.tail_angle * std::numbers::pi_v<float> / 180;
  const glm::vec3 root = skeleton.tail;
  // It leaves the trunk more level than it hangs.
  const glm::vec3 first{-std::cos(angle * 0.55F), 0, std::sin(angle * 0.55F)};
  const glm::vec3 then{-std::cos(angle * 1.08F), 0, std::sin(angle * 1.08F)};
  const float length = b.tail_length * h;
  const glm::vec3 bend = root + first * (0.22F * length);
  const glm::vec3 tip = bend + then * (0.78F * length);
  const glm::vec3 hair = b.hair_tail ? f.dark * 0.45F : f.coat;
  const glm::vec3 end = glm::mix(glm::mix(hair, glm::vec3(0.08F), b.dark_tail_tip), f.pale, b.pale_tail_tip);
  const auto rig = [](float share) { return glm::vec4(5, 0, share, 0); };
  const float r = b.tail_radius * h;
  const bool thin_first = b.hair_tail && b.tail_length > 0.3F && b.tail_radius < 0.03F;
  const glm::vec3 under = b.tail_length < 0.3F ? glm::mix(f.coat, f.pale, 0.4F * b.pale_rump) : f.coat;
  const std::array<Joint, 5> joints{{{root + glm::vec3(0.03F * h, 0, 0), 0.7F * r, f.coat, rig(0)},
                                     {bend, thin_first ? 0.6F * r : 0.9F * r, under, rig(0.2F)},
                                     {glm::mix(bend, tip, 0.5F), thin_first ? 0.6F * r : r, hair, rig(0.6F)},
                                     {glm::mix(bend, tip, 0.82F), thin_first ? 1.5F * r : 0.85F * r, end, rig(0.85F)},
                                     {tip, 0.15F * r, end, rig(1)}}};
  builder.limb(joints, builder.sides(6));
}

}  // namespace

void add_legs(AnimalMeshBuilder& builder, const AnimalFrame& frame, const AnimalSkeleton& skeleton) {
  for (std::size_t i = 0; i < skeleton.legs.size(); ++i) {
    const bool hind = i % 2 == 0;
    const std::vector<Joint> all =
        hind ? hind_leg(frame, skeleton.legs[i], float(i + 1)) : foreleg(frame, skeleton.legs[i], float(i + 1));
    std::vector<Joint> kept;
    if (builder.detail() == AnimalDetail::fine)
      kept = all;
    else if (builder.detail() == AnimalDetail::plain)
      kept = {all[1], all[2], all[4], all[6], all.back()};
    else
      kept = {all[1], all[4], all.back()};
    builder.limb(kept, builder.sides(7));
  }
}

void add_far_details(AnimalMeshBuilder& builder, const AnimalFrame& frame, const AnimalSkeleton& skeleton) {
  const AnimalBuild& b = frame.build;
  if (b.tail_length < 0.3F) return;
  const float angle = b.tail_angle * std::numbers::pi_v<float> / 180;
  const glm::vec3 tip = skeleton.tail + glm::vec3(-std::cos(angle), 0, std::sin(angle)) * (b.tail_length * frame.height);
  const glm::vec3 hair = b.hair_tail ? frame.dark * 0.45F : frame.coat;
  const float r = 0.9F * b.tail_radius * frame.height;
  const std::array<Joint, 2> joints{
      {{skeleton.tail, r, frame.coat, glm::vec4(5, 0, 0, 0)}, {tip, r, hair, glm::vec4(5, 0, 0.9F, 0)}}};
  builder.limb(joints, builder.sides(6));
}

void add_details(AnimalMeshBuilder& builder, const AnimalFrame& frame, const AnimalSkeleton& skeleton) {
  add_ears(builder, frame);
  add_tail(builder, frame, skeleton);
  if (builder.detail() != AnimalDetail::fine) return;
  const AnimalBuild& b = frame.build;
  for (const float side : {-1.0F, 1.0F}) {
    const glm::vec3 eye = frame.on_head(0.30F * b.head_length, side * 0.86F * b.head_width, 0.46F * b.head_depth);
    builder.ball(eye, std::min(0.0175F, 0.18F * b.head_depth) * frame.height, glm::vec3(0.05F, 0.04F, 0.03F), {0, 1, 1, 0});
  }
}

}  // namespace biotope

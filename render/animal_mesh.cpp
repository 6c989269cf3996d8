#include "render/animal_mesh.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "render/animal_body.hpp"

namespace biotope {

namespace {

/// Turns a point about a joint in the plane of symmetry; positive lifts what lies ahead.
glm::vec3 turned(glm::vec3 point, glm::vec3 joint, float angle) {
  const float c = std::cos(angle);
  const float s = std::sin(angle);
  const float x = point.x - joint.x;
  const float z = point.z - joint.z;
  return {joint.x + c * x - s * z, point.y, joint.z + s * x + c * z};
}

void set_legs(const AnimalFrame& f, AnimalSkeleton& skeleton) {
  const AnimalBuild& b = f.build;
  for (std::size_t i = 0; i < skeleton.legs.size(); ++i) {
    const bool hind = i % 2 == 0;
    const float side = i < 2 ? 1.0F : -1.0F;
    const float width = side * (hind ? 0.56F * b.rump_width : 0.60F * b.shoulder_width);
    AnimalLeg& leg = skeleton.legs[i];
    if (hind) {
      const float x = -0.36F * b.trunk;
      leg.hip = f.at(x, width, b.groin + 0.42F * (b.rump - b.groin));
      leg.knee = f.at(x - 0.085F - 0.03F * b.trunk, 0.92F * width, b.hock);
      leg.foot = f.at(x - 0.055F - 0.02F * b.trunk, 0.88F * width, 0);
    } else {
      const float x = 0.35F * b.trunk;
      leg.hip = f.at(x, width, b.chest + 0.30F * (1 - b.chest));
      leg.knee = f.at(x + 0.02F, 0.86F * width, b.knee);
      leg.foot = f.at(x - 0.005F, 0.82F * width, 0);
    }
  }
}

/// The least turns that bring the muzzle to the ground: the neck first, then the whole trunk.
void set_grazing(AnimalSkeleton& s, float head_angle, float height) {
  const float target = 0.02F * height;
  // A grazing head hangs steeply, but not beyond 68 degrees below the horizon.
  const float hanging = 68 * std::numbers::pi_v<float> / 180;
  const auto head_turn = [&](float neck) { return std::clamp(-(hanging - head_angle) - neck, -0.6F, 1.1F); };
  constexpr float steepest = -1.75F;
  for (float neck = 0; neck >= steepest; neck -= 0.01F) {
    s.graze_neck = neck;
    s.graze_head = head_turn(neck);
    if (grazing_muzzle(s, 1).z <= target) return;
  }
  // The steepest neck is not always the lowest one.
  float best = 1e9F;
  for (float neck = 0; neck >= steepest; neck -= 0.01F) {
    AnimalSkeleton tried = s;
    tried.graze_neck = neck;
    tried.graze_head = head_turn(neck);
    const float z = grazing_muzzle(tried, 1).z;
    if (z < best) {
      best = z;
      s.graze_neck = tried.graze_neck;
      s.graze_head = tried.graze_head;
    }
  }
  for (s.graze_pitch = 0; s.graze_pitch > -0.4F && grazing_muzzle(s, 1).z > target;) s.graze_pitch -= 0.005F;
}

}  // namespace

glm::vec3 grazing_muzzle(const AnimalSkeleton& s, float share) {
  glm::vec3 muzzle = turned(s.muzzle, s.head, s.graze_head * share);
  muzzle = turned(muzzle, s.neck, s.graze_neck * share);
  const glm::vec3 hips = 0.5F * (s.legs[0].hip + s.legs[2].hip);
  return turned(muzzle, hips, s.graze_pitch * share);
}

AnimalSkeleton animal_skeleton(const AnimalShape& shape, const AnimalBuild& build) {
  const AnimalFrame f = animal_frame(shape, build);
  AnimalSkeleton skeleton;
  set_legs(f, skeleton);
  const float top = 1 + build.hump * 0.45F;
  skeleton.neck = f.at(0.44F * build.trunk, 0, top - 0.02F - build.neck_base);
  skeleton.head = f.poll;
  skeleton.muzzle = f.on_head(build.head_length, 0, -0.6F * build.muzzle_depth);
  skeleton.tail = f.at(-0.505F * build.trunk, 0, build.rump - 0.17F * (build.rump - build.groin));
  skeleton.lie_drop = (std::min({build.chest, build.belly, build.groin}) - 0.03F) * f.height;
  skeleton.hip_height = 0.5F * (skeleton.legs[0].hip.z + skeleton.legs[1].hip.z);
  set_grazing(skeleton, build.head_angle * std::numbers::pi_v<float> / 180, f.height);
  return skeleton;
}

AnimalMesh make_animal_mesh(const AnimalShape& shape, std::string_view scientific_name, AnimalDetail detail) {
  const AnimalBuild build = animal_build(shape, scientific_name);
  const AnimalFrame frame = animal_frame(shape, build);
  const AnimalSkeleton skeleton = animal_skeleton(shape, build);
  AnimalMeshBuilder builder(detail);
  add_body(builder, frame);
  add_legs(builder, frame, skeleton);
  if (detail == AnimalDetail::silhouette)
    add_far_details(builder, frame, skeleton);
  else
    add_details(builder, frame, skeleton);
  add_headgear(builder, frame);
  return builder.take();
}

}  // namespace biotope

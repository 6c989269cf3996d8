#include "render/animal_mesh.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <span>

#include "render/animal_proportions.hpp"

namespace biotope {

namespace {

/// A cross-section of a limb: an ellipse across the limb's direction.
struct Section {
  glm::vec3 centre;
  float across;  ///< half width to the sides
  float along;   ///< half width in the plane of symmetry
  glm::vec3 colour;
};

class Builder {
 public:
  Builder(int sides, bool every_section) : sides_(sides), every_section_(every_section) {}
  void set_rig(glm::vec4 rig) { rig_ = rig; }

  /// Joins sections by a skin, closed at both ends; a silhouette keeps only the first, the middle and the last.
  void loft(std::span<const Section> all) {
    const std::vector<Section> few{all.front(), all[all.size() / 2], all.back()};
    const std::span<const Section> sections = every_section_ ? all : std::span<const Section>(few);
    const auto first = std::uint32_t(mesh_.vertices.size());
    for (std::size_t i = 0; i < sections.size(); ++i) ring(sections, i);
    const auto around = std::uint32_t(sides_);
    for (std::uint32_t i = 0; i + 1 < sections.size(); ++i) {
      for (std::uint32_t s = 0; s < around; ++s) {
        const std::uint32_t a = first + i * around + s;
        const std::uint32_t b = first + i * around + (s + 1) % around;
        triangle(a, b, a + around);
        triangle(b, b + around, a + around);
      }
    }
    cap(sections, 0, first);
    cap(sections, sections.size() - 1, first + std::uint32_t(sections.size() - 1) * around);
  }

  [[nodiscard]] AnimalMesh take() { return std::move(mesh_); }

 private:
  static glm::vec3 direction(std::span<const Section> sections, std::size_t i) {
    const std::size_t before = i == 0 ? 0 : i - 1;
    const std::size_t after = std::min(i + 1, sections.size() - 1);
    return glm::normalize(sections[after].centre - sections[before].centre);
  }

  void ring(std::span<const Section> sections, std::size_t i) {
    const Section& section = sections[i];
    const glm::vec3 forward = direction(sections, i);
    const glm::vec3 side = glm::abs(forward.y) > 0.9F ? glm::vec3(1, 0, 0) : glm::normalize(glm::vec3(0, 1, 0) - forward * forward.y);
    const glm::vec3 up = glm::cross(forward, side);
    for (int s = 0; s < sides_; ++s) {
      const float angle = 2 * std::numbers::pi_v<float> * (float(s) + 0.5F) / float(sides_);
      const glm::vec3 at = side * (std::cos(angle) * section.across) + up * (std::sin(angle) * section.along);
      const glm::vec3 normal = side * (std::cos(angle) / std::max(section.across, 1e-4F)) + up * (std::sin(angle) / std::max(section.along, 1e-4F));
      mesh_.vertices.push_back({section.centre + at, glm::normalize(normal), section.colour, rig_});
    }
  }

  void cap(std::span<const Section> sections, std::size_t i, std::uint32_t ring_start) {
    const glm::vec3 outward = direction(sections, i) * (i == 0 ? -1.0F : 1.0F);
    const auto centre = std::uint32_t(mesh_.vertices.size());
    const float bulge = 0.35F * std::min(sections[i].across, sections[i].along);
    mesh_.vertices.push_back({sections[i].centre + outward * bulge, outward, sections[i].colour, rig_});
    for (int s = 0; s < sides_; ++s) triangle(centre, ring_start + std::uint32_t(s), ring_start + std::uint32_t((s + 1) % sides_));
  }

  void triangle(std::uint32_t a, std::uint32_t b, std::uint32_t c) {
    mesh_.indices.insert(mesh_.indices.end(), {a, b, c});
  }

  int sides_;
  bool every_section_;
  glm::vec4 rig_{0};
  AnimalMesh mesh_;
};

/// An animal's measures in metres.
struct Frame {
  AnimalProportions build;
  float height;
  float trunk;       ///< length
  float back;        ///< height of the back's line of centres
  glm::vec3 coat;
  glm::vec3 belly;
  glm::vec3 dark;
};

Frame frame_of(const AnimalShape& shape) {
  Frame frame;
  frame.build = animal_proportions(shape.model);
  frame.height = shape.shoulder_height;
  // The given length is of head and body together; the trunk keeps the share that the build gives it.
  const float parts = frame.build.trunk_length + frame.build.head_length + 0.5F * frame.build.neck_length;
  frame.trunk = std::min(frame.build.trunk_length * frame.height, shape.body_length * frame.build.trunk_length / parts * 1.1F);
  frame.back = frame.height * (1 - frame.build.hump) - 0.5F * frame.build.trunk_height * frame.height;
  frame.coat = {shape.coat_colour[0], shape.coat_colour[1], shape.coat_colour[2]};
  frame.belly = {shape.belly_colour[0], shape.belly_colour[1], shape.belly_colour[2]};
  frame.dark = frame.coat * 0.55F;
  return frame;
}

void add_trunk(Builder& builder, const Frame& f) {
  const float h = f.build.trunk_height * f.height * 0.5F;
  const float w = f.build.trunk_width * f.height * 0.5F;
  const float hump = f.build.hump * f.height;
  const float half = f.trunk * 0.5F;
  const std::vector<Section> sections{
      {{-half, 0, f.back + 0.05F * h}, 0.55F * w, 0.55F * h, f.coat},
      {{-0.78F * half, 0, f.back + 0.04F * h}, 0.92F * w, 0.86F * h, f.coat},
      {{-0.15F * half, 0, f.back - 0.06F * h}, w, 0.92F * h, glm::mix(f.coat, f.belly, 0.18F)},
      {{0.45F * half, 0, f.back + 0.35F * hump}, w, h + 0.45F * hump, f.coat},
      {{0.85F * half, 0, f.back + 0.40F * hump}, 0.85F * w, 0.95F * h + 0.4F * hump, f.coat},
      {{1.05F * half, 0, f.back + 0.15F * h}, 0.5F * w, 0.6F * h, f.coat}};
  builder.loft(sections);
}

void add_leg(Builder& builder, const Frame& f, bool front, float side, float phase) {
  const float r = f.build.leg_radius * f.height;
  const float w = f.build.trunk_width * f.height * 0.5F;
  const float x = (front ? 0.40F : -0.42F) * f.trunk;
  const float hip = f.back;
  const float y = side * 0.55F * w;
  const float knee = hip * 0.48F;
  const float bend = front ? 0.02F * f.height : -0.05F * f.height;
  builder.set_rig({1, phase, x, hip});
  const std::vector<Section> sections{{{x, y, hip}, 1.9F * r, (front ? 2.4F : 3.0F) * r, f.coat},
                                      {{x + 0.3F * bend, y * 1.02F, 0.5F * (hip + knee)}, 1.4F * r, (front ? 1.6F : 2.0F) * r, f.coat},
                                      {{x + bend, y, knee}, r, 1.1F * r, glm::mix(f.coat, f.dark, 0.4F)},
                                      {{x, y, 0.12F * hip}, 0.72F * r, 0.8F * r, f.dark},
                                      {{x + 0.3F * r, y, 0.0F}, 1.0F * r, 1.25F * r, f.dark * 0.6F}};
  builder.loft(sections);
}

/// Where the neck leaves the trunk, and where the head begins.
struct NeckLine {
  glm::vec3 root;
  glm::vec3 crown;
};

NeckLine neck_line(const Frame& f) {
  const float angle = f.build.neck_angle * std::numbers::pi_v<float> / 180;
  const glm::vec3 root{0.44F * f.trunk, 0, f.back + (0.25F * f.build.trunk_height + 0.3F * f.build.hump) * f.height};
  const float length = f.build.neck_length * f.height;
  return {root, root + glm::vec3(std::cos(angle), 0, std::sin(angle)) * length};
}

void add_neck_and_head(Builder& builder, const Frame& f, const AnimalShape& shape) {
  const NeckLine neck = neck_line(f);
  builder.set_rig({2, 0, neck.root.x, neck.root.z});
  const float r = f.build.neck_radius * f.height;
  const float hr = f.build.head_radius * f.height;
  const glm::vec3 mane = shape.model == "horse" || shape.model == "bovid" ? glm::mix(f.coat, f.dark, 0.7F) : f.coat;
  builder.loft(std::vector<Section>{{neck.root - glm::vec3(0.06F * f.trunk, 0, 0), 1.25F * r, 1.7F * r, mane},
                                    {glm::mix(neck.root, neck.crown, 0.5F), 0.95F * r, 1.2F * r, mane},
                                    {neck.crown, 0.8F * hr, hr, f.coat}});
  const float fall = f.build.neck_angle > 30 ? -0.5F : -0.75F;
  const glm::vec3 forward = glm::normalize(glm::vec3(1, 0, fall));
  const float length = f.build.head_length * f.height;
  builder.loft(std::vector<Section>{{neck.crown - forward * (0.15F * length), 0.75F * hr, 0.8F * hr, f.coat},
                                    {neck.crown + forward * (0.15F * length), hr, 1.05F * hr, f.coat},
                                    {neck.crown + forward * (0.55F * length), 0.62F * hr, 0.68F * hr, glm::mix(f.coat, f.belly, 0.4F)},
                                    {neck.crown + forward * (0.95F * length), 0.48F * hr, 0.5F * hr, f.dark}});
}

void add_ears(Builder& builder, const Frame& f) {
  const NeckLine neck = neck_line(f);
  builder.set_rig({2, 0, neck.root.x, neck.root.z});
  const float hr = f.build.head_radius * f.height;
  for (const float side : {-1.0F, 1.0F}) {
    const glm::vec3 base = neck.crown + glm::vec3(-0.05F * f.build.head_length * f.height, side * 0.7F * hr, 0.8F * hr);
    const glm::vec3 tip = base + glm::vec3(-0.3F, side * 0.6F, 0.75F) * (f.build.ear_length * f.height);
    builder.loft(std::vector<Section>{{base, 0.3F * hr, 0.35F * hr, f.coat},
                                      {glm::mix(base, tip, 0.5F), 0.32F * hr, 0.25F * hr, f.coat},
                                      {tip, 0.05F * hr, 0.05F * hr, f.dark}});
  }
}

void add_tail(Builder& builder, const Frame& f, const AnimalShape& shape) {
  builder.set_rig({0, 0, 0, 0});
  const float angle = f.build.tail_angle * std::numbers::pi_v<float> / 180;
  const glm::vec3 root{-0.5F * f.trunk, 0, f.back + 0.35F * f.build.trunk_height * f.height};
  const glm::vec3 tip = root + glm::vec3(-std::cos(angle), 0, std::sin(angle)) * (f.build.tail_length * f.height);
  const float r = f.build.tail_radius * f.height;
  const glm::vec3 end = shape.model == "fox" ? f.belly : f.dark;
  builder.loft(std::vector<Section>{{root, 0.6F * r, 0.6F * r, f.coat}, {glm::mix(root, tip, 0.55F), r, r, f.coat}, {tip, 0.35F * r, 0.35F * r, end}});
}

/// A curved horn or a beam of antlers through given points.
void add_beam(Builder& builder, const std::vector<glm::vec3>& points, float radius, glm::vec3 colour) {
  std::vector<Section> sections;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const float taper = 1 - 0.85F * float(i) / float(points.size() - 1);
    sections.push_back({points[i], radius * taper, radius * taper, colour});
  }
  builder.loft(sections);
}

void add_antlers(Builder& builder, glm::vec3 base, float side, float size, bool palmate, glm::vec3 colour) {
  const auto at = [&](float back, float out, float up) { return base + glm::vec3(-back, side * out, up) * size; };
  add_beam(builder, {base, at(0.25F, 0.25F, 0.4F), at(0.35F, 0.5F, 0.8F), at(0.2F, 0.55F, 1.15F)}, 0.045F * size, colour);
  add_beam(builder, {at(0.02F, 0.05F, 0.08F), at(-0.3F, 0.18F, 0.3F)}, 0.035F * size, colour);
  add_beam(builder, {at(0.27F, 0.3F, 0.5F), at(-0.05F, 0.42F, 0.75F)}, 0.03F * size, colour);
  if (palmate) {
    builder.loft(std::vector<Section>{{at(0.34F, 0.48F, 0.7F), 0.02F * size, 0.06F * size, colour},
                                      {at(0.36F, 0.52F, 0.95F), 0.025F * size, 0.2F * size, colour},
                                      {at(0.30F, 0.55F, 1.2F), 0.02F * size, 0.12F * size, colour}});
  } else {
    add_beam(builder, {at(0.35F, 0.5F, 0.8F), at(0.6F, 0.45F, 1.1F)}, 0.03F * size, colour);
  }
}

void add_headgear(Builder& builder, const Frame& f, const AnimalShape& shape) {
  if (shape.headgear == "none") return;
  const NeckLine neck = neck_line(f);
  builder.set_rig({2, 0, neck.root.x, neck.root.z});
  const float hr = f.build.head_radius * f.height;
  const glm::vec3 horn{0.24F, 0.2F, 0.16F};
  const glm::vec3 bone{0.42F, 0.34F, 0.25F};
  for (const float side : {-1.0F, 1.0F}) {
    const glm::vec3 base = neck.crown + glm::vec3(0.02F * f.height, side * 0.55F * hr, 0.75F * hr);
    const auto at = [&](float back, float out, float up) { return base + glm::vec3(-back, side * out, up) * f.height; };
    if (shape.headgear == "antlers" || shape.headgear == "palmate") {
      add_antlers(builder, base, side, 0.62F * f.height, shape.headgear == "palmate", bone);
    } else if (shape.headgear == "curled") {
      add_beam(builder, {base, at(0.12F, 0.06F, 0.12F), at(0.24F, 0.14F, 0.04F), at(0.2F, 0.22F, -0.12F), at(0.04F, 0.26F, -0.14F), at(-0.06F, 0.28F, -0.02F)}, 0.055F * f.height, horn);
    } else if (shape.model == "bovid") {
      add_beam(builder, {base, at(0.02F, 0.14F, 0.02F), at(0.0F, 0.2F, 0.12F), at(0.0F, 0.16F, 0.2F)}, 0.04F * f.height, horn);
    } else if (shape.model == "rhino") {
      const glm::vec3 nose = neck.crown + glm::vec3(0.26F, 0, -0.16F) * f.height;
      if (side > 0) add_beam(builder, {nose, nose + glm::vec3(0.06F, 0, 0.16F) * f.height, nose + glm::vec3(0.04F, 0, 0.3F) * f.height}, 0.05F * f.height, horn);
    } else {
      add_beam(builder, {base, at(0.06F, 0.03F, 0.18F), at(0.2F, 0.07F, 0.26F), at(0.32F, 0.1F, 0.2F)}, 0.04F * f.height, horn);
    }
  }
}

}  // namespace

AnimalMesh make_animal_mesh(const AnimalShape& shape, AnimalDetail detail) {
  const Frame frame = frame_of(shape);
  const bool silhouette = detail == AnimalDetail::silhouette;
  Builder builder(detail == AnimalDetail::fine ? 7 : silhouette ? 3 : 4, !silhouette);
  add_trunk(builder, frame);
  // Phases of a walk: left hind, left fore, right hind, right fore, a quarter of a stride apart.
  add_leg(builder, frame, false, 1, 0);
  add_leg(builder, frame, true, 1, 0.25F);
  add_leg(builder, frame, false, -1, 0.5F);
  add_leg(builder, frame, true, -1, 0.75F);
  add_neck_and_head(builder, frame, shape);
  if (silhouette) return builder.take();
  add_ears(builder, frame);
  add_tail(builder, frame, shape);
  add_headgear(builder, frame, shape);
  return builder.take();
}

}  // namespace biotope

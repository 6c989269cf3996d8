#include "render/animal_body.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace biotope {

namespace {

float radians(float degrees) { return degrees * std::numbers::pi_v<float> / 180; }

float smooth(float low, float high, float value) {
  const float t = std::clamp((value - low) / (high - low), 0.0F, 1.0F);
  return t * t * (3 - 2 * t);
}

/// Trunk: what is darker above and paler below, the patches on it, and the shade in the folds before haunch and behind elbow.
glm::vec3 trunk_colour(const AnimalFrame& frame, float along, float height) {
  const AnimalBuild& b = frame.build;
  const float on_head = smooth(1.95F, 2.15F, along);
  // A back in the sun looks as bright as a flank in its own shade: coats are darker above.
  glm::vec3 colour = frame.coat * (1.08F - 0.20F * smooth(-0.2F, 0.95F, height));
  const float flank = smooth(0.3F, 0.45F, along) * (1 - smooth(0.62F, 0.78F, along));
  colour = glm::mix(colour, frame.pale, b.saddle * 0.55F * flank * (1 - smooth(0.3F, 0.8F, std::abs(height - 0.2F))));
  colour = glm::mix(colour, frame.dark, std::clamp(b.dark_front, 0.0F, 1.0F) * smooth(0.62F, 0.95F, along));
  // The pale underside ends where thighs and upper arms begin.
  const float limbs = std::max(1 - smooth(0.14F, 0.30F, along), smooth(0.60F, 0.74F, along) * (1 - smooth(0.9F, 1.1F, along)));
  const float below =
      smooth(0.25F, 0.9F, -height) * (1 - 0.75F * limbs) * (1 - smooth(0.95F, 1.4F, along) * (1 - on_head * 0.6F));
  colour = glm::mix(colour, frame.belly, std::min(1.0F, below * b.belly_share));
  colour = glm::mix(colour, frame.pale,
                    b.pale_front * smooth(0.66F, 1.30F, along) * (1 - smooth(1.75F, 2.1F, along)) *
                        (0.65F + 0.35F * smooth(0.4F, -0.5F, height)));
  // The long hair below a neck is darker than the neck.
  colour = glm::mix(colour, frame.dark,
                    std::min(0.35F, 6 * b.throat_mane) * (1 - b.pale_front) * smooth(0.2F, -0.7F, height) *
                        smooth(0.9F, 1.2F, along) * (1 - on_head));
  const float folds = smooth(0.22F, 0.32F, along) * (1 - smooth(0.32F, 0.46F, along)) +
                      0.8F * smooth(0.56F, 0.66F, along) * (1 - smooth(0.66F, 0.76F, along));
  return colour * (1 - 0.20F * std::min(1.0F, folds) * smooth(0.35F, -0.25F, height));
}

/// Head: a darker bridge of the nose, pale rings about the eyes, a pale chin, and the nose.
glm::vec3 face_colour(const AnimalFrame& frame, glm::vec3 colour, float along, float height) {
  const AnimalBuild& b = frame.build;
  const float face = smooth(2.1F, 2.25F, along);
  colour = glm::mix(colour, frame.dark, 0.30F * face * smooth(0.55F, 0.95F, height) * (1 - smooth(2.7F, 2.9F, along)));
  const float ring =
      smooth(2.16F, 2.28F, along) * (1 - smooth(2.32F, 2.46F, along)) * (1 - smooth(0.15F, 0.45F, std::abs(height - 0.5F)));
  colour = glm::mix(colour, frame.pale, b.eye_rings * ring);
  colour = glm::mix(colour, frame.pale, b.pale_chin * face * smooth(-0.25F, -0.8F, height));
  colour = glm::mix(colour, frame.dark, b.dark_face * smooth(2.2F, 2.5F, along) * smooth(-0.3F, 0.5F, height));
  colour = glm::mix(colour, frame.pale, b.pale_muzzle * smooth(2.45F, 2.8F, along) * smooth(0.75F, 0.1F, height));
  return glm::mix(colour, glm::vec3(0.10F, 0.085F, 0.08F),
                  b.dark_muzzle * smooth(2.86F, 2.97F, along) * smooth(-0.8F, -0.2F, height));
}

/// Sections carry in `colour.x` where along the animal they are: 0 rump .. 1 chest, 2 neck's end, 3 nose.
glm::vec3 body_colour(const void* paint, const BodySection& section, float height) {
  const auto& frame = *static_cast<const AnimalFrame*>(paint);
  const AnimalBuild& b = frame.build;
  const float along = section.colour.x;
  const float on_head = smooth(1.95F, 2.15F, along);
  glm::vec3 colour = trunk_colour(frame, along, height);
  colour = glm::mix(
      colour, frame.dark,
      b.dorsal_stripe * smooth(0.85F - 0.6F * std::max(0.0F, b.dorsal_stripe - 0.6F), 0.99F, height) * (1 - 0.5F * on_head));
  colour =
      glm::mix(colour, frame.pale, b.pale_rump * (1 - smooth(0.03F, 0.12F, along)) * (1 - 0.5F * smooth(0.85F, 1.0F, height)));
  return face_colour(frame, colour, along, height);
}

/// The neck's line: where it leaves the trunk and where it ends (shoulder heights).
struct NeckLine {
  glm::vec2 root;
  glm::vec2 end;
  glm::vec2 direction;
};
NeckLine neck_line(const AnimalBuild& b) {
  NeckLine line;
  const float top = 1 + b.hump * 0.45F;
  line.root = {0.50F * b.trunk, top - 0.02F - b.neck_base};
  const float angle = radians(b.neck_angle);
  line.direction = {std::cos(angle), std::sin(angle)};
  line.end = line.root + line.direction * (b.neck_length + 0.6F * b.neck_base);
  return line;
}

std::vector<BodySection> trunk_sections(const AnimalFrame& f) {
  const AnimalBuild& b = f.build;
  const float t = b.trunk;
  std::vector<BodySection> list;
  const auto put = [&](float along, float top_x, float top_z, float bottom_x, float bottom_z, float width, float neck) {
    list.push_back(
        {f.at(top_x * t, 0, top_z), f.at(bottom_x * t, 0, bottom_z), width * f.height, {0, neck, 0, 0}, glm::vec3(along, 0, 0)});
  };
  const float depth = 1 - b.chest;
  put(0.00F, -0.515F, b.rump - 0.30F * (b.rump - b.groin), -0.525F, b.groin + 0.38F * (b.rump - b.groin), 0.30F * b.rump_width,
      0);
  put(0.04F, -0.50F, b.rump - 0.14F * (b.rump - b.groin), -0.50F, b.groin + 0.16F * (b.rump - b.groin), 0.70F * b.rump_width, 0);
  put(0.10F, -0.445F, b.rump - 0.03F, -0.44F, b.groin + 0.02F, 0.95F * b.rump_width, 0);
  put(0.20F, -0.35F, b.rump, -0.33F, b.groin, 1.02F * b.rump_width, 0);
  put(0.33F, -0.20F, 0.5F * (b.rump + b.back), -0.18F, glm::mix(b.groin, b.belly, 0.5F), 0.93F * b.belly_width, 0);
  put(0.48F, 0.0F, b.back, 0.0F, b.belly, b.belly_width, 0);
  put(0.62F, 0.17F, b.back + 0.45F * (1 - b.back) + 0.55F * b.hump, 0.17F, glm::mix(b.belly, b.chest, 0.6F),
      glm::mix(b.belly_width, b.shoulder_width, 0.45F), 0);
  put(0.76F, 0.32F, 1.0F + b.hump, 0.32F, b.chest, b.shoulder_width, 0.0F);
  put(0.88F, 0.42F, 0.995F + 0.85F * b.hump, 0.44F, b.chest + 0.06F * depth, 0.92F * b.shoulder_width, 0.06F);
  return list;
}

void append_neck(const AnimalFrame& f, std::vector<BodySection>& list) {
  const AnimalBuild& b = f.build;
  const NeckLine line = neck_line(b);
  const glm::vec2 across{-line.direction.y, line.direction.x};
  constexpr std::array<float, 6> shares{0.10F, 0.28F, 0.46F, 0.64F, 0.82F, 1.0F};
  const auto& last = list.back();
  const glm::vec2 trunk_across = glm::normalize(glm::vec2(last.top.x - last.bottom.x, last.top.z - last.bottom.z));
  for (const float share : shares) {
    const float eased = std::pow(share, 0.6F);
    // The section's plane turns from the trunk's to the neck's.
    const glm::vec2 plane = glm::normalize(glm::mix(trunk_across, across, smooth(-0.1F, 0.55F, share)));
    const glm::vec2 middle = line.root + (line.end - line.root) * share;
    const float half = glm::mix(b.neck_base * 1.18F, b.neck_top, eased);
    const float width = glm::mix(b.neck_width * 1.25F, b.neck_top_width, eased);
    const float mane = b.mane * smooth(0.0F, 0.4F, share);
    const float throat = b.throat_mane * std::sin(std::numbers::pi_v<float> * std::clamp(0.25F + 0.6F * share, 0.0F, 1.0F));
    const glm::vec2 top = middle + plane * (half + mane * 0.35F);
    const glm::vec2 bottom = middle - plane * (half + throat);
    list.push_back({f.at(top.x, 0, top.y),
                    f.at(bottom.x, 0, bottom.y),
                    width * f.height,
                    {0, smooth(-0.05F, 0.75F, share), 0, 0},
                    glm::vec3(1.0F + share * 0.95F, 0, 0)});
  }
}

void append_head(const AnimalFrame& f, std::vector<BodySection>& list) {
  const AnimalBuild& b = f.build;
  struct Station {
    float along;
    float top;  ///< of the depth at the cheeks, above the nose's line
    float bottom;
    float width;
    float head;  ///< share of the head's turn
  };
  const float muzzle = b.muzzle_depth / b.head_depth;
  const float narrow = b.muzzle_width / b.head_width;
  const std::array<Station, 8> stations{
      {{0.02F, 0.86F, -0.95F, 0.86F, 0.45F},
       {0.14F, 1.02F, -1.06F, 1.0F, 0.85F},
       {0.28F, 1.0F, -0.98F, 1.0F, 1},
       {0.44F, 0.80F, -0.72F, glm::mix(1.0F, narrow, 0.5F), 1},
       {0.64F, glm::mix(0.6F, muzzle, 0.6F), -glm::mix(0.55F, muzzle, 0.6F), glm::mix(1.0F, narrow, 0.85F), 1},
       {0.84F, 0.92F * muzzle, -0.98F * muzzle, narrow, 1},
       {0.96F, 0.70F * muzzle, -0.85F * muzzle, 0.92F * narrow, 1},
       {1.0F, 0.35F * muzzle, -0.5F * muzzle, 0.55F * narrow, 1}}};
  for (const Station& s : stations) {
    const float ahead = s.along * b.head_length;
    list.push_back({f.on_head(ahead, 0, s.top * b.head_depth),
                    f.on_head(ahead, 0, s.bottom * b.head_depth),
                    s.width * b.head_width * f.height,
                    {0, 1, s.head, 0},
                    glm::vec3(2.0F + s.along, 0, 0)});
  }
}

/// Crest of a mane or of bristles along the neck.
void add_mane(AnimalMeshBuilder& builder, const AnimalFrame& f) {
  const AnimalBuild& b = f.build;
  if (b.mane <= 0) return;
  const glm::vec3 hair = f.dark * 0.45F;
  const NeckLine line = neck_line(b);
  const glm::vec2 across{-line.direction.y, line.direction.x};
  std::vector<BodySection> sections;
  for (int i = 0; i <= 5; ++i) {
    const float share = float(i) / 5;
    const glm::vec2 middle = line.root + (line.end - line.root) * share;
    const float half = glm::mix(b.neck_base * 1.1F, b.neck_top, std::pow(share, 0.75F));
    const float rise = b.mane * (0.35F + 0.65F * std::sin(std::numbers::pi_v<float> * (0.15F + 0.7F * share)));
    const glm::vec2 low = middle + across * (half * 0.82F);
    const glm::vec2 high = middle + across * (half + rise);
    sections.push_back(
        {f.at(high.x, 0, high.y), f.at(low.x, 0, low.y), 0.020F * f.height, {0, smooth(-0.05F, 0.75F, share), 0, 0}, hair});
  }
  const glm::vec3 forelock = f.on_head(0.16F * b.head_length, 0, b.head_depth * 1.12F);
  sections.push_back({forelock, f.on_head(0.10F * b.head_length, 0, b.head_depth * 0.9F), 0.02F * f.height, {0, 1, 1, 0}, hair});
  builder.loft(sections, builder.sides(6));
}

void add_beard(AnimalMeshBuilder& builder, const AnimalFrame& f) {
  const AnimalBuild& b = f.build;
  if (b.beard <= 0) return;
  const glm::vec3 chin = f.on_head(0.52F * b.head_length, 0, -0.45F * b.head_depth);
  const glm::vec3 tip = chin + glm::vec3(-0.25F * b.beard, 0, -b.beard) * f.height;
  const glm::vec4 rig{0, 1, 1, 0};
  const float thick = (0.16F * b.beard + 0.015F) * f.height;
  const std::array<AnimalMeshBuilder::Joint, 3> joints{{{chin, 1.2F * thick, f.dark, rig, 1.6F},
                                                        {glm::mix(chin, tip, 0.5F), thick, f.dark, rig, 1.4F},
                                                        {tip, 0.2F * thick, f.dark, rig}}};
  builder.limb(joints, builder.sides(6));
}

}  // namespace

AnimalFrame animal_frame(const AnimalShape& shape, const AnimalBuild& build) {
  AnimalFrame f;
  f.build = build;
  f.height = std::max(0.05F, shape.shoulder_height);
  // The given length is of head and body together.
  const float natural = build.trunk + 0.85F * build.head_length + 0.75F * build.neck_length;
  f.stretch = std::clamp(shape.body_length / (natural * f.height), 0.88F, 1.14F);
  // A coat in daylight is duller than its colour on a chart.
  const auto dull = [](glm::vec3 colour) {
    return glm::mix(colour, glm::vec3(glm::dot(colour, glm::vec3(0.3F, 0.55F, 0.15F))), 0.08F);
  };
  f.coat = dull({shape.coat_colour[0], shape.coat_colour[1], shape.coat_colour[2]});
  f.belly = {shape.belly_colour[0], shape.belly_colour[1], shape.belly_colour[2]};
  f.dark = f.coat * 0.55F;
  f.pale = glm::mix(f.belly, glm::vec3(0.93F, 0.91F, 0.86F), 0.5F);
  const NeckLine line = neck_line(build);
  const float angle = radians(build.head_angle);
  f.forward = {std::cos(angle), 0, -std::sin(angle)};
  f.up = {std::sin(angle), 0, std::cos(angle)};
  f.poll = f.at(line.end.x, 0, line.end.y) + f.up * (0.15F * build.head_depth * f.height);
  return f;
}

void add_body(AnimalMeshBuilder& builder, const AnimalFrame& frame) {
  std::vector<BodySection> sections = trunk_sections(frame);
  append_neck(frame, sections);
  append_head(frame, sections);
  // Less detail leaves sections out, but never those that make the outline.
  std::vector<BodySection> kept;
  if (builder.detail() == AnimalDetail::fine) {
    kept = std::move(sections);
  } else if (builder.detail() == AnimalDetail::plain) {
    for (const std::size_t i : {0UL, 1UL, 3UL, 5UL, 7UL, 9UL, 11UL, 14UL, 16UL, 18UL, 20UL, 22UL}) kept.push_back(sections[i]);
  } else {
    for (const std::size_t i : {1UL, 3UL, 7UL, 10UL, 14UL, 17UL, 21UL}) kept.push_back(sections[i]);
  }
  builder.loft(kept, builder.sides(12), body_colour, &frame);
  if (builder.detail() == AnimalDetail::silhouette) return;
  add_mane(builder, frame);
  add_beard(builder, frame);
}

}  // namespace biotope

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>
#include <numbers>

#include "render/animal_body.hpp"

namespace biotope {

namespace {

using Joint = AnimalMeshBuilder::Joint;

constexpr glm::vec3 bone{0.50F, 0.42F, 0.32F};
constexpr glm::vec3 tips{0.72F, 0.66F, 0.55F};
constexpr glm::vec3 horn{0.27F, 0.23F, 0.18F};
constexpr glm::vec3 black_horn{0.13F, 0.12F, 0.11F};
constexpr glm::vec4 rig{7, 1, 1, 0};

/// Points of a head of unit headgear, on one side: back from the brow, outward, and up.
class Side {
 public:
  Side(AnimalMeshBuilder& builder, const AnimalFrame& frame, float side, float out, float ahead)
      : builder_(builder), frame_(frame), side_(side), out_(out), ahead_(ahead) {}

  [[nodiscard]] glm::vec3 at(float back, float out, float up) const {
    const float size = frame_.build.headgear_size * frame_.height;
    // Headgear grows up from the head, not along its nose: axes between the head's and the world's.
    const glm::vec3 above = glm::normalize(frame_.up + glm::vec3(0, 0, 0.8F));
    const glm::vec3 behind = glm::normalize(-glm::vec3(above.z, 0, -above.x));
    return frame_.on_head(ahead_, 0, 0.82F * frame_.build.head_depth) + glm::vec3(0, side_ * out_ * frame_.height, 0) +
           (behind * back + glm::vec3(0, side_ * out, 0) + above * up) * size;
  }
  /// A beam through points (back, out, up), tapering from `first` to `last` of the size. A silhouette has the first two, stout
  /// and of few pieces, so that from afar one still sees what it is.
  void beam(const std::vector<glm::vec3>& points, float first, float last, glm::vec3 base, glm::vec3 tip, int corners = 5,
            float stretch = 1) {
    const bool silhouette = builder_.detail() == AnimalDetail::silhouette;
    if (silhouette && beams_ >= 2) return;
    ++beams_;
    const std::size_t step = fine() ? 1 : !silhouette ? 2 : std::max<std::size_t>(1, (points.size() - 1) / (beams_ == 1 ? 2 : 1));
    const float stout = silhouette ? 1.6F : 1.0F;
    std::vector<Joint> joints;
    for (std::size_t i = 0; i < points.size(); ++i) {
      if (i % step != 0 && i + 1 != points.size()) continue;
      // No short last piece where the steps do not come out even.
      if (silhouette && i + 1 != points.size() && i + step / 2 + 1 > points.size() - 1 && i > 0) continue;
      const float t = float(i) / float(points.size() - 1);
      const float radius = stout * glm::mix(first, last, t) * frame_.build.headgear_size * frame_.height;
      joints.push_back({at(points[i].x, points[i].y, points[i].z), radius, glm::mix(base, tip, t * t), rig, stretch});
    }
    builder_.limb(joints, builder_.sides(corners));
  }
  [[nodiscard]] bool fine() const { return builder_.detail() == AnimalDetail::fine; }

 private:
  AnimalMeshBuilder& builder_;
  const AnimalFrame& frame_;
  float side_;
  float out_;
  float ahead_;
  int beams_ = 0;
};

void red_antlers(Side& s) {
  s.beam({{0, 0, -0.05F},
          {0.10F, 0.14F, 0.16F},
          {0.24F, 0.32F, 0.38F},
          {0.32F, 0.44F, 0.62F},
          {0.30F, 0.47F, 0.84F},
          {0.20F, 0.44F, 1.04F}},
         0.046F, 0.016F, bone, tips);
  s.beam({{0.01F, 0.03F, 0.02F}, {-0.16F, 0.10F, 0.06F}, {-0.28F, 0.15F, 0.22F}}, 0.034F, 0.008F, bone, tips, 4);
  s.beam({{0.20F, 0.28F, 0.32F}, {0.04F, 0.40F, 0.40F}, {-0.05F, 0.44F, 0.55F}}, 0.03F, 0.008F, bone, tips, 4);
  s.beam({{0.30F, 0.46F, 0.78F}, {0.16F, 0.60F, 0.90F}, {0.10F, 0.66F, 1.04F}}, 0.028F, 0.008F, bone, tips, 4);
  s.beam({{0.29F, 0.47F, 0.84F}, {0.42F, 0.48F, 0.98F}, {0.42F, 0.46F, 1.12F}}, 0.026F, 0.008F, bone, tips, 4);
  if (s.fine()) s.beam({{0.06F, 0.08F, 0.09F}, {-0.08F, 0.20F, 0.16F}, {-0.16F, 0.26F, 0.30F}}, 0.026F, 0.008F, bone, tips, 4);
}

void palmate_antlers(Side& s) {
  s.beam({{0, 0, -0.05F}, {0.12F, 0.16F, 0.18F}, {0.26F, 0.36F, 0.38F}, {0.37F, 0.47F, 0.58F}}, 0.045F, 0.03F, bone, bone);
  // The shovel: flat, turned a little outward, with points along its back.
  s.beam({{0.33F, 0.43F, 0.48F}, {0.42F, 0.52F, 0.66F}, {0.44F, 0.58F, 0.86F}, {0.36F, 0.58F, 1.04F}, {0.26F, 0.56F, 1.14F}},
         0.020F, 0.010F, bone, tips, 6, 6.0F);
  s.beam({{0.40F, 0.53F, 0.70F}, {0.50F, 0.55F, 0.86F}, {0.50F, 0.58F, 1.02F}}, 0.018F, 0.012F, bone, tips, 5, 4.0F);
  s.beam({{0.01F, 0.03F, 0.02F}, {-0.14F, 0.08F, 0.06F}, {-0.24F, 0.12F, 0.2F}}, 0.032F, 0.008F, bone, tips, 4);
  s.beam({{0.24F, 0.34F, 0.36F}, {0.08F, 0.46F, 0.44F}, {0.02F, 0.5F, 0.58F}}, 0.028F, 0.008F, bone, tips, 4);
  if (!s.fine()) return;
  s.beam({{0.46F, 0.56F, 0.78F}, {0.60F, 0.56F, 0.84F}}, 0.026F, 0.008F, bone, tips, 4);
  s.beam({{0.46F, 0.58F, 0.94F}, {0.58F, 0.60F, 1.04F}}, 0.026F, 0.008F, bone, tips, 4);
  s.beam({{0.38F, 0.58F, 1.04F}, {0.46F, 0.62F, 1.18F}}, 0.024F, 0.008F, bone, tips, 4);
}

void caribou_antlers(Side& s) {
  // A long bow back and up, then forward, with a hand at its end and shovels over the brow.
  s.beam({{0, 0, -0.04F},
          {0.20F, 0.12F, 0.14F},
          {0.42F, 0.28F, 0.34F},
          {0.52F, 0.40F, 0.60F},
          {0.44F, 0.44F, 0.84F},
          {0.26F, 0.40F, 1.02F}},
         0.036F, 0.018F, bone, bone);
  s.beam({{0.40F, 0.44F, 0.88F}, {0.36F, 0.50F, 1.06F}}, 0.024F, 0.008F, bone, tips, 4);
  s.beam({{0.28F, 0.41F, 1.0F}, {0.12F, 0.46F, 1.12F}}, 0.024F, 0.008F, bone, tips, 4);
  s.beam({{0.27F, 0.40F, 1.0F}, {0.10F, 0.34F, 1.0F}}, 0.022F, 0.008F, bone, tips, 4);
  s.beam({{0.02F, 0.02F, 0.0F}, {-0.14F, 0.03F, 0.10F}, {-0.26F, 0.02F, 0.24F}}, 0.026F, 0.016F, bone, tips, 4, 1.9F);
  s.beam({{0.12F, 0.08F, 0.08F}, {-0.04F, 0.20F, 0.22F}, {-0.12F, 0.24F, 0.38F}}, 0.026F, 0.012F, bone, tips, 4);
  if (s.fine()) s.beam({{0.51F, 0.39F, 0.56F}, {0.64F, 0.42F, 0.62F}}, 0.02F, 0.007F, bone, tips, 4);
}

void forked_antlers(Side& s) {
  s.beam({{0, 0, -0.04F}, {0.10F, 0.16F, 0.16F}, {0.18F, 0.32F, 0.36F}}, 0.042F, 0.034F, bone, bone);
  s.beam({{0.17F, 0.31F, 0.34F}, {0.06F, 0.40F, 0.58F}, {-0.06F, 0.40F, 0.80F}}, 0.034F, 0.008F, bone, tips);
  s.beam({{0.17F, 0.31F, 0.34F}, {0.30F, 0.46F, 0.52F}, {0.26F, 0.50F, 0.76F}}, 0.034F, 0.008F, bone, tips);
  s.beam({{0.08F, 0.40F, 0.54F}, {0.16F, 0.50F, 0.70F}}, 0.024F, 0.008F, bone, tips, 4);
}

void bison_horns(Side& s) {
  s.beam({{0, -0.1F, -0.12F}, {0.0F, 0.30F, -0.10F}, {0.0F, 0.62F, 0.10F}, {0.02F, 0.70F, 0.46F}, {0.06F, 0.56F, 0.78F}}, 0.19F,
         0.02F, black_horn * 1.4F, black_horn, 6);
}

void ibex_horns(Side& s) {
  // Scimitars: up, back and down in an even bow.
  std::vector<glm::vec3> points;
  for (int i = 0; i <= 7; ++i) {
    const float angle = 0.3F * float(i);
    points.push_back({0.62F * (1 - std::cos(angle)), 0.02F + 0.028F * float(i), 0.72F * std::sin(angle) - 0.04F});
  }
  s.beam(points, 0.078F, 0.014F, horn, horn * 0.8F, 6, 1.25F);
}

void curled_horns(Side& s) {
  // A snail's turn beside the cheek: up, back, down and forward again, drawn outward.
  std::vector<glm::vec3> points;
  for (int i = 0; i <= 10; ++i) {
    const float angle = 1.0F + 0.5F * float(i);
    const float radius = 0.52F - 0.014F * float(i);
    points.push_back({0.30F - radius * std::cos(angle), 0.12F + 0.07F * float(i), radius * std::sin(angle) - 0.46F});
  }
  s.beam(points, 0.21F, 0.03F, horn * 1.25F, horn, 6);
}

void prong_horns(Side& s) {
  s.beam({{0, 0.03F, -0.06F}, {0.0F, 0.10F, 0.34F}, {0.04F, 0.14F, 0.74F}, {0.20F, 0.10F, 0.98F}, {0.30F, 0.08F, 0.92F}}, 0.085F,
         0.02F, black_horn, black_horn, 5, 1.3F);
  s.beam({{0.02F, 0.12F, 0.46F}, {-0.20F, 0.12F, 0.58F}}, 0.06F, 0.02F, black_horn, black_horn, 4);
}

void nose_horns(AnimalMeshBuilder& builder, const AnimalFrame& f) {
  const AnimalBuild& b = f.build;
  const float h = f.height * b.headgear_size;
  const auto one = [&](float along, float size) {
    const glm::vec3 root = f.on_head(along * b.head_length, 0, 0.5F * b.head_depth);
    const std::array<Joint, 4> joints{{{root, 0.16F * size * h, horn, rig, 1.3F},
                                       {root + (f.up * 0.35F + f.forward * 0.10F) * (size * h), 0.10F * size * h, horn, rig},
                                       {root + (f.up * 0.70F + f.forward * 0.10F) * (size * h), 0.055F * size * h, horn, rig},
                                       {root + (f.up * 1.0F + f.forward * 0.02F) * (size * h), 0.01F * size * h, horn, rig}}};
    builder.limb(joints, builder.sides(6));
  };
  one(0.86F, 1);
  one(0.60F, 0.5F);
}

}  // namespace

void add_headgear(AnimalMeshBuilder& builder, const AnimalFrame& frame) {
  const AnimalBuild& b = frame.build;
  if (b.headgear == Headgear::none) return;
  if (b.headgear == Headgear::nose_horns) return nose_horns(builder, frame);
  for (const float side : {-1.0F, 1.0F}) {
    const bool wide = b.headgear == Headgear::bison_horns;
    Side s(builder, frame, side, (wide ? 0.85F : 0.42F) * b.head_width, (wide ? 0.10F : 0.16F) * b.head_length);
    switch (b.headgear) {
      case Headgear::red_antlers:
        red_antlers(s);
        break;
      case Headgear::palmate_antlers:
        palmate_antlers(s);
        break;
      case Headgear::caribou_antlers:
        caribou_antlers(s);
        break;
      case Headgear::forked_antlers:
        forked_antlers(s);
        break;
      case Headgear::bison_horns:
        bison_horns(s);
        break;
      case Headgear::ibex_horns:
        ibex_horns(s);
        break;
      case Headgear::curled_horns:
        curled_horns(s);
        break;
      case Headgear::prong_horns:
        prong_horns(s);
        break;
      case Headgear::none:
      case Headgear::nose_horns:
        break;
    }
  }
}

}  // namespace biotope

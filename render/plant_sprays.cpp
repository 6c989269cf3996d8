#include <array>

#include "render/plant_leaf_canvas.hpp"

namespace biotope {

namespace {

constexpr Ink twig{0.78F, 0, 1};

/// How the leaves of a spray look.
struct SprayHabit {
  LeafForm form;
  float length = 0.15F;   ///< of a leaf / side of the card
  float slender = 0.28F;  ///< half width / length
  int leaves = 7;         ///< on each side twig
  int twigs = 4;          ///< on each side
  float hang = 0;         ///< 0 leaves spread from their twig .. 1 hang
};

void spray_leaf(LeafCanvas& canvas, const SprayHabit& habit, const glm::vec2& at, float heading, float low, float high) {
  const float own = heading * (1 - habit.hang) + habit.hang * glm::pi<float>() * (heading > 0 ? 0.85F : -0.85F);
  const glm::vec2 along(std::sin(own), std::cos(own));
  const glm::vec2 foot = at + along * 0.12F * habit.length;
  const float length = habit.length * canvas.between(0.72F, 1.12F);
  canvas.stroke(at, foot, 0.0028F, 0.0022F, {0.9F, 0.4F, 0});
  const Ink ink{canvas.between(low, high), canvas.unit(), 0};
  canvas.leaf(foot, foot + along * length, length * habit.slender * canvas.between(0.85F, 1.1F), ink, habit.form);
}

/// A shoot with side twigs; leaves alternate along them. Those behind come first and are darker.
Grid<Rgba> spray(const SprayHabit& habit, std::uint64_t what) {
  LeafCanvas canvas(what);
  struct Twig {
    glm::vec2 from;
    glm::vec2 to;
  };
  std::vector<Twig> twigs{{{0.5F, 0}, {0.5F, 0.80F}}};
  for (int i = 0; i < habit.twigs; ++i) {
    for (const float side : {-1.0F, 1.0F}) {
      const float t = (float(i) + canvas.between(0.25F, 0.75F)) / float(habit.twigs);
      const glm::vec2 from(0.5F, 0.10F + 0.62F * t);
      const float turn = side * canvas.between(0.75F, 1.15F);
      const float length = (0.44F - 0.20F * t) * canvas.between(0.8F, 1.05F);
      twigs.push_back({from, from + length * glm::vec2(std::sin(turn), std::cos(turn))});
    }
  }
  const auto leaves = [&](float share, float low, float high) {
    for (const Twig& one : twigs) {
      const glm::vec2 along = one.to - one.from;
      const float heading = std::atan2(along.x, along.y);
      for (int i = 0; i < habit.leaves; ++i) {
        if (canvas.unit() > share) continue;
        const float t = (float(i) + canvas.between(0.3F, 0.9F)) / float(habit.leaves);
        const float side = i % 2 == 0 ? 1.0F : -1.0F;
        spray_leaf(canvas, habit, one.from + along * t, heading + side * canvas.between(0.4F, 1.25F), low, high);
      }
      spray_leaf(canvas, habit, one.to, heading + canvas.between(-0.3F, 0.3F), low, high);
    }
  };
  leaves(0.8F, 0.46F, 0.68F);
  for (const Twig& one : twigs) canvas.stroke(one.from, one.to, 0.0062F, 0.003F, twig);
  leaves(1.0F, 0.76F, 1.18F);
  return canvas.take();
}

}  // namespace

Grid<Rgba> oak_spray() { return spray({{0.62F, 0.55F, 4.0F, 0.42F}, 0.185F, 0.33F, 6, 4, 0}, 21); }
Grid<Rgba> oval_spray() { return spray({{0.46F, 1.05F, 13, 0.05F}, 0.155F, 0.29F, 7, 4, 0}, 22); }
Grid<Rgba> round_spray() { return spray({{0.55F, 0.50F, 9, 0.05F}, 0.150F, 0.42F, 6, 4, 0}, 23); }
Grid<Rgba> birch_spray() { return spray({{0.30F, 1.25F, 9, 0.10F}, 0.105F, 0.40F, 8, 4, 0.45F}, 24); }
Grid<Rgba> leathery_spray() { return spray({{0.48F, 0.9F, 0, 0}, 0.095F, 0.26F, 9, 5, 0}, 25); }

Grid<Rgba> pine_spray() {
  LeafCanvas canvas(26);
  constexpr std::array<glm::vec2, 6> ends{
      {{0.5F, 0.60F}, {0.24F, 0.50F}, {0.76F, 0.48F}, {0.36F, 0.74F}, {0.66F, 0.76F}, {0.5F, 0.34F}}};
  for (const glm::vec2& end : ends) {
    const glm::vec2 foot(0.5F, 0.5F * end.y - 0.12F);
    canvas.stroke(foot, end, 0.010F, 0.007F, {0.7F, 0, 1});
    const glm::vec2 way = glm::normalize(end - foot);
    const float heading = std::atan2(way.x, way.y);
    // Needles stand in pairs along the last third of the shoot and out of its end.
    constexpr int needles = 44;
    for (int needle = 0; needle < needles; ++needle) {
      const float t = std::sqrt(canvas.unit());
      const glm::vec2 at = glm::mix(foot, end, 0.45F + 0.55F * t);
      const float turn = heading + canvas.between(-1.35F, 1.35F) * (1.15F - 0.6F * t);
      const float length = canvas.between(0.12F, 0.19F);
      const float light = canvas.between(0.55F, 0.8F) + 0.45F * float(needle) / needles;
      canvas.stroke(at, at + length * glm::vec2(std::sin(turn), std::cos(turn)), 0.0050F, 0.0022F, {light, canvas.unit(), 0});
    }
  }
  return canvas.take();
}

Grid<Rgba> scale_spray() {
  LeafCanvas canvas(27);
  // Cords of scales that fork again and again.
  const auto cord = [&](const glm::vec2& from, float heading, float length, float shade) {
    const glm::vec2 way(std::sin(heading), std::cos(heading));
    const int scales = 3 + int(length / 0.018F);
    for (int i = 0; i < scales; ++i) {
      const glm::vec2 at = from + way * length * (float(i) / float(scales));
      const float side = i % 2 == 0 ? 0.7F : -0.7F;
      const glm::vec2 out(std::sin(heading + side), std::cos(heading + side));
      canvas.leaf(at, at + 0.038F * out, 0.010F, {shade * canvas.between(0.75F, 1.2F), canvas.unit(), 0});
    }
  };
  for (int i = 0; i < 17; ++i) {
    const float t = (float(i) + 0.5F) / 17;
    const float side = i % 2 == 0 ? 1.0F : -1.0F;
    const glm::vec2 from(0.5F, 0.84F * t);
    const float heading = side * canvas.between(0.35F, 0.85F);
    const float length = (0.46F - 0.26F * t) * canvas.between(0.8F, 1.1F);
    cord(from, heading, length, canvas.between(0.6F, 0.95F));
    for (int k = 1; k < 6; ++k) {
      const glm::vec2 at = from + length * float(k) / 6 * glm::vec2(std::sin(heading), std::cos(heading));
      for (const float lean : {-0.6F, 0.6F})
        cord(at, heading + lean, length * canvas.between(0.22F, 0.42F), canvas.between(0.7F, 1.15F));
    }
  }
  cord({0.5F, 0.1F}, 0, 0.88F, 1);
  return canvas.take();
}

Grid<Rgba> fern_frond() {
  LeafCanvas canvas(28);
  canvas.stroke({0.5F, 0}, {0.5F, 0.97F}, 0.010F, 0.003F, {0.75F, 0.5F, 0});
  constexpr int pinnae = 13;
  for (int i = 0; i < pinnae; ++i) {
    const float t = (float(i) + 0.5F) / pinnae;
    const float length = 0.47F * std::min(1.0F, 0.55F + 2.2F * t) * std::pow(1 - t, 0.75F) + 0.02F;
    for (const float side : {-1.0F, 1.0F}) {
      const glm::vec2 from(0.5F, 0.16F + 0.81F * t);
      const glm::vec2 way = glm::normalize(glm::vec2(side, 0.42F + 0.5F * t));
      const float shade = canvas.between(0.78F, 1.1F);
      const int leaflets = 4 + int(length / 0.032F);
      for (int k = 0; k < leaflets; ++k) {
        const float along = float(k) / float(leaflets);
        const glm::vec2 at = from + way * length * along;
        const float reach = 0.052F * (1.12F - along) * (0.35F + 0.9F * length);
        for (const float lean : {-1.0F, 1.0F}) {
          const glm::vec2 out = glm::normalize(way * 0.5F + lean * glm::vec2(-way.y, way.x));
          canvas.leaf(at, at + reach * out, 0.0115F, {shade * canvas.between(0.88F, 1.1F), canvas.unit(), 0});
        }
      }
    }
  }
  return canvas.take();
}

Grid<Rgba> shade_leaves() {
  LeafCanvas canvas(29);
  for (int i = 0; i < 34; ++i) {
    const float turn = glm::radians(137.5F) * float(i);
    const float away = 0.40F * std::sqrt(1 - (float(i) + 0.5F) / 34);
    const glm::vec2 at = glm::vec2(0.5F) + away * 0.45F * glm::vec2(std::cos(turn), std::sin(turn));
    const glm::vec2 tip = glm::vec2(0.5F) + (away + 0.09F) * glm::vec2(std::cos(turn + 0.2F), std::sin(turn + 0.2F));
    const float shade = 0.62F + 0.5F * float(i) / 34;
    canvas.leaf(at, tip, 0.062F, {shade * canvas.between(0.9F, 1.1F), canvas.unit(), 0}, {0.5F, 0.85F, 8, 0.06F});
  }
  return canvas.take();
}

}  // namespace biotope

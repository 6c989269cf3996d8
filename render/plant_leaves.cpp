#include "render/plant_leaves.hpp"

#include <algorithm>
#include <cmath>
#include <glm/glm.hpp>
#include <glm/gtc/constants.hpp>

#include "core/base/random.hpp"

namespace biotope {

namespace {

/// How a stroke is coloured.
struct Ink {
  float shade = 1;
  float flower = 0;
  float wood = 0;
};

/// Draws leaves and stalks on a card; coordinates are 0..1 with the foot at y = 0.
class LeafCanvas {
 public:
  explicit LeafCanvas(std::uint64_t what) : picture_(leaf_picture_side, leaf_picture_side, Rgba{128, 0, 0, 0}), what_(what) {}

  float unit() { return float(random_unit({0x6c656166ULL, what_, drawn_++})); }
  float between(float low, float high) { return low + (high - low) * unit(); }

  /// A leaf: two arcs from stalk to tip, its widest part in the middle, one half a little darker than the other.
  void leaf(const glm::vec2& from, const glm::vec2& to, float half_width, const Ink& ink) {
    const glm::vec2 along = to - from;
    const float length = glm::length(along);
    if (length <= 0) return;
    const glm::vec2 axis = along / length;
    const glm::vec2 side(-axis.y, axis.x);
    stamp(
        glm::min(from, to) - half_width, glm::max(from, to) + half_width,
        [&](const glm::vec2& p) {
          const float t = glm::dot(p - from, axis) / length;
          if (t < 0 || t > 1) return 0.0F;
          const float across = glm::dot(p - from, side);
          return std::abs(across) < half_width * std::sin(glm::pi<float>() * std::pow(t, 0.8F)) ? (across > 0 ? 1.0F : 0.84F)
                                                                                                : 0.0F;
        },
        ink);
  }

  /// A tapering stroke.
  void stroke(const glm::vec2& from, const glm::vec2& to, float half_from, float half_to, const Ink& ink) {
    const glm::vec2 along = to - from;
    const float length = glm::length(along);
    if (length <= 0) return;
    const glm::vec2 axis = along / length;
    stamp(
        glm::min(from, to) - half_from, glm::max(from, to) + half_from,
        [&](const glm::vec2& p) {
          const float t = glm::dot(p - from, axis) / length;
          if (t < 0 || t > 1) return 0.0F;
          return std::abs(axis.x * (p.y - from.y) - axis.y * (p.x - from.x)) < glm::mix(half_from, half_to, t) ? 1.0F : 0.0F;
        },
        ink);
  }

  void dot(const glm::vec2& centre, float radius, const Ink& ink) {
    stamp(
        centre - radius, centre + radius, [&](const glm::vec2& p) { return glm::distance(p, centre) < radius ? 1.0F : 0.0F; },
        ink);
  }

  [[nodiscard]] Grid<Rgba> take() { return std::move(picture_); }

 private:
  template <class Shape>
  void stamp(const glm::vec2& low, const glm::vec2& high, const Shape& shape, const Ink& ink) {
    const auto texel = [](float v) { return std::clamp(int(v * leaf_picture_side), 0, leaf_picture_side - 1); };
    for (int y = texel(low.y); y <= texel(high.y); ++y) {
      for (int x = texel(low.x); x <= texel(high.x); ++x) {
        const float inside = shape((glm::vec2(x, y) + 0.5F) / float(leaf_picture_side));
        if (inside <= 0) continue;
        const auto code = [](float v) { return std::uint8_t(std::lround(std::clamp(v, 0.0F, 1.0F) * 255)); };
        picture_(x, y) = {code(0.5F * ink.shade * inside), code(ink.flower), code(ink.wood), 255};
      }
    }
  }

  Grid<Rgba> picture_;
  std::uint64_t what_;
  std::uint64_t drawn_ = 0;
};

constexpr Ink twig{0.8F, 0, 1};

/// Leaves around the ends of twigs, with gaps between the twigs so that the cluster stays ragged from afar. Those behind first
/// and darker. `leaf_length` of the card's side.
Grid<Rgba> cluster(int twigs, int leaves, float leaf_length, float slender, std::uint64_t what) {
  LeafCanvas canvas(what);
  std::vector<glm::vec2> ends;
  for (int i = 0; i < twigs; ++i) {
    const float turn = glm::radians(137.5F) * float(i) + canvas.between(-0.3F, 0.3F);
    const float away = 0.36F * std::sqrt((float(i) + 0.6F) / float(twigs)) * canvas.between(0.85F, 1.1F);
    ends.push_back(glm::vec2(0.5F) + away * glm::vec2(std::cos(turn), std::sin(turn)));
    canvas.stroke({0.5F, 0.5F}, ends.back(), 0.012F, 0.006F, twig);
  }
  for (int i = 0; i < leaves; ++i) {
    const float back = float(i) / float(leaves);
    const glm::vec2& end = ends[std::size_t(i) % ends.size()];
    const float turn = canvas.between(0, glm::two_pi<float>());
    const glm::vec2 at = end + 0.105F * std::sqrt(canvas.unit()) * glm::vec2(std::cos(turn), std::sin(turn));
    const float lean = turn + canvas.between(-0.9F, 0.9F);
    const glm::vec2 along = leaf_length * canvas.between(0.7F, 1.15F) * glm::vec2(std::cos(lean), std::sin(lean));
    canvas.leaf(at - 0.3F * along, at + 0.7F * along, glm::length(along) * slender,
                {0.52F + 0.5F * back + canvas.between(-0.12F, 0.2F), 0, 0});
  }
  return canvas.take();
}

/// Tufts of long needles around twigs.
Grid<Rgba> needle_tufts() {
  LeafCanvas canvas(3);
  constexpr int tufts = 24;
  for (int tuft = 0; tuft < tufts; ++tuft) {
    const float turn = glm::radians(137.5F) * float(tuft);
    const float away = 0.34F * std::sqrt((float(tuft) + 0.5F) / tufts);
    const glm::vec2 at = glm::vec2(0.5F) + 1.1F * away * glm::vec2(std::cos(turn), std::sin(turn));
    const float shade = 0.66F + 0.016F * float(tufts - tuft) + canvas.between(-0.06F, 0.1F);
    for (int needle = 0; needle < 20; ++needle) {
      const float direction = canvas.between(0, glm::two_pi<float>());
      const float length = canvas.between(0.045F, 0.085F);
      canvas.stroke(at, at + length * glm::vec2(std::cos(direction), std::sin(direction)), 0.0075F, 0.0045F,
                    {shade * canvas.between(0.75F, 1.25F), 0, 0});
    }
  }
  return canvas.take();
}

/// A flat bough, foot at y = 0, broad then pointed, twigs slanting to its tip.
Grid<Rgba> bough() {
  LeafCanvas canvas(4);
  canvas.stroke({0.5F, 0}, {0.5F, 0.9F}, 0.016F, 0.006F, twig);
  constexpr int twigs = 15;
  for (int i = 0; i < twigs; ++i) {
    const float t = (float(i) + 0.4F) / twigs;
    for (const float side : {-1.0F, 1.0F}) {
      const glm::vec2 at(0.5F, 0.9F * t);
      const float length =
          (0.46F * std::sin(glm::pi<float>() * std::pow(0.12F + 0.86F * t, 0.7F)) + 0.06F) * canvas.between(0.8F, 1.05F);
      const glm::vec2 along = length * glm::normalize(glm::vec2(side, 0.55F + 0.5F * t));
      const float shade = canvas.between(0.72F, 1.14F);
      canvas.stroke(at, at + along, 0.028F, 0.01F, {shade, 0, 0});
      for (int needle = 0; needle < 9; ++needle) {
        const glm::vec2 foot = at + along * (float(needle) + 0.5F) / 9.0F;
        for (const float lean : {-1.0F, 1.0F}) {
          const glm::vec2 out = glm::normalize(along) + 0.8F * lean * glm::normalize(glm::vec2(-along.y, along.x));
          canvas.stroke(foot, foot + 0.05F * glm::normalize(out), 0.008F, 0.004F, {shade * canvas.between(0.85F, 1.2F), 0, 0});
        }
      }
    }
  }
  for (int needle = 0; needle < 10; ++needle) {
    canvas.stroke({0.5F, 0.86F}, {0.5F + canvas.between(-0.05F, 0.05F), 0.98F}, 0.01F, 0.004F, {1, 0, 0});
  }
  return canvas.take();
}

/// Blades of grass that bend away from the foot.
Grid<Rgba> blades() {
  LeafCanvas canvas(5);
  for (int i = 0; i < 46; ++i) {
    const float foot = canvas.between(0.30F, 0.70F);
    const float lean = canvas.between(-0.34F, 0.34F) + 0.5F * (foot - 0.5F);
    const float height = canvas.between(0.45F, 0.98F) * (1 - 0.5F * std::abs(lean));
    glm::vec2 before(foot, 0);
    const float shade = canvas.between(0.75F, 1.25F);
    constexpr int pieces = 6;
    for (int p = 1; p <= pieces; ++p) {
      const float t = float(p) / pieces;
      const glm::vec2 at(std::clamp(foot + lean * t * t, 0.02F, 0.98F), height * (t - 0.12F * t * t * t));
      canvas.stroke(before, at + (at - before) * 0.15F, 0.013F * (1 - 0.85F * (t - 1.0F / pieces)), 0.013F * (1 - 0.85F * t),
                    {shade * (0.62F + 0.45F * t), 0, 0});
      before = at;
    }
  }
  return canvas.take();
}

/// Leaves from the ground that spread and bend: a herb seen from the side.
Grid<Rgba> rosette() {
  LeafCanvas canvas(6);
  for (int i = 0; i < 26; ++i) {
    const float foot = canvas.between(0.38F, 0.62F);
    const float lean = canvas.between(-0.9F, 0.9F);
    const float length = canvas.between(0.4F, 0.9F);
    const glm::vec2 from(foot + 0.1F * lean, canvas.between(0, 0.22F));
    const glm::vec2 to = from + length * glm::vec2(0.52F * lean, 1 - 0.6F * std::abs(lean));
    const glm::vec2 tip = glm::clamp(to, glm::vec2(0.02F), glm::vec2(0.98F));
    canvas.leaf(from, tip, 0.055F, {canvas.between(0.7F, 1.2F) * (0.7F + 0.4F * tip.y), 0, 0});
  }
  return canvas.take();
}

/// Upright stalks with a few leaves and a flower head each.
Grid<Rgba> flowers() {
  LeafCanvas canvas(7);
  for (int i = 0; i < 6; ++i) {
    const float foot = canvas.between(0.42F, 0.58F);
    const glm::vec2 head(0.5F + canvas.between(-0.36F, 0.36F), canvas.between(0.66F, 0.92F));
    canvas.stroke({foot, 0}, head, 0.011F, 0.008F, {0.85F, 0, 0});
    const glm::vec2 at = glm::mix(glm::vec2(foot, 0), head, 0.55F);
    canvas.leaf(at, at + glm::vec2(canvas.between(-0.14F, 0.14F), 0.1F), 0.018F, {0.95F, 0, 0});
    for (int petal = 0; petal < 8; ++petal) {
      const float turn = canvas.between(0, glm::two_pi<float>());
      const glm::vec2 off = canvas.between(0.005F, 0.04F) * glm::vec2(std::cos(turn), 0.5F * std::sin(turn));
      canvas.dot(head + off, 0.014F, {canvas.between(0.85F, 1.15F), 1, 0});
    }
  }
  return canvas.take();
}

/// What is left of a cluster in winter: a spray of twigs that fork twice.
Grid<Rgba> bare_twigs() {
  LeafCanvas canvas(8);
  for (int i = 0; i < 9; ++i) {
    const float turn = glm::two_pi<float>() * (float(i) + canvas.between(-0.35F, 0.35F)) / 9;
    const glm::vec2 fork = glm::vec2(0.5F) + canvas.between(0.16F, 0.24F) * glm::vec2(std::cos(turn), std::sin(turn));
    canvas.stroke({0.5F, 0.5F}, fork, 0.014F, 0.011F, twig);
    for (const float lean : {-0.8F, -0.3F, 0.15F, 0.7F}) {
      const float end = turn + lean + canvas.between(-0.2F, 0.2F);
      const glm::vec2 tip = fork + canvas.between(0.14F, 0.24F) * glm::vec2(std::cos(end), std::sin(end));
      canvas.stroke(fork, tip, 0.011F, 0.007F, {canvas.between(0.7F, 1.05F), 0, 1});
    }
  }
  return canvas.take();
}

/// Bark: all covered, furrowed along the stem.
Grid<Rgba> bark() {
  Grid<Rgba> picture(leaf_picture_side, leaf_picture_side);
  // Smooth noise on lattices that are much longer than wide.
  const auto furrow = [](float x, float y, std::uint64_t what) {
    const int ix = int(std::floor(x));
    const int iy = int(std::floor(y));
    const auto at = [&](int cx, int cy) { return float(random_unit({what, std::uint64_t(cx), std::uint64_t(cy)})); };
    const float fx = glm::smoothstep(0.0F, 1.0F, x - float(ix));
    const float fy = glm::smoothstep(0.0F, 1.0F, y - float(iy));
    return glm::mix(glm::mix(at(ix, iy), at(ix + 1, iy), fx), glm::mix(at(ix, iy + 1), at(ix + 1, iy + 1), fx), fy);
  };
  for (int y = 0; y < leaf_picture_side; ++y) {
    for (int x = 0; x < leaf_picture_side; ++x) {
      const float value = 0.62F + 0.5F * furrow(float(x) / 4, float(y) / 22, 0x6261726bULL) +
                          0.25F * furrow(float(x) / 2, float(y) / 5, 0x6261726cULL);
      picture(x, y) = {std::uint8_t(std::lround(std::min(255.0F, 128 * value))), 0, 255, 255};
    }
  }
  return picture;
}

}  // namespace

std::vector<Grid<Rgba>> leaf_pictures() {
  std::vector<Grid<Rgba>> pictures(leaf_picture_count);
  pictures[std::size_t(LeafPicture::bark)] = bark();
  pictures[std::size_t(LeafPicture::broad)] = cluster(9, 78, 0.125F, 0.27F, 1);
  pictures[std::size_t(LeafPicture::small)] = cluster(11, 120, 0.085F, 0.30F, 2);
  pictures[std::size_t(LeafPicture::needles)] = needle_tufts();
  pictures[std::size_t(LeafPicture::bough)] = bough();
  pictures[std::size_t(LeafPicture::blades)] = blades();
  pictures[std::size_t(LeafPicture::rosette)] = rosette();
  pictures[std::size_t(LeafPicture::flower)] = flowers();
  pictures[std::size_t(LeafPicture::twigs)] = bare_twigs();
  return pictures;
}

}  // namespace biotope

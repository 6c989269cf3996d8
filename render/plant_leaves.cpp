#include "render/plant_leaves.hpp"

#include <array>

#include "core/base/parallel.hpp"
#include "render/plant_leaf_canvas.hpp"

namespace biotope {

namespace {

constexpr Ink twig{0.8F, 0, 1};

/// A piece of a spray of twigs, and how far from its foot it begins (0..1).
struct Shoot {
  glm::vec2 from;
  glm::vec2 to;
  float half_width;
};

/// A twig that forks into a fan: what carries the leaves of a card, and all that is left of it in winter.
std::vector<Shoot> spray(LeafCanvas& canvas, float spread) {
  std::vector<Shoot> shoots;
  constexpr int pieces = 7;
  glm::vec2 at(0.5F, 0);
  float heading = canvas.between(-0.1F, 0.1F);
  for (int i = 0; i < pieces; ++i) {
    const float t = float(i) / pieces;
    const glm::vec2 next = at + 0.125F * glm::vec2(std::sin(heading), std::cos(heading));
    shoots.push_back({at, next, 0.0075F - 0.004F * t});
    for (const float side : {-1.0F, 1.0F}) {
      if (i == 0) continue;
      const float turn = heading + side * spread * canvas.between(0.75F, 1.2F);
      const float length = (0.42F - 0.27F * t) * canvas.between(0.8F, 1.1F);
      glm::vec2 foot = glm::mix(at, next, canvas.unit());
      float bend = turn;
      for (int piece = 0; piece < 3; ++piece) {
        const glm::vec2 end = foot + length / 3 * glm::vec2(std::sin(bend), std::cos(bend));
        shoots.push_back({foot, end, 0.0042F - 0.0007F * float(piece)});
        for (const float lean : {-0.65F, 0.65F}) {
          const float own = bend + lean * canvas.between(0.7F, 1.3F);
          const float reach = length * canvas.between(0.22F, 0.4F);
          shoots.push_back({end, end + reach * glm::vec2(std::sin(own), std::cos(own)), 0.0026F});
        }
        foot = end;
        bend += canvas.between(-0.25F, 0.25F) - 0.1F * side;
      }
    }
    at = next;
    heading += canvas.between(-0.18F, 0.18F);
  }
  return shoots;
}

/// Leaves along the shoots of a spray; those behind first and darker. `leaf_length` of the card's side.
Grid<Rgba> leafy(int leaves, float leaf_length, float slender, float spread, float hang, std::uint64_t what) {
  LeafCanvas canvas(what);
  const std::vector<Shoot> shoots = spray(canvas, spread);
  const auto draw_leaves = [&](int count, float dark, float light) {
    for (int i = 0; i < count; ++i) {
      const Shoot& shoot = shoots[std::size_t(canvas.unit() * float(shoots.size())) % shoots.size()];
      const glm::vec2 at = glm::mix(shoot.from, shoot.to, 0.3F + 0.7F * canvas.unit());
      const glm::vec2 along = shoot.to - shoot.from;
      const float own = std::atan2(along.x, along.y) * (1 - hang) + canvas.between(-1.25F, 1.25F);
      const glm::vec2 leaf = leaf_length * canvas.between(0.7F, 1.15F) * glm::vec2(std::sin(own), std::cos(own));
      canvas.leaf(at, at + leaf, glm::length(leaf) * slender, {canvas.between(dark, light), canvas.unit(), 0});
    }
  };
  draw_leaves(leaves / 3, 0.42F, 0.66F);
  for (const Shoot& shoot : shoots) {
    if (shoot.half_width > 0.0035F) canvas.stroke(shoot.from, shoot.to, shoot.half_width, shoot.half_width * 0.8F, twig);
  }
  draw_leaves(leaves - leaves / 3, 0.74F, 1.22F);
  return canvas.take();
}

/// Half the width of twigs that are drawn from however far.
constexpr float kept_twig = 0.0039F;

/// What is left of a spray in winter. No twig is thinner than `least` (half its width), and those that are much thinner are left
/// out: from afar lines stay lines where they would be dots.
Grid<Rgba> bare_twigs(float least) {
  LeafCanvas canvas(8);
  for (const Shoot& shoot : spray(canvas, 0.75F)) {
    const float shade = canvas.between(0.75F, 1.05F);
    if (shoot.half_width < std::min(0.4F * least, kept_twig)) continue;
    canvas.stroke(shoot.from, shoot.to, std::max(least, shoot.half_width), std::max(least, shoot.half_width * 0.75F),
                  {shade, 0, 1});
  }
  return canvas.take();
}

/// Twigs in each of their sizes: drawn anew with lines a little wider than a texel.
std::vector<Grid<Rgba>> twig_mipmaps(const Grid<Rgba>& whole) {
  constexpr float half_texel = 0.52F;
  std::vector<Grid<Rgba>> levels{whole};
  for (int level = 1; whole.width() >> level >= 4; ++level) {
    Grid<Rgba> drawn = bare_twigs(half_texel * float(1 << level) / float(leaf_picture_side));
    for (int i = 0; i < level; ++i) drawn = halved(drawn);
    levels.push_back(std::move(drawn));
  }
  return levels;
}

/// Brushes of long needles at the ends of a fan of twigs.
Grid<Rgba> needle_tufts() {
  LeafCanvas canvas(3);
  constexpr int tufts = 26;
  for (int tuft = 0; tuft < tufts; ++tuft) {
    const float turn = glm::radians(137.5F) * float(tuft);
    const float away = 0.40F * std::sqrt((float(tuft) + 0.5F) / tufts);
    const glm::vec2 at = glm::vec2(0.5F) + away * glm::vec2(std::cos(turn), std::sin(turn));
    const float shade = 0.6F + 0.018F * float(tufts - tuft) + canvas.between(-0.08F, 0.12F);
    canvas.stroke({0.5F, 0.35F}, at, 0.006F, 0.004F, {0.6F, 0, 1});
    for (int needle = 0; needle < 34; ++needle) {
      // They stand up and outward more than down.
      const float direction = turn + canvas.between(-1.9F, 1.9F);
      const float length = canvas.between(0.055F, 0.105F);
      canvas.stroke(at, at + length * glm::vec2(std::cos(direction), std::sin(direction) + 0.25F), 0.0045F, 0.0025F,
                    {shade * canvas.between(0.7F, 1.35F), canvas.unit(), 0});
    }
  }
  return canvas.take();
}

/// A flat bough, foot at y = 0, broad then pointed, combs of needles along side twigs that slant to its tip.
Grid<Rgba> bough() {
  LeafCanvas canvas(4);
  canvas.stroke({0.5F, 0}, {0.5F, 0.92F}, 0.009F, 0.004F, twig);
  constexpr int twigs = 17;
  for (int i = 0; i < twigs; ++i) {
    const float t = (float(i) + 0.4F) / twigs;
    for (const float side : {-1.0F, 1.0F}) {
      const glm::vec2 at(0.5F, 0.93F * t);
      const float length =
          (0.44F * std::sin(glm::pi<float>() * std::pow(0.10F + 0.88F * t, 0.75F)) + 0.05F) * canvas.between(0.72F, 1.08F);
      const glm::vec2 along = length * glm::normalize(glm::vec2(side, 0.5F + 0.55F * t + canvas.between(-0.1F, 0.1F)));
      const float shade = canvas.between(0.66F, 1.12F);
      canvas.stroke(at, at + along, 0.011F, 0.005F, {0.8F * shade, 0.5F, 0});
      const int combs = 6 + int(26 * length / 0.45F);
      for (int needle = 0; needle < combs; ++needle) {
        const glm::vec2 foot = at + along * (float(needle) + 0.5F) / float(combs);
        for (const float lean : {-1.0F, 1.0F}) {
          const glm::vec2 out = glm::normalize(along) + 0.9F * lean * glm::normalize(glm::vec2(-along.y, along.x));
          canvas.stroke(foot, foot + canvas.between(0.03F, 0.048F) * glm::normalize(out), 0.0042F, 0.0024F,
                        {shade * canvas.between(0.8F, 1.3F), canvas.unit(), 0});
        }
      }
    }
  }
  for (int needle = 0; needle < 16; ++needle) {
    canvas.stroke({0.5F, 0.88F}, {0.5F + canvas.between(-0.05F, 0.05F), 0.99F}, 0.006F, 0.003F, {1, 0.5F, 0});
  }
  return canvas.take();
}

/// A strip of meadow from the side: blades of all heights that bend over, dark at the root and light at the tip.
Grid<Rgba> blades() {
  LeafCanvas canvas(5);
  constexpr int count = 130;
  for (int i = 0; i < count; ++i) {
    const float back = float(i) / count;
    const float foot = canvas.between(0.06F, 0.94F);
    const float lean = canvas.between(-0.24F, 0.24F);
    const float edge = 1 - 0.55F * std::pow(std::abs(2 * foot - 1), 3.0F);
    const float height = (0.28F + 0.68F * std::pow(canvas.unit(), 1.6F)) * edge;
    glm::vec2 before(foot, 0);
    const float shade = 0.78F + 0.3F * back + canvas.between(-0.16F, 0.16F);
    constexpr int pieces = 6;
    for (int p = 1; p <= pieces; ++p) {
      const float t = float(p) / pieces;
      const glm::vec2 at(std::clamp(foot + lean * t * t, 0.01F, 0.99F), height * (t - 0.14F * t * t * t));
      canvas.stroke(before, at + (at - before) * 0.15F, 0.0065F * (1 - 0.8F * (t - 1.0F / pieces)), 0.0065F * (1 - 0.8F * t),
                    {shade * (0.72F + 0.34F * t), 0, 0});
      before = at;
    }
  }
  return canvas.take();
}

/// Leaves from the ground that spread and bend: herbs seen from the side.
Grid<Rgba> rosette() {
  LeafCanvas canvas(6);
  for (int i = 0; i < 70; ++i) {
    const float foot = canvas.between(0.2F, 0.8F);
    const float lean = canvas.between(-1.0F, 1.0F);
    const float length = canvas.between(0.25F, 0.8F);
    const glm::vec2 from(foot, canvas.between(0, 0.3F));
    const glm::vec2 to = from + length * glm::vec2(0.4F * lean, 1 - 0.55F * std::abs(lean));
    const glm::vec2 tip = glm::clamp(to, glm::vec2(0.02F), glm::vec2(0.98F));
    canvas.leaf(from, tip, 0.028F, {canvas.between(0.75F, 1.2F) * (0.55F + 0.55F * tip.y), 0, 0});
  }
  return canvas.take();
}

/// Upright stalks with a few leaves and a flower head each.
Grid<Rgba> flowers() {
  LeafCanvas canvas(7);
  for (int i = 0; i < 11; ++i) {
    const float foot = canvas.between(0.2F, 0.8F);
    const glm::vec2 head(std::clamp(foot + canvas.between(-0.2F, 0.2F), 0.06F, 0.94F), canvas.between(0.5F, 0.93F));
    canvas.stroke({foot, 0}, head, 0.006F, 0.0045F, {0.8F, 0, 0});
    const glm::vec2 at = glm::mix(glm::vec2(foot, 0), head, 0.5F);
    canvas.leaf(at, at + glm::vec2(canvas.between(-0.1F, 0.1F), 0.08F), 0.011F, {0.95F, 0, 0});
    for (int petal = 0; petal < 12; ++petal) {
      const float turn = canvas.between(0, glm::two_pi<float>());
      const glm::vec2 off = canvas.between(0.005F, 0.034F) * glm::vec2(std::cos(turn), 0.5F * std::sin(turn));
      canvas.dot(head + off, 0.0115F, {canvas.between(0.8F, 1.15F), 1, 0});
    }
  }
  return canvas.take();
}

/// One flower head from above: florets in a spiral, a darker heart.
Grid<Rgba> flower_head() {
  LeafCanvas canvas(9);
  constexpr int petals = 21;
  for (int i = 0; i < petals; ++i) {
    const float turn = glm::radians(137.5F) * float(i);
    const glm::vec2 out(std::cos(turn), std::sin(turn));
    canvas.leaf(glm::vec2(0.5F) + 0.08F * out, glm::vec2(0.5F) + canvas.between(0.36F, 0.48F) * out, 0.06F,
                {canvas.between(0.82F, 1.12F), 1, 0});
  }
  for (int i = 0; i < 26; ++i) {
    const float turn = glm::radians(137.5F) * float(i);
    const glm::vec2 out(std::cos(turn), std::sin(turn));
    canvas.dot(glm::vec2(0.5F) + 0.022F * std::sqrt(float(i)) * out, 0.022F, {canvas.between(0.5F, 0.75F), 0.9F, 0});
  }
  return canvas.take();
}

double share_above(const Grid<Rgba>& picture, double threshold) {
  std::size_t count = 0;
  for (const Rgba& texel : picture.cells()) count += texel[3] >= threshold ? 1 : 0;
  return double(count) / double(picture.size());
}

/// Scales coverage so that `share` of the texels pass an alpha test at one half.
void keep_share(Grid<Rgba>& picture, double share) {
  double low = 1;
  double high = 255;
  for (int step = 0; step < 12; ++step) {
    const double middle = 0.5 * (low + high);
    (share_above(picture, middle) > share ? low : high) = middle;
  }
  for (Rgba& texel : picture.cells()) texel[3] = std::uint8_t(std::min(255.0, double(texel[3]) * 128 / high + 0.5));
}

/// Gives holes the mean colour of what is covered.
void fill_holes(Grid<Rgba>& picture) {
  std::array<double, 3> mean{};
  double covered = 1e-9;
  for (const Rgba& texel : picture.cells()) {
    if (texel[3] == 0) continue;
    ++covered;
    for (std::size_t c = 0; c < 3; ++c) mean[c] += texel[c];
  }
  for (Rgba& texel : picture.cells()) {
    if (texel[3] != 0) continue;
    for (std::size_t c = 0; c < 3; ++c) texel[c] = std::uint8_t(mean[c] / covered);
  }
}

}  // namespace

Grid<Rgba> halved(const Grid<Rgba>& picture) {
  Grid<Rgba> out(picture.width() / 2, picture.height() / 2);
  for (int y = 0; y < out.height(); ++y) {
    for (int x = 0; x < out.width(); ++x) {
      std::array<int, 3> colour{};
      int covered = 0;
      for (int i = 0; i < 4; ++i) {
        const Rgba& texel = picture(2 * x + i % 2, 2 * y + i / 2);
        // Holes weigh a little, so that their colour is defined too.
        const int weight = 16 * int(texel[3]) + 1;
        covered += texel[3];
        for (std::size_t c = 0; c < 3; ++c) colour[c] += weight * int(texel[c]);
      }
      const int weights = 16 * covered + 4;
      Rgba& texel = out(x, y);
      for (std::size_t c = 0; c < 3; ++c) texel[c] = std::uint8_t(colour[c] / weights);
      texel[3] = std::uint8_t((covered + 2) / 4);
    }
  }
  return out;
}

std::vector<Grid<Rgba>> leaf_mipmaps(LeafPicture which, const Grid<Rgba>& picture) {
  if (which == LeafPicture::twigs) {
    std::vector<Grid<Rgba>> levels = twig_mipmaps(picture);
    for (Grid<Rgba>& level : levels) fill_holes(level);
    return levels;
  }
  std::vector<Grid<Rgba>> levels{picture};
  fill_holes(levels.front());
  const double share = share_above(picture, 128);
  std::vector<Grid<Rgba>> plain{levels.front()};
  while (plain.back().width() > 4) {
    plain.push_back(halved(plain.back()));
    levels.push_back(plain.back());
    keep_share(levels.back(), share);
  }
  return levels;
}

std::vector<Grid<Rgba>> leaf_pictures() {
  struct Drawing {
    LeafPicture which;
    Grid<Rgba> (*draw)();
  };
  constexpr std::array<Drawing, leaf_picture_count> drawings{{
      {LeafPicture::bark, furrowed_bark},
      {LeafPicture::broad, [] { return leafy(430, 0.058F, 0.30F, 0.75F, 0, 1); }},
      {LeafPicture::small, [] { return leafy(430, 0.050F, 0.33F, 0.8F, 0, 2); }},
      {LeafPicture::needles, needle_tufts},
      {LeafPicture::bough, bough},
      {LeafPicture::blades, blades},
      {LeafPicture::rosette, rosette},
      {LeafPicture::flower, flowers},
      {LeafPicture::twigs, [] { return bare_twigs(0); }},
      {LeafPicture::airy, [] { return leafy(260, 0.058F, 0.36F, 0.5F, 0.5F, 10); }},
      {LeafPicture::flower_head, flower_head},
      {LeafPicture::pale_bark, birch_bark},
      {LeafPicture::smooth_bark, smooth_bark},
      {LeafPicture::plated_bark, plated_bark},
      {LeafPicture::oak_spray, oak_spray},
      {LeafPicture::oval_spray, oval_spray},
      {LeafPicture::round_spray, round_spray},
      {LeafPicture::birch_spray, birch_spray},
      {LeafPicture::leathery_spray, leathery_spray},
      {LeafPicture::pine_spray, pine_spray},
      {LeafPicture::scale_spray, scale_spray},
      {LeafPicture::frond, fern_frond},
      {LeafPicture::shade_leaves, shade_leaves},
      {LeafPicture::stone, stone_face},
  }};
  std::vector<Grid<Rgba>> pictures(leaf_picture_count);
  parallel_each(drawings.size(), [&](std::size_t i) { pictures[std::size_t(drawings[i].which)] = drawings[i].draw(); });
  return pictures;
}

}  // namespace biotope

#include <algorithm>
#include <cmath>
#include <glm/glm.hpp>

#include "core/base/random.hpp"
#include "render/ground_maps.hpp"
#include "render/season.hpp"

namespace biotope {

namespace {

glm::vec3 linear(float r, float g, float b) {
  const auto c = linear_colour({r, g, b});
  return {c[0], c[1], c[2]};
}

/// Colours of bare ground, our choice: earthy and a little desaturated.
struct Palette {
  glm::vec3 limestone = linear(0.57F, 0.555F, 0.51F);
  glm::vec3 marl = linear(0.47F, 0.41F, 0.32F);
  glm::vec3 scree = linear(0.50F, 0.485F, 0.455F);
  glm::vec3 alluvium = linear(0.53F, 0.49F, 0.41F);
  glm::vec3 bed = linear(0.36F, 0.35F, 0.29F);
  glm::vec3 moist_earth = linear(0.31F, 0.26F, 0.19F);
  glm::vec3 dry_grass = linear(0.49F, 0.455F, 0.245F);
  glm::vec3 fresh_grass = linear(0.33F, 0.405F, 0.17F);
  glm::vec3 winter_grass = linear(0.48F, 0.44F, 0.31F);
  glm::vec3 leaf_litter = linear(0.30F, 0.245F, 0.175F);
  glm::vec3 needle_litter = linear(0.30F, 0.235F, 0.175F);
  glm::vec3 undergrowth = linear(0.235F, 0.30F, 0.135F);  ///< herbs and ferns of the shade, in full growth
};

/// One plant as the ground painter needs it.
struct PlantTint {
  const CoverMap* cover;
  Stratum stratum;
  glm::vec3 colour;
  float leafy;
  glm::vec3 litter{0};  ///< what lies under a tree
};

std::vector<PlantTint> plant_tints(const MapsSnapshot& snapshot, int month, const SpeciesVisibility& visible) {
  std::vector<PlantTint> tints;
  if (!snapshot.web || snapshot.web->levels.empty()) return tints;
  const auto& plants = snapshot.web->levels[0];
  for (std::size_t i = 0; i < plants.size() && i < snapshot.cover.size(); ++i) {
    const auto number = std::size_t(plants[i]);
    if (!snapshot.cover[i] || (number < visible.size() && !visible[number])) continue;
    const PlantTraits& plant = snapshot.web->species[number].plant();
    const SeasonalFoliage foliage = seasonal_foliage(plant, month);
    // Bare crowns have the colour of twigs; the last leaves hang outside.
    const glm::vec3 twigs(0.088F, 0.084F, 0.084F);
    const glm::vec3 leaves(foliage.colour[0], foliage.colour[1], foliage.colour[2]);
    const glm::vec3 turned(foliage.turned[0], foliage.turned[1], foliage.turned[2]);
    // In autumn and the winter after it leaves lie there that are not brown yet.
    const float fresh = plant.shape.evergreen ? 0.0F : month >= 8 ? 0.7F * foliage.turn : 0.25F * foliage.bare;
    const Palette palette;
    const glm::vec3 litter = glm::mix(plant.shape.evergreen ? palette.needle_litter : palette.leaf_litter, 0.62F * turned, fresh);
    tints.push_back({snapshot.cover[i].get(), plant.stratum, glm::mix(leaves, twigs, foliage.bare * foliage.bare),
                     1 - 0.5F * foliage.bare, litter});
  }
  return tints;
}

struct CellLook {
  glm::vec3 ground;
  float rock = 0;
  glm::vec3 canopy{0.05F};
  float canopy_cover = 0;
};

class GroundPainter {
 public:
  GroundPainter(const MapsSnapshot& snapshot, int month, const SpeciesVisibility& visible)
      : snapshot_(snapshot), tints_(plant_tints(snapshot, month, visible)) {
    // Grass is fresh in late spring, straw-coloured in late summer, green again after the first rains, dull in winter.
    constexpr std::array<float, 12> freshness{0.25F, 0.3F, 0.5F, 0.8F, 1.0F, 0.95F, 0.75F, 0.6F, 0.55F, 0.72F, 0.45F, 0.25F};
    freshness_ = freshness[std::size_t(month)];
    winter_ = month <= 1 || month >= 10 ? 0.7F : 0.0F;
  }

  CellLook look(int x, int y) const {
    CellLook cell;
    const float slope = slope_at(x, y);
    const float moisture = snapshot_.environment
                               ? std::clamp((snapshot_.environment->map(Resource::moisture).mean(x, y) - 1) / 8, 0.0F, 1.0F)
                               : unknown_moisture();
    cell.rock = std::clamp((slope - 0.62F) / 0.5F, 0.0F, 1.0F);
    glm::vec3 bare = bare_ground(x, y, slope, moisture, cell.rock);
    // A thin sward grows wherever nothing else is known or counted: the herbs of the species list are only part of it.
    const glm::vec3 green =
        glm::mix(palette_.dry_grass, palette_.fresh_grass, std::clamp(freshness_ * (0.35F + 0.9F * moisture), 0.0F, 1.0F));
    const glm::vec3 grass = glm::mix(green, palette_.winter_grass, winter_);
    const float sward = (1 - cell.rock) * (tints_.empty() ? 0.85F : 0.6F);
    cell.ground = glm::mix(bare, grass, sward);
    plants(x, y, cell);
    if (snapshot_.hydrology && snapshot_.hydrology->water_depth(x, y) > 0.05F)
      cell.ground = glm::mix(cell.ground, palette_.bed, 0.8F);
    return cell;
  }

 private:
  /// While nothing is known yet the ground is dull: it must not promise meadows.
  float unknown_moisture() const { return tints_.empty() ? 0.2F : 0.5F; }

  float slope_at(int x, int y) const {
    if (snapshot_.derivatives) return snapshot_.derivatives->slope(x, y);
    const Grid<float>& height = snapshot_.terrain().height;
    const float run = float(2 * snapshot_.terrain().cell_size);
    return std::hypot(height.clamped(x + 1, y) - height.clamped(x - 1, y), height.clamped(x, y + 1) - height.clamped(x, y - 1)) /
           run;
  }

  glm::vec3 bare_ground(int x, int y, float slope, float moisture, float rock) const {
    glm::vec3 soil = palette_.marl;
    glm::vec3 cliff = palette_.limestone;
    if (snapshot_.environment && snapshot_.environment->geology) {
      switch ((*snapshot_.environment->geology)(x, y)) {
        case Geology::limestone:
          soil = glm::mix(palette_.marl, palette_.limestone, 0.6F);
          break;
        case Geology::water:
          soil = palette_.bed;
          break;
        case Geology::marl:
          cliff = glm::mix(palette_.limestone, palette_.marl, 0.35F);
          break;
        case Geology::scree:
          soil = palette_.scree;
          cliff = palette_.scree;
          break;
        case Geology::alluvium:
          soil = palette_.alluvium;
          break;
      }
    }
    soil = glm::mix(soil, palette_.moist_earth, 0.6F * moisture);
    const float stony = std::clamp((slope - 0.45F) / 0.4F, 0.0F, 1.0F) * 0.5F;
    return glm::mix(glm::mix(soil, palette_.scree, stony), cliff, rock);
  }

  void plants(int x, int y, CellLook& cell) const {
    glm::vec3 canopy(0);
    glm::vec3 herbs(0);
    float herb_cover = 0;
    glm::vec3 shrubs(0);
    float shrub_cover = 0;
    float canopy_leaves = 0;
    glm::vec3 litter(0);
    for (const PlantTint& tint : tints_) {
      const float cover = cover_fraction((*tint.cover)(x, y));
      if (cover <= 0) continue;
      if (tint.stratum == Stratum::herb) {
        herbs += cover * tint.colour;
        herb_cover += cover;
      } else if (tint.stratum == Stratum::shrub) {
        shrubs += cover * tint.colour;
        shrub_cover += cover * tint.leafy;
      } else {
        canopy += cover * tint.colour;
        litter += cover * tint.litter;
        canopy_leaves += cover * tint.leafy;
        cell.canopy_cover += cover;
      }
    }
    if (herb_cover > 0) {
      const glm::vec3 leaves = herbs / herb_cover;
      const auto meadow = meadow_colour({leaves.r, leaves.g, leaves.b});
      cell.ground = glm::mix(cell.ground, glm::vec3(meadow[0], meadow[1], meadow[2]),
                             std::min(herb_cover, 1.0F) * 0.75F * (1 - 0.85F * cell.rock));
    }
    // Leaves cover more ground than the crowns they fell from; where herbs are dense, less of it, and what bears shade is green.
    const float covered = glm::smoothstep(0.2F, 0.9F, cell.canopy_cover) * (0.90F - 0.30F * std::min(herb_cover, 1.0F));
    if (cell.canopy_cover > 0) {
      const glm::vec3 floor = glm::mix(litter / cell.canopy_cover, palette_.undergrowth, 0.65F * freshness_ * (1 - winter_));
      cell.ground = glm::mix(cell.ground, floor, covered * (1 - 0.7F * cell.rock));
    }
    // Shrubs are lost from sight sooner than trees: they colour the ground, half of it their shade.
    if (shrub_cover > 0) cell.ground = glm::mix(cell.ground, shrubs / shrub_cover * 0.5F, 0.8F * std::min(shrub_cover, 1.0F));
    if (cell.canopy_cover <= 0) return;
    // Seen from afar a canopy is darker than its leaves: half of it is shade between crowns.
    cell.canopy = canopy / cell.canopy_cover * 0.62F;
    cell.canopy_cover = std::min(1.0F, canopy_leaves);
  }

  const MapsSnapshot& snapshot_;
  std::vector<PlantTint> tints_;
  Palette palette_;
  float freshness_ = 1;
  float winter_ = 0;
};

Rgba coded(const glm::vec3& colour, float alpha) {
  const auto code = [](float v) { return std::uint8_t(std::lround(std::sqrt(std::clamp(v, 0.0F, 1.0F)) * 255)); };
  return {code(colour.r), code(colour.g), code(colour.b), std::uint8_t(std::lround(std::clamp(alpha, 0.0F, 1.0F) * 255))};
}

}  // namespace

std::array<float, 3> linear_colour(const std::array<float, 3>& srgb) {
  return {std::pow(srgb[0], 2.2F), std::pow(srgb[1], 2.2F), std::pow(srgb[2], 2.2F)};
}

std::array<float, 3> meadow_colour(const std::array<float, 3>& leaf) {
  const float grey = 0.3F * leaf[0] + 0.55F * leaf[1] + 0.15F * leaf[2];
  constexpr std::array<float, 3> straw{1.14F, 1.0F, 0.52F};
  std::array<float, 3> out{};
  for (std::size_t i = 0; i < 3; ++i) out[i] = 0.80F * (0.64F * leaf[i] + 0.36F * grey * straw[i]);
  return out;
}

SeasonalFoliage seasonal_foliage(const PlantTraits& plant, int month) {
  // Share of autumn colour and of fallen leaves by month, for the temperate northern hemisphere (our choice).
  constexpr std::array<float, 12> turning{1, 1, 0.6F, 0.15F, 0, 0, 0, 0.05F, 0.25F, 0.9F, 1, 1};
  constexpr std::array<float, 12> fallen{1, 1, 0.85F, 0.3F, 0, 0, 0, 0, 0, 0.25F, 0.8F, 1};
  // Herbs have ripe stalks from July on; the rains of autumn make meadows green again when the woods turn.
  constexpr std::array<float, 12> ripe{0.95F, 0.95F, 0.75F, 0.2F, 0, 0, 0.05F, 0.25F, 0.38F, 0.18F, 0.6F, 0.95F};
  const auto m = std::size_t(std::clamp(month, 0, 11));
  const bool herb = plant.stratum == Stratum::herb;
  // Young leaves of spring are lighter and yellower than those of late summer.
  const bool young = m == 3 || m == 4;
  const std::array<float, 3> light = !young                  ? std::array<float, 3>{1, 1, 1}
                                     : plant.shape.evergreen ? std::array<float, 3>{1.06F, 1.06F, 1}
                                                             : std::array<float, 3>{1.22F, 1.16F, 0.95F};
  // A crown is duller than a leaf: sky and twigs mix into it.
  const auto in_crown = [&](const std::array<float, 3>& srgb, float dull) {
    std::array<float, 3> colour = linear_colour(srgb);
    for (std::size_t i = 0; i < 3; ++i) colour[i] *= light[i];
    const float grey = 0.3F * colour[0] + 0.55F * colour[1] + 0.15F * colour[2];
    constexpr std::array<float, 3> warm{1.1F, 1.0F, 0.8F};
    for (std::size_t i = 0; i < 3; ++i) colour[i] += dull * (grey * warm[i] - colour[i]);
    return colour;
  };
  SeasonalFoliage out;
  out.fresh = in_crown(plant.shape.leaf_colour, 0.22F);
  out.turned = in_crown(plant.shape.autumn_colour, herb ? 0.22F : 0.06F);
  // Woods as a whole are more golden than green.
  if (!herb && !plant.shape.evergreen) {
    constexpr std::array<float, 3> golden{1.04F, 0.90F, 0.80F};
    for (std::size_t i = 0; i < 3; ++i) out.turned[i] *= golden[i];
  }
  const float turn = herb ? ripe[m] : turning[m];
  out.turn = plant.shape.evergreen ? 0.25F * turn : turn;
  // What comes out in April is new; last year's grass still stands.
  if (!herb && m == 3) out.turn = 0;
  for (std::size_t i = 0; i < 3; ++i) out.colour[i] = out.fresh[i] + (out.turned[i] - out.fresh[i]) * out.turn;
  out.bare = plant.shape.evergreen || herb ? 0.0F : fallen[m];
  return out;
}

GroundColours colour_ground(const MapsSnapshot& snapshot, int month, const SpeciesVisibility& visible, int stride,
                            const Rect& rect) {
  const GroundPainter painter(snapshot, northern_month(month, snapshot.terrain().latitude), visible);
  GroundColours out{Grid<Rgba>(rect.width(), rect.height()), Grid<Rgba>(rect.width(), rect.height())};
  for (int y = rect.y0; y < rect.y1; ++y) {
    for (int x = rect.x0; x < rect.x1; ++x) {
      const CellLook cell = painter.look(x * stride + stride / 2, y * stride + stride / 2);
      const float grain = 0.94F + 0.12F * float(random_unit({0x67726f756e64ULL, std::uint64_t(x), std::uint64_t(y)}));
      out.ground(x - rect.x0, y - rect.y0) = coded(cell.ground * grain, cell.rock);
      out.canopy(x - rect.x0, y - rect.y0) = coded(cell.canopy * grain, cell.canopy_cover);
    }
  }
  return out;
}

}  // namespace biotope

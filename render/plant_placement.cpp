#include "render/plant_placement.hpp"

#include <algorithm>
#include <cmath>
#include <glm/gtc/constants.hpp>
#include <span>

#include "core/base/random.hpp"
#include "render/landscape_renderer.hpp"

namespace biotope {

namespace {

/// Side of the largest cells, m; a block holds a whole number of them.
constexpr float root_side = 32;
constexpr int deepest_level = 11;
constexpr float trunk_clearance = 0.4F;
/// Of a hundred plants so many are of an age, and their crowns' diameters are so many times that of the species. Our choice: the
/// many young and few old trees of a wood that renews itself.
struct AgeClass {
  float number;
  float least;
  float most;
};
constexpr std::array<AgeClass, 4> tree_ages{{{25, 0.4F, 0.6F}, {24, 0.6F, 0.9F}, {30, 0.9F, 1.25F}, {21, 1.25F, 1.75F}}};
constexpr std::array<AgeClass, 2> shrub_ages{{{35, 0.45F, 0.8F}, {65, 0.8F, 1.35F}}};
/// Radius of a trunk's foot with its roots, as a share of the tree's height; of a shrub's stems, as a share of its crown's
/// radius. Our choice.
constexpr float trunk_share = 0.024F;
constexpr float stems_share = 0.35F;
/// Size of a shrub of which nothing is left.
constexpr float browsed_size = 0.6F;
/// In a full wood crowns grow into all the room there is.
constexpr float most_crowded = 1.45F;
constexpr float wet = 0.05F;
/// Nothing stands nearer to drawn water than this, m; herbs come one by one within the next metres.
constexpr float bank = 0.7F;
constexpr float herb_bank = 3.0F;
constexpr float tuft_spacing = 0.25F;
/// Share of tufts and of their height where nothing of the growth is left.
constexpr float eaten_density = 0.76F;
constexpr float eaten_height = 0.38F;
/// Wear of the ground from which tufts grow sparser, and at which none is left.
constexpr float first_worn = 0.12F;
constexpr float bare_worn = 0.62F;
/// Share of tufts that no mouth likes: they stand as high as they grew.
constexpr float spurned = 0.06F;
/// Grass is higher here and lower there within some metres.
constexpr float sward_patch = 2.6F;

float cell_width(int level) { return root_side / float(1 << ((level + 1) / 2)); }
float cell_height(int level) { return root_side / float(1 << (level / 2)); }

/// Level whose cells' area is nearest to a crown's, as a ratio.
int level_of(float crown_area) {
  const float levels = std::log2(root_side * root_side / std::max(crown_area, 0.05F));
  return std::clamp(int(std::lround(levels)), 0, deepest_level);
}

/// Mean square of sizes that are as likely from `least` to `most`.
constexpr float mean_square(float least, float most) { return (least * least + least * most + most * most) / 3; }

/// One of the draws 0..1 of a place.
float draw(std::uint64_t place, std::uint64_t what) { return float(mix_bits(place + what) >> 40U) * 0x1.0p-24F; }

/// A draw 0..1 for a cell of which every group of 8 x 8 cells has one in each 64th: cells that are filled with some probability
/// are then as many as the probability says, wherever one counts. `key`: 64 random bits of the group; `within`: 0..1.
float even_draw(int column, int row, std::uint64_t key, float within) {
  // Steps that each map 0..63 onto itself.
  std::uint32_t k = std::uint32_t((column & 7) | ((row & 7) << 3));
  for (int round = 0; round < 3; ++round) {
    k = (k + std::uint32_t(key & 63)) & 63;
    k = (k * std::uint32_t(((key >> 6) & 31) * 2 + 1)) & 63;
    k ^= k >> 3;
    key >>= 13;
  }
  return (float(k) + within) / 64;
}

/// Smooth noise 0..1 over the ground, in patches of `sward_patch` metres.
float patch_noise(std::uint64_t seed, float x, float y) {
  const float column = std::floor(x / sward_patch);
  const float row = std::floor(y / sward_patch);
  const auto at = [&](float dx, float dy) {
    return draw(seed, std::uint64_t(std::int64_t(column + dx)) * 0x9e3779b97f4a7c15ULL + std::uint64_t(std::int64_t(row + dy)));
  };
  const float fx = glm::smoothstep(0.0F, 1.0F, x / sward_patch - column);
  const float fy = glm::smoothstep(0.0F, 1.0F, y / sward_patch - row);
  return glm::mix(glm::mix(at(0, 0), at(1, 0), fx), glm::mix(at(0, 1), at(1, 1), fx), fy);
}

}  // namespace

PlantPlacement::PlantPlacement(PlantGround ground)
    : snapshot_(std::move(ground.maps)),
      shore_(std::move(ground.shore)),
      trails_(std::move(ground.trails)),
      grazing_(std::move(ground.grazing)) {
  if (!snapshot_ || !snapshot_->web || snapshot_->web->levels.empty()) return;
  const auto& plants = snapshot_->web->levels[0];
  for (std::size_t i = 0; i < plants.size() && i < snapshot_->cover.size(); ++i) {
    if (!snapshot_->cover[i]) continue;
    const PlantTraits& traits = snapshot_->web->species[std::size_t(plants[i])].plant();
    Kind kind;
    kind.plant = int(i);
    kind.cover = snapshot_->cover[i].get();
    kind.crown_radius = std::max(0.05F, 0.5F * traits.shape.crown_diameter);
    kind.crown_area = glm::pi<float>() * kind.crown_radius * kind.crown_radius;
    kind.height = traits.shape.height;
    kind.evergreen = traits.shape.evergreen;
    kind.trunk_radius = traits.stratum == Stratum::tree ? trunk_share * kind.height : stems_share * kind.crown_radius;
    kinds_[std::size_t(traits.stratum)].push_back(kind);
  }
  add_ages(Stratum::tree);
  add_ages(Stratum::shrub);
}

void PlantPlacement::add_ages(Stratum stratum) {
  const std::span<const AgeClass> classes =
      stratum == Stratum::tree ? std::span<const AgeClass>(tree_ages) : std::span<const AgeClass>(shrub_ages);
  float number = 0;
  float crowns = 0;
  for (const AgeClass& age : classes) {
    number += age.number;
    crowns += age.number * mean_square(age.least, age.most);
  }
  const float normal = std::sqrt(number / crowns);
  auto& kinds = kinds_[std::size_t(stratum)];
  for (std::size_t k = 0; k < kinds.size(); ++k) {
    kinds[k].cells_wanted = 0;
    for (const AgeClass& age : classes) {
      Age made;
      made.kind = k;
      made.least = normal * age.least;
      made.most = normal * age.most;
      made.cover = age.number * mean_square(age.least, age.most) / crowns;
      made.crown_area = kinds[k].crown_area * mean_square(made.least, made.most);
      made.level = level_of(made.crown_area);
      kinds[k].cells_wanted += made.cover * cell_width(made.level) * cell_height(made.level) / made.crown_area;
      ages_[std::size_t(stratum)].push_back(made);
    }
  }
}

bool PlantPlacement::grows_at(int map_x, int map_y, float x, float y, float away, float off_trail) const {
  const MapsSnapshot& maps = *snapshot_;
  if (maps.hydrology &&
      (maps.hydrology->water_depth(map_x, map_y) > wet || maps.hydrology->water(map_x, map_y) != WaterKind::dry)) {
    return false;
  }
  if (shore_) {
    const double fine = maps.terrain().cell_size / shore_->scale;
    const std::uint8_t code = shore_->codes.clamped(int(double(x) / fine), shore_->codes.height() - 1 - int(double(y) / fine));
    if (shore_distance(code) > -away) return false;
  }
  if (trails_) return trails_->inside(x, y) <= -off_trail;
  return !maps.trails || maps.trails->wear.empty() || maps.trails->wear(map_x, map_y) <= trodden_wear;
}

bool PlantPlacement::has_room(float x, float y, float trunk_radius) const {
  const Terrain& terrain = snapshot_->terrain();
  const int map_x = int(std::floor(double(x) / terrain.cell_size));
  const int map_y = terrain.height.height() - 1 - int(std::floor(double(y) / terrain.cell_size));
  return terrain.height.contains(map_x, map_y) && grows_at(map_x, map_y, x, y, bank, trunk_radius);
}

float PlantPlacement::trunk_radius(const PlantInstance& plant) const {
  for (const auto& kinds : kinds_) {
    for (const Kind& kind : kinds) {
      if (float(kind.plant) == plant.plant) return kind.trunk_radius * plant.scale;
    }
  }
  return 0;
}

PlantInstance PlantPlacement::stand(const Kind& kind, float x, float y) const {
  PlantInstance plant;
  plant.x = x;
  plant.y = y;
  plant.z = ground_height(snapshot_->terrain(), x, y);
  plant.plant = float(std::min(kind.plant, most_plant_kinds - 1));
  return plant;
}

std::vector<PlantInstance> PlantPlacement::block(Stratum stratum, int column, int row) const {
  std::vector<PlantInstance> out;
  if (!snapshot_ || kinds_[std::size_t(stratum)].empty()) return out;
  if (stratum == Stratum::herb) {
    out = herbs(column, row);
  } else {
    constexpr int roots = int(woody_block_side / root_side);
    for (int y = row * roots; y < (row + 1) * roots; ++y) {
      for (int x = column * roots; x < (column + 1) * roots; ++x) {
        const Ages ages = ages_in(stratum, x, y);
        if (!ages.empty()) woody_cell(stratum, ages, {0, x, y}, 0, out);
      }
    }
  }
  std::stable_sort(out.begin(), out.end(), [](const PlantInstance& a, const PlantInstance& b) { return a.rank < b.rank; });
  return out;
}

PlantPlacement::Ages PlantPlacement::ages_in(Stratum stratum, int column, int row) const {
  const Terrain& terrain = snapshot_->terrain();
  const Rect cells = cells_under(terrain, double(column) * double(root_side), double(row) * double(root_side), double(root_side));
  const auto& kinds = kinds_[std::size_t(stratum)];
  std::vector<std::uint8_t> grows(kinds.size(), 0);
  for (std::size_t k = 0; k < kinds.size(); ++k) {
    for (int y = cells.y0; y < cells.y1 && grows[k] == 0; ++y) {
      for (int x = cells.x0; x < cells.x1 && grows[k] == 0; ++x) grows[k] = (*kinds[k].cover)(x, y) != 0 ? 1 : 0;
    }
  }
  Ages ages;
  for (const Age& age : ages_[std::size_t(stratum)]) {
    if (grows[age.kind] != 0) ages.push_back(&age);
  }
  return ages;
}

float PlantPlacement::cells_wanted(Stratum stratum, int x, int y) const {
  float wanted = 0;
  for (const Kind& kind : kinds_[std::size_t(stratum)]) wanted += cover_fraction((*kind.cover)(x, y)) * kind.cells_wanted;
  return wanted;
}

float PlantPlacement::crowding(Stratum stratum, int x, int y) const {
  return std::clamp(cells_wanted(stratum, x, y), 1.0F, most_crowded);
}

double PlantPlacement::density(int plant, int x, int y) const {
  for (const Stratum stratum : {Stratum::tree, Stratum::shrub}) {
    for (const Kind& kind : kinds_[std::size_t(stratum)]) {
      if (kind.plant != plant) continue;
      return double(cover_fraction((*kind.cover)(x, y))) / double(kind.crown_area * crowding(stratum, x, y));
    }
  }
  return 0;
}

glm::vec2 PlantPlacement::neighbourhood(Stratum stratum) const {
  int level = deepest_level;
  for (const Age& age : ages_[std::size_t(stratum)]) level = std::min(level, age.level);
  return {cell_width(level), cell_height(level)};
}

std::optional<PlantPlacement::Candidate> PlantPlacement::candidate(Stratum stratum, const Age& age, const Cell& cell, float older,
                                                                   const glm::vec2& jitter) const {
  const double cell_size = snapshot_->terrain().cell_size;
  const int rows = snapshot_->terrain().height.height();
  const Kind& kind = kinds_[std::size_t(stratum)][age.kind];
  const float width = cell_width(cell.level);
  const float height = cell_height(cell.level);
  // No larger than leaves its trunk at home in a narrow cell.
  const float of_size = trunk_clearance * kind.crown_radius * std::sqrt(most_crowded);
  const float size = std::min(glm::mix(age.least, age.most, older), 0.5F * std::min(width, height) / of_size);
  const float inset = of_size * size;
  const float x = (float(cell.column) + 0.5F) * width + jitter.x * std::max(0.0F, 0.5F * width - inset);
  const float y = (float(cell.row) + 0.5F) * height + jitter.y * std::max(0.0F, 0.5F * height - inset);
  const int map_x = int(std::floor(double(x) / cell_size));
  const int map_y = rows - 1 - int(std::floor(double(y) / cell_size));
  if (!kind.cover->rect().contains(map_x, map_y)) return std::nullopt;
  const float cover = cover_fraction((*kind.cover)(map_x, map_y));
  if (cover <= 0) return std::nullopt;
  const float crowded = crowding(stratum, map_x, map_y);
  if (!grows_at(map_x, map_y, x, y, bank, kind.trunk_radius * size * std::sqrt(crowded))) return std::nullopt;
  return Candidate{x, y, size * std::sqrt(crowded), cover * age.cover * width * height / (age.crown_area * crowded)};
}

void PlantPlacement::woody_cell(Stratum stratum, const Ages& ages, const Cell& cell, float taken,
                                std::vector<PlantInstance>& out) const {
  const std::uint64_t own = random_bits({snapshot_->document.seed, 0x706c616e74ULL + std::uint64_t(stratum),
                                         std::uint64_t(cell.level), std::uint64_t(cell.column), std::uint64_t(cell.row)});
  const auto random = [own](std::uint64_t what) { return draw(own, what); };
  // Given that no larger cell around this one is taken, the chance is higher by as much.
  const std::uint64_t group =
      random_bits({snapshot_->document.seed, 0x67726f7570ULL + std::uint64_t(stratum), std::uint64_t(cell.level),
                   std::uint64_t(cell.column >> 3), std::uint64_t(cell.row >> 3)});
  float chance = even_draw(cell.column, cell.row, group, random(4)) * std::max(1 - taken, 1e-3F);
  bool smaller = false;
  for (const Age* age : ages) {
    smaller = smaller || age->level > cell.level;
    if (age->level != cell.level) continue;
    const auto place = candidate(stratum, *age, cell, random(1), {2 * random(2) - 1, 2 * random(3) - 1});
    if (!place) continue;
    taken += place->share;
    if (chance >= place->share) {
      chance -= place->share;
      continue;
    }
    PlantInstance plant = stand(kinds_[std::size_t(stratum)][age->kind], place->x, place->y);
    plant.scale = place->size * browsed(stratum, plant);
    plant.turn = glm::two_pi<float>() * random(5);
    plant.tint = random(6);
    plant.rank = random(7);
    out.push_back(plant);
    return;
  }
  if (!smaller) return;
  // Odd levels have halved the width of even ones; even levels the height of odd ones.
  const bool halve_width = cell.level % 2 == 0;
  for (int half = 0; half < 2; ++half) {
    const Cell child{cell.level + 1, halve_width ? 2 * cell.column + half : cell.column,
                     halve_width ? cell.row : 2 * cell.row + half};
    woody_cell(stratum, ages, child, std::min(1.0F, taken), out);
  }
}

float PlantPlacement::browsed(Stratum stratum, const PlantInstance& plant) const {
  if (stratum != Stratum::shrub || !grazing_) return 1;
  const Terrain& terrain = snapshot_->terrain();
  const int x = int(std::floor(double(plant.x) / terrain.cell_size));
  const int y = terrain.height.height() - 1 - int(std::floor(double(plant.y) / terrain.cell_size));
  return browsed_size + (1 - browsed_size) * grazing_->left(int(plant.plant), x, y);
}

std::vector<PlantInstance> PlantPlacement::herbs(int column, int row) const {
  const Terrain& terrain = snapshot_->terrain();
  constexpr int tufts = int(herb_block_side / tuft_spacing);
  const bool near_trail =
      trails_ && !trails_->none_within(float(column) * herb_block_side, float(row) * herb_block_side, herb_block_side);
  std::vector<PlantInstance> out;
  for (int j = 0; j < tufts; ++j) {
    for (int i = 0; i < tufts; ++i) {
      const int lattice_x = column * tufts + i;
      const int lattice_y = row * tufts + j;
      const std::uint64_t own =
          random_bits({snapshot_->document.seed, 0x74756674ULL, std::uint64_t(lattice_x), std::uint64_t(lattice_y)});
      const auto random = [own](std::uint64_t what) { return draw(own, what); };
      const float x = (float(lattice_x) + random(1)) * tuft_spacing;
      const float y = (float(lattice_y) + random(2)) * tuft_spacing;
      const int map_x = int(std::floor(x / float(terrain.cell_size)));
      const int map_y = terrain.height.height() - 1 - int(std::floor(y / float(terrain.cell_size)));
      if (!terrain.height.contains(map_x, map_y)) continue;
      // The bank is bare at the water and overgrown some metres off.
      if (!grows_at(map_x, map_y, x, y, bank + (herb_bank - bank) * random(8))) continue;
      // Beside a trail tufts come one by one as the earth is less worn.
      if (near_trail && random(10) < glm::smoothstep(first_worn, bare_worn, trails_->worn(x, y))) continue;
      float chance = random(3);
      for (const Kind& kind : kinds_[std::size_t(Stratum::herb)]) {
        const float cover = cover_fraction((*kind.cover)(map_x, map_y));
        if (cover <= 0) continue;
        const float left = grazing_ ? grazing_->left(kind.plant, map_x, map_y) : 1.0F;
        const float share = cover * (eaten_density + (1 - eaten_density) * left);
        if (chance >= share) {
          chance -= share;
          continue;
        }
        PlantInstance plant = stand(kind, x, y);
        const float kept = random(9) < spurned ? 1.0F : eaten_height + (1 - eaten_height) * left;
        plant.scale = (0.6F + 0.75F * random(4)) * (0.72F + 0.56F * patch_noise(snapshot_->document.seed, x, y)) * kept;
        plant.turn = glm::two_pi<float>() * random(5);
        plant.tint = random(6);
        plant.rank = random(7);
        out.push_back(plant);
        break;
      }
    }
  }
  return out;
}

}  // namespace biotope

#include "core/ecosystem/plant_shortage.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "core/base/parallel.hpp"
#include "core/ecosystem/animal_needs.hpp"
#include "core/terrain/ground_coordinates.hpp"

namespace biotope {
namespace {

constexpr std::size_t most_samples = 50000;

/// Tiles that hold paint.
std::vector<std::size_t> painted_tiles(const PaintLayer& paint) {
  std::vector<std::size_t> tiles;
  for (std::size_t i = 0; i < paint.tile_count(); ++i) {
    if (paint.tile(i)) tiles.push_back(i);
  }
  return tiles;
}

/// Side of the squares that one cell stands for: a power of two, so that squares fill tiles.
int sample_stride(std::size_t tiles) {
  int stride = 1;
  while (stride < tile_side && tiles * std::size_t(tile_side / stride) * std::size_t(tile_side / stride) > most_samples)
    stride *= 2;
  return stride;
}

std::optional<PlantShortage> shortage_of(const PlantTraits& plant, const PlantEnvironment& environment, const CoverMap& cover,
                                         const PaintLayer& paint, double cell_size) {
  const std::vector<std::size_t> tiles = painted_tiles(paint);
  const int stride = sample_stride(tiles.size());
  auto where = std::make_shared<PaintLayer>(paint.width(), paint.height());
  std::array<std::size_t, 6> by_factor{};
  double sum_x = 0;
  double sum_y = 0;
  std::size_t cells = 0;
  std::vector<std::array<int, 2>> found;
  for (const std::size_t tile : tiles) {
    const Rect rect = paint.tile_rect(tile);
    for (int y = rect.y0; y < rect.y1; y += stride) {
      for (int x = rect.x0; x < rect.x1; x += stride) {
        if (paint(x, y).coverage <= 0 || cover_fraction(cover(x, y)) < told_cover) continue;
        const Fitness fitness = plant_fitness(plant, environment.cell(x, y));
        if (fitness.value >= least_fitness) continue;
        ++by_factor[std::size_t(fitness.limiting)];
        for (int sy = y; sy < std::min(y + stride, rect.y1); ++sy) {
          for (int sx = x; sx < std::min(x + stride, rect.x1); ++sx) where->set(sx, sy, {1, 1});
        }
        cells += std::size_t(std::min(stride, rect.x1 - x)) * std::size_t(std::min(stride, rect.y1 - y));
        sum_x += x;
        sum_y += y;
        found.push_back({x, y});
      }
    }
  }
  if (found.empty()) return std::nullopt;
  PlantShortage shortage;
  shortage.area = double(cells) * cell_size * cell_size;
  shortage.limiting = LimitingFactor(std::max_element(by_factor.begin(), by_factor.end()) - by_factor.begin());
  // The found cell nearest to their middle: the middle itself may lie where nothing is wrong.
  const double middle_x = sum_x / double(found.size());
  const double middle_y = sum_y / double(found.size());
  const auto nearest = std::min_element(found.begin(), found.end(), [&](const auto& a, const auto& b) {
    return std::hypot(a[0] - middle_x, a[1] - middle_y) < std::hypot(b[0] - middle_x, b[1] - middle_y);
  });
  shortage.x = (*nearest)[0];
  shortage.y = (*nearest)[1];
  shortage.where = std::move(where);
  return shortage;
}

std::string_view lack(LimitingFactor factor) {
  switch (factor) {
    case LimitingFactor::illumination:
      return "the light does not suit it";
    case LimitingFactor::temperature:
      return "the temperature does not suit it";
    case LimitingFactor::moisture:
      return "the moisture does not suit it";
    case LimitingFactor::texture:
      return "the soil's texture does not suit it";
    case LimitingFactor::geology:
      return "the rock does not suit it";
    case LimitingFactor::none:
      break;
  }
  return "nothing suits it";
}

}  // namespace

std::vector<PlantShortage> plant_shortages(const FoodWeb& web, const PlantEnvironment& environment,
                                           std::span<const std::shared_ptr<const CoverMap>> covers,
                                           std::span<const std::shared_ptr<const PaintLayer>> paint, double cell_size) {
  const auto& level = web.levels.front();
  std::vector<std::optional<PlantShortage>> found(level.size());
  parallel_each(level.size(), [&](std::size_t i) {
    if (!paint[i] || !covers[i]) return;
    found[i] = shortage_of(web.species[std::size_t(level[i])].plant(), environment, *covers[i], *paint[i], cell_size);
    if (found[i]) found[i]->species = level[i];
  });
  std::vector<PlantShortage> shortages;
  for (auto& one : found) {
    if (one) shortages.push_back(std::move(*one));
  }
  return shortages;
}

Warning shortage_warning(const FoodWeb& web, const Terrain& terrain, const PlantShortage& shortage) {
  const std::string area =
      shortage.area < 10000 ? number_text(shortage.area) + " m2" : number_text(shortage.area / 10000) + " ha";
  return {display_name(web, shortage.species) + ": painted over " + area + " where " + std::string(lack(shortage.limiting)) +
              " " + near_text(terrain, shortage.x, shortage.y),
          shortage.species, PathPoint{float(shortage.x), float(shortage.y)}, shortage.area, "m2"};
}

}  // namespace biotope

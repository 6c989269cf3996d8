#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstdint>
#include <utility>

#include "core/base/parallel.hpp"
#include "core/ecosystem/plant_competition.hpp"
#include "core/ecosystem/plant_competition_kernel.hpp"
#include "core/ecosystem/plant_flora_fitness.hpp"
#include "core/ecosystem/plant_priority.hpp"
#include "core/ecosystem/plant_share_choice.hpp"

namespace biotope {

namespace {

constexpr std::string_view stage = "plant competition";

/// Units between two looks at the stop token: a few milliseconds.
constexpr std::int64_t units_at_once = 1 << 15;

/// Cells are compared by fitness in steps of 1/20 (12/240), like the cover of a unit: what differs by less counts as equal, and
/// row order decides. Finer steps find hardly fitter cells, and have to look at each of them again whenever a little light is
/// gone.
constexpr int key_step = 12;

/// Fitness in steps of 1/240 as a key: 0 for none, else at least 1.
std::uint8_t key_of_fitness(std::uint8_t fitness) {
  return fitness == 0 ? std::uint8_t(0) : std::uint8_t(std::max(1, (int(fitness) + key_step / 2) / key_step));
}

/// A plant that somebody wants: its number in the level and what one unit takes.
struct Wanted {
  int plant = 0;
  const PlantTraits* traits = nullptr;
  Cover unit = 1;
  float light_taken = 0;
  float water_taken = 0;
};

std::vector<Wanted> wanted_plants(const FoodWeb& web, std::span<const double> desired) {
  std::vector<Wanted> wanted;
  for (std::size_t i = 0; i < desired.size(); ++i) {
    if (!(desired[i] > 0)) continue;
    const PlantTraits& plant = web.species[std::size_t(web.levels[0][i])].plant();
    const Cover unit = unit_of(plant);
    wanted.push_back(
        {int(i), &plant, unit, unit_consumption(plant.light_consumption, unit), unit_consumption(plant.water_consumption, unit)});
  }
  return wanted;
}

/// What is left in a cell.
struct Stock {
  float light_taken = 0;
  float water_taken = 0;
  std::array<Cover, strata> ground{full_cover, full_cover, full_cover};
};

/// The whole terrain while its plants are given out. Numbers by cell and wanted plant lie side by side for each cell.
class Landscape {
 public:
  Landscape(const std::vector<Wanted>& wanted, const PlantEnvironment& environment)
      : wanted_(wanted),
        environment_(environment),
        fitness_(traits_of(wanted)),
        width_(environment.maps->geology->width()),
        height_(environment.maps->geology->height()),
        stock_(cells()),
        fixed_(cells() * wanted.size()),
        cover_(cells() * wanted.size()),
        priority_(wanted.size(), CellPriority(cells())),
        keys_(wanted.size()) {
    parallel_rows(0, height_, [this](int y) { start_row(y); });
    parallel_each(priority_.size(), [this](std::size_t i) { priority_[i].index_all(); });
  }

  [[nodiscard]] std::size_t cells() const { return std::size_t(width_) * std::size_t(height_); }

  /// Whether some cell may still feed a unit of the plant.
  [[nodiscard]] bool has_place(std::size_t i) const { return priority_[i].best() > 0; }

  /// Gives one unit to the fittest cell, the first in row order of equals; false when no cell can feed it after all.
  bool place(std::size_t i) {
    CellPriority& priority = priority_[i];
    while (priority.best() > 0) {
      const std::size_t cell = priority.first_best();
      const std::uint8_t key = look_at(cell, i);
      if (key == priority.best()) {
        give_unit(cell, i);
        return true;
      }
      priority.set(cell, key);
    }
    return false;
  }

  /// Cover of a wanted plant as a map; tiles where it does not grow stay null.
  [[nodiscard]] CoverMap cover_map(std::size_t i) const {
    CoverMap map(width_, height_);
    for (int y = 0; y < height_; ++y) {
      for (int x = 0; x < width_; ++x) {
        const Cover cover = cover_[cell_of(x, y) * wanted_.size() + i];
        if (cover > 0) map.set(x, y, cover);
      }
    }
    return map;
  }

 private:
  static std::vector<const PlantTraits*> traits_of(const std::vector<Wanted>& wanted) {
    std::vector<const PlantTraits*> traits;
    for (const Wanted& plant : wanted) traits.push_back(plant.traits);
    return traits;
  }

  [[nodiscard]] std::size_t cell_of(int x, int y) const { return std::size_t(y) * std::size_t(width_) + std::size_t(x); }

  /// Fitness that nothing consumes, and with it the keys of an empty row.
  void start_row(int y) {
    std::vector<std::uint8_t> keys(wanted_.size());
    FloraFitness::Room room;
    for (int x = 0; x < width_; ++x) {
      const std::size_t cell = cell_of(x, y);
      const std::span<std::uint8_t> fixed(fixed_.data() + cell * wanted_.size(), wanted_.size());
      const float texture = environment_.texture(x, y);
      const Geology geology = environment_.geology(x, y);
      for (std::size_t i = 0; i < wanted_.size(); ++i) {
        const PlantTraits& plant = *wanted_[i].traits;
        const float viability = plant.texture.contains(texture) ? plant.geology[std::size_t(geology)] : 0;
        fixed[i] = viability < least_fitness ? 0 : std::max(to_cover(viability), Cover(1));
      }
      if (std::ranges::all_of(fixed, [](std::uint8_t key) { return key == 0; })) continue;
      fitness_.limit(Resource::temperature, year_intervals(environment_.year(Resource::temperature, x, y)), 0, room, fixed);
      keys_of(cell, year_of(Resource::illumination, cell), year_of(Resource::moisture, cell), room, keys);
      for (std::size_t i = 0; i < wanted_.size(); ++i) priority_[i].put(cell, keys[i]);
    }
  }

  [[nodiscard]] YearIntervals year_of(Resource resource, std::size_t cell) const {
    return year_intervals(environment_.year(resource, int(cell % std::size_t(width_)), int(cell / std::size_t(width_))));
  }

  [[nodiscard]] static bool is_fed(const Wanted& plant, const Stock& stock, const YearIntervals& light,
                                   const YearIntervals& water) {
    return light.mean - stock.light_taken > plant.light_taken && water.mean - stock.water_taken > plant.water_taken;
  }

  /// The fitness, in steps of 1/240, that no shade and no thirst could raise: soil and temperature, own crowding, ground.
  [[nodiscard]] std::uint8_t ceiling(std::size_t cell, std::size_t i) const {
    const Wanted& plant = wanted_[i];
    if (stock_[cell].ground[std::size_t(plant.traits->stratum)] < plant.unit) return 0;
    const std::size_t at = cell * wanted_.size() + i;
    return std::min(fixed_[at], Cover(full_cover - cover_[at]));
  }

  /// Keys of all plants in a cell: fitness with what is left, 0 where a need of a unit is not available.
  void keys_of(std::size_t cell, const YearIntervals& light, const YearIntervals& water, FloraFitness::Room& room,
               std::span<std::uint8_t> keys) const {
    const Stock& stock = stock_[cell];
    for (std::size_t i = 0; i < wanted_.size(); ++i) {
      keys[i] = is_fed(wanted_[i], stock, light, water) ? ceiling(cell, i) : std::uint8_t(0);
    }
    fitness_.limit(Resource::illumination, light, stock.light_taken, room, keys);
    fitness_.limit(Resource::moisture, water, stock.water_taken, room, keys);
    for (std::uint8_t& key : keys) key = key_of_fitness(key);
  }

  /// The key of one plant in a cell as it is now. Keeps the cell's light and water for give_unit.
  std::uint8_t look_at(std::size_t cell, std::size_t i) {
    const std::uint8_t most = ceiling(cell, i);
    if (most == 0) return 0;
    const Stock& stock = stock_[cell];
    light_ = year_of(Resource::illumination, cell);
    water_ = year_of(Resource::moisture, cell);
    if (!is_fed(wanted_[i], stock, light_, water_)) return 0;
    return key_of_fitness(std::min({most, fitness_.key_of(i, Resource::illumination, light_, stock.light_taken),
                                    fitness_.key_of(i, Resource::moisture, water_, stock.water_taken)}));
  }

  /// Gives a unit in the cell that was looked at last. Keys in the queues are upper bounds, looked at again when they come
  /// first: what is taken makes a place worse, but for plants for which it was too bright or too wet.
  void give_unit(std::size_t cell, std::size_t i) {
    const Wanted& plant = wanted_[i];
    Stock& stock = stock_[cell];
    const bool may_rise = someone_has_too_much(cell);
    stock.light_taken += plant.light_taken;
    stock.water_taken += plant.water_taken;
    stock.ground[std::size_t(plant.traits->stratum)] -= plant.unit;
    prefetch(cell + 1);
    cover_[cell * wanted_.size() + i] += plant.unit;
    priority_[i].set(cell, std::min(priority_[i].best(), key_of_fitness(ceiling(cell, i))));
    if (!may_rise) return;
    keys_of(cell, light_, water_, room_, keys_);
    for (std::size_t other = 0; other < wanted_.size(); ++other) {
      if (keys_[other] > priority_[other].key(cell)) priority_[other].set(cell, keys_[other]);
    }
  }

  /// Asks for what is known of a cell: plants mostly go from one cell to the next, but take turns, so that each finds its
  /// next cell gone from the cache.
  void prefetch(std::size_t cell) const {
    if (cell >= stock_.size()) return;
    __builtin_prefetch(&stock_[cell]);
    __builtin_prefetch(&fixed_[cell * wanted_.size()]);
    __builtin_prefetch(&cover_[cell * wanted_.size()]);
  }

  /// Whether the cell that was looked at last is, for part of the year, too bright or too wet for a plant that could live there.
  [[nodiscard]] bool someone_has_too_much(std::size_t cell) const {
    const float brightest = light_.most - stock_[cell].light_taken;
    const float wettest = water_.most - stock_[cell].water_taken;
    for (std::size_t i = 0; i < wanted_.size(); ++i) {
      const PlantTraits& plant = *wanted_[i].traits;
      const bool too_much = plant.illumination.high < brightest || plant.moisture.high < wettest;
      if (too_much && priority_[i].key(cell) < key_of_fitness(ceiling(cell, i))) return true;
    }
    return false;
  }

  const std::vector<Wanted>& wanted_;
  const PlantEnvironment& environment_;
  FloraFitness fitness_;
  int width_;
  int height_;
  std::vector<Stock> stock_;
  std::vector<std::uint8_t> fixed_;
  std::vector<Cover> cover_;
  std::vector<CellPriority> priority_;
  YearIntervals light_;
  YearIntervals water_;
  FloraFitness::Room room_;
  std::vector<std::uint8_t> keys_;
};

/// Cover that one stratum could hold if it were full everywhere, for the progress bar.
double most_cover(const std::vector<Wanted>& wanted, std::size_t cells) {
  std::array<bool, strata> present{};
  for (const Wanted& plant : wanted) present[std::size_t(plant.traits->stratum)] = true;
  return double(std::count(present.begin(), present.end(), true)) * double(cells) * full_cover;
}

}  // namespace

Result<std::vector<CoverMap>> compete_with_proportions(const FoodWeb& web, const PlantEnvironment& environment,
                                                       std::span<const double> desired, const TaskContext& context) {
  assert(desired.size() == web.levels[0].size());
  const Rect area = environment.maps->geology->rect();
  std::vector<CoverMap> covers(desired.size(), CoverMap(area.width(), area.height()));
  const std::vector<Wanted> wanted = wanted_plants(web, desired);
  if (wanted.empty()) return covers;

  context.report(stage, 0);
  Landscape landscape(wanted, environment);
  ShareChoice choice;
  for (const Wanted& plant : wanted) choice.add(desired[std::size_t(plant.plant)], plant.unit);
  const double most = most_cover(wanted, landscape.cells());
  for (std::int64_t units = 0;; ++units) {
    if (units % units_at_once == 0) {
      if (context.stopped()) return fail("Plant competition was stopped.");
      context.report(stage, double(choice.total()) / most);
    }
    const int next = choice.closest([&](std::size_t i) { return landscape.has_place(i); });
    if (next < 0) break;
    if (landscape.place(std::size_t(next))) choice.give(std::size_t(next));
  }
  parallel_each(wanted.size(), [&](std::size_t i) { covers[std::size_t(wanted[i].plant)] = landscape.cover_map(i); });
  context.report(stage, 1);
  return covers;
}

}  // namespace biotope

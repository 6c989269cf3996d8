#include "core/ecosystem/plant_shared_landscape.hpp"

#include <algorithm>

#include "core/base/parallel.hpp"

namespace biotope {

namespace {

/// Cells whose first keys one task finds.
constexpr std::size_t cells_at_once = 256;

/// Fitness in steps of 1/240 as a key: 0 for none, else at least 1.
std::uint8_t key_of_fitness(std::uint8_t fitness) {
  return fitness == 0 ? std::uint8_t(0) : std::uint8_t(std::max(1, (int(fitness) + share_key_step / 2) / share_key_step));
}

std::vector<const PlantTraits*> traits_of(const std::vector<WantedPlant>& wanted) {
  std::vector<const PlantTraits*> traits;
  for (const WantedPlant& plant : wanted) traits.push_back(plant.traits);
  return traits;
}

bool is_fed(const WantedPlant& plant, float light_taken, float water_taken, const YearIntervals& light,
            const YearIntervals& water) {
  return light.mean - light_taken > plant.light_taken && water.mean - water_taken > plant.water_taken;
}

}  // namespace

std::vector<WantedPlant> wanted_plants(const FoodWeb& web, std::span<const double> desired) {
  std::vector<WantedPlant> wanted;
  for (std::size_t i = 0; i < desired.size(); ++i) {
    if (!(desired[i] > 0)) continue;
    const PlantTraits& plant = web.species[std::size_t(web.levels[0][i])].plant();
    const Cover unit = unit_of(plant);
    wanted.push_back(
        {int(i), &plant, unit, unit_consumption(plant.light_consumption, unit), unit_consumption(plant.water_consumption, unit)});
  }
  return wanted;
}

SharedLandscape::SharedLandscape(const std::vector<WantedPlant>& wanted, const PlantEnvironment& environment,
                                 const CellList& cells)
    : wanted_(wanted),
      environment_(environment),
      cells_(cells),
      fitness_(traits_of(wanted)),
      years_(cells.size()),
      stock_(cells.size()),
      fixed_(cells.size() * wanted.size()),
      cover_(cells.size() * wanted.size()),
      priority_(wanted.size(), CellPriority(cells.size())),
      keys_(wanted.size()) {
  parallel_each((cells.size() + cells_at_once - 1) / cells_at_once, [&](std::size_t chunk) {
    std::vector<std::uint8_t> keys(wanted_.size());
    const std::size_t end = std::min(cells_.size(), (chunk + 1) * cells_at_once);
    for (std::size_t cell = chunk * cells_at_once; cell < end; ++cell) start_cell(cell, keys);
  });
  parallel_each(priority_.size(), [this](std::size_t i) { priority_[i].index_all(); });
}

SharedLandscape::Place SharedLandscape::place(std::size_t i) {
  CellPriority& priority = priority_[i];
  while (priority.best() > 0) {
    const std::size_t cell = priority.first_best();
    const std::uint8_t key = look_at(cell, i);
    if (key == priority.best()) {
      give_unit(cell, i);
      return {cell, key};
    }
    priority.set(cell, key);
  }
  return {};
}

CoverMap SharedLandscape::cover_map(std::size_t i, int width, int height) const {
  CoverMap map(width, height);
  for (std::size_t cell = 0; cell < cells_.size(); ++cell) {
    const Cover cover = cover_[cell * wanted_.size() + i];
    if (cover > 0) map.set(cells_[cell][0], cells_[cell][1], cover);
  }
  return map;
}

/// Fitness that nothing consumes, and with it the keys of an empty cell.
void SharedLandscape::start_cell(std::size_t cell, std::vector<std::uint8_t>& keys) {
  const auto [x, y] = cells_[cell];
  const std::span<std::uint8_t> fixed(fixed_.data() + cell * wanted_.size(), wanted_.size());
  const float texture = environment_.texture(x, y);
  const Geology geology = environment_.geology(x, y);
  for (std::size_t i = 0; i < wanted_.size(); ++i) {
    const PlantTraits& plant = *wanted_[i].traits;
    const float viability = plant.texture.contains(texture) ? plant.geology[std::size_t(geology)] : 0;
    fixed[i] = viability < least_fitness ? 0 : std::max(to_cover(viability), Cover(1));
  }
  if (std::ranges::all_of(fixed, [](std::uint8_t key) { return key == 0; })) return;
  FloraFitness::Room room;
  fitness_.limit(Resource::temperature, year_intervals(environment_.year(Resource::temperature, x, y)), 0, room, fixed);
  years_[cell].light = year_intervals(environment_.year(Resource::illumination, x, y));
  years_[cell].water = year_intervals(environment_.year(Resource::moisture, x, y));
  keys_of(cell, room, keys);
  for (std::size_t i = 0; i < wanted_.size(); ++i) priority_[i].put(cell, keys[i]);
}

/// The fitness, in steps of 1/240, that no shade and no thirst could raise: soil and temperature, own crowding, ground.
std::uint8_t SharedLandscape::ceiling(std::size_t cell, std::size_t i) const {
  const WantedPlant& plant = wanted_[i];
  if (stock_[cell].ground[std::size_t(plant.traits->stratum)] < plant.unit) return 0;
  const std::size_t at = cell * wanted_.size() + i;
  return std::min(fixed_[at], Cover(full_cover - cover_[at]));
}

/// Keys of all plants in a cell: fitness with what is left, 0 where a need of a unit is not available.
void SharedLandscape::keys_of(std::size_t cell, FloraFitness::Room& room, std::span<std::uint8_t> keys) const {
  const auto& [light, water] = years_[cell];
  const Stock& stock = stock_[cell];
  for (std::size_t i = 0; i < wanted_.size(); ++i) {
    keys[i] = is_fed(wanted_[i], stock.light_taken, stock.water_taken, light, water) ? ceiling(cell, i) : std::uint8_t(0);
  }
  fitness_.limit(Resource::illumination, light, stock.light_taken, room, keys);
  fitness_.limit(Resource::moisture, water, stock.water_taken, room, keys);
  for (std::uint8_t& key : keys) key = key_of_fitness(key);
}

/// The key of one plant in a cell as it is now.
std::uint8_t SharedLandscape::look_at(std::size_t cell, std::size_t i) {
  const std::uint8_t most = ceiling(cell, i);
  if (most == 0) return 0;
  const Stock& stock = stock_[cell];
  const auto& [light, water] = years_[cell];
  if (!is_fed(wanted_[i], stock.light_taken, stock.water_taken, light, water)) return 0;
  return key_of_fitness(std::min({most, fitness_.key_of(i, Resource::illumination, light, stock.light_taken),
                                  fitness_.key_of(i, Resource::moisture, water, stock.water_taken)}));
}

/// Gives a unit. Keys in the queues are upper bounds, looked at again when they come
/// first: what is taken makes a place worse, but for plants for which it was too bright or too wet.
void SharedLandscape::give_unit(std::size_t cell, std::size_t i) {
  const WantedPlant& plant = wanted_[i];
  Stock& stock = stock_[cell];
  const bool may_rise = someone_has_too_much(cell);
  stock.light_taken += plant.light_taken;
  stock.water_taken += plant.water_taken;
  stock.ground[std::size_t(plant.traits->stratum)] -= plant.unit;
  prefetch(cell + 1);
  cover_[cell * wanted_.size() + i] += plant.unit;
  priority_[i].set(cell, std::min(priority_[i].best(), key_of_fitness(ceiling(cell, i))));
  if (!may_rise) return;
  keys_of(cell, room_, keys_);
  for (std::size_t other = 0; other < wanted_.size(); ++other) {
    if (keys_[other] > priority_[other].key(cell)) priority_[other].set(cell, keys_[other]);
  }
}

/// Asks for what is known of a cell: plants mostly go from one cell to the next, but take turns, so that each finds its
/// next cell gone from the cache.
void SharedLandscape::prefetch(std::size_t cell) const {
  if (cell >= stock_.size()) return;
  __builtin_prefetch(&stock_[cell]);
  __builtin_prefetch(&years_[cell]);
  __builtin_prefetch(&fixed_[cell * wanted_.size()]);
  __builtin_prefetch(&cover_[cell * wanted_.size()]);
}

/// Whether a cell is, for part of the year, too bright or too wet for a plant that could live there.
bool SharedLandscape::someone_has_too_much(std::size_t cell) const {
  const float brightest = years_[cell].light.most - stock_[cell].light_taken;
  const float wettest = years_[cell].water.most - stock_[cell].water_taken;
  for (std::size_t i = 0; i < wanted_.size(); ++i) {
    const PlantTraits& plant = *wanted_[i].traits;
    const bool too_much = plant.illumination.high < brightest || plant.moisture.high < wettest;
    if (too_much && priority_[i].key(cell) < key_of_fitness(ceiling(cell, i))) return true;
  }
  return false;
}

}  // namespace biotope

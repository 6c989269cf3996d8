#include "core/ecosystem/plant_share_schedule.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstdint>
#include <tuple>

#include "core/base/random.hpp"
#include "core/ecosystem/plant_share_giving.hpp"

namespace biotope {

namespace {

constexpr std::uint64_t queue_hash = 0x706c616e74;  // tells these draws from all others

/// A unit that was given: when (number of the unit) and to which place in the queue.
struct GivenUnit {
  std::int64_t number = 0;
  float place = 0;
};
using UnitsByKey = std::array<std::vector<GivenUnit>, share_keys>;

/// When the queue of a key came to each knot: the first unit to a cell there or behind; where nobody stood there, at its end.
std::array<float, ShareSchedule::knots> moments_of(const std::vector<GivenUnit>& units, double all) {
  std::array<float, ShareSchedule::knots> moments;
  for (int knot = 0; knot < ShareSchedule::knots; ++knot) {
    const float place = float(knot) / float(ShareSchedule::knots - 1);
    const auto first = std::ranges::find_if(units, [&](const GivenUnit& unit) { return unit.place >= place; });
    moments[std::size_t(knot)] = float(double(first != units.end() ? first->number : units.back().number) / all);
  }
  return moments;
}

ShareSchedule::Plant schedule_of(int plant, const UnitsByKey& units, double all) {
  ShareSchedule::Plant schedule;
  schedule.plant = plant;
  float with_lower = 1;
  for (std::size_t key = 0; key < share_keys; ++key) {
    if (units[key].empty()) {
      schedule.moments[key].fill(with_lower);
    } else {
      schedule.moments[key] = moments_of(units[key], all);
      const auto time = double(units[key].back().number - units[key].front().number);
      schedule.pace[key] = float(time / (double(units[key].size()) * all));
      with_lower = schedule.moments[key].front();
    }
  }
  return schedule;
}

/// Side of the blocks of which each gives one cell.
int block_side(int width, int height) {
  int side = std::max(1, int(std::sqrt(double(width) * height / most_share_cells)));
  while (std::int64_t((width + side - 1) / side) * ((height + side - 1) / side) > most_share_cells) ++side;
  return side;
}

}  // namespace

float place_in_queue(int x, int y) {
  return float(random_bits({queue_hash, std::uint64_t(x), std::uint64_t(y)}) >> 40) * 0x1.0p-24F;
}

CellList share_sample(int width, int height) {
  const int side = block_side(width, height);
  CellList cells;
  for (int y = 0; y < height; y += side) {
    for (int x = 0; x < width; x += side) {
      const std::uint64_t column = std::uint64_t(x / side);
      const std::uint64_t row = std::uint64_t(y / side);
      cells.push_back({random_int(x, std::min(width, x + side) - 1, {queue_hash, column, row, 1}),
                       random_int(y, std::min(height, y + side) - 1, {queue_hash, column, row, 2})});
    }
  }
  std::ranges::sort(
      cells, {}, [](const std::array<int, 2>& cell) { return std::tuple(place_in_queue(cell[0], cell[1]), cell[1], cell[0]); });
  return cells;
}

Result<ShareSchedule> share_schedule(const FoodWeb& web, const PlantEnvironment& environment, std::span<const double> desired,
                                     const TaskContext& context) {
  assert(desired.size() == web.levels[0].size());
  const std::vector<WantedPlant> wanted = wanted_plants(web, desired);
  const Rect area = environment.maps->geology->rect();
  const CellList cells = share_sample(area.width(), area.height());
  SharedLandscape landscape(wanted, environment, cells);
  std::vector<UnitsByKey> units(wanted.size());
  std::int64_t given = 0;
  const auto note = [&](std::size_t i, SharedLandscape::Place place) {
    const auto [x, y] = cells[place.cell];
    units[i][std::size_t(place.key)].push_back({given++, place_in_queue(x, y)});
  };
  const Status done = give_out(landscape, wanted, desired, context, note);
  if (!done) return tl::unexpected<Error>(done.error());
  ShareSchedule schedule;
  for (std::size_t i = 0; i < wanted.size(); ++i) {
    schedule.plants.push_back(schedule_of(wanted[i].plant, units[i], double(std::max<std::int64_t>(given, 1))));
  }
  return schedule;
}

}  // namespace biotope

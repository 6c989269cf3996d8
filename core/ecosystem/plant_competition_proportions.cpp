#include <cassert>

#include "core/base/parallel.hpp"
#include "core/ecosystem/plant_competition.hpp"
#include "core/ecosystem/plant_share_giving.hpp"
#include "core/ecosystem/plant_share_schedule.hpp"
#include "core/ecosystem/plant_tiles.hpp"

namespace biotope {

namespace {

/// Paper algorithm 1 over all cells, in row order.
Result<std::vector<CoverMap>> compete_whole(const FoodWeb& web, const PlantEnvironment& environment,
                                            std::span<const double> desired, const TaskContext& context) {
  const Rect area = environment.maps->geology->rect();
  std::vector<CoverMap> covers(desired.size(), CoverMap(area.width(), area.height()));
  const std::vector<WantedPlant> wanted = wanted_plants(web, desired);
  CellList cells;
  for (int y = 0; y < area.height(); ++y) {
    for (int x = 0; x < area.width(); ++x) cells.push_back({x, y});
  }
  SharedLandscape landscape(wanted, environment, cells);
  if (Status done = give_out(landscape, wanted, desired, context, [](std::size_t, SharedLandscape::Place) {}); !done) {
    return tl::unexpected<Error>(done.error());
  }
  parallel_each(wanted.size(), [&](std::size_t i) {
    covers[std::size_t(wanted[i].plant)] = landscape.cover_map(i, area.width(), area.height());
  });
  return covers;
}

}  // namespace

Result<std::vector<CoverMap>> compete_with_proportions(const FoodWeb& web, const PlantEnvironment& environment,
                                                       std::span<const double> desired, const TaskContext& context) {
  assert(desired.size() == web.levels[0].size());
  context.report(plant_competition_stage, 0);
  const Rect area = environment.maps->geology->rect();
  if (!competes_by_schedule(area.width(), area.height())) return compete_whole(web, environment, desired, context);
  const auto schedule = share_schedule(web, environment, desired, context);
  if (!schedule) return tl::unexpected<Error>(schedule.error());
  return compete_by_schedule(web, environment, *schedule, context);
}

}  // namespace biotope

#include <algorithm>
#include <array>
#include <cassert>
#include <cstddef>
#include <vector>

#include "core/ecosystem/plant_competition_lanes.hpp"
#include "core/ecosystem/plant_share_schedule.hpp"
#include "core/ecosystem/plant_tiles.hpp"

namespace biotope {

namespace {

/// Later than every moment of a schedule.
constexpr float never = 2;

/// Where the cells of a batch stand between two knots of a queue.
struct QueuePlaces {
  std::array<std::size_t, batch_cells> knot{};
  std::array<float, batch_cells> part{};
};

QueuePlaces queue_places(int x, int y, int count) {
  QueuePlaces places;
  for (int lane = 0; lane < batch_cells; ++lane) {
    const float place = place_in_queue(x + std::min(lane, count - 1), y) * float(ShareSchedule::knots - 1);
    places.knot[std::size_t(lane)] = std::size_t(place);
    places.part[std::size_t(lane)] = place - float(int(place));
  }
  return places;
}

/// A plant's next unit in every cell of a batch.
struct Turn {
  Lanes moment{};
  Lanes pace{};
};

/// The moment at which a cell of this fitness (steps of 1/240; 0: no place) gets its unit, and how long it has to wait for
/// another.
BIOTOPE_INLINE Turn turn_of(const ShareSchedule::Plant& plant, const QueuePlaces& places, const Lanes& fitness) {
  Turn turn{lanes(never), {}};
  for (std::size_t lane = 0; lane < std::size_t(batch_cells); ++lane) {
    if (!(fitness[lane] > 0)) continue;
    const auto key = std::size_t(std::max(1, (int(fitness[lane]) + share_key_step / 2) / share_key_step));
    const float* const knot = plant.moments[key].data() + places.knot[lane];
    turn.moment[lane] = knot[0] + (knot[1] - knot[0]) * places.part[lane];
    turn.pace[lane] = plant.pace[key];
  }
  return turn;
}

/// What a batch that competes by a schedule needs between calls.
struct SharingBatch {
  SharingBatch(int plants, std::size_t most) : batch(plants, most), open(most) {}
  CompetitionBatch batch;
  /// By competitor, the earliest moment of its next unit.
  std::vector<LaneValues> open;
};

/// The competitor whose moment comes first in every lane: its number in the layer + 1, or 0. `now` is the moment of the last unit
/// in every lane, and becomes that of the next.
BIOTOPE_INLINE Lanes choose_first(const CompetitionPlan::Layer& layer, const ShareSchedule& schedule, const QueuePlaces& places,
                                  SharingBatch& sharing, const Left& left, Lanes& now) {
  const CompetitionBatch& batch = sharing.batch;
  Lanes first = lanes(never);
  Lanes pace{};
  Lanes chosen{};
  for (const int i : batch.active) {
    const Competitor& c = layer.competitors[std::size_t(i)];
    const Lanes fitness = where_fed(c, left, fitness_now(c, batch, std::size_t(i)));
    if (!any(fitness)) continue;
    const Turn turn = turn_of(schedule.plants[std::size_t(i)], places, fitness);
    const Lanes moment = larger(turn.moment, sharing.open[std::size_t(i)].v);
    const auto sooner = moment < first;
    chosen = sooner ? lanes(float(i + 1)) : chosen;
    pace = sooner ? turn.pace : pace;
    first = smaller(moment, first);
  }
  now = chosen > Lanes{} ? larger(now, first) : now;
  for (const int i : batch.active) {
    LaneValues& open = sharing.open[std::size_t(i)];
    open.v = chosen == float(i + 1) ? now + pace : open.v;
  }
  return chosen;
}

BIOTOPE_INLINE void compete_inline(const CompetitionPlan::Layer& layer, const ShareSchedule& schedule,
                                   const PlantEnvironment& environment, int x, int y, int count, SharingBatch& sharing) {
  CompetitionBatch& batch = sharing.batch;
  load_batch(environment, x, y, count, batch);
  const QueuePlaces places = queue_places(x, y, count);
  Left left = nothing_taken();
  Lanes now{};
  std::ranges::fill(sharing.open, LaneValues{});
  start_layer(layer, batch);
  while (!batch.active.empty()) {
    look_again(layer, batch, left);
    drop_hopeless(layer, batch, left);
    const Lanes chosen = choose_first(layer, schedule, places, sharing, left, now);
    if (!any(chosen)) return;
    give_units(layer, chosen, batch, left);
  }
}

#if defined(__x86_64__)
// The same operations in the same order whatever the width of the vectors: results are the same to the bit.
__attribute__((target("avx2"))) void compete_avx2(const CompetitionPlan::Layer& layer, const ShareSchedule& schedule,
                                                  const PlantEnvironment& environment, int x, int y, int count,
                                                  SharingBatch& batch) {
  compete_inline(layer, schedule, environment, x, y, count, batch);
}
#endif

void compete_batch(const CompetitionPlan::Layer& layer, const ShareSchedule& schedule, const PlantEnvironment& environment, int x,
                   int y, int count, SharingBatch& batch) {
#if defined(__x86_64__)
  if (__builtin_cpu_supports("avx2")) return compete_avx2(layer, schedule, environment, x, y, count, batch);
#endif
  compete_inline(layer, schedule, environment, x, y, count, batch);
}

CompetitionPlan::Layer wanted_layer(const FoodWeb& web, const ShareSchedule& schedule) {
  CompetitionPlan::Layer layer;
  for (const ShareSchedule::Plant& wanted : schedule.plants) {
    layer.add(wanted.plant, web.species[std::size_t(web.levels[0][std::size_t(wanted.plant)])].plant());
  }
  return layer;
}

}  // namespace

void compete_in_tile(const FoodWeb& web, const PlantEnvironment& environment, const ShareSchedule& schedule,
                     const Rect& tile_rect, std::span<CoverMap::Tile* const> out) {
  assert(out.size() == web.levels[0].size());
  const CompetitionPlan::Layer layer = wanted_layer(web, schedule);
  SharingBatch batch(int(out.size()), layer.competitors.size());
  compete_in_batches(tile_rect, batch.batch, out,
                     [&](int x, int y, int count) { compete_batch(layer, schedule, environment, x, y, count, batch); });
}

Result<std::vector<CoverMap>> compete_by_schedule(const FoodWeb& web, const PlantEnvironment& environment,
                                                  const ShareSchedule& schedule, const TaskContext& context) {
  return compete_everywhere(
      environment.maps->geology->rect(), int(web.levels[0].size()), context,
      [&](const Rect& rect, std::span<CoverMap::Tile* const> out) { compete_in_tile(web, environment, schedule, rect, out); });
}

}  // namespace biotope

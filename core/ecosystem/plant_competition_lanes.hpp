#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstring>
#include <span>

#include "core/ecosystem/plant_competition_kernel.hpp"

// What the rules of competition share: fitness and what is left of eight cells side by side. Everything is inlined, so that it is
// compiled for the vectors of its caller.

namespace biotope {

/// Fitness is counted in steps of 1/240 here, so that crowding (1 - own cover) is a whole number.
inline constexpr float fitness_steps = float(full_cover);
inline constexpr float steps_per_interval = fitness_steps / float(months);

/// Number of intervals (0..12, parts included) that lie below the lower end of a range. Often the whole year lies above it.
BIOTOPE_INLINE Lanes intervals_below(const IntervalLanes& resource, const Lanes& end) {
  Lanes sum{};
  if (!any(larger(end - resource.year_low.v, sum))) return sum;
  for (std::size_t m = 0; m < months; ++m) {
    sum += share((end - resource.low[m].v) * resource.inverse_length[m].v);
  }
  return sum;
}

/// Number of intervals (0..12, parts included) that lie above the upper end of a range. Often the whole year lies below it.
BIOTOPE_INLINE Lanes intervals_above(const IntervalLanes& resource, const Lanes& end) {
  Lanes sum{};
  if (!any(larger(resource.year_high.v - end, sum))) return sum;
  for (std::size_t m = 0; m < months; ++m) {
    sum += share((resource.high[m].v - end) * resource.inverse_length[m].v);
  }
  return sum;
}

BIOTOPE_INLINE Lanes fitness_from(const Lanes& below, const Lanes& above) {
  return (float(months) - below - above) * steps_per_interval;
}

/// Fitness by temperature, texture and geology, which no plant consumes.
BIOTOPE_INLINE Lanes fixed_fitness(const PlantTraits& plant, const CompetitionBatch& batch) {
  const IntervalLanes& warmth = batch.resources[std::size_t(Resource::temperature)];
  Lanes viability{};
  for (std::size_t c = 0; c < geology_classes; ++c) viability += batch.on_geology[c].v * plant.geology[c];
  const Lanes soil = viability * fitness_steps;
  const Lanes& texture = batch.texture.v;
  const Lanes none{};
  const Lanes on_soil = texture < plant.texture.low ? none : (texture > plant.texture.high ? none : soil);
  if (!any(on_soil)) return none;
  return smaller(on_soil, fitness_from(intervals_below(warmth, lanes(plant.temperature.low)),
                                       intervals_above(warmth, lanes(plant.temperature.high))));
}

/// What is left in the cells of a batch while their plants compete; the ground of a stratum in steps of 1/240.
struct Left {
  Lanes light_taken{};
  Lanes water_taken{};
  Lanes light{};  ///< of the yearly mean
  Lanes water{};
  std::array<LaneValues, strata> ground;
};

/// All the ground, light and water of a batch.
BIOTOPE_INLINE Left nothing_taken() {
  Left left;
  for (LaneValues& ground : left.ground) ground.v = lanes(float(full_cover));
  return left;
}

/// Sums over the year of the range ends that an active competitor has.
BIOTOPE_INLINE void sum_intervals(const IntervalLanes& resource, const RangeEnds& ends, const Lanes& taken, IntervalSums& sums) {
  for (std::size_t i = 0; i < ends.lows.size(); ++i) {
    if (sums.low_users[i] > 0) sums.below[i].v = intervals_below(resource, taken + ends.lows[i]);
  }
  for (std::size_t i = 0; i < ends.highs.size(); ++i) {
    if (sums.high_users[i] > 0) sums.above[i].v = intervals_above(resource, taken + ends.highs[i]);
  }
}

BIOTOPE_INLINE void count_user(IntervalSums& sums, int low, int high, int step) {
  sums.low_users[std::size_t(low)] += step;
  if (high >= 0) sums.high_users[std::size_t(high)] += step;
}

BIOTOPE_INLINE void count_competitor(const Competitor& c, CompetitionBatch& batch, int step) {
  count_user(batch.light_sums, c.light_low, c.light_high, step);
  count_user(batch.water_sums, c.water_low, c.water_high, step);
}

BIOTOPE_INLINE Lanes above_end(const IntervalSums& sums, int high) {
  return high < 0 ? Lanes{} : sums.above[std::size_t(high)].v;
}

BIOTOPE_INLINE Lanes at_least(const Lanes& fitness, float least) { return fitness < least ? Lanes{} : fitness; }

/// The value where a unit of ground, light and water is left for a competitor, else 0.
BIOTOPE_INLINE Lanes where_fed(const Competitor& c, const Left& left, const Lanes& value) {
  const Lanes none{};
  const Lanes lit = left.light > c.light_taken ? value : none;
  const Lanes watered = left.water > c.water_taken ? lit : none;
  return left.ground[c.stratum].v < c.unit ? none : watered;
}

/// Fitness of a competitor with what is left, 0 where a need is not available.
BIOTOPE_INLINE Lanes fitness_now(const Competitor& c, const CompetitionBatch& batch, std::size_t index) {
  const Lanes light = fitness_from(batch.light_sums.below[std::size_t(c.light_low)].v, above_end(batch.light_sums, c.light_high));
  const Lanes water = fitness_from(batch.water_sums.below[std::size_t(c.water_low)].v, above_end(batch.water_sums, c.water_high));
  const Lanes crowding = fitness_steps - batch.cover[std::size_t(c.plant)].v;
  const Lanes fitness = smaller(smaller(batch.fixed[index].v, light), smaller(water, crowding));
  return at_least(fitness, least_fitness * fitness_steps);
}

/// The best that a competitor's fitness can still become: what is taken never comes back, so what is too dark or too dry
/// stays so; what is too bright or too wet may change.
BIOTOPE_INLINE Lanes best_fitness(const Competitor& c, const CompetitionBatch& batch, std::size_t index) {
  const Lanes none{};
  const Lanes light = fitness_from(batch.light_sums.below[std::size_t(c.light_low)].v, none);
  const Lanes water = fitness_from(batch.water_sums.below[std::size_t(c.water_low)].v, none);
  return at_least(smaller(batch.fixed[index].v, smaller(light, water)), least_fitness * fitness_steps);
}

/// Finds the competitors that temperature, texture and geology allow somewhere in the batch.
BIOTOPE_INLINE void start_layer(const CompetitionPlan::Layer& layer, CompetitionBatch& batch) {
  batch.active.clear();
  batch.light_sums.forget_users();
  batch.water_sums.forget_users();
  for (std::size_t i = 0; i < layer.competitors.size(); ++i) {
    const Competitor& c = layer.competitors[i];
    batch.cover[std::size_t(c.plant)].v = Lanes{};
    batch.fixed[i].v = fixed_fitness(*c.traits, batch);
    if (!any(batch.fixed[i].v)) continue;
    batch.active.push_back(int(i));
    count_competitor(c, batch, 1);
  }
}

/// What is left now of the light and water of the year, and how long in the year there is too little or too much of them.
BIOTOPE_INLINE void look_again(const CompetitionPlan::Layer& layer, CompetitionBatch& batch, Left& left) {
  const IntervalLanes& light = batch.resources[std::size_t(Resource::illumination)];
  const IntervalLanes& water = batch.resources[std::size_t(Resource::moisture)];
  sum_intervals(light, layer.light, left.light_taken, batch.light_sums);
  sum_intervals(water, layer.water, left.water_taken, batch.water_sums);
  left.light = light.mean.v - left.light_taken;
  left.water = water.mean.v - left.water_taken;
}

/// Competitors that can nowhere in the batch grow any more leave.
BIOTOPE_INLINE void drop_hopeless(const CompetitionPlan::Layer& layer, CompetitionBatch& batch, const Left& left) {
  std::size_t staying = 0;
  for (const int i : batch.active) {
    const Competitor& c = layer.competitors[std::size_t(i)];
    if (any(where_fed(c, left, best_fitness(c, batch, std::size_t(i))))) {
      batch.active[staying++] = i;
    } else {
      count_competitor(c, batch, -1);
    }
  }
  batch.active.resize(staying);
}

/// One unit in every lane to the competitor whose number + 1 is chosen there.
BIOTOPE_INLINE void give_units(const CompetitionPlan::Layer& layer, const Lanes& chosen, CompetitionBatch& batch, Left& left) {
  const Lanes none{};
  for (const int i : batch.active) {
    const Competitor& c = layer.competitors[std::size_t(i)];
    const Lanes here = chosen == float(i + 1) ? lanes(1) : none;
    batch.cover[std::size_t(c.plant)].v += here * c.unit;
    left.ground[c.stratum].v -= here * c.unit;
    left.light_taken += here * c.light_taken;
    left.water_taken += here * c.water_taken;
  }
}

/// A row of a map in a batch: the value at x + lane, the last valid one repeated.
template <class T>
BIOTOPE_INLINE std::array<T, batch_cells> lane_row(const Grid<T>& grid, int x, int y, int count) {
  std::array<T, batch_cells> values{};
  const std::span<const T> row = grid.row(y);
  std::copy_n(row.data() + x, count, values.data());
  std::fill(values.begin() + count, values.end(), values[std::size_t(count) - 1]);
  return values;
}

BIOTOPE_INLINE LaneValues to_lanes(const std::array<float, batch_cells>& values) {
  LaneValues lane_values;
  std::memcpy(&lane_values.v, values.data(), sizeof(lane_values.v));
  return lane_values;
}

BIOTOPE_INLINE Lanes mean_of(const std::array<LaneValues, months>& values) {
  Lanes sum{};
  for (const LaneValues& month : values) sum += month.v;
  return sum / float(months);
}

/// Moves the months by the paint over their mean, as PlantEnvironment::cell does.
BIOTOPE_INLINE void paint_months(const PaintLayer& paint, int x, int y, int count, std::array<LaneValues, months>& values) {
  std::array<Paint, batch_cells> strokes{};
  paint.read_row(y, x, std::span(strokes.data(), std::size_t(count)));
  const Lanes mean = mean_of(values);
  Lanes shift{};
  for (int lane = 0; lane < batch_cells; ++lane) {
    const Paint& stroke = strokes[std::size_t(std::min(lane, count - 1))];
    shift[lane] = stroke.coverage * (stroke.value - mean[lane]);
  }
  for (LaneValues& month : values) month.v = smaller(larger(month.v + shift, lanes(1)), lanes(9));
}

BIOTOPE_INLINE void load_resource(const MonthlyMap& map, const PaintLayer* paint, int x, int y, int count,
                                  IntervalLanes& resource) {
  std::array<LaneValues, months> values;
  LaneValues layer;
  for (int month = 0; month < months; ++month) {
    if (month == 0 || map.layers.size() > 1) layer = to_lanes(lane_row(map.layer(month), x, y, count));
    values[std::size_t(month)].v = smaller(larger(layer.v + map.offset[std::size_t(month)], lanes(1)), lanes(9));
  }
  if (paint != nullptr) paint_months(*paint, x, y, count, values);
  resource.mean.v = mean_of(values);
  resource.year_low = resource.year_high = values[0];
  for (std::size_t m = 0; m < months; ++m) {
    const Lanes& next = values[(m + 1) % months].v;
    const Lanes low = smaller(values[m].v, next);
    const Lanes high = larger(values[m].v, next);
    const Lanes length = high - low;
    resource.low[m].v = low;
    resource.high[m].v = high;
    resource.year_low.v = smaller(resource.year_low.v, low);
    resource.year_high.v = larger(resource.year_high.v, high);
    resource.inverse_length[m].v = length > 0 ? 1 / length : lanes(point_slope);
  }
}

/// Lays paint over a row of soil, cell by cell as PlantEnvironment::cell does.
template <class T, class Lay>
BIOTOPE_INLINE void paint_soil(const PaintLayer& paint, int x, int y, int count, std::array<T, batch_cells>& values,
                               const Lay& lay) {
  std::array<Paint, batch_cells> strokes{};
  paint.read_row(y, x, std::span(strokes.data(), std::size_t(count)));
  for (std::size_t lane = 0; lane < std::size_t(batch_cells); ++lane) {
    values[lane] = lay(values[lane], strokes[std::min(lane, std::size_t(count) - 1)]);
  }
}

/// Reads batch_cells cells of row y from x on; cells from `count` on repeat the last one.
BIOTOPE_INLINE void load_batch(const PlantEnvironment& environment, int x, int y, int count, CompetitionBatch& batch) {
  const EnvironmentMaps& maps = *environment.maps;
  for (std::size_t r = 0; r < monthly_resources; ++r) {
    load_resource(maps.monthly[r], environment.paint[r].get(), x, y, count, batch.resources[r]);
  }
  std::array<float, batch_cells> texture = lane_row(*maps.texture, x, y, count);
  std::array<Geology, batch_cells> classes = lane_row(*maps.geology, x, y, count);
  if (environment.soil.texture) paint_soil(*environment.soil.texture, x, y, count, texture, painted_texture);
  if (environment.soil.geology) paint_soil(*environment.soil.geology, x, y, count, classes, painted_geology);
  batch.texture = to_lanes(texture);
  for (std::size_t c = 0; c < geology_classes; ++c) {
    for (int lane = 0; lane < batch_cells; ++lane) {
      batch.on_geology[c].v[lane] = classes[std::size_t(lane)] == Geology(c) ? 1.0F : 0.0F;
    }
  }
}

}  // namespace biotope

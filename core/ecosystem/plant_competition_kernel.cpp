#include "core/ecosystem/plant_competition_kernel.hpp"

#include <algorithm>
#include <cmath>
#include <cstring>

namespace biotope {

namespace {

/// Fitness is counted in steps of 1/240 here, so that crowding (1 - own cover) is a whole number.
constexpr float fitness_steps = float(full_cover);
constexpr float steps_per_interval = fitness_steps / float(months);

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

/// What is left in the cells of a batch while their plants compete.
struct Left {
  Lanes light_taken{};
  Lanes water_taken{};
  Lanes light{};  ///< of the yearly mean
  Lanes water{};
  Lanes ground{};  ///< of the layer
};

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
  return left.ground < c.unit ? none : watered;
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

/// The fittest competitor in every lane: its number + 1, or 0. Competitors that can nowhere grow any more leave.
BIOTOPE_INLINE Lanes choose_fittest(const CompetitionPlan::Layer& layer, CompetitionBatch& batch, const Left& left) {
  Lanes best{};
  Lanes chosen{};
  std::size_t staying = 0;
  for (const int i : batch.active) {
    const Competitor& c = layer.competitors[std::size_t(i)];
    if (!any(where_fed(c, left, best_fitness(c, batch, std::size_t(i))))) {
      count_competitor(c, batch, -1);
      continue;
    }
    batch.active[staying++] = i;
    const Lanes fitness = where_fed(c, left, fitness_now(c, batch, std::size_t(i)));
    chosen = fitness > best ? lanes(float(i + 1)) : chosen;
    best = larger(fitness, best);
  }
  batch.active.resize(staying);
  return chosen;
}

BIOTOPE_INLINE void give_units(const CompetitionPlan::Layer& layer, const Lanes& chosen, CompetitionBatch& batch, Left& left) {
  const Lanes none{};
  for (const int i : batch.active) {
    const Competitor& c = layer.competitors[std::size_t(i)];
    const Lanes here = chosen == float(i + 1) ? lanes(1) : none;
    batch.cover[std::size_t(c.plant)].v += here * c.unit;
    left.ground -= here * c.unit;
    left.light_taken += here * c.light_taken;
    left.water_taken += here * c.water_taken;
  }
}

BIOTOPE_INLINE void compete_layer(const CompetitionPlan::Layer& layer, CompetitionBatch& batch, Left& left) {
  const IntervalLanes& light = batch.resources[std::size_t(Resource::illumination)];
  const IntervalLanes& water = batch.resources[std::size_t(Resource::moisture)];
  start_layer(layer, batch);
  left.ground = lanes(float(full_cover));
  while (!batch.active.empty()) {
    sum_intervals(light, layer.light, left.light_taken, batch.light_sums);
    sum_intervals(water, layer.water, left.water_taken, batch.water_sums);
    left.light = light.mean.v - left.light_taken;
    left.water = water.mean.v - left.water_taken;
    const Lanes chosen = choose_fittest(layer, batch, left);
    if (!any(chosen)) return;
    give_units(layer, chosen, batch, left);
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

BIOTOPE_INLINE void compete_inline(const CompetitionPlan& plan, const PlantEnvironment& environment, int x, int y, int count,
                                   CompetitionBatch& batch) {
  load_batch(environment, x, y, count, batch);
  Left left;
  for (const CompetitionPlan::Layer& layer : plan.layers) compete_layer(layer, batch, left);
}

#if defined(__x86_64__)
// The same operations in the same order whatever the width of the vectors: results are the same to the bit.
__attribute__((target("avx2"))) void compete_avx2(const CompetitionPlan& plan, const PlantEnvironment& environment, int x, int y,
                                                  int count, CompetitionBatch& batch) {
  compete_inline(plan, environment, x, y, count, batch);
}
#endif

int position_of(std::vector<float>& ends, float end) {
  const auto found = std::find(ends.begin(), ends.end(), end);
  if (found != ends.end()) return int(found - ends.begin());
  ends.push_back(end);
  return int(ends.size()) - 1;
}

/// Positions of a range's ends in the lists of its layer, added where new.
void place_ends(Range range, RangeEnds& ends, int& low, int& high) {
  low = position_of(ends.lows, range.low);
  high = range.high < 9 ? position_of(ends.highs, range.high) : -1;
}

}  // namespace

Cover unit_of(const PlantTraits& plant) { return std::max(to_cover(plant.unit_cover), Cover(1)); }

float unit_consumption(float consumption_at_full_cover, Cover unit) {
  constexpr float exact = 65536;
  return std::round(consumption_at_full_cover * cover_fraction(unit) * exact) / exact;
}

CompetitionPlan competition_plan(const FoodWeb& web) {
  CompetitionPlan plan;
  if (web.levels.empty()) return plan;
  for (const int species : web.levels[0]) {
    const PlantTraits& plant = web.species[std::size_t(species)].plant();
    CompetitionPlan::Layer& layer = plan.layers[std::size_t(plant.stratum)];
    const Cover unit = unit_of(plant);
    Competitor competitor;
    competitor.plant = plan.plants++;
    competitor.traits = &plant;
    competitor.unit = float(unit);
    competitor.light_taken = unit_consumption(plant.light_consumption, unit);
    competitor.water_taken = unit_consumption(plant.water_consumption, unit);
    place_ends(plant.illumination, layer.light, competitor.light_low, competitor.light_high);
    place_ends(plant.moisture, layer.water, competitor.water_low, competitor.water_high);
    layer.competitors.push_back(competitor);
  }
  return plan;
}

CompetitionBatch::CompetitionBatch(const CompetitionPlan& plan) : cover(std::size_t(plan.plants)) {
  std::size_t most = 0;
  for (const CompetitionPlan::Layer& layer : plan.layers) most = std::max(most, layer.competitors.size());
  for (IntervalSums* sums : {&light_sums, &water_sums}) {
    sums->below.resize(most);
    sums->above.resize(most);
    sums->low_users.resize(most);
    sums->high_users.resize(most);
  }
  fixed.resize(most);
  active.reserve(most);
}

void compete_batch(const CompetitionPlan& plan, const PlantEnvironment& environment, int x, int y, int count,
                   CompetitionBatch& batch) {
#if defined(__x86_64__)
  if (__builtin_cpu_supports("avx2")) return compete_avx2(plan, environment, x, y, count, batch);
#endif
  compete_inline(plan, environment, x, y, count, batch);
}

}  // namespace biotope

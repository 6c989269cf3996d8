#include "core/ecosystem/plant_competition_kernel.hpp"

#include <algorithm>
#include <cmath>

#include "core/ecosystem/plant_competition_lanes.hpp"

namespace biotope {

namespace {

/// The fittest competitor in every lane: its number + 1, or 0.
BIOTOPE_INLINE Lanes choose_fittest(const CompetitionPlan::Layer& layer, const CompetitionBatch& batch, const Left& left) {
  Lanes best{};
  Lanes chosen{};
  for (const int i : batch.active) {
    const Competitor& c = layer.competitors[std::size_t(i)];
    const Lanes fitness = where_fed(c, left, fitness_now(c, batch, std::size_t(i)));
    chosen = fitness > best ? lanes(float(i + 1)) : chosen;
    best = larger(fitness, best);
  }
  return chosen;
}

BIOTOPE_INLINE void compete_layer(const CompetitionPlan::Layer& layer, CompetitionBatch& batch, Left& left) {
  start_layer(layer, batch);
  while (!batch.active.empty()) {
    look_again(layer, batch, left);
    drop_hopeless(layer, batch, left);
    const Lanes chosen = choose_fittest(layer, batch, left);
    if (!any(chosen)) return;
    give_units(layer, chosen, batch, left);
  }
}

BIOTOPE_INLINE void compete_inline(const CompetitionPlan& plan, const PlantEnvironment& environment, int x, int y, int count,
                                   CompetitionBatch& batch) {
  load_batch(environment, x, y, count, batch);
  Left left = nothing_taken();
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

void CompetitionPlan::Layer::add(int number, const PlantTraits& plant) {
  const Cover unit = unit_of(plant);
  Competitor competitor;
  competitor.plant = number;
  competitor.traits = &plant;
  competitor.stratum = std::size_t(plant.stratum);
  competitor.unit = float(unit);
  competitor.light_taken = unit_consumption(plant.light_consumption, unit);
  competitor.water_taken = unit_consumption(plant.water_consumption, unit);
  place_ends(plant.illumination, light, competitor.light_low, competitor.light_high);
  place_ends(plant.moisture, water, competitor.water_low, competitor.water_high);
  competitors.push_back(competitor);
}

CompetitionPlan competition_plan(const FoodWeb& web) {
  CompetitionPlan plan;
  if (web.levels.empty()) return plan;
  for (const int species : web.levels[0]) {
    const PlantTraits& plant = web.species[std::size_t(species)].plant();
    plan.layers[std::size_t(plant.stratum)].add(plan.plants++, plant);
  }
  return plan;
}

CompetitionBatch::CompetitionBatch(const CompetitionPlan& plan)
    : CompetitionBatch(plan.plants, std::max({plan.layers[0].competitors.size(), plan.layers[1].competitors.size(),
                                              plan.layers[2].competitors.size()})) {}

CompetitionBatch::CompetitionBatch(int plants, std::size_t most) : cover(std::size_t(plants)) {
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

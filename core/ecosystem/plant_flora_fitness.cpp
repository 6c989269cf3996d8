#include "core/ecosystem/plant_flora_fitness.hpp"

#include <algorithm>

namespace biotope {

namespace {

BIOTOPE_INLINE Lanes intervals_below(const YearIntervals& year, const Lanes& end) {
  Lanes below{};
  for (std::size_t m = 0; m < months; ++m) below += share((end - year.low[m]) * year.inverse_length[m]);
  return below;
}

BIOTOPE_INLINE Lanes intervals_above(const YearIntervals& year, const Lanes& end) {
  Lanes above{};
  for (std::size_t m = 0; m < months; ++m) above += share((year.high[m] - end) * year.inverse_length[m]);
  return above;
}

BIOTOPE_INLINE void sum_inline(const YearIntervals& year, float taken, std::span<const LaneValues> lows,
                               std::span<const LaneValues> highs, LaneValues* below, LaneValues* above) {
  for (std::size_t i = 0; i < lows.size(); ++i) below[i].v = intervals_below(year, lows[i].v + taken);
  for (std::size_t i = 0; i < highs.size(); ++i) above[i].v = intervals_above(year, highs[i].v + taken);
}

#if defined(__x86_64__)
__attribute__((target("avx2"))) void sum_avx2(const YearIntervals& year, float taken, std::span<const LaneValues> lows,
                                              std::span<const LaneValues> highs, LaneValues* below, LaneValues* above) {
  sum_inline(year, taken, lows, highs, below, above);
}
#endif

/// Sums over the year of the ends of ranges, in as many rows of lanes as there are ends.
void sum_by_end(const YearIntervals& year, float taken, std::span<const LaneValues> lows, std::span<const LaneValues> highs,
                LaneValues* below, LaneValues* above) {
#if defined(__x86_64__)
  if (__builtin_cpu_supports("avx2")) return sum_avx2(year, taken, lows, highs, below, above);
#endif
  sum_inline(year, taken, lows, highs, below, above);
}

/// Nearest whole step; what is enough to live is at least one.
std::uint8_t to_key(float intervals) {
  const float fitness = intervals * (float(full_cover) / float(months));
  return fitness < least_fitness * float(full_cover) ? std::uint8_t(0) : std::uint8_t(std::max(fitness + 0.5F, 1.0F));
}

float lane(const std::vector<LaneValues>& values, std::uint32_t at) { return values[at / lane_count].v[at % lane_count]; }

/// Lane of an end in a list of distinct ends, added where new.
std::uint32_t lane_of(std::vector<float>& ends, float end) {
  const auto found = std::find(ends.begin(), ends.end(), end);
  const auto at = std::uint32_t(found - ends.begin());
  if (found == ends.end()) ends.push_back(end);
  return at;
}

std::vector<LaneValues> in_lanes(const std::vector<float>& values) {
  std::vector<LaneValues> rows((values.size() + lane_count - 1) / lane_count);
  for (std::size_t i = 0; i < values.size(); ++i) rows[i / lane_count].v[i % lane_count] = values[i];
  return rows;
}

Range range_of(const PlantTraits& plant, std::size_t resource) {
  switch (Resource(resource)) {
    case Resource::illumination: return plant.illumination;
    case Resource::temperature: return plant.temperature;
    case Resource::moisture: return plant.moisture;
  }
  return {};
}

}  // namespace

YearIntervals year_intervals(const std::array<float, months>& year) {
  YearIntervals intervals;
  float sum = 0;
  for (std::size_t m = 0; m < months; ++m) sum += year[m];
  for (std::size_t m = 0; m < months; ++m) {
    const float next = year[m + 1 < months ? m + 1 : 0];
    intervals.low[m] = std::min(year[m], next);
    intervals.high[m] = std::max(year[m], next);
  }
  for (std::size_t m = 0; m < months; ++m) {
    const float length = intervals.high[m] - intervals.low[m];
    const float inverse = 1 / length;
    intervals.inverse_length[m] = length > 0 ? inverse : point_slope;
  }
  intervals.mean = sum / float(months);
  intervals.most = *std::max_element(year.begin(), year.end());
  return intervals;
}

FloraFitness::FloraFitness(std::span<const PlantTraits* const> plants) {
  for (std::size_t r = 0; r < monthly_resources; ++r) {
    std::vector<float> lows;
    std::vector<float> highs;
    for (const PlantTraits* plant : plants) {
      const Range range = range_of(*plant, r);
      ends_[r].low_of.push_back(lane_of(lows, range.low));
      ends_[r].high_of.push_back(lane_of(highs, range.high));
    }
    ends_[r].lows = in_lanes(lows);
    ends_[r].highs = in_lanes(highs);
  }
}

void FloraFitness::limit(Resource resource, const YearIntervals& year, float taken, Room& room,
                         std::span<std::uint8_t> keys) const {
  const Ends& ends = ends_[std::size_t(resource)];
  room.below.resize(ends.lows.size());
  room.above.resize(ends.highs.size());
  sum_by_end(year, taken, ends.lows, ends.highs, room.below.data(), room.above.data());
  for (std::size_t i = 0; i < keys.size(); ++i) {
    if (keys[i] == 0) continue;
    const float intervals = float(months) - lane(room.below, ends.low_of[i]) - lane(room.above, ends.high_of[i]);
    keys[i] = std::min(keys[i], to_key(intervals));
  }
}

std::uint8_t FloraFitness::key_of(std::size_t plant, Resource resource, const YearIntervals& year, float taken) const {
  const Ends& ends = ends_[std::size_t(resource)];
  const std::uint32_t low = ends.low_of[plant];
  const std::uint32_t high = ends.high_of[plant];
  LaneValues below;
  LaneValues above;
  sum_by_end(year, taken, {&ends.lows[low / lane_count], 1}, {&ends.highs[high / lane_count], 1}, &below, &above);
  return to_key(float(months) - below.v[low % lane_count] - above.v[high % lane_count]);
}

}  // namespace biotope

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

BIOTOPE_INLINE YearIntervals year_intervals_inline(const std::array<float, months>& year) {
  // Twelve months in two rows of lanes; the lanes beyond them hold the first months again.
  constexpr std::size_t room = std::size_t(2 * lane_count);
  std::array<float, room + 1> values{};
  std::copy(year.begin(), year.end(), values.begin());
  std::copy_n(year.begin(), room + 1 - months, values.begin() + months);
  std::array<float, room> low{};
  std::array<float, room> high{};
  std::array<float, room> inverse_length{};
  for (std::size_t first = 0; first < room; first += lane_count) {
    Lanes month;
    Lanes next;
    std::memcpy(&month, values.data() + first, sizeof(month));
    std::memcpy(&next, values.data() + first + 1, sizeof(next));
    const Lanes least = smaller(month, next);
    const Lanes most = larger(month, next);
    const Lanes length = most - least;
    const Lanes inverse = length > 0 ? 1 / length : lanes(point_slope);
    std::memcpy(low.data() + first, &least, sizeof(least));
    std::memcpy(high.data() + first, &most, sizeof(most));
    std::memcpy(inverse_length.data() + first, &inverse, sizeof(inverse));
  }
  YearIntervals intervals;
  std::copy_n(low.begin(), months, intervals.low.begin());
  std::copy_n(high.begin(), months, intervals.high.begin());
  std::copy_n(inverse_length.begin(), months, intervals.inverse_length.begin());
  float sum = 0;
  intervals.most = year.front();
  for (const float value : year) {
    sum += value;
    intervals.most = std::max(intervals.most, value);
  }
  intervals.mean = sum / float(months);
  return intervals;
}

#if defined(__x86_64__)
__attribute__((target("avx2"))) YearIntervals year_intervals_avx2(const std::array<float, months>& year) {
  return year_intervals_inline(year);
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
    case Resource::illumination:
      return plant.illumination;
    case Resource::temperature:
      return plant.temperature;
    case Resource::moisture:
      return plant.moisture;
  }
  return {};
}

}  // namespace

YearIntervals year_intervals(const std::array<float, months>& year) {
#if defined(__x86_64__)
  if (__builtin_cpu_supports("avx2")) return year_intervals_avx2(year);
#endif
  return year_intervals_inline(year);
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

#include "render/animal_members.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/base/random.hpp"

namespace biotope {

namespace {

/// What all members of a herd share.
struct HerdFrame {
  const MapsSnapshot& maps;
  const DailyPlan& plan;
  const GraphLevel& graph;
  std::uint64_t seed;
  float body_length;
  double flat_speed;  ///< m/s
  double cell;
};

double unit(const HerdFrame& herd, std::uint64_t member, std::uint64_t what) { return random_unit({herd.seed, member, what}); }

glm::dvec2 metres(const HerdFrame& herd, PathPoint at) {
  return {(double(at.x) + 0.5) * herd.cell, (herd.maps.terrain().height.height() - 0.5 - double(at.y)) * herd.cell};
}

float depth_at(const HerdFrame& herd, glm::dvec2 place) {
  if (!herd.maps.hydrology) return 0;
  const auto& depth = herd.maps.hydrology->water_depth;
  return depth.clamped(int(place.x / herd.cell), depth.height() - 1 - int(place.y / herd.cell));
}

/// How much a herd is on its way, 0 standing about .. 1 walking in file, over a stretch of time. It is averaged over two minutes, so that
/// animals gather and scatter at a walk.
class March {
 public:
  March(const HerdFrame& herd, double from_hour, double until_hour)
      : first_(std::int64_t(std::floor(from_hour * steps_per_hour)) - reach) {
    const auto last = std::int64_t(std::ceil(until_hour * steps_per_hour)) + reach + 1;
    for (std::int64_t step = first_; step <= last; ++step) {
      const HerdState state = herd_state(herd.plan, herd.graph, double(step) / steps_per_hour, herd.cell);
      samples_.push_back(std::clamp((double(state.speed) - 0.12) / 0.5, 0.0, 1.0));
    }
  }

  [[nodiscard]] double at(double hour) const {
    const double step = hour * steps_per_hour - double(first_);
    const auto below = std::size_t(step);
    const double share = step - double(below);
    return mean_around(below) * (1 - share) + mean_around(below + 1) * share;
  }

 private:
  static constexpr double steps_per_hour = 180;
  static constexpr std::int64_t reach = 3;

  [[nodiscard]] double mean_around(std::size_t middle) const {
    double sum = 0;
    for (std::size_t i = middle - reach; i <= middle + reach; ++i) sum += samples_[std::min(i, samples_.size() - 1)];
    return sum / double(2 * reach + 1);
  }

  std::int64_t first_;
  std::vector<double> samples_;
};

/// Hours by which a member trails the first. A constant time, so that nobody jumps when the slope changes the herd's pace.
double lag(const HerdFrame& herd, std::uint64_t number) {
  const double metres_behind = 1.5 * double(herd.body_length) * (double(number) * 0.55 + 0.6 * unit(herd, number, 1));
  return metres_behind / herd.flat_speed / 3600;
}

HerdMember member_at(const HerdFrame& herd, const March& marching, std::uint64_t number, double hour) {
  const double lag_hours = lag(herd, number);
  const HerdState state = herd_state(herd.plan, herd.graph, hour - lag_hours, herd.cell);
  const double march = marching.at(hour - lag_hours);

  const double spread = double(herd.body_length) * (1.6 + 1.9 * std::sqrt(double(herd.plan.size)));
  const double radius = spread * std::sqrt(unit(herd, number, 2)) * (1 - march);
  const double bearing = 2 * std::numbers::pi * unit(herd, number, 3);
  const glm::dvec2 ahead{std::sin(double(state.heading)), std::cos(double(state.heading))};
  const glm::dvec2 aside{ahead.y, -ahead.x};
  const double lane = (unit(herd, number, 4) - 0.5) * double(herd.body_length) * 1.6 * march;

  HerdMember member;
  const glm::dvec2 path = metres(herd, state.at);
  member.place = path + aside * lane + glm::dvec2(std::cos(bearing), std::sin(bearing)) * radius;
  const double width = herd.maps.terrain().width_metres();
  const double height = herd.maps.terrain().height_metres();
  member.place = glm::clamp(member.place, glm::dvec2(0.5), glm::dvec2(width - 0.5, height - 0.5));
  if (depth_at(herd, member.place) > depth_at(herd, path) + 0.05F) member.place = path + aside * (lane * 0.5);

  const double turned = (unit(herd, number, 5) - 0.5) * 2.6 + 0.35 * std::sin(hour * 21 + 6.3 * unit(herd, number, 6));
  member.heading = state.heading + float(turned * (1 - march));
  member.speed = state.speed * float(march);
  member.walked = float(herd.flat_speed * 3600 * (hour - lag_hours));
  const double nod = std::sin(hour * 40 + 6.3 * unit(herd, number, 7));
  const bool feeds = state.activity == HerdActivity::feeding || state.activity == HerdActivity::drinking;
  member.head_down = float((feeds ? std::clamp(0.75 + 0.8 * nod, 0.0, 1.0) : 0.1) * (1 - march));
  member.size = float(0.9 + 0.2 * unit(herd, number, 8));
  return member;
}

/// Share of a species' growth that nobody ate: herds with surplus have more young.
double young_share(const HerdFrame& herd) {
  const auto& species = herd.maps.web->species[std::size_t(herd.plan.species)].animal();
  return std::clamp(double(species.growth_rate) * 0.6, 0.0, 0.35);
}

}  // namespace

std::vector<HerdMember> herd_members(const MapsSnapshot& maps, const DailyPlan& plan, std::size_t plan_number, double hour) {
  const auto& species = maps.web->species[std::size_t(plan.species)].animal();
  const HerdFrame herd{maps,
                       plan,
                       maps.graph->levels[std::size_t(plan.level)],
                       random_bits({maps.document.seed, 0xbea57, plan_number}),
                       species.shape.body_length,
                       std::max(0.2, double(species.speed)),
                       maps.terrain().cell_size};
  const March marching(herd, hour - lag(herd, std::uint64_t(plan.size)), hour);
  std::vector<HerdMember> members;
  members.reserve(std::size_t(plan.size));
  for (int i = 0; i < plan.size; ++i) {
    members.push_back(member_at(herd, marching, std::uint64_t(i), hour));
    if (unit(herd, std::uint64_t(i), 9) < young_share(herd)) members.back().size *= 0.62F;
  }
  return members;
}

}  // namespace biotope

#include "core/movement/herd_stays.hpp"

#include <algorithm>
#include <cmath>
#include <tuple>

namespace biotope {

namespace {

/// Herds that drink at one bank share it as far as they look for room there, m. Our choice.
constexpr double shared_bank = 30;

/// Whether two stretches of hours meet within a day that repeats.
bool meet(const HerdStay& a, const HerdStay& b) {
  const auto after = [](double hours) { return hours - 24 * std::floor(hours / 24); };
  return after(b.arrive - a.arrive) < a.leave - a.arrive || after(a.arrive - b.arrive) < b.leave - b.arrive;
}

double reach_of(const HerdStay& stay) { return herd_radius(stay.body_length, stay.members) + (stay.at_water ? shared_bank : 0); }

}  // namespace

double herd_radius(double body_length, int members) { return 1.3 * body_length * std::sqrt(double(std::max(1, members))); }

HerdStays::HerdStays(const HerdWorld& world) {
  for (std::size_t p = 0; p < world.plans->size(); ++p) {
    const DailyPlan& plan = (*world.plans)[p];
    if (plan.way.empty() || plan.size <= 0) continue;
    const GraphLevel& graph = world.graph_of(plan);
    for (std::size_t stop = 0; stop < plan.stops.size(); ++stop) {
      const double arrive = double(plan.stops[stop].arrive);
      const double leave = double(plan.stops[stop].leave);
      HerdStay stay{int(p), stop, world.place_of(world.state(plan, 0.5 * (arrive + leave) * 3600).at), arrive, leave};
      stay.body_length = std::max(0.2, double(world.traits(plan).shape.body_length));
      stay.members = plan.size;
      stay.at_water = graph.nodes[std::size_t(plan.stops[stop].node)].kind == NodeKind::bank;
      widest_ = std::max(widest_, reach_of(stay));
      stays_.push_back(stay);
    }
  }
  std::sort(stays_.begin(), stays_.end(), [](const HerdStay& a, const HerdStay& b) {
    return std::tie(a.centre.x, a.plan, a.stop) < std::tie(b.centre.x, b.plan, b.stop);
  });
}

std::vector<HerdStay> HerdStays::before(int plan, std::size_t stop) const {
  const auto own =
      std::find_if(stays_.begin(), stays_.end(), [&](const HerdStay& stay) { return stay.plan == plan && stay.stop == stop; });
  std::vector<HerdStay> found;
  if (own == stays_.end()) return found;
  const double farthest = widest_ + reach_of(*own);
  const auto first = std::lower_bound(stays_.begin(), stays_.end(), own->centre.x - farthest,
                                      [](const HerdStay& stay, double x) { return stay.centre.x < x; });
  for (auto other = first; other != stays_.end() && other->centre.x <= own->centre.x + farthest; ++other) {
    if (other->plan >= plan || other->at_water != own->at_water || !meet(*own, *other)) continue;
    if (length(other->centre - own->centre) < reach_of(*own) + reach_of(*other)) found.push_back(*other);
  }
  std::sort(found.begin(), found.end(),
            [](const HerdStay& a, const HerdStay& b) { return std::tie(a.plan, a.stop) < std::tie(b.plan, b.stop); });
  return found;
}

}  // namespace biotope

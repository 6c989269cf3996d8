#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iterator>

#include "core/movement/daily_plan.hpp"

namespace biotope {
namespace {

/// The hour within the 24 that begin at `first`.
double hour_within_day(double hour, double first) {
  const double from_first = hour - first;
  // Nearly always within a day already: a division less.
  const double offset = std::abs(from_first) < 24 ? from_first : std::fmod(from_first, 24.0);
  return first + (offset < 0 ? offset + 24 : offset);
}

bool within(double hour, double from, double until) { return hour_within_day(hour, from) < until; }

float heading_of(PathPoint a, PathPoint b) {
  // Clockwise from north; rows grow to the south.
  const float angle = std::atan2(b.x - a.x, a.y - b.y);
  return angle < 0 ? angle + 6.28318531F : angle;
}

bool moves(const DailyPlan& plan, std::size_t i) {
  return plan.way[i].at.x != plan.way[i + 1].at.x || plan.way[i].at.y != plan.way[i + 1].at.y;
}

HerdActivity activity_at(const DailyPlan& plan, const GraphLevel& graph, double hour) {
  const bool active = std::any_of(plan.active.begin(), plan.active.end(), [&](const DailyPlan::Span& span) {
    return within(hour, double(span.from), double(span.until));
  });
  for (const PlanStop& stop : plan.stops) {
    if (!within(hour, double(stop.arrive), double(stop.leave))) continue;
    const NodeKind kind = graph.nodes[std::size_t(stop.node)].kind;
    if (kind == NodeKind::bank) return HerdActivity::drinking;
    if (!active || kind == NodeKind::waypoint) return HerdActivity::resting;
    return kind == NodeKind::prey ? HerdActivity::hunting : HerdActivity::feeding;
  }
  return plan.stops.empty() ? HerdActivity::resting : HerdActivity::walking;
}

}  // namespace

const HerdPursuit* pursuit_at(const DailyPlan& plan, double hour) {
  if (plan.pursuits.empty() || plan.way.empty()) return nullptr;
  const double at = hour_within_day(hour, double(plan.way.front().hour));
  const auto after = std::upper_bound(plan.pursuits.begin(), plan.pursuits.end(), at,
                                      [](double h, const HerdPursuit& pursuit) { return h < double(pursuit.from); });
  if (after == plan.pursuits.begin()) return nullptr;
  const HerdPursuit& pursuit = *std::prev(after);
  return at <= double(pursuit.until) ? &pursuit : nullptr;
}

HerdState herd_state(const DailyPlan& plan, const GraphLevel& graph, double hour, double cell_size) {
  HerdState state;
  if (plan.way.empty()) return state;
  const double at = hour_within_day(hour, double(plan.way.front().hour));
  state.activity = activity_at(plan, graph, at);
  const auto after = std::upper_bound(plan.way.begin(), plan.way.end(), at,
                                      [](double h, const DailyPlan::Waypoint& point) { return h < double(point.hour); });
  if (after == plan.way.end() || after == plan.way.begin()) {
    state.at = plan.way.back().at;
    return state;
  }
  const auto i = std::size_t(after - plan.way.begin()) - 1;
  const DailyPlan::Waypoint& a = plan.way[i];
  const DailyPlan::Waypoint& b = plan.way[i + 1];
  const double duration = double(b.hour) - double(a.hour);
  const auto t = float((at - double(a.hour)) / duration);
  state.at = {a.at.x + (b.at.x - a.at.x) * t, a.at.y + (b.at.y - a.at.y) * t};
  state.speed = float(std::hypot(double(b.at.x - a.at.x), double(b.at.y - a.at.y)) * cell_size / (duration * 3600));
  // A herd that stands looks where it walked last.
  std::size_t segment = i;
  for (std::size_t back = 0; back < plan.way.size() && !moves(plan, segment); ++back) {
    segment = segment == 0 ? plan.way.size() - 2 : segment - 1;
  }
  if (moves(plan, segment)) state.heading = heading_of(plan.way[segment].at, plan.way[segment + 1].at);
  return state;
}

}  // namespace biotope

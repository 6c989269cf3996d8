#include "ui/activity_curve.hpp"

namespace biotope {

std::vector<float> activity_curve(const MapsSnapshot& snapshot) {
  constexpr int steps = 48;
  if (!snapshot.plans || !snapshot.graph) return {};
  std::vector<float> active(steps, 0);
  float total = 0;
  for (const DailyPlan& plan : *snapshot.plans) {
    if (std::size_t(plan.level) >= snapshot.graph->levels.size()) continue;
    total += float(plan.size);
    const GraphLevel& graph = snapshot.graph->levels[std::size_t(plan.level)];
    for (int step = 0; step < steps; ++step) {
      const HerdState state = herd_state(plan, graph, 24.0 * (step + 0.5) / steps, snapshot.terrain().cell_size);
      if (state.activity != HerdActivity::resting) active[std::size_t(step)] += float(plan.size);
    }
  }
  if (total <= 0) return {};
  for (float& value : active) value /= total;
  return active;
}

}  // namespace biotope

#include <algorithm>

#include "core/movement/walk_cost.hpp"
#include "core/movement/walkers.hpp"

namespace biotope {
namespace {

constexpr double worn_quantile = 0.3;

double quantile_of_positive(const std::vector<double>& weight, double quantile) {
  std::vector<double> positive;
  std::copy_if(weight.begin(), weight.end(), std::back_inserter(positive), [](double w) { return w > 0; });
  if (positive.empty()) return 0;
  const auto at = positive.begin() + std::ptrdiff_t(quantile * double(positive.size() - 1));
  std::nth_element(positive.begin(), at, positive.end());
  return *at;
}

std::vector<std::uint16_t> stays_of(const TravelGraph& graph, std::span<const WalkSource> sources) {
  std::vector<std::uint16_t> stays(graph.vertices.size(), 0);
  for (const WalkSource& source : sources) stays[source.vertex] = 1;
  return stays;
}

}  // namespace

std::vector<float> worn_share(const std::vector<double>& weight) {
  const double half = quantile_of_positive(weight, worn_quantile);
  std::vector<float> share(weight.size(), 0.0F);
  for (std::size_t e = 0; e < weight.size(); ++e) {
    if (weight[e] > 0) share[e] = float(weight[e] / (weight[e] + half));
  }
  return share;
}

std::vector<double> walked_weight(const TravelGraph& graph, std::span<const float> cost, std::span<const Walkers> walkers) {
  const std::vector<WalkSource> sources = walk_sources(walkers);
  std::vector<double> weight(graph.edge_count, 0.0);
  add_walks(graph, cost, walkers, sources, stays_of(graph, sources), weight);
  return weight;
}

std::vector<double> gathered_weight(const TravelGraph& graph, std::span<const float> cost, std::span<const Walkers> walkers) {
  std::vector<WalkSource> sources = walk_sources(walkers);
  const std::vector<std::uint16_t> stays = stays_of(graph, sources);
  std::stable_sort(sources.begin(), sources.end(), [](const WalkSource& a, const WalkSource& b) { return a.yearly > b.yearly; });
  std::vector<float> worn_cost(cost.begin(), cost.end());
  std::vector<double> weight(graph.edge_count, 0.0);
  const auto wear = [&] {
    const std::vector<float> share = worn_share(weight);
    for (std::size_t slot = 0; slot < worn_cost.size(); ++slot) worn_cost[slot] = cost[slot] * (1 - (1 - worn_factor) * share[graph.edge[slot]]);
  };
  // One source, then as many as have walked: the first ways decide where trails run. A quarter of them is enough to show where.
  for (std::size_t first = 0; first * 4 < sources.size();) {
    const std::size_t count = std::min(sources.size() - first, std::max<std::size_t>(1, first));
    add_walks(graph, worn_cost, walkers, std::span(sources).subspan(first, count), stays, weight);
    wear();
    first += count;
  }
  std::fill(weight.begin(), weight.end(), 0.0);
  add_walks(graph, worn_cost, walkers, sources, stays, weight);
  return weight;
}

}  // namespace biotope

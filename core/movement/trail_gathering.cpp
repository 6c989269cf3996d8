#include <algorithm>

#include "core/movement/walk_cost.hpp"
#include "core/movement/walkers.hpp"

namespace biotope {
namespace {

constexpr double worn_quantile = 0.3;
/// Sources that walk before the others, and that walk in the end, at most: where there are more, some stand for all. Our choice.
constexpr std::size_t most_leaders = 48;
constexpr std::size_t most_sources = 144;

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

/// The sources that send most, and of the others evenly so many as are allowed, each for several.
std::vector<WalkSource> sampled(std::vector<WalkSource> sources) {
  if (sources.size() <= most_sources) return sources;
  constexpr std::size_t sure = most_sources / 2;
  constexpr std::size_t drawn = most_sources - sure;
  const std::size_t others = sources.size() - sure;
  std::vector<WalkSource> result(sources.begin(), sources.begin() + sure);
  for (std::size_t i = 0; i < drawn; ++i) {
    result.push_back(std::move(sources[sure + (2 * i + 1) * others / (2 * drawn)]));
    result.back().stands_for = double(others) / double(drawn);
  }
  return result;
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
  const std::vector<std::uint16_t> stays = stays_of(graph, sources);
  WalkSum sum(graph, cost, walkers, stays);
  sum.add(sources);
  return sum.weight();
}

GatheredWalks gather_walks(const TravelGraph& graph, std::vector<float> cost, std::span<const Walkers> walkers) {
  std::vector<WalkSource> sources = walk_sources(walkers);
  const std::vector<std::uint16_t> stays = stays_of(graph, sources);
  std::stable_sort(sources.begin(), sources.end(), [](const WalkSource& a, const WalkSource& b) { return a.yearly > b.yearly; });
  GatheredWalks gathered{{}, cost};
  WalkSum sum(graph, gathered.worn_cost, walkers, stays);
  const auto wear = [&] {
    gathered.weight = sum.weight();
    const std::vector<float> share = worn_share(gathered.weight);
    for (std::size_t slot = 0; slot < cost.size(); ++slot) {
      gathered.worn_cost[slot] = cost[slot] * (1 - (1 - worn_factor) * share[graph.edge[slot]]);
    }
  };
  // One source, then as many as have walked: the first ways decide where trails run. A quarter of them is enough to show where.
  const std::size_t leaders = std::min(most_leaders, (sources.size() + 3) / 4);
  for (std::size_t first = 0; first < leaders;) {
    const std::size_t count = std::min(sources.size() - first, std::max<std::size_t>(1, first));
    sum.add(std::span(sources).subspan(first, count));
    wear();
    first += count;
  }
  sum.clear();
  sum.add(sampled(std::move(sources)));
  wear();
  return gathered;
}

}  // namespace biotope

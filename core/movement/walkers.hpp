#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "core/movement/trails.hpp"

namespace biotope {

/// Two resources are never less than this apart, s: within it a herd grazes from one to the other. Our choice.
inline constexpr float shortest_walk = 60;

/// A search from a resource ends once this many resources are reached: beyond, the inverse travel time of eq. 2 leaves next to nothing, and
/// the work grows with the number of resources only. Our choice.
inline constexpr std::uint32_t searched_nodes = 64;

/// All animals of one species in one region, as they wear the ground.
struct Walkers {
  /// ||s|| m_s of eq. 3 times walks per year: kg x trips per year.
  double yearly = 0;
  float speed = 1;
  /// Where they stay, with the probability of presence.
  struct Stay {
    std::uint32_t vertex = 0;
    float probability = 0;
  };
  std::vector<Stay> stays;
};

/// The walkers of one travel graph of a level (levels[i] with movement[i]). A predator's presence on a region of prey is spread over the
/// places where that prey is, so that predators wear the trails of what they follow.
[[nodiscard]] std::vector<Walkers> walkers_of_graph(const FoodWeb& web, std::span<const std::shared_ptr<const AnimalLevel>> levels,
                                                    std::span<const LevelMovement> movement, std::size_t level, std::size_t graph);

/// All stays at one vertex: where walks begin.
struct WalkSource {
  std::uint32_t vertex = 0;
  /// Walkers (indices) that stay here.
  std::vector<std::size_t> walkers;
  /// kg x trips per year that set out.
  double yearly = 0;
  /// So many like it; their walks are laid on its ways.
  double stands_for = 1;
};
[[nodiscard]] std::vector<WalkSource> walk_sources(std::span<const Walkers> walkers);

/// Sums what walks leave on the undirected edges of a graph (eq. 3) when they take the cheapest ways under `cost` to the stays marked 1 in `stays`
/// (by vertex). The same for any number of threads. What is passed in must outlive it; costs may change between calls.
class WalkSum {
 public:
  WalkSum(const TravelGraph& graph, std::span<const float> cost, std::span<const Walkers> walkers, std::span<const std::uint16_t> stays);
  ~WalkSum();

  /// Adds the walks from some sources.
  void add(std::span<const WalkSource> sources);
  /// By undirected edge.
  [[nodiscard]] std::vector<double> weight() const;
  void clear();

 private:
  struct Part;
  const TravelGraph& graph_;
  std::span<const float> cost_;
  std::span<const Walkers> walkers_;
  std::span<const std::uint16_t> stays_;
  std::vector<std::unique_ptr<Part>> parts_;
};

/// Weight (eq. 3) of every undirected edge when all walkers take the cheapest ways under `cost`.
[[nodiscard]] std::vector<double> walked_weight(const TravelGraph& graph, std::span<const float> cost, std::span<const Walkers> walkers);

/// Weights, and the costs of directed edges once they are worn.
struct GatheredWalks {
  std::vector<double> weight;
  std::vector<float> worn_cost;
};
/// The same when walks are drawn to worn ground: a quarter of the sources, those that send most, walk first, and what they have worn costs
/// the next less, so that ways gather to trails; then all walk on what was worn in the end. Where there are very many sources some stand for all.
[[nodiscard]] GatheredWalks gather_walks(const TravelGraph& graph, std::vector<float> cost, std::span<const Walkers> walkers);

/// How worn edges are by their weight, 0..1: half at the 30 % quantile of the walked edges. Our choice.
[[nodiscard]] std::vector<float> worn_share(const std::vector<double>& weight);

}  // namespace biotope

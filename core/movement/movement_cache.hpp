#pragma once

#include <cstdint>
#include <memory>
#include <unordered_map>
#include <utility>
#include <vector>

#include "core/ecosystem/confinement.hpp"
#include "core/movement/fine_path.hpp"
#include "core/movement/travel.hpp"
#include "core/movement/travel_blocks.hpp"

namespace biotope {

/// By node: nodes that a search from it reached, with what the way takes (metres of flat walking). Empty where no search was
/// made.
struct ReachedNode {
  int node = 0;
  float cost = 0;
};
using ReachedNodes = std::vector<std::vector<ReachedNode>>;

/// What movement found before and may need again: pure memoisation, results are the same with and without it. Entries that two
/// runs in a row did not use are dropped. For one run at a time.
class MovementCache {
 public:
  /// The graph of a mobility over regions with the same labels; built when there is none.
  [[nodiscard]] std::shared_ptr<const TravelGraph> graph(const Ground& ground,
                                                         const std::shared_ptr<const ConfinementRegions>& regions,
                                                         const Mobility& mobility, int block);
  /// What searches over a graph by these costs found between nodes at these vertices; null when it is not known.
  [[nodiscard]] const ReachedNodes* reached(const TravelGraph& graph, std::span<const float> cost,
                                            const std::vector<std::int32_t>& vertices) const;
  void keep_reached(const TravelGraph& graph, std::span<const float> cost, const std::vector<std::int32_t>& vertices,
                    ReachedNodes reached);
  /// Ends a run of a level over its mobilities: forgets graphs of the level that neither it nor the run before used.
  void end_graphs(std::span<const std::shared_ptr<const TravelGraph>> used, int level);

  /// Begins a run over fine paths in tubes of blocks of this side, and notes in which blocks the ground is another than in the
  /// run before; forgets all when it has another size.
  void begin_paths(const Ground& ground, int block);
  /// Key of a fine path: its ends, what may count for it of the ground, with what is open there, and who walks. In a run over
  /// fine paths.
  [[nodiscard]] std::uint64_t path_key(const FineGround& ground, const Tube& tube, PathCell from, PathCell to,
                                       const Mobility& mobility) const;
  /// The cells found under a key (see path_key); null when it is not known. Safe from several threads while none is kept.
  [[nodiscard]] const std::vector<PathCell>* path(std::uint64_t key) const;
  /// Notes that a path was found or used in this run.
  void keep_path(std::uint64_t key, const std::vector<PathCell>& cells);
  /// Ends a run over fine paths: forgets those that neither it nor the run before used.
  void end_paths();

 private:
  struct GraphEntry {
    std::shared_ptr<const Terrain> terrain;
    std::shared_ptr<const Hydrology> hydrology;
    std::shared_ptr<const ConfinementRegions> regions;
    int block = 1;
    int level = 0;
    std::shared_ptr<TravelGraph> graph;
    TravelBlocks blocks;
    int unused_runs = 0;
    /// Costs (empty for the graph's own) and vertices of the nodes that were last asked for, and what was found between them.
    std::vector<float> cost;
    std::vector<std::int32_t> vertices;
    ReachedNodes reached;
  };
  struct PathEntry {
    std::vector<PathCell> cells;
    std::uint64_t run = 0;
  };
  /// By block: where a ground is the same as one of before; empty where it is everywhere.
  [[nodiscard]] std::vector<char> same_ground(const Ground& ground, const std::shared_ptr<const Terrain>& terrain,
                                              const std::shared_ptr<const Hydrology>& hydrology, int block);

  std::vector<GraphEntry> graphs_;
  /// Blocks in which two grounds are the same, as they were last asked for.
  struct SameGround {
    std::shared_ptr<const Terrain> terrain[2];
    std::shared_ptr<const Hydrology> hydrology[2];
    int block = 0;
    std::vector<char> same;
  };
  SameGround same_ground_;
  /// Ground of the last run over fine paths, and by block the run since which it and those around it are as they are.
  std::shared_ptr<const Terrain> terrain_;
  std::shared_ptr<const Hydrology> hydrology_;
  int path_block_ = 0;
  Grid<std::uint64_t> since_;
  std::uint64_t run_ = 1;
  std::unordered_map<std::uint64_t, PathEntry> paths_;
};

}  // namespace biotope

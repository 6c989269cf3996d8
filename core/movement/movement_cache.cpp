#include "core/movement/movement_cache.hpp"

#include <algorithm>
#include <bit>
#include <cstring>

#include "core/base/random.hpp"

namespace biotope {

std::shared_ptr<const TravelGraph> MovementCache::graph(const Ground& ground, const std::shared_ptr<const ConfinementRegions>& regions,
                                                        const Mobility& mobility, int block) {
  for (GraphEntry& entry : graphs_) {
    if (entry.terrain != ground.terrain || entry.hydrology != ground.hydrology || entry.block != block) continue;
    if (!(entry.graph->mobility == mobility)) continue;
    if (entry.regions != regions && !(entry.regions->label == regions->label)) continue;
    return entry.graph;
  }
  auto made = std::make_shared<const TravelGraph>(build_travel_graph(ground, *regions, mobility, block));
  graphs_.push_back({ground.terrain, ground.hydrology, regions, block, -1, made, 0, {}, {}});
  return made;
}

const ReachedNodes* MovementCache::reached(const TravelGraph& graph, const std::vector<std::int32_t>& vertices) const {
  for (const GraphEntry& entry : graphs_) {
    if (entry.graph.get() == &graph) return entry.vertices == vertices ? &entry.reached : nullptr;
  }
  return nullptr;
}

void MovementCache::keep_reached(const TravelGraph& graph, const std::vector<std::int32_t>& vertices, ReachedNodes reached) {
  for (GraphEntry& entry : graphs_) {
    if (entry.graph.get() != &graph) continue;
    entry.vertices = vertices;
    entry.reached = std::move(reached);
  }
}

void MovementCache::end_graphs(std::span<const std::shared_ptr<const TravelGraph>> used, int level) {
  for (GraphEntry& entry : graphs_) {
    const bool now = std::find(used.begin(), used.end(), entry.graph) != used.end();
    if (now) {
      entry.level = level;
      entry.unused_runs = 0;
    } else if (entry.level == level) {
      ++entry.unused_runs;
    }
  }
  std::erase_if(graphs_, [](const GraphEntry& entry) { return entry.unused_runs >= 2; });
}

void MovementCache::begin_paths(const Ground& ground) {
  if (terrain_ != ground.terrain || hydrology_ != ground.hydrology) paths_.clear();
  terrain_ = ground.terrain;
  hydrology_ = ground.hydrology;
  ++run_;
}

const std::vector<PathCell>* MovementCache::path(std::uint64_t key) const {
  const auto found = paths_.find(key);
  return found == paths_.end() ? nullptr : &found->second.cells;
}

void MovementCache::keep_path(std::uint64_t key, const std::vector<PathCell>& cells) {
  const auto [entry, fresh] = paths_.try_emplace(key);
  if (fresh) entry->second.cells = cells;
  entry->second.run = run_;
}

void MovementCache::end_paths() {
  std::erase_if(paths_, [this](const auto& entry) { return entry.second.run + 1 < run_; });
}

std::uint64_t path_key(const Tube& tube, PathCell from, PathCell to, const Mobility& mobility) {
  const auto pair = [](int a, int b) { return (std::uint64_t(std::uint32_t(a)) << 32) | std::uint32_t(b); };
  const auto bits = [](float value) { return std::uint64_t(std::bit_cast<std::uint32_t>(value)); };
  std::uint64_t key = random_bits({pair(from.x, from.y), pair(to.x, to.y), pair(tube.cells.x0, tube.cells.y0), pair(tube.cells.x1, tube.cells.y1),
                                   bits(mobility.max_slope), bits(mobility.slope_sensitivity)});
  std::size_t i = 0;
  for (; i + 8 <= tube.open.size(); i += 8) {
    std::uint64_t word = 0;
    std::memcpy(&word, tube.open.data() + i, 8);
    key = std::rotl(key ^ word, 23) * 0x9e3779b97f4a7c15ULL;
  }
  for (; i < tube.open.size(); ++i) key = mix_bits(key ^ tube.open[i]);
  return mix_bits(key);
}

}  // namespace biotope

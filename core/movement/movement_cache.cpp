#include "core/movement/movement_cache.hpp"

#include <algorithm>
#include <bit>
#include <cassert>
#include <cstdlib>
#include <optional>

#include "core/base/random.hpp"

namespace biotope {

std::shared_ptr<const TravelGraph> MovementCache::graph(const Ground& ground,
                                                        const std::shared_ptr<const ConfinementRegions>& regions,
                                                        const Mobility& mobility, int block) {
  for (GraphEntry& entry : graphs_) {
    if (entry.terrain != ground.terrain || entry.hydrology != ground.hydrology || entry.block != block) continue;
    if (!(entry.graph->mobility == mobility)) continue;
    if (entry.regions != regions && !(entry.regions->label == regions->label)) continue;
    return entry.graph;
  }
  // Of several graphs of this mobility the last one is the most alike.
  const auto known = std::find_if(graphs_.rbegin(), graphs_.rend(), [&](const GraphEntry& entry) {
    return entry.block == block && entry.graph->mobility == mobility && entry.regions->label.rect() == regions->label.rect() &&
           entry.terrain->cell_size == ground.terrain->cell_size;
  });
  GraphEntry entry{ground.terrain, ground.hydrology, regions, block, -1, nullptr, {}, 0, {}, {}, {}};
  std::optional<KnownGraph> base;
  if (known != graphs_.rend())
    base.emplace(KnownGraph{*known->graph, known->blocks, known->regions->label,
                            same_ground(ground, known->terrain, known->hydrology, block)});
  entry.graph =
      std::make_shared<TravelGraph>(build_travel_graph(ground, *regions, mobility, block, base ? &*base : nullptr, entry.blocks));
  graphs_.push_back(std::move(entry));
  return graphs_.back().graph;
}

std::vector<char> MovementCache::same_ground(const Ground& ground, const std::shared_ptr<const Terrain>& terrain,
                                             const std::shared_ptr<const Hydrology>& hydrology, int block) {
  if (terrain == ground.terrain && hydrology == ground.hydrology) return {};
  SameGround& last = same_ground_;
  const bool asked = last.terrain[0] == terrain && last.terrain[1] == ground.terrain && last.hydrology[0] == hydrology &&
                     last.hydrology[1] == ground.hydrology && last.block == block;
  if (!asked) {
    Ground before = ground;
    before.terrain = terrain;
    before.hydrology = hydrology;
    last = {{terrain, ground.terrain}, {hydrology, ground.hydrology}, block, blocks_of_same_ground(before, ground, block)};
  }
  return last.same;
}

const ReachedNodes* MovementCache::reached(const TravelGraph& graph, std::span<const float> cost,
                                           const std::vector<std::int32_t>& vertices) const {
  const bool own = cost.data() == graph.cost.data();
  for (const GraphEntry& entry : graphs_) {
    if (entry.graph.get() != &graph) continue;
    const bool same_cost = own ? entry.cost.empty() : std::equal(cost.begin(), cost.end(), entry.cost.begin(), entry.cost.end());
    return same_cost && entry.vertices == vertices ? &entry.reached : nullptr;
  }
  return nullptr;
}

void MovementCache::keep_reached(const TravelGraph& graph, std::span<const float> cost, const std::vector<std::int32_t>& vertices,
                                 ReachedNodes reached) {
  for (GraphEntry& entry : graphs_) {
    if (entry.graph.get() != &graph) continue;
    if (cost.data() == graph.cost.data()) {
      entry.cost.clear();
    } else {
      entry.cost.assign(cost.begin(), cost.end());
    }
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

void MovementCache::begin_paths(const Ground& ground, int block) {
  ++run_;
  const Rect map = ground.terrain->height.rect();
  const int columns = (map.width() + block - 1) / block;
  const int rows = (map.height() + block - 1) / block;
  const bool alike = terrain_ && terrain_->height.rect() == map && terrain_->cell_size == ground.terrain->cell_size &&
                     path_block_ == block && bool(hydrology_) == bool(ground.hydrology);
  if (!alike) {
    paths_.clear();
    since_ = Grid<std::uint64_t>(columns, rows, run_);
  } else if (const auto same = same_ground(ground, terrain_, hydrology_, block); !same.empty()) {
    for (std::size_t i = 0; i < same.size(); ++i) {
      if (same[i]) continue;
      const int x = int(i) % columns;
      const int y = int(i) / columns;
      // What samples the ground between cells reads beside a block too.
      const Rect around = intersection({x - 1, y - 1, x + 2, y + 2}, since_.rect());
      for (int ny = around.y0; ny < around.y1; ++ny) std::fill_n(since_.row(ny).begin() + around.x0, around.width(), run_);
    }
  }
  terrain_ = ground.terrain;
  hydrology_ = ground.hydrology;
  path_block_ = block;
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

std::uint64_t MovementCache::path_key(const FineGround& ground, const Tube& tube, PathCell from, PathCell to,
                                      const Mobility& mobility) const {
  assert(ground.block() == path_block_);
  const auto pair = [](int a, int b) { return (std::uint64_t(std::uint32_t(a)) << 32) | std::uint32_t(b); };
  const auto bits = [](float value) { return std::uint64_t(std::bit_cast<std::uint32_t>(value)); };
  std::uint64_t key =
      random_bits({pair(from.x, from.y), pair(to.x, to.y), bits(mobility.max_slope), bits(mobility.slope_sensitivity)});
  const auto add = [&](const PathCell& block) {
    key = mix_bits(mix_bits(key ^ pair(block.x, block.y)) ^ ground.block_key(block) ^ mix_bits(since_(block.x, block.y)));
  };
  for (const PathCell& block : tube.blocks) add(block);
  // The straight line between the ends is looked at too, wherever it goes.
  const int span = std::max(std::abs(to.x - from.x), std::abs(to.y - from.y));
  const int samples = 2 * (span / path_block_ + 1);
  for (int i = 0; i <= samples; ++i) {
    add({(from.x + (to.x - from.x) * i / samples) / path_block_, (from.y + (to.y - from.y) * i / samples) / path_block_});
  }
  return key;
}

}  // namespace biotope

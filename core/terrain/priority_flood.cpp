#include <algorithm>
#include <functional>
#include <limits>
#include <queue>
#include <utility>
#include <vector>

#include "core/base/parallel.hpp"
#include "core/terrain/depressions.hpp"
#include "core/terrain/flow_routing.hpp"
#include "core/terrain/neighbours.hpp"
#include "core/terrain/ordered_bits.hpp"
#include "core/terrain/tile_changes.hpp"

namespace biotope {
namespace {

constexpr int flood_tile = 256;
constexpr float lowest = -std::numeric_limits<float>::infinity();

/// Watershed numbers inside a tile; `outside` is the sea and what lies beyond the map, which all tiles share.
using Label = std::uint16_t;
constexpr Label unlabelled = 0;
constexpr Label outside = 1;

using Pass = WatershedPass;

/// Name of a watershed of any tile.
std::uint32_t name_of(std::size_t tile, Label label) { return std::uint32_t(tile) << 16 | label; }

/// Keeps the lowest pass of each pair.
void keep_lowest(std::vector<Pass>& passes) {
  std::sort(passes.begin(), passes.end(), [](const Pass& p, const Pass& q) {
    if (p.a != q.a) return p.a < q.a;
    if (p.b != q.b) return p.b < q.b;
    return p.level < q.level;
  });
  passes.erase(std::unique(passes.begin(), passes.end(), [](const Pass& p, const Pass& q) { return p.a == q.a && p.b == q.b; }),
               passes.end());
}

using FloodEntry = std::uint64_t;  // ordered height above, cell inside the tile below: ties go to the first cell
using FloodHeap = std::priority_queue<FloodEntry, std::vector<FloodEntry>, std::greater<>>;

/// Floods one tile from its rim as if water left there, and names each cell's watershed.
class TileFlood {
 public:
  TileFlood(const Grid<float>& height, const Grid<std::uint8_t>& sea, float sea_level, std::size_t number, const Rect& tile,
            Grid<float>& filled, Grid<Label>& labels)
      : height_(height), sea_(sea), sea_level_(sea_level), number_(number), tile_(tile), filled_(filled), labels_(labels) {}

  void run() {
    for (int y = tile_.y0; y < tile_.y1; ++y) {
      for (int x = tile_.x0; x < tile_.x1; ++x) seed(x, y);
    }
    while (!heap_.empty() || pit_next_ < pit_.size()) {
      std::uint32_t cell = 0;
      if (pit_next_ < pit_.size()) {
        cell = pit_[pit_next_++];
      } else {
        pit_.clear();
        pit_next_ = 0;
        cell = std::uint32_t(heap_.top() & 0xffffffffU);
        heap_.pop();
      }
      visit(tile_.x0 + int(cell) % tile_.width(), tile_.y0 + int(cell) / tile_.width());
    }
    keep_lowest(passes_);
  }

  [[nodiscard]] std::vector<Pass>& passes() { return passes_; }
  [[nodiscard]] Label label_count() const { return next_label_; }

 private:
  [[nodiscard]] bool is_sea(int x, int y) const { return !sea_.empty() && sea_(x, y) != 0; }
  [[nodiscard]] bool on_rim(int x, int y) const {
    return x == tile_.x0 || y == tile_.y0 || x == tile_.x1 - 1 || y == tile_.y1 - 1;
  }

  [[nodiscard]] std::uint32_t local(int x, int y) const { return std::uint32_t((y - tile_.y0) * tile_.width() + x - tile_.x0); }

  void push(int x, int y, float level) { heap_.push(FloodEntry(ordered_bits(level)) << 32 | local(x, y)); }

  /// Cells from which water leaves the tile: its rim and the sea.
  void seed(int x, int y) {
    labels_(x, y) = unlabelled;
    if (is_sea(x, y)) {
      filled_(x, y) = sea_level_;
      labels_(x, y) = outside;
      push(x, y, lowest);
    } else if (on_rim(x, y)) {
      filled_(x, y) = height_(x, y);
      push(x, y, height_(x, y));
    } else {
      filled_(x, y) = lowest;
    }
  }

  void visit(int x, int y) {
    Label& label = labels_(x, y);
    if (label == unlabelled) label = next_label_++;
    const float level = filled_(x, y);
    for (std::size_t d = 0; d < 8; ++d) {
      const int nx = x + neighbour_dx[d];
      const int ny = y + neighbour_dy[d];
      if (!tile_.contains(nx, ny)) continue;
      Label& other = labels_(nx, ny);
      if (other == unlabelled) {
        other = label;
        reach(nx, ny, level);
      } else if (other != label) {
        const Label low = std::min(other, label);
        const Label high = std::max(other, label);
        passes_.push_back({name_of(number_, low), name_of(number_, high), std::max(level, filled_(nx, ny))});
      }
    }
  }

  void reach(int x, int y, float level) {
    if (filled_(x, y) != lowest) return;  // a rim cell that waits in the heap
    const float height = height_(x, y);
    if (height <= level) {
      filled_(x, y) = level;
      pit_.push_back(local(x, y));
    } else {
      filled_(x, y) = height;
      push(x, y, height);
    }
  }

  const Grid<float>& height_;
  const Grid<std::uint8_t>& sea_;
  float sea_level_;
  std::size_t number_;
  Rect tile_;
  Grid<float>& filled_;
  Grid<Label>& labels_;
  FloodHeap heap_;
  std::vector<std::uint32_t> pit_;
  std::size_t pit_next_ = 0;
  std::vector<Pass> passes_;
  Label next_label_ = outside + 1;
};

/// Watersheds and passes of all tiles as a graph with one node for the outside.
struct PassGraph {
  /// First node of each tile, and the number of nodes.
  std::vector<std::uint32_t> first_node;
  std::uint32_t nodes = 1;
  std::vector<std::uint32_t> first_edge;
  std::vector<std::pair<std::uint32_t, float>> edges;

  [[nodiscard]] std::uint32_t node(std::uint32_t name) const {
    const auto label = Label(name & 0xffffU);
    return label == outside ? 0U : first_node[name >> 16] + label - outside - 1;
  }
};

/// Level to which water stands in each watershed before it finds a way out: a priority-flood over the graph of watersheds.
std::vector<float> spill_levels(const PassGraph& graph) {
  std::vector<float> level(graph.nodes, std::numeric_limits<float>::infinity());
  FloodHeap heap;
  level[0] = lowest;
  heap.push(FloodEntry(ordered_bits(lowest)) << 32);
  while (!heap.empty()) {
    const FloodEntry entry = heap.top();
    heap.pop();
    const auto node = std::uint32_t(entry & 0xffffffffU);
    if (std::uint32_t(entry >> 32) != ordered_bits(level[node])) continue;
    for (std::uint32_t e = graph.first_edge[node]; e < graph.first_edge[node + 1]; ++e) {
      const auto& [other, pass] = graph.edges[e];
      const float next = std::max(level[node], pass);
      if (next >= level[other]) continue;
      level[other] = next;
      heap.push(FloodEntry(ordered_bits(next)) << 32 | other);
    }
  }
  return level;
}

}  // namespace

Rect DepressionField::rect(std::size_t tile) const {
  const int x0 = int(tile % std::size_t(columns_)) * flood_tile;
  const int y0 = int(tile / std::size_t(columns_)) * flood_tile;
  return intersection({x0, y0, x0 + flood_tile, y0 + flood_tile}, within_.rect());
}

void DepressionField::flood(std::size_t tile, const Grid<float>& height, const Grid<std::uint8_t>& sea, float sea_level) {
  TileFlood flood(height, sea, sea_level, tile, rect(tile), within_, labels_);
  flood.run();
  tiles_[tile].inside = std::move(flood.passes());
  tiles_[tile].watersheds = std::uint32_t(flood.label_count()) - outside - 1;
}

/// Passes between cells of different tiles and over the map's border, which is closed at inlets.
void DepressionField::join(std::size_t tile, const Grid<std::uint8_t>& inlets) {
  std::vector<Pass>& passes = tiles_[tile].beside;
  passes.clear();
  const auto name = [&](int x, int y) {
    const std::size_t at = std::size_t(y / flood_tile) * std::size_t(columns_) + std::size_t(x / flood_tile);
    const Label label = labels_(x, y);
    return label == outside ? std::uint32_t(outside) : name_of(at, label);
  };
  const auto pass = [&](int x, int y, int nx, int ny) {
    if (!within_.contains(nx, ny)) return;
    const std::uint32_t a = name(x, y);
    const std::uint32_t b = name(nx, ny);
    if (a != b) passes.push_back({std::min(a, b), std::max(a, b), std::max(within_(x, y), within_(nx, ny))});
  };
  const auto leave = [&](int x, int y) {
    if (labels_(x, y) == outside || (!inlets.empty() && inlets(x, y) != 0)) return;
    passes.push_back({outside, name(x, y), within_(x, y)});
  };
  const Rect cells = rect(tile);
  for (int x = cells.x0; x < cells.x1; ++x) {
    for (int dx = -1; dx <= 1; ++dx) pass(x, cells.y1 - 1, x + dx, cells.y1);
    if (cells.y0 == 0) leave(x, 0);
    if (cells.y1 == within_.height()) leave(x, cells.y1 - 1);
  }
  for (int y = cells.y0; y < cells.y1; ++y) {
    for (int dy = -1; dy <= 1; ++dy) pass(cells.x1 - 1, y, cells.x1, y + dy);
    if (cells.x0 == 0) leave(0, y);
    if (cells.x1 == within_.width()) leave(cells.x1 - 1, y);
  }
  keep_lowest(passes);
}

std::vector<char> DepressionField::spill() {
  PassGraph graph;
  for (const Tile& tile : tiles_) {
    graph.first_node.push_back(graph.nodes);
    graph.nodes += tile.watersheds;
  }
  graph.first_edge.assign(std::size_t(graph.nodes) + 1, 0);
  const auto each_pass = [&](const auto& body) {
    for (const Tile& tile : tiles_) {
      for (const Pass& pass : tile.inside) body(graph.node(pass.a), graph.node(pass.b), pass.level);
      for (const Pass& pass : tile.beside) body(graph.node(pass.a), graph.node(pass.b), pass.level);
    }
  };
  each_pass([&](std::uint32_t a, std::uint32_t b, float) {
    ++graph.first_edge[a];
    ++graph.first_edge[b];
  });
  std::uint32_t sum = 0;
  for (auto& begin : graph.first_edge) sum += std::exchange(begin, sum);
  std::vector<std::uint32_t> place(graph.first_edge.begin(), graph.first_edge.end() - 1);
  graph.edges.resize(sum);
  each_pass([&](std::uint32_t a, std::uint32_t b, float level) {
    graph.edges[place[a]++] = {b, level};
    graph.edges[place[b]++] = {a, level};
  });
  const std::vector<float> levels = spill_levels(graph);
  std::vector<char> another(tiles_.size(), 0);
  for (std::size_t t = 0; t < tiles_.size(); ++t) {
    const auto first = levels.begin() + std::ptrdiff_t(graph.first_node[t]);
    std::vector<float> of_tile(first, first + std::ptrdiff_t(tiles_[t].watersheds));
    another[t] = of_tile != tiles_[t].levels ? 1 : 0;
    tiles_[t].levels = std::move(of_tile);
  }
  return another;
}

bool DepressionField::raise(const Rect& cells, Grid<float>& filled) const {
  const std::size_t tile = std::size_t(cells.y0 / flood_tile) * std::size_t(columns_) + std::size_t(cells.x0 / flood_tile);
  const std::vector<float>& levels = tiles_[tile].levels;
  bool another = false;
  for (int y = cells.y0; y < cells.y1; ++y) {
    for (int x = cells.x0; x < cells.x1; ++x) {
      const Label label = labels_(x, y);
      const float level = label == outside ? lowest : levels[std::size_t(label) - outside - 1];
      const float height = std::max(within_(x, y), level);
      another = another || filled(x, y) != height;
      filled(x, y) = height;
    }
  }
  return another;
}

Grid<float> DepressionField::restart(const Grid<float>& height, const Grid<std::uint8_t>& sea, float sea_level,
                                     const Grid<std::uint8_t>& inlets) {
  const int width = height.width();
  const int rows = height.height();
  within_ = Grid<float>(width, rows);
  labels_ = Grid<Label>(width, rows);
  columns_ = (width + flood_tile - 1) / flood_tile;
  tiles_.assign(std::size_t(columns_) * std::size_t((rows + flood_tile - 1) / flood_tile), {});
  parallel_each(tiles_.size(), [&](std::size_t t) { flood(t, height, sea, sea_level); });
  parallel_each(tiles_.size(), [&](std::size_t t) { join(t, inlets); });
  (void)spill();
  auto filled = Grid<float>::shareable(width, rows);
  parallel_each(tiles_.size(), [&](std::size_t t) { (void)raise(rect(t), filled); });
  return filled;
}

TileSet DepressionField::update(const Grid<float>& height, const Grid<std::uint8_t>& sea, float sea_level,
                                const Grid<std::uint8_t>& inlets, const TileSet& changed, Grid<float>& filled) {
  static_assert(flood_tile % tile_side == 0);
  std::vector<char> dirty(tiles_.size(), 0);
  std::vector<char> beside(tiles_.size(), 0);
  const int rows = int(tiles_.size()) / columns_;
  for (const std::size_t small : changed.list()) {
    const Rect cells = changed.rect(small);
    const int column = cells.x0 / flood_tile;
    const int row = cells.y0 / flood_tile;
    dirty[std::size_t(row) * std::size_t(columns_) + std::size_t(column)] = 1;
    for (int y = std::max(row - 1, 0); y <= std::min(row + 1, rows - 1); ++y) {
      for (int x = std::max(column - 1, 0); x <= std::min(column + 1, columns_ - 1); ++x) {
        beside[std::size_t(y) * std::size_t(columns_) + std::size_t(x)] = 1;
      }
    }
  }
  parallel_each(tiles_.size(), [&](std::size_t t) {
    if (dirty[t] != 0) flood(t, height, sea, sea_level);
  });
  parallel_each(tiles_.size(), [&](std::size_t t) {
    if (beside[t] != 0) join(t, inlets);
  });
  const std::vector<char> another = spill();
  TileSet asked(filled.width(), filled.height());
  for (std::size_t t = 0; t < tiles_.size(); ++t) {
    if (dirty[t] != 0 || another[t] != 0) asked.insert(rect(t));
  }
  return changed_tiles(asked, [&](const Rect& cells) { return raise(cells, filled); });
}

Grid<float> fill_depressions(const Grid<float>& height, const Grid<std::uint8_t>& sea, float sea_level,
                             const Grid<std::uint8_t>& inlets) {
  return DepressionField().restart(height, sea, sea_level, inlets);
}

}  // namespace biotope

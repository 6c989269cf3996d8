#include <algorithm>
#include <bit>
#include <functional>
#include <limits>
#include <queue>
#include <utility>
#include <vector>

#include "core/base/parallel.hpp"
#include "core/terrain/flow_routing.hpp"
#include "core/terrain/neighbours.hpp"

namespace biotope {
namespace {

constexpr int flood_tile = 256;
constexpr float lowest = -std::numeric_limits<float>::infinity();

/// Watershed numbers inside a tile; each tile's numbers begin at `outside`, which all tiles share.
using Label = std::uint16_t;
constexpr Label unlabelled = 0;
constexpr Label outside = 1;

/// The lowest place where water passes between two watersheds.
struct Pass {
  std::uint32_t a = 0;
  std::uint32_t b = 0;
  float level = 0;
};

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

/// An integer that orders like the float.
std::uint32_t ordered_bits(float value) {
  const auto bits = std::bit_cast<std::uint32_t>(value + 0.0F);
  return (bits & 0x80000000U) != 0 ? ~bits : bits | 0x80000000U;
}

using FloodEntry = std::uint64_t;  // ordered height above, cell inside the tile below: ties go to the first cell
using FloodHeap = std::priority_queue<FloodEntry, std::vector<FloodEntry>, std::greater<>>;

/// Floods one tile from its rim as if water left there, and names each cell's watershed.
class TileFlood {
 public:
  TileFlood(const Grid<float>& height, const Grid<std::uint8_t>& sea, float sea_level, const Rect& tile, Grid<float>& filled,
            Grid<Label>& labels)
      : height_(height), sea_(sea), sea_level_(sea_level), tile_(tile), filled_(filled), labels_(labels) {}

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
        passes_.push_back({std::min(other, label), std::max(other, label), std::max(level, filled_(nx, ny))});
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
  Rect tile_;
  Grid<float>& filled_;
  Grid<Label>& labels_;
  FloodHeap heap_;
  std::vector<std::uint32_t> pit_;
  std::size_t pit_next_ = 0;
  std::vector<Pass> passes_;
  Label next_label_ = outside + 1;
};

/// How the map is cut: tile of a cell, and the number of each tile's first watershed.
struct TileNumbers {
  int columns = 0;
  std::vector<std::uint32_t> first;
  [[nodiscard]] std::uint32_t node(std::size_t tile, Label label) const {
    return label == outside ? 0U : first[tile] + label - outside;
  }
  [[nodiscard]] std::size_t tile(int x, int y) const { return std::size_t(y / flood_tile) * std::size_t(columns) + std::size_t(x / flood_tile); }
};

/// Passes between cells of different tiles and over the map's border, which is closed at inlets.
void add_rim_passes(const Grid<float>& filled, const Grid<Label>& labels, const Grid<std::uint8_t>& inlets, const TileNumbers& numbers,
                    std::vector<Pass>& passes) {
  const auto node = [&](int x, int y) { return numbers.node(numbers.tile(x, y), labels(x, y)); };
  const auto join = [&](int x, int y, int nx, int ny) {
    if (!filled.contains(nx, ny)) return;
    const std::uint32_t a = node(x, y);
    const std::uint32_t b = node(nx, ny);
    if (a != b) passes.push_back({std::min(a, b), std::max(a, b), std::max(filled(x, y), filled(nx, ny))});
  };
  const int width = filled.width();
  const int height = filled.height();
  for (int y = flood_tile - 1; y + 1 < height; y += flood_tile) {
    for (int x = 0; x < width; ++x) {
      for (int dx = -1; dx <= 1; ++dx) join(x, y, x + dx, y + 1);
    }
  }
  for (int x = flood_tile - 1; x + 1 < width; x += flood_tile) {
    for (int y = 0; y < height; ++y) {
      for (int dy = -1; dy <= 1; ++dy) join(x, y, x + 1, y + dy);
    }
  }
  const auto leave = [&](int x, int y) {
    const std::uint32_t a = node(x, y);
    if (a != 0 && (inlets.empty() || inlets(x, y) == 0)) passes.push_back({0, a, filled(x, y)});
  };
  for (int x = 0; x < width; ++x) {
    leave(x, 0);
    leave(x, height - 1);
  }
  for (int y = 0; y < height; ++y) {
    leave(0, y);
    leave(width - 1, y);
  }
}

/// Level to which water stands in each watershed before it finds a way out: a priority-flood over the graph of watersheds.
std::vector<float> spill_levels(std::size_t nodes, const std::vector<Pass>& passes) {
  std::vector<std::uint32_t> first(nodes + 1, 0);
  for (const Pass& pass : passes) {
    ++first[pass.a];
    ++first[pass.b];
  }
  std::uint32_t sum = 0;
  for (auto& begin : first) sum += std::exchange(begin, sum);
  std::vector<std::uint32_t> place(first.begin(), first.end() - 1);
  std::vector<std::pair<std::uint32_t, float>> edges(sum);
  for (const Pass& pass : passes) {
    edges[place[pass.a]++] = {pass.b, pass.level};
    edges[place[pass.b]++] = {pass.a, pass.level};
  }
  std::vector<float> level(nodes, std::numeric_limits<float>::infinity());
  std::priority_queue<FloodEntry, std::vector<FloodEntry>, std::greater<>> heap;
  level[0] = lowest;
  heap.push(FloodEntry(ordered_bits(lowest)) << 32);
  while (!heap.empty()) {
    const FloodEntry entry = heap.top();
    heap.pop();
    const auto node = std::uint32_t(entry & 0xffffffffU);
    if (std::uint32_t(entry >> 32) != ordered_bits(level[node])) continue;
    for (std::uint32_t e = first[node]; e < first[node + 1]; ++e) {
      const float next = std::max(level[node], edges[e].second);
      if (next >= level[edges[e].first]) continue;
      level[edges[e].first] = next;
      heap.push(FloodEntry(ordered_bits(next)) << 32 | edges[e].first);
    }
  }
  return level;
}

}  // namespace

Grid<float> fill_depressions(const Grid<float>& height, const Grid<std::uint8_t>& sea, float sea_level, const Grid<std::uint8_t>& inlets) {
  const int width = height.width();
  const int rows = height.height();
  Grid<float> filled(width, rows);
  Grid<Label> labels(width, rows, unlabelled);
  TileNumbers numbers;
  numbers.columns = (width + flood_tile - 1) / flood_tile;
  const auto tiles = std::size_t(numbers.columns) * std::size_t((rows + flood_tile - 1) / flood_tile);
  std::vector<std::vector<Pass>> tile_passes(tiles);
  std::vector<Label> counts(tiles);
  const auto tile_rect = [&](std::size_t t) {
    const int x0 = int(t % std::size_t(numbers.columns)) * flood_tile;
    const int y0 = int(t / std::size_t(numbers.columns)) * flood_tile;
    return intersection({x0, y0, x0 + flood_tile, y0 + flood_tile}, height.rect());
  };
  parallel_each(tiles, [&](std::size_t t) {
    TileFlood flood(height, sea, sea_level, tile_rect(t), filled, labels);
    flood.run();
    tile_passes[t] = std::move(flood.passes());
    counts[t] = flood.label_count();
  });
  std::uint32_t nodes = 0;
  for (const Label count : counts) {
    numbers.first.push_back(nodes);
    nodes += std::uint32_t(count) - outside - 1;
  }
  std::vector<Pass> passes;
  for (std::size_t t = 0; t < tiles; ++t) {
    for (const Pass& pass : tile_passes[t]) {
      passes.push_back({numbers.node(t, Label(pass.a)), numbers.node(t, Label(pass.b)), pass.level});
    }
  }
  add_rim_passes(filled, labels, inlets, numbers, passes);
  keep_lowest(passes);
  const std::vector<float> levels = spill_levels(std::size_t(nodes) + 1, passes);
  parallel_each(tiles, [&](std::size_t t) {
    const Rect tile = tile_rect(t);
    for (int y = tile.y0; y < tile.y1; ++y) {
      for (int x = tile.x0; x < tile.x1; ++x) {
        filled(x, y) = std::max(filled(x, y), levels[numbers.node(t, labels(x, y))]);
      }
    }
  });
  return filled;
}

}  // namespace biotope

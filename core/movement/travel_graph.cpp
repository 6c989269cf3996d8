#include <algorithm>
#include <cmath>
#include <optional>

#include "core/base/parallel.hpp"
#include "core/movement/travel.hpp"
#include "core/movement/travel_blocks.hpp"
#include "core/movement/travel_pieces.hpp"
#include "core/movement/walk_cost.hpp"

namespace biotope {
namespace {

using Pair = VertexPair;

/// Cost of walking the straight line between two cells on the fine ground, both ways. What the line meets that cannot be walked
/// counts as a detour: the caller knows that the fine cells connect.
Pair straight_walk(const Ground& ground, const BlockVertices& cells, const WalkCost& walk, int stride,
                   const TravelGraph::Vertex& a, const TravelGraph::Vertex& b) {
  const Grid<float>& height = ground.terrain->height;
  const Grid<float>* water = ground.hydrology ? &ground.hydrology->water_depth : nullptr;
  const int dx = b.x - a.x;
  const int dy = b.y - a.y;
  const int span = std::max(std::abs(dx), std::abs(dy));
  const int steps = std::max(1, (span + stride - 1) / stride);
  int x = a.x;
  int y = a.y;
  double walked = 0;
  double forth = 0;
  double back = 0;
  for (int i = 1; i <= steps; ++i) {
    const int nx = a.x + (2 * dx * i + steps + 2 * steps * span) / (2 * steps) - span;
    const int ny = a.y + (2 * dy * i + steps + 2 * steps * span) / (2 * steps) - span;
    const double run = std::sqrt(double((nx - x) * (nx - x) + (ny - y) * (ny - y))) * ground.terrain->cell_size;
    const auto slope = float((height(nx, ny) - height(x, y)) / run);
    double factor = run;
    if (!cells.open(nx, ny)) factor *= detour_factor;
    if (water && (*water)(nx, ny) > 0) factor *= wading_factor;
    walked += run;
    forth += factor * walk(slope);
    back += factor * walk(-slope);
    x = nx;
    y = ny;
  }
  const double length = std::hypot(double(dx), double(dy)) * ground.terrain->cell_size;
  return {0, 0, float(forth * length / walked), float(back * length / walked)};
}

/// Builds one graph; the steps share the ground and what has been made so far.
class Builder {
 public:
  Builder(const Ground& ground, const ConfinementRegions& regions, const Mobility& mobility, int block, const KnownGraph* known)
      : ground_(ground),
        label_(regions.label),
        rect_(ground.terrain->height.rect()),
        walk_(mobility),
        stride_(walking_stride(ground.terrain->cell_size)),
        known_(known) {
    graph_.mobility = mobility;
    graph_.block = block;
    graph_.vertex_of_cell = BlockVertices(rect_.width(), rect_.height(), block);
    graph_.columns = (rect_.width() + block - 1) / block;
    graph_.rows = (rect_.height() + block - 1) / block;
  }

  TravelGraph build(TravelBlocks& blocks) {
    number_vertices();
    std::vector<std::vector<Pair>> pairs(count());
    parallel_rows(0, graph_.rows, [&](int row) {
      for (int column = 0; column < graph_.columns; ++column) {
        const std::size_t i = number(column, row);
        pairs[i] = same_around(column, row) ? known_pairs(i) : pairs_of(block_rect(column, row));
      }
    });
    connect(pairs);
    blocks.pairs = std::move(pairs);
    return std::move(graph_);
  }

 private:
  [[nodiscard]] std::size_t count() const { return std::size_t(graph_.columns) * std::size_t(graph_.rows); }
  [[nodiscard]] std::size_t number(int column, int row) const {
    return std::size_t(row) * std::size_t(graph_.columns) + std::size_t(column);
  }
  [[nodiscard]] Rect block_rect(int column, int row) const {
    return intersection(rect_,
                        {column * graph_.block, row * graph_.block, (column + 1) * graph_.block, (row + 1) * graph_.block});
  }

  void number_vertices() {
    std::vector<BlockPieces> found(count());
    graph_.open_cells.assign(count(), 0);
    same_.assign(count(), 0);
    parallel_rows(0, graph_.rows, [&](int row) { find_pieces(row, found); });
    for (std::size_t i = 0; i < found.size(); ++i) {
      const auto own = std::int32_t(found[i].vertices.size());
      graph_.vertex_of_cell.set(i, std::int32_t(graph_.vertices.size()), own, std::move(found[i].piece_of_cell));
      graph_.vertices.insert(graph_.vertices.end(), found[i].vertices.begin(), found[i].vertices.end());
    }
  }

  /// The pieces of a row of blocks; what is passable as before is taken over.
  void find_pieces(int row, std::vector<BlockPieces>& found) {
    const Rect rows = block_rect(0, row);
    const bool surely = known_ != nullptr && surely_same_open_rows(label_, known_->label, rows.y0, rows.y1);
    std::optional<RegionRows> label;
    std::optional<RegionRows> before;
    if (!surely) label.emplace(label_, rows.y0, rows.y1);
    if (!surely && known_ != nullptr) before.emplace(known_->label, rows.y0, rows.y1);
    for (int column = 0; column < graph_.columns; ++column) {
      const Rect block = block_rect(column, row);
      const std::size_t i = number(column, row);
      same_[i] = surely || (before && same_open_cells(*label, *before, block)) ? 1 : 0;
      found[i] = same_[i] ? known_pieces(i) : pieces_of_block(*label, block);
      graph_.open_cells[i] = same_[i] ? known_->graph.open_cells[i] : hash_of_open(found[i]);
    }
  }

  /// The vertices of a block in which the same cells are passable as before, in the regions of now.
  [[nodiscard]] BlockPieces known_pieces(std::size_t i) const {
    const BlockVertices& before = known_->graph.vertex_of_cell;
    BlockPieces pieces{{}, before.pieces(i)};
    for (std::int32_t v = before.first(i); v < before.first(i) + before.count(i); ++v) {
      const TravelGraph::Vertex& vertex = known_->graph.vertices[std::size_t(v)];
      pieces.vertices.push_back({vertex.x, vertex.y, label_(vertex.x, vertex.y)});
    }
    return pieces;
  }

  /// Whether a block and those around it are the same as before, passable cells and ground: then so are the walks out of it.
  [[nodiscard]] bool same_around(int column, int row) const {
    if (known_ == nullptr) return false;
    for (int y = std::max(row - 1, 0); y <= std::min(row + 1, graph_.rows - 1); ++y) {
      for (int x = std::max(column - 1, 0); x <= std::min(column + 1, graph_.columns - 1); ++x) {
        const std::size_t i = number(x, y);
        if (!same_[i] || (!known_->same_ground.empty() && !known_->same_ground[i])) return false;
      }
    }
    return true;
  }

  [[nodiscard]] std::vector<Pair> known_pairs(std::size_t i) const {
    std::vector<Pair> pairs = known_->blocks.pairs[i];
    const auto renumber = [&](std::uint32_t& v) {
      const TravelGraph::Vertex& vertex = known_->graph.vertices[v];
      const std::size_t block = number(vertex.x / graph_.block, vertex.y / graph_.block);
      v = std::uint32_t(std::int32_t(v) - known_->graph.vertex_of_cell.first(block) + graph_.vertex_of_cell.first(block));
    };
    for (Pair& pair : pairs) {
      renumber(pair.a);
      renumber(pair.b);
    }
    return pairs;
  }

  /// Adds the pair of vertices of two cells that touch, once.
  void touch(std::vector<Pair>& pairs, int ax, int ay, int bx, int by) const {
    const std::int32_t a = graph_.vertex_of_cell(ax, ay);
    const std::int32_t b = graph_.vertex_of_cell(bx, by);
    if (a < 0 || b < 0) return;
    const auto same = [&](const Pair& pair) { return pair.a == std::uint32_t(a) && pair.b == std::uint32_t(b); };
    if (std::any_of(pairs.rbegin(), pairs.rend(), same)) return;
    Pair pair = straight_walk(ground_, graph_.vertex_of_cell, walk_, stride_, graph_.vertices[std::size_t(a)],
                              graph_.vertices[std::size_t(b)]);
    pair.a = std::uint32_t(a);
    pair.b = std::uint32_t(b);
    pairs.push_back(pair);
  }

  /// Pairs of a block with the blocks east, south, south-east and south-west of it.
  [[nodiscard]] std::vector<Pair> pairs_of(const Rect& block) const {
    std::vector<Pair> pairs;
    if (block.x1 < rect_.width()) {
      for (int y = block.y0; y < block.y1; ++y) touch(pairs, block.x1 - 1, y, block.x1, y);
    }
    if (block.y1 < rect_.height()) {
      for (int x = block.x0; x < block.x1; ++x) touch(pairs, x, block.y1 - 1, x, block.y1);
      if (block.x1 < rect_.width()) touch_corner(pairs, block.x1 - 1, 1, block.y1 - 1);
      if (block.x0 > 0) touch_corner(pairs, block.x0, -1, block.y1 - 1);
    }
    return pairs;
  }

  /// Across a shared corner, where an animal can go diagonally without cutting a blocked corner.
  void touch_corner(std::vector<Pair>& pairs, int x, int side, int y) const {
    if (!graph_.vertex_of_cell.open(x + side, y) || !graph_.vertex_of_cell.open(x, y + 1)) return;
    touch(pairs, x, y, x + side, y + 1);
  }

  void connect(const std::vector<std::vector<Pair>>& pairs) {
    std::vector<std::uint32_t>& first = graph_.first_edge;
    first.assign(graph_.vertices.size() + 1, 0);
    for (const auto& of_block : pairs) {
      for (const Pair& pair : of_block) {
        ++first[pair.a + 1];
        ++first[pair.b + 1];
        ++graph_.edge_count;
      }
    }
    for (std::size_t v = 1; v < first.size(); ++v) first[v] += first[v - 1];
    std::vector<std::uint32_t> next(first.begin(), first.end() - 1);
    graph_.target.resize(first.back());
    graph_.cost.resize(first.back());
    graph_.edge.resize(first.back());
    std::uint32_t number = 0;
    const auto put = [&](std::uint32_t from, std::uint32_t to, float cost) {
      const std::uint32_t slot = next[from]++;
      graph_.target[slot] = to;
      graph_.cost[slot] = cost;
      graph_.edge[slot] = number;
    };
    for (const auto& of_block : pairs) {
      for (const Pair& pair : of_block) {
        put(pair.a, pair.b, pair.forth);
        put(pair.b, pair.a, pair.back);
        ++number;
      }
    }
    double sum = 0;
    for (const float cost : graph_.cost) {
      sum += cost;
      graph_.longest_cost = std::max(graph_.longest_cost, cost);
    }
    if (!graph_.cost.empty()) graph_.mean_cost = float(sum / double(graph_.cost.size()));
  }

  const Ground& ground_;
  const RunMap& label_;
  Rect rect_;
  WalkCost walk_;
  int stride_;
  const KnownGraph* known_;
  /// By block: whether the same cells are passable as before.
  std::vector<char> same_;
  TravelGraph graph_;
};

}  // namespace

int travel_block(int width, int height) {
  constexpr int blocks = 80;
  return std::max(1, (std::max(width, height) + blocks / 2) / blocks);
}

int walking_stride(double cell_size) {
  constexpr double step = 4;
  return std::clamp(int(std::lround(step / cell_size)), 1, 4);
}

TravelGraph build_travel_graph(const Ground& ground, const ConfinementRegions& regions, const Mobility& mobility, int block) {
  assert(block >= 1 && regions.label.rect() == ground.terrain->height.rect());
  TravelBlocks blocks;
  return Builder(ground, regions, mobility, block, nullptr).build(blocks);
}

TravelGraph build_travel_graph(const Ground& ground, const ConfinementRegions& regions, const Mobility& mobility, int block,
                               const KnownGraph* known, TravelBlocks& blocks) {
  assert(block >= 1 && regions.label.rect() == ground.terrain->height.rect());
  assert(known == nullptr ||
         (known->label.rect() == regions.label.rect() && known->graph.block == block && known->graph.mobility == mobility));
  return Builder(ground, regions, mobility, block, known).build(blocks);
}

}  // namespace biotope

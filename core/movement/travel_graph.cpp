#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "core/base/parallel.hpp"
#include "core/base/random.hpp"
#include "core/movement/travel.hpp"
#include "core/movement/travel_blocks.hpp"
#include "core/movement/walk_cost.hpp"
#include "core/terrain/tile_changes.hpp"

namespace biotope {
namespace {

using Label = Grid<std::int32_t>;

using Pair = VertexPair;

bool all_passable(const Label& label, const Rect& block) {
  for (int y = block.y0; y < block.y1; ++y) {
    const auto cells = label.row(y).subspan(std::size_t(block.x0), std::size_t(block.width()));
    if (std::any_of(cells.begin(), cells.end(), [](std::int32_t region) { return region < 0; })) return false;
  }
  return true;
}

/// The cell of `cells` nearest to their mean (the first on ties).
TravelGraph::Vertex representative(const std::vector<std::array<int, 2>>& cells, int region) {
  double mean_x = 0;
  double mean_y = 0;
  for (const auto& [x, y] : cells) {
    mean_x += x;
    mean_y += y;
  }
  mean_x /= double(cells.size());
  mean_y /= double(cells.size());
  TravelGraph::Vertex best{cells[0][0], cells[0][1], region};
  double nearest = std::numeric_limits<double>::infinity();
  for (const auto& [x, y] : cells) {
    const double distance = (x - mean_x) * (x - mean_x) + (y - mean_y) * (y - mean_y);
    if (distance < nearest) {
      nearest = distance;
      best.x = x;
      best.y = y;
    }
  }
  return best;
}

/// The 4-connected pieces inside a block, numbered by their first cell.
struct BlockPieces {
  std::vector<TravelGraph::Vertex> vertices;
  /// Piece of each cell of the block, row by row, -1 where blocked; empty when all cells are in one piece or none is in any.
  std::vector<std::int32_t> piece_of_cell;
};

/// A hash of which cells of a block are passable; 0 where all are, else never 0.
std::uint64_t hash_of_open(const BlockPieces& pieces) {
  if (pieces.piece_of_cell.empty()) return pieces.vertices.empty() ? 1 : 0;
  std::uint64_t hash = 1;
  std::uint64_t bits = 0;
  for (std::size_t i = 0; i < pieces.piece_of_cell.size(); ++i) {
    bits = (bits << 1) | std::uint64_t(pieces.piece_of_cell[i] >= 0);
    if (i % 64 == 63) hash = mix_bits(hash ^ bits);
  }
  return mix_bits(hash ^ bits) | 1;
}

BlockPieces pieces_of_block(const Label& label, const Rect& block) {
  BlockPieces result;
  if (all_passable(label, block)) {
    const int x = block.x0 + block.width() / 2;
    const int y = block.y0 + block.height() / 2;
    result.vertices.push_back({x, y, label(x, y)});
    return result;
  }
  std::vector<std::int32_t> number(std::size_t(block.width()) * std::size_t(block.height()), -1);
  const auto number_at = [&](int x, int y) -> std::int32_t& {
    return number[std::size_t(y - block.y0) * std::size_t(block.width()) + std::size_t(x - block.x0)];
  };
  std::vector<std::array<int, 2>> piece;
  for (int y = block.y0; y < block.y1; ++y) {
    for (int x = block.x0; x < block.x1; ++x) {
      if (label(x, y) < 0 || number_at(x, y) >= 0) continue;
      const auto own = std::int32_t(result.vertices.size());
      piece.assign(1, {x, y});
      number_at(x, y) = own;
      for (std::size_t i = 0; i < piece.size(); ++i) {
        const auto [px, py] = piece[i];
        for (const auto& [dx, dy] : {std::array{1, 0}, std::array{0, 1}, std::array{-1, 0}, std::array{0, -1}}) {
          const int nx = px + dx;
          const int ny = py + dy;
          if (!block.contains(nx, ny) || label(nx, ny) < 0 || number_at(nx, ny) >= 0) continue;
          number_at(nx, ny) = own;
          piece.push_back({nx, ny});
        }
      }
      result.vertices.push_back(representative(piece, label(x, y)));
    }
  }
  if (!result.vertices.empty()) result.piece_of_cell = std::move(number);
  return result;
}

/// Cost of walking the straight line between two cells on the fine ground, both ways. What the line meets that cannot be walked
/// counts as a detour: the caller knows that the fine cells connect.
Pair straight_walk(const Ground& ground, const Label& label, const WalkCost& walk, int stride, const TravelGraph::Vertex& a,
                   const TravelGraph::Vertex& b) {
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
    if (label(nx, ny) < 0) factor *= detour_factor;
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

/// Whether the same cells of a block are passable.
bool same_open_cells(const Label& a, const Label& b, const Rect& block) {
  for (int y = block.y0; y < block.y1; ++y) {
    const std::int32_t* one = a.row(y).data() + block.x0;
    const std::int32_t* other = b.row(y).data() + block.x0;
    const auto width = std::size_t(block.width());
    if (std::equal(one, one + width, other)) continue;
    std::int32_t differs = 0;
    for (std::size_t x = 0; x < width; ++x) differs |= one[x] ^ other[x];
    // The sign says what is passable; regions may have other numbers.
    if (differs < 0) return false;
  }
  return true;
}

/// Builds one graph; the steps share the ground and what has been made so far.
class Builder {
 public:
  Builder(const Ground& ground, const ConfinementRegions& regions, const Mobility& mobility, int block, const KnownGraph* known)
      : ground_(ground),
        label_(regions.label),
        walk_(mobility),
        stride_(walking_stride(ground.terrain->cell_size)),
        known_(known) {
    graph_.mobility = mobility;
    graph_.block = block;
    graph_.columns = (label_.width() + block - 1) / block;
    graph_.rows = (label_.height() + block - 1) / block;
  }

  /// `memory` is overwritten and becomes the graph's map of cells.
  TravelGraph build(TravelBlocks& blocks, Label memory) {
    graph_.vertex_of_cell = std::move(memory);
    number_vertices();
    std::vector<std::vector<Pair>> pairs(count());
    parallel_rows(0, graph_.rows, [&](int row) {
      for (int column = 0; column < graph_.columns; ++column) {
        const std::size_t i = number(column, row);
        pairs[i] = same_around(column, row) ? known_pairs(i) : pairs_of(block_rect(column, row));
      }
    });
    connect(pairs);
    blocks.first_vertex = std::move(first_);
    blocks.pairs = std::move(pairs);
    return std::move(graph_);
  }

 private:
  [[nodiscard]] std::size_t count() const { return std::size_t(graph_.columns) * std::size_t(graph_.rows); }
  [[nodiscard]] std::size_t number(int column, int row) const {
    return std::size_t(row) * std::size_t(graph_.columns) + std::size_t(column);
  }
  [[nodiscard]] Rect block_rect(int column, int row) const {
    return intersection(label_.rect(),
                        {column * graph_.block, row * graph_.block, (column + 1) * graph_.block, (row + 1) * graph_.block});
  }

  void number_vertices() {
    std::vector<BlockPieces> found(count());
    graph_.open_cells.assign(count(), 0);
    same_.assign(count(), 0);
    const auto of_row = [&](int row, const auto& body) {
      for (int column = 0; column < graph_.columns; ++column) body(block_rect(column, row), number(column, row));
    };
    parallel_rows(0, graph_.rows, [&](int row) {
      of_row(row, [&](const Rect& block, std::size_t i) {
        same_[i] = known_ != nullptr && same_open_cells(label_, known_->label, block) ? 1 : 0;
        found[i] = same_[i] ? known_pieces(i) : pieces_of_block(label_, block);
        graph_.open_cells[i] = same_[i] ? known_->graph.open_cells[i] : hash_of_open(found[i]);
      });
    });
    std::vector<std::int32_t>& first = first_;
    for (std::size_t i = 0; i < found.size(); ++i) {
      first.push_back(std::int32_t(graph_.vertices.size()));
      graph_.vertices.insert(graph_.vertices.end(), found[i].vertices.begin(), found[i].vertices.end());
    }
    first.push_back(std::int32_t(graph_.vertices.size()));
    // Vertices are written once: the map is large, and a further pass over it costs more than the search for pieces.
    Label& cells = graph_.vertex_of_cell;
    if (cells.rect() != label_.rect()) cells = Label(label_.width(), label_.height());
    parallel_rows(0, graph_.rows, [&](int row) {
      of_row(row, [&](const Rect& block, std::size_t i) {
        const std::int32_t all = found[i].vertices.empty() ? -1 : first[i];
        const std::vector<std::int32_t>& piece_of_cell = found[i].piece_of_cell;
        for (int y = block.y0; y < block.y1; ++y) {
          const auto out = cells.row(y).subspan(std::size_t(block.x0), std::size_t(block.width()));
          if (same_[i] && graph_.open_cells[i] != 0 && all >= 0) {
            const std::int32_t* before = known_->graph.vertex_of_cell.row(y).data() + block.x0;
            const std::int32_t shift = first[i] - known_->blocks.first_vertex[i];
            for (std::size_t x = 0; x < out.size(); ++x) out[x] = before[x] >= 0 ? before[x] + shift : -1;
            continue;
          }
          if (piece_of_cell.empty()) {
            std::fill(out.begin(), out.end(), all);
            continue;
          }
          const std::int32_t* piece = piece_of_cell.data() + std::size_t(y - block.y0) * out.size();
          for (std::size_t x = 0; x < out.size(); ++x) out[x] = piece[x] >= 0 ? piece[x] + first[i] : -1;
        }
      });
    });
  }

  /// The vertices of a block in which the same cells are passable as before, in the regions of now.
  [[nodiscard]] BlockPieces known_pieces(std::size_t i) const {
    BlockPieces pieces;
    const auto& vertices = known_->graph.vertices;
    for (std::int32_t v = known_->blocks.first_vertex[i]; v < known_->blocks.first_vertex[i + 1]; ++v) {
      const TravelGraph::Vertex& vertex = vertices[std::size_t(v)];
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
      v = std::uint32_t(std::int32_t(v) - known_->blocks.first_vertex[block] + first_[block]);
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
    Pair pair = straight_walk(ground_, label_, walk_, stride_, graph_.vertices[std::size_t(a)], graph_.vertices[std::size_t(b)]);
    pair.a = std::uint32_t(a);
    pair.b = std::uint32_t(b);
    pairs.push_back(pair);
  }

  /// Pairs of a block with the blocks east, south, south-east and south-west of it.
  [[nodiscard]] std::vector<Pair> pairs_of(const Rect& block) const {
    std::vector<Pair> pairs;
    if (block.x1 < label_.width()) {
      for (int y = block.y0; y < block.y1; ++y) touch(pairs, block.x1 - 1, y, block.x1, y);
    }
    if (block.y1 < label_.height()) {
      for (int x = block.x0; x < block.x1; ++x) touch(pairs, x, block.y1 - 1, x, block.y1);
      if (block.x1 < label_.width()) touch_corner(pairs, block.x1 - 1, 1, block.y1 - 1);
      if (block.x0 > 0) touch_corner(pairs, block.x0, -1, block.y1 - 1);
    }
    return pairs;
  }

  /// Across a shared corner, where an animal can go diagonally without cutting a blocked corner.
  void touch_corner(std::vector<Pair>& pairs, int x, int side, int y) const {
    if (label_(x + side, y) < 0 || label_(x, y + 1) < 0) return;
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
  const Label& label_;
  WalkCost walk_;
  int stride_;
  const KnownGraph* known_;
  /// By block: whether the same cells are passable as before.
  std::vector<char> same_;
  std::vector<std::int32_t> first_;
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
  return Builder(ground, regions, mobility, block, nullptr).build(blocks, {});
}

TravelGraph build_travel_graph(const Ground& ground, const ConfinementRegions& regions, const Mobility& mobility, int block,
                               const KnownGraph* known, TravelBlocks& blocks, Grid<std::int32_t> memory) {
  assert(block >= 1 && regions.label.rect() == ground.terrain->height.rect());
  assert(known == nullptr ||
         (known->label.rect() == regions.label.rect() && known->graph.block == block && known->graph.mobility == mobility));
  return Builder(ground, regions, mobility, block, known).build(blocks, std::move(memory));
}

std::vector<char> blocks_of_same_ground(const Ground& a, const Ground& b, int block) {
  const Grid<float>& height = a.terrain->height;
  const int columns = (height.width() + block - 1) / block;
  const int rows = (height.height() + block - 1) / block;
  std::vector<char> same(std::size_t(columns) * std::size_t(rows), 1);
  parallel_rows(0, rows, [&](int row) {
    for (int column = 0; column < columns; ++column) {
      const Rect rect = intersection(height.rect(), {column * block, row * block, (column + 1) * block, (row + 1) * block});
      const bool alike = (a.terrain == b.terrain || same_cells(height, b.terrain->height, rect)) &&
                         (a.hydrology == b.hydrology ||
                          (a.hydrology && b.hydrology && same_cells(a.hydrology->water_depth, b.hydrology->water_depth, rect)));
      same[std::size_t(row) * std::size_t(columns) + std::size_t(column)] = alike ? 1 : 0;
    }
  });
  return same;
}

}  // namespace biotope

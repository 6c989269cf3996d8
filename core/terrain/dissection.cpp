#include "core/terrain/dissection.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <limits>
#include <queue>
#include <utility>

#include "core/base/parallel.hpp"
#include "core/base/random.hpp"
#include "core/terrain/neighbours.hpp"

namespace biotope {
namespace {

/// Flint's concavity: how channels flatten downstream. Typical of mountain rivers.
constexpr float concavity = 0.45F;
constexpr float unknown = -std::numeric_limits<float>::infinity();

/// What a level knows of the rock at each cell.
struct RockMaps {
  Grid<float> hardness;
  Grid<float> plateau;
  Grid<float> dip;
};

/// Fields are smooth: they are asked on a raster at most this fine and joined linearly.
constexpr int field_cells = 256;

Grid<float> sample_field(const Field& field, double side, int cells) {
  const int coarse = std::min(cells, field_cells);
  Grid<float> samples(coarse, coarse);
  const double step = side / coarse;
  parallel_rows(0, coarse, [&](int y) {
    for (int x = 0; x < coarse; ++x) samples(x, y) = field((x + 0.5) * step, (y + 0.5) * step);
  });
  if (coarse == cells) return samples;
  Grid<float> fine(cells, cells);
  const double scale = double(coarse) / cells;
  parallel_rows(0, cells, [&](int y) {
    for (int x = 0; x < cells; ++x) fine(x, y) = sample_bilinear(samples, (x + 0.5) * scale - 0.5, (y + 0.5) * scale - 0.5);
  });
  return fine;
}

/// One level of resolution.
class Level {
 public:
  Level(const LandscapeDesign& design, int cells)
      : design_(design),
        cells_(cells),
        cell_size_(design.side / cells),
        rock_{sample_field(design.hardness, design.side, cells), sample_field(design.plateau, design.side, cells),
              sample_field(design.dip, design.side, cells)},
        course_(course_distance(design.course, cells, cell_size_)),
        height_(cells, cells, unknown),
        root_(cells, cells),
        receiver_(cells, cells, leaves_map) {
    for (int y = 0; y < cells; ++y) {
      for (int x = 0; x < cells; ++x) place_root(x, y);
    }
  }

  /// First heights of the coarsest level: distance from the roots through ground that resists at random.
  void grow(std::uint64_t seed) {
    Grid<float> resistance(cells_, cells_);
    for (std::size_t i = 0; i < resistance.size(); ++i) resistance[i] = float(0.3 + random_unit({seed, 77, i}));
    flood([&](std::size_t from, std::size_t to, float distance) { return height_[from] + distance * resistance[to]; });
  }

  /// First heights of a finer level: those of the coarser one, with every hollow led out.
  void refine(const Grid<float>& coarser, std::uint64_t seed) {
    Grid<float> start(cells_, cells_);
    parallel_rows(0, cells_, [&](int y) {
      for (int x = 0; x < cells_; ++x) {
        const double rough = 0.25 * cell_size_ * (random_unit({seed, std::uint64_t(cells_), start.index(x, y)}) - 0.5);
        start(x, y) = sample_bilinear(coarser, (x + 0.5) / 2 - 0.5, (y + 0.5) / 2 - 0.5) + float(rough);
      }
    });
    flood([&](std::size_t from, std::size_t to, float) { return std::max(start[to], height_[from] + 1e-3F); });
  }

  /// Solves tree and heights by turns.
  void settle(int rounds) {
    for (int round = 0; round < rounds; ++round) {
      order_upstream();
      accumulate();
      raise();
      if (round + 1 < rounds) turn_to_steepest();
    }
  }

  [[nodiscard]] const Grid<float>& height() const { return height_; }

 private:
  void place_root(int x, int y) {
    if (double(course_.distance(x, y)) <= 0.71 * cell_size_) {
      height_(x, y) = float(design_.course[std::size_t(course_.nearest(x, y))].bed);
      root_(x, y) = 1;
      return;
    }
    const bool border = x == 0 || y == 0 || x == cells_ - 1 || y == cells_ - 1;
    if (!border) return;
    const float floor = design_.border_floor((x + 0.5) * cell_size_, (y + 0.5) * cell_size_);
    if (floor <= 0) return;
    height_(x, y) = floor;
    root_(x, y) = 1;
  }

  /// Visits all cells from the roots, lowest first; a cell's height is `height_of(from, to, distance)` and it drains back to `from`.
  template <class HeightOf>
  void flood(const HeightOf& height_of) {
    using Entry = std::pair<float, std::uint32_t>;
    std::priority_queue<Entry, std::vector<Entry>, std::greater<>> heap;
    for (std::size_t i = 0; i < height_.size(); ++i) {
      if (root_[i] != 0) heap.emplace(height_[i], std::uint32_t(i));
    }
    while (!heap.empty()) {
      const std::uint32_t cell = heap.top().second;
      heap.pop();
      each_neighbour(cell, [&](std::size_t n, int d) {
        if (height_[n] != unknown) return;
        height_[n] = height_of(cell, n, link_length(d));
        receiver_[n] = std::uint8_t(opposite_direction(d));
        heap.emplace(height_[n], std::uint32_t(n));
      });
    }
  }

  template <class Body>
  void each_neighbour(std::size_t cell, const Body& body) const {
    const int x = int(cell % std::size_t(cells_));
    const int y = int(cell / std::size_t(cells_));
    for (int d = 0; d < 8; ++d) {
      const int nx = x + neighbour_dx[std::size_t(d)];
      const int ny = y + neighbour_dy[std::size_t(d)];
      if (height_.contains(nx, ny)) body(height_.index(nx, ny), d);
    }
  }

  [[nodiscard]] float link_length(int direction) const { return float(cell_size_) / neighbour_inverse_distance[std::size_t(direction)]; }

  [[nodiscard]] std::size_t receiver_of(std::size_t cell) const {
    const std::size_t d = receiver_[cell];
    return std::size_t(std::ptrdiff_t(cell) + neighbour_dy[d] * cells_ + neighbour_dx[d]);
  }

  /// Cells such that each comes after the one it drains to.
  void order_upstream() {
    first_donor_.assign(height_.size() + 1, 0);
    for (std::size_t i = 0; i < height_.size(); ++i) {
      if (root_[i] == 0) ++first_donor_[receiver_of(i)];
    }
    std::uint32_t sum = 0;
    for (auto& first : first_donor_) sum += std::exchange(first, sum);
    donors_.resize(height_.size());
    std::vector<std::uint32_t> place(first_donor_.begin(), first_donor_.end() - 1);
    for (std::size_t i = 0; i < height_.size(); ++i) {
      if (root_[i] == 0) donors_[place[receiver_of(i)]++] = std::uint32_t(i);
    }
    order_.clear();
    order_.reserve(height_.size());
    for (std::size_t i = 0; i < height_.size(); ++i) {
      if (root_[i] != 0) order_.push_back(std::uint32_t(i));
    }
    for (std::size_t next = 0; next < order_.size(); ++next) {
      const std::uint32_t cell = order_[next];
      for (std::uint32_t d = first_donor_[cell]; d < first_donor_[cell + 1]; ++d) order_.push_back(donors_[d]);
    }
  }

  void accumulate() {
    area_.assign(height_.size(), float(cell_size_ * cell_size_));
    for (std::size_t k = order_.size(); k-- > 0;) {
      const std::uint32_t cell = order_[k];
      if (root_[cell] == 0) area_[receiver_of(cell)] += area_[cell];
    }
  }

  void raise() {
    for (const std::uint32_t cell : order_) {
      if (root_[cell] != 0) continue;
      const float below = height_[receiver_of(cell)];
      height_[cell] = below + slope_above(cell, below) * link_length(receiver_[cell]);
    }
  }

  /// Slope of the ground that rises from `below` to a cell.
  [[nodiscard]] float slope_above(std::uint32_t cell, float below) const {
    const float hardness = rock_.hardness[cell];
    const float level = below + rock_.dip[cell];
    float hard = design_.hard_slope;
    for (const RockBed& bed : design_.beds) {
      if (level >= bed.from && level < bed.to) hard = bed.steepest;
    }
    float slope = design_.soft_slope + (hard - design_.soft_slope) * hardness;
    const float steepness = design_.soft_steepness + (design_.hard_steepness - design_.soft_steepness) * hardness;
    slope = std::min(slope, steepness * std::pow(area_[cell] * 1e-6F, -concavity));
    const float edge = std::clamp((below - rock_.plateau[cell]) / design_.plateau_edge + 0.5F, 0.0F, 1.0F);
    slope += (std::min(slope, design_.plateau_slope) - slope) * edge;
    const auto floor = float(design_.course[std::size_t(course_.nearest[cell])].floor);
    // The floor's edge is a few cells of ever steeper ground, not a line.
    const float beyond = std::clamp((course_.distance[cell] - floor) / (0.35F * floor + 1), 0.0F, 1.0F);
    return std::min(slope, design_.floor_slope + (slope - design_.floor_slope) * beyond * beyond);
  }

  void turn_to_steepest() {
    parallel_rows(0, cells_, [&](int y) {
      for (int x = 0; x < cells_; ++x) {
        const std::size_t cell = height_.index(x, y);
        if (root_[cell] != 0) continue;
        float best = 0;
        each_neighbour(cell, [&](std::size_t n, int d) {
          const float fall = (height_[cell] - height_[n]) * neighbour_inverse_distance[std::size_t(d)];
          if (fall <= best) return;
          best = fall;
          receiver_[cell] = std::uint8_t(d);
        });
      }
    });
  }

  const LandscapeDesign& design_;
  int cells_;
  double cell_size_;
  RockMaps rock_;
  CourseDistance course_;
  Grid<float> height_;
  Grid<std::uint8_t> root_;
  Grid<std::uint8_t> receiver_;
  std::vector<float> area_;
  std::vector<std::uint32_t> order_;
  std::vector<std::uint32_t> first_donor_;
  std::vector<std::uint32_t> donors_;
};

}  // namespace

Grid<float> dissect(const LandscapeDesign& design, int coarsest, int cells, const TaskContext& context) {
  Grid<float> height;
  int rounds = 30;
  for (int level_cells = coarsest; level_cells <= cells; level_cells *= 2) {
    if (context.stopped()) return {};
    context.report("eroding", double(level_cells) / (2 * cells));
    Level level(design, level_cells);
    if (height.empty()) {
      level.grow(design.seed);
    } else {
      level.refine(height, design.seed);
    }
    level.settle(std::max(rounds, 2));
    rounds /= 3;
    height = level.height();
  }
  return height;
}

}  // namespace biotope

#include "core/ecosystem/explanation_obstacles.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <string_view>
#include <unordered_set>

#include "core/ecosystem/explanation_plant_text.hpp"
#include "core/ecosystem/obstacle_rows.hpp"

namespace biotope {
namespace {

double severity(const Ground& ground, Obstacle kind, int x, int y) {
  switch (kind) {
    case Obstacle::slope:
      return double(ground.derivatives->slope(x, y));
    case Obstacle::deep_water:
      return double(ground.hydrology->water_depth(x, y));
    case Obstacle::trees:
      return double((*ground.tree_cover)(x, y)) / full_cover;
    case Obstacle::painted:
    case Obstacle::none:
      break;
  }
  return 0;
}

/// Counts obstacles by kind, the nearest first.
class BarrierCount {
 public:
  explicit BarrierCount(const Ground& ground) : ground_(ground) {}

  void meet(Obstacle kind, int x, int y, double distance) {
    if (kind == Obstacle::none) return;
    Own& own = kinds_[std::size_t(kind)];
    if (own.cells++ == 0 || distance < own.distance) {
      own.distance = distance;
      own.barrier.x = x;
      own.barrier.y = y;
    }
    own.barrier.kind = kind;
    own.barrier.worst = std::max(own.barrier.worst, severity(ground_, kind, x, y));
  }
  [[nodiscard]] std::optional<Barrier> greatest() const {
    const auto most =
        std::max_element(kinds_.begin(), kinds_.end(), [](const Own& a, const Own& b) { return a.cells < b.cells; });
    return most->cells > 0 ? std::optional(most->barrier) : std::nullopt;
  }

 private:
  struct Own {
    std::size_t cells = 0;
    double distance = 0;
    Barrier barrier;
  };
  const Ground& ground_;
  std::array<Own, std::size_t(Obstacle::painted) + 1> kinds_;
};

std::string_view water_name(const Ground& ground, int x, int y) {
  switch (ground.hydrology->water(x, y)) {
    case WaterKind::lake:
      return "a lake";
    case WaterKind::sea:
      return "the sea";
    case WaterKind::river:
      return "a river";
    case WaterKind::dry:
      break;
  }
  return "water";
}

std::string kind_text(const Ground& ground, const Barrier& barrier) {
  switch (barrier.kind) {
    case Obstacle::slope:
      return "ground steeper than it walks (" + number_text(barrier.worst, 2) + " m per m)";
    case Obstacle::deep_water:
      return std::string(water_name(ground, barrier.x, barrier.y)) + " deeper than it wades (" + number_text(barrier.worst, 1) +
             " m)";
    case Obstacle::trees:
      return "trees denser than it pushes through (" + percent_text(barrier.worst) + ")";
    case Obstacle::painted:
      return "a painted obstacle";
    case Obstacle::none:
      break;
  }
  return "nothing";
}

}  // namespace

std::optional<Barrier> barrier_between(const Ground& ground, const Mobility& mobility, int x, int y, int to_x, int to_y) {
  const ObstacleRows obstacles(ground, mobility);
  BarrierCount count(ground);
  const int steps = std::max({std::abs(to_x - x), std::abs(to_y - y), 1});
  for (int i = 0; i <= steps; ++i) {
    const int cx = x + int(std::lround(double(to_x - x) * i / steps));
    const int cy = y + int(std::lround(double(to_y - y) * i / steps));
    count.meet(obstacles.at(cx, cy), cx, cy, double(i));
  }
  return count.greatest();
}

std::optional<Barrier> barrier_around(const Ground& ground, const Mobility& mobility, int x, int y, std::size_t most_cells) {
  const ObstacleRows obstacles(ground, mobility);
  const Grid<float>& height = ground.terrain->height;
  if (obstacles.at(x, y) != Obstacle::none) return std::nullopt;
  BarrierCount count(ground);
  std::vector<std::size_t> cells{height.index(x, y)};
  std::unordered_set<std::size_t> seen{cells.front()};
  for (std::size_t next = 0; next < cells.size(); ++next) {
    if (cells.size() > most_cells) return std::nullopt;
    const int cx = int(cells[next] % std::size_t(height.width()));
    const int cy = int(cells[next] / std::size_t(height.width()));
    for (const auto& [dx, dy] : {std::array{1, 0}, std::array{-1, 0}, std::array{0, 1}, std::array{0, -1}}) {
      const int nx = cx + dx;
      const int ny = cy + dy;
      if (!height.contains(nx, ny) || !seen.insert(height.index(nx, ny)).second) continue;
      const Obstacle kind = obstacles.at(nx, ny);
      count.meet(kind, nx, ny, std::hypot(double(nx - x), double(ny - y)));
      if (kind == Obstacle::none) cells.push_back(height.index(nx, ny));
    }
  }
  return count.greatest();
}

std::string barrier_text(const Ground& ground, const Barrier& barrier, int from_x, int from_y) {
  constexpr std::array<std::string_view, 8> winds{"east", "south-east", "south", "south-west",
                                                  "west", "north-west", "north", "north-east"};
  const std::string text = kind_text(ground, barrier);
  const double dx = barrier.x - from_x;
  const double dy = barrier.y - from_y;
  if (dx == 0 && dy == 0) return text;
  const double eighths = std::atan2(dy, dx) / (3.14159265358979323846 / 4);
  const auto wind = std::size_t((int(std::lround(eighths)) + 8) % 8);
  return text + ", " + number_text(std::hypot(dx, dy) * ground.terrain->cell_size, 0) + " m to the " + std::string(winds[wind]);
}

std::optional<RegionCell> nearest_region_cell(const RunMap& label, std::span<const double> population, int x, int y) {
  const int farthest = std::max({x, y, label.width() - 1 - x, label.height() - 1 - y});
  std::optional<RegionCell> nearest;
  double best = 0;
  const auto look = [&](int cx, int cy) {
    if (!label.contains(cx, cy)) return;
    const std::int32_t region = label(cx, cy);
    if (region < 0 || !(population[std::size_t(region)] > 0)) return;
    const double distance = std::hypot(double(cx - x), double(cy - y));
    if (nearest && distance >= best) return;
    best = distance;
    nearest = RegionCell{cx, cy, region};
  };
  // A cell of a ring is at least as far as the ring is wide.
  for (int ring = 0; ring <= farthest && !(nearest && best <= ring); ++ring) {
    for (int cx = x - ring; cx <= x + ring; ++cx) look(cx, y - ring);
    for (int cy = y - ring + 1; cy < y + ring; ++cy) {
      look(x - ring, cy);
      look(x + ring, cy);
    }
    for (int cx = x - ring; ring > 0 && cx <= x + ring; ++cx) look(cx, y + ring);
  }
  return nearest;
}

}  // namespace biotope

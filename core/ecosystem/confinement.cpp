#include "core/ecosystem/confinement.hpp"

#include <algorithm>
#include <atomic>
#include <cmath>

#include "core/base/parallel.hpp"
#include "core/ecosystem/cell_runs.hpp"

namespace biotope {
namespace {

/// Smallest radius of a ford's corridor, cells and metres. Our choice: wide enough that a diagonal river does not close it.
constexpr double ford_radius_cells = 2;
constexpr double ford_radius_metres = 6;

/// Radius (cells) of the disk that a ford opens: its river's width and a cell.
double ford_radius(const Hydrology& hydrology, const Ford& ford, double cell_size) {
  float discharge = 0;
  for (int dy = -1; dy <= 1; ++dy) {
    for (int dx = -1; dx <= 1; ++dx) {
      if (hydrology.discharge.contains(ford.x + dx, ford.y + dy)) {
        discharge = std::max(discharge, hydrology.discharge(ford.x + dx, ford.y + dy));
      }
    }
  }
  return std::max({river_width(discharge) / cell_size + 1, ford_radius_cells, ford_radius_metres / cell_size});
}

/// Columns [x0, x1) of a row.
struct Interval {
  int x0 = 0;
  int x1 = 0;
};

/// Densest tree cover that an animal pushes through, in 1/full_cover.
int most_trees(const Mobility& mobility) { return int(std::floor(double(mobility.max_tree_cover) * full_cover + 0.5)); }

/// Obstacles of one kind of animal, row by row.
class ObstacleRows {
 public:
  ObstacleRows(const Ground& ground, const Mobility& mobility)
      : slope_(ground.derivatives->slope),
        depth_(ground.hydrology->water_depth),
        trees_(ground.tree_cover.get()),
        mobility_(mobility),
        max_trees_(most_trees(mobility)),
        fords_(std::size_t(slope_.height())) {
    for (const Ford& ford : ground.hydrology->fords) {
      const double radius = ford_radius(*ground.hydrology, ford, ground.terrain->cell_size);
      const int reach = int(std::floor(radius));
      for (int dy = -reach; dy <= reach; ++dy) {
        const int y = ford.y + dy;
        if (y < 0 || y >= slope_.height()) continue;
        const int half = int(std::floor(std::sqrt(radius * radius - double(dy) * dy)));
        fords_[std::size_t(y)].push_back({std::max(0, ford.x - half), std::min(slope_.width(), ford.x + half + 1)});
      }
    }
  }

  /// Writes `open` or `closed` for every cell of row y.
  template <class Value>
  void fill_row(int y, std::span<Value> out, Value open, Value closed) const {
    const auto slope = slope_.row(y);
    const auto depth = depth_.row(y);
    for (std::size_t x = 0; x < out.size(); ++x) {
      out[x] = (slope[x] > mobility_.max_slope) | (depth[x] > mobility_.wade_depth) ? closed : open;
    }
    for (const Interval& ford : fords_[std::size_t(y)]) {
      for (int x = ford.x0; x < ford.x1; ++x) out[std::size_t(x)] = slope[std::size_t(x)] > mobility_.max_slope ? closed : open;
    }
    if (trees_ == nullptr) return;
    const auto trees = trees_->row(y);
    for (std::size_t x = 0; x < out.size(); ++x) out[x] = trees[x] > max_trees_ ? closed : out[x];
  }

  [[nodiscard]] Obstacle at(int x, int y) const {
    if (slope_(x, y) > mobility_.max_slope) return Obstacle::slope;
    const auto& fords = fords_[std::size_t(y)];
    const bool in_ford = std::any_of(fords.begin(), fords.end(), [&](const Interval& i) { return x >= i.x0 && x < i.x1; });
    if (depth_(x, y) > mobility_.wade_depth && !in_ford) return Obstacle::deep_water;
    if (trees_ != nullptr && (*trees_)(x, y) > max_trees_) return Obstacle::trees;
    return Obstacle::none;
  }

 private:
  const Grid<float>& slope_;
  const Grid<float>& depth_;
  const Grid<Cover>* trees_;
  Mobility mobility_;
  int max_trees_;
  std::vector<std::vector<Interval>> fords_;
};

ConfinementRegions regions_of(const RunTable& passable, double cell_size) {
  const Areas areas = connected_areas(passable);
  const std::size_t minimum = minimum_region_cells(cell_size);
  ConfinementRegions result;
  std::vector<std::int32_t> region_of_area(areas.areas.size(), -1);
  for (std::size_t i = 0; i < areas.areas.size(); ++i) {
    const Area& area = areas.areas[i];
    if (area.cells < minimum) continue;
    region_of_area[i] = std::int32_t(result.regions.size());
    result.regions.push_back({area.cells, double(area.cells) * cell_size * cell_size, area.bounds});
  }
  result.label = Grid<std::int32_t>(passable.width, passable.height, -1);
  parallel_rows(0, passable.height, [&](int y) {
    const auto row = result.label.row(y);
    for (std::size_t i = passable.row_start[std::size_t(y)]; i < passable.row_start[std::size_t(y) + 1]; ++i) {
      const std::int32_t region = region_of_area[std::size_t(areas.area_of_run[i])];
      const CellRun& run = passable.runs[i];
      if (region >= 0) std::fill(row.begin() + run.x0, row.begin() + run.x1, region);
    }
  });
  return result;
}

}  // namespace

std::size_t minimum_region_cells(double cell_size) {
  return std::size_t(std::max(1.0, std::ceil(minimum_region_area / (cell_size * cell_size) - 1e-9)));
}

Mobility mobility_of(const AnimalTraits& animal) {
  return {animal.max_slope, animal.wade_depth, animal.max_tree_cover, animal.slope_sensitivity};
}

bool same_obstacles(const Mobility& a, const Mobility& b) {
  return a.max_slope == b.max_slope && a.wade_depth == b.wade_depth && a.max_tree_cover == b.max_tree_cover;
}

bool same_blocked_cells(const Ground& a, const Ground& b, const Mobility& mobility) {
  if (a.terrain != b.terrain || a.derivatives != b.derivatives || a.hydrology != b.hydrology) return false;
  if (a.tree_cover == b.tree_cover) return true;
  if (!a.tree_cover || !b.tree_cover) return false;
  const int most = most_trees(mobility);
  std::atomic<bool> same = true;
  parallel_rows(0, a.tree_cover->height(), [&](int y) {
    const auto before = a.tree_cover->row(y);
    const auto after = b.tree_cover->row(y);
    int changed = 0;
    for (std::size_t x = 0; x < before.size(); ++x) changed |= int((before[x] > most) != (after[x] > most));
    if (changed != 0) same = false;
  });
  return same;
}

Obstacle obstacle_at(const Ground& ground, const Mobility& mobility, int x, int y) {
  return ObstacleRows(ground, mobility).at(x, y);
}

Grid<std::uint8_t> blocked_cells(const Ground& ground, const Mobility& mobility) {
  const ObstacleRows obstacles(ground, mobility);
  Grid<std::uint8_t> blocked(ground.terrain->height.width(), ground.terrain->height.height());
  parallel_rows(0, blocked.height(), [&](int y) { obstacles.fill_row<std::uint8_t>(y, blocked.row(y), 0, 1); });
  return blocked;
}

ConfinementRegions confinement_regions(const Grid<std::uint8_t>& blocked, double cell_size) {
  return regions_of(collect_runs(blocked.width(), blocked.height(),
                                 [&](int y, std::span<std::int64_t> out) {
                                   const auto row = blocked.row(y);
                                   for (std::size_t x = 0; x < out.size(); ++x) out[x] = row[x] != 0 ? -1 : 0;
                                 }),
                    cell_size);
}

ConfinementRegions confinement_regions(const Ground& ground, const Mobility& mobility) {
  const ObstacleRows obstacles(ground, mobility);
  return regions_of(
      collect_runs<std::int8_t>(ground.terrain->height.width(), ground.terrain->height.height(),
                                [&](int y, std::span<std::int8_t> out) { obstacles.fill_row<std::int8_t>(y, out, 0, -1); }),
      ground.terrain->cell_size);
}

}  // namespace biotope

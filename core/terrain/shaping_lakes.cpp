#include <algorithm>
#include <cmath>
#include <limits>

#include "core/terrain/neighbours.hpp"
#include "core/terrain/shaping.hpp"
#include "core/terrain/shaping_parts.hpp"

namespace biotope {
namespace {

/// The floor of a drawn lake falls at most this steeply (our choice: one can wade in), rise / run.
constexpr float steepest_floor = 0.5F;
/// ... and reaches its depth at this share of the way from the shore to the place farthest from it, or later. Our choice.
constexpr float wide_floor = 0.6F;

/// Cells that the curve's box touches, within the map.
Rect bounds_of(std::span<const PathPoint> line, const Rect& map) {
  Rect box;
  for (const PathPoint& point : line) {
    const double x = std::clamp(double(point.x), -2.0, map.x1 + 1.0);
    const double y = std::clamp(double(point.y), -2.0, map.y1 + 1.0);
    box = bounding(box, {int(std::floor(x)), int(std::floor(y)), int(std::ceil(x)) + 1, int(std::ceil(y)) + 1});
  }
  return intersection(box, map);
}

/// Marks the cells of `bounds` whose centres lie inside the closed line (even-odd rule).
void mark_inside(std::span<const PathPoint> line, LakeBasin& lake) {
  std::vector<double> crossings;
  for (int row = 0; row < lake.parts.height(); ++row) {
    const double y = row + lake.bounds.y0;
    crossings.clear();
    for (std::size_t i = 0; i + 1 < line.size(); ++i) {
      const double ya = double(line[i].y);
      const double yb = double(line[i + 1].y);
      if ((ya <= y) == (yb <= y)) continue;
      crossings.push_back(double(line[i].x) + (double(line[i + 1].x) - double(line[i].x)) * (y - ya) / (yb - ya));
    }
    std::sort(crossings.begin(), crossings.end());
    for (std::size_t i = 0; i + 1 < crossings.size(); i += 2) {
      const double first = std::max(std::ceil(crossings[i]), double(lake.bounds.x0));
      const double last = std::min(std::floor(crossings[i + 1]), double(lake.bounds.x1 - 1));
      for (int x = int(first); double(x) <= last; ++x) lake.parts(x - lake.bounds.x0, row) = LakeBasin::basin;
    }
  }
}

/// Turns inside cells beside others, or on the map's border, into the rim; those that touch no basin are left outside.
void mark_rim(LakeBasin& lake, const Rect& map) {
  const Grid<std::uint8_t> inside = lake.parts;
  for (int y = 0; y < inside.height(); ++y) {
    for (int x = 0; x < inside.width(); ++x) {
      if (inside(x, y) == LakeBasin::outside) continue;
      bool at_edge = false;
      for (std::size_t d = 0; d < 8; ++d) {
        const int nx = x + neighbour_dx[d];
        const int ny = y + neighbour_dy[d];
        const bool on_map = map.contains(nx + lake.bounds.x0, ny + lake.bounds.y0);
        at_edge |= !on_map || !inside.contains(nx, ny) || inside(nx, ny) == LakeBasin::outside;
      }
      if (at_edge) lake.parts(x, y) = LakeBasin::rim;
    }
  }
  for (int y = 0; y < inside.height(); ++y) {
    for (int x = 0; x < inside.width(); ++x) {
      if (lake.parts(x, y) != LakeBasin::rim) continue;
      bool holds = false;
      for (std::size_t d = 0; d < 8; ++d) {
        const int nx = x + neighbour_dx[d];
        const int ny = y + neighbour_dy[d];
        holds |= inside.contains(nx, ny) && lake.parts(nx, ny) == LakeBasin::basin;
      }
      if (!holds) lake.parts(x, y) = LakeBasin::outside;
    }
  }
}

/// Squared distance from each place of a line to the nearest one, where `own` are the squared distances across the line: the
/// lower envelope of parabolas (Felzenszwalb and Huttenlocher 2012).
void lower_envelope(std::vector<float>& own) {
  const int count = int(own.size());
  std::vector<int> site(own.size());
  std::vector<double> from(own.size() + 1);
  int last = -1;
  const auto value = [&](int i) { return double(own[std::size_t(i)]) + double(i) * i; };
  for (int i = 0; i < count; ++i) {
    if (own[std::size_t(i)] == std::numeric_limits<float>::infinity()) continue;
    double start = -std::numeric_limits<double>::infinity();
    while (last >= 0) {
      const int before = site[std::size_t(last)];
      start = (value(i) - value(before)) / (2.0 * (i - before));
      if (start > from[std::size_t(last)]) break;
      --last;
      start = -std::numeric_limits<double>::infinity();
    }
    site[std::size_t(++last)] = i;
    from[std::size_t(last)] = start;
  }
  if (last < 0) return;
  std::vector<float> result(own.size());
  int k = 0;
  for (int i = 0; i < count; ++i) {
    while (k < last && from[std::size_t(k) + 1] < i) ++k;
    const int nearest = site[std::size_t(k)];
    result[std::size_t(i)] = own[std::size_t(nearest)] + float(i - nearest) * float(i - nearest);
  }
  own = std::move(result);
}

/// Distance (cells) of each cell of the basin to the nearest one that is not of it.
Grid<float> distance_to_rim(const Grid<std::uint8_t>& parts) {
  Grid<float> square(parts.width(), parts.height());
  for (std::size_t i = 0; i < parts.size(); ++i) {
    square[i] = parts[i] == LakeBasin::basin ? std::numeric_limits<float>::infinity() : 0.0F;
  }
  std::vector<float> line(static_cast<std::size_t>(parts.height()));
  for (int x = 0; x < parts.width(); ++x) {
    for (int y = 0; y < parts.height(); ++y) line[std::size_t(y)] = square(x, y);
    lower_envelope(line);
    for (int y = 0; y < parts.height(); ++y) square(x, y) = line[std::size_t(y)];
  }
  for (int y = 0; y < parts.height(); ++y) {
    line.assign(square.row(y).begin(), square.row(y).end());
    lower_envelope(line);
    std::transform(line.begin(), line.end(), square.row(y).begin(), [](float value) { return std::sqrt(value); });
  }
  return square;
}

/// Ground of a cell, or the water of a lake that is already there.
float surface_at(const Terrain& terrain, std::span<const LakeBasin> lakes, int x, int y) {
  float surface = terrain.height(x, y);
  for (const LakeBasin& lake : lakes) {
    if (lake.part(x, y) == LakeBasin::basin) surface = std::max(surface, lake.surface);
  }
  return surface;
}

/// The cells of the basin with the floor they are dug to.
std::vector<CutCell> basin_floor(const LakeBasin& lake, float depth, const Terrain& terrain) {
  const Grid<float> distance = distance_to_rim(lake.parts);
  const auto cell_size = float(terrain.cell_size);
  const float farthest = *std::max_element(distance.cells().begin(), distance.cells().end()) * cell_size;
  // The smooth step from shore to depth is steepest in its middle: 1.5 depth / way.
  const float reached = std::min(depth, farthest * steepest_floor / 1.5F);
  const float way = std::max(1.5F * reached / steepest_floor, wide_floor * farthest);
  std::vector<CutCell> cells;
  for (int y = 0; y < distance.height(); ++y) {
    for (int x = 0; x < distance.width(); ++x) {
      if (lake.parts(x, y) != LakeBasin::basin) continue;
      const float t = std::min(distance(x, y) * cell_size / way, 1.0F);
      cells.push_back(
          {terrain.height.index(x + lake.bounds.x0, y + lake.bounds.y0), lake.surface - reached * t * t * (3 - 2 * t)});
    }
  }
  return cells;
}

/// A drawn lake's parts, without its surface; without cells where it has no place on the map.
LakeBasin outline(const DrawnLake& drawn, const Rect& map) {
  LakeBasin lake;
  if (drawn.shore.size() < 3 || !(drawn.depth > 0)) return lake;
  const std::vector<PathPoint> shore = smooth_line(drawn.shore, true);
  lake.bounds = bounds_of(shore, map);
  if (lake.bounds.empty()) return lake;
  lake.parts = Grid<std::uint8_t>(lake.bounds.width(), lake.bounds.height(), LakeBasin::outside);
  mark_inside(shore, lake);
  mark_rim(lake, map);
  return lake;
}

}  // namespace

std::vector<std::uint32_t> cells_of_lakes(std::span<const DrawnLake> lakes, const Rect& map) {
  std::vector<std::uint32_t> cells;
  for (const DrawnLake& drawn : lakes) {
    const LakeBasin lake = outline(drawn, map);
    for (int y = lake.bounds.y0; y < lake.bounds.y1; ++y) {
      for (int x = lake.bounds.x0; x < lake.bounds.x1; ++x) {
        if (lake.part(x, y) == LakeBasin::basin)
          cells.push_back(std::uint32_t(y) * std::uint32_t(map.width()) + std::uint32_t(x));
      }
    }
  }
  std::sort(cells.begin(), cells.end());
  cells.erase(std::unique(cells.begin(), cells.end()), cells.end());
  return cells;
}

void dig_lake(Terrain& terrain, const DrawnLake& drawn, std::vector<LakeBasin>& lakes, TouchedTiles& touched) {
  LakeBasin lake = outline(drawn, terrain.height.rect());
  if (lake.bounds.empty()) return;
  touched.insert(lake.bounds);
  lake.surface = std::numeric_limits<float>::infinity();
  bool has_basin = false;
  for (int y = lake.bounds.y0; y < lake.bounds.y1; ++y) {
    for (int x = lake.bounds.x0; x < lake.bounds.x1; ++x) {
      has_basin |= lake.part(x, y) == LakeBasin::basin;
      if (lake.part(x, y) == LakeBasin::rim) lake.surface = std::min(lake.surface, surface_at(terrain, lakes, x, y));
    }
  }
  if (!has_basin) return;
  const std::vector<CutCell> floor = basin_floor(lake, drawn.depth, terrain);
  lakes.push_back(std::move(lake));
  cut_with_banks(terrain.height, terrain.cell_size, floor, lakes, touched);
}

}  // namespace biotope

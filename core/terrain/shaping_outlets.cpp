#include "core/terrain/shaping_outlets.hpp"

#include <algorithm>
#include <queue>
#include <unordered_map>

#include "core/base/tiled_map.hpp"
#include "core/terrain/neighbours.hpp"

namespace biotope {
namespace {

/// Digging a metre deep costs as much as so many metres of way. Our choice.
constexpr double digging_cost = 10;
/// The way is not dug through ground that rises more than this over that at the end, m: less is noise. Our choice.
constexpr float highest_rise = 0.5F;
/// Cells that are looked at, at most: a second's tenth.
constexpr std::size_t most_cells = 400000;
/// The way keeps so many cells away from the bed above its end.
constexpr int kept_beside = 2;
/// Fall of the channel, rise / run.
constexpr double channel_fall = 1e-4;

struct Visit {
  double cost = 0;
  double way = 0;
  std::size_t cell = 0;
  bool operator>(const Visit& other) const { return cost != other.cost ? cost > other.cost : cell > other.cell; }
};

struct Best {
  double cost = 0;
  double way = 0;
  std::size_t before = 0;
};

bool near_end(const BedEnd& end, int x, int y) {
  const double dx = x - end.x;
  const double dy = y - end.y;
  return dx * dx + dy * dy <= (end.half_width + 1) * (end.half_width + 1);
}

/// 1 on the bed but for its end, and on the cells beside it: the way out must not undercut the river.
TiledMap<std::uint8_t> upstream_cells(const Grid<float>& height, const BedEnd& end, std::span<const CutCell> bed) {
  TiledMap<std::uint8_t> upstream(height.width(), height.height());
  for (const CutCell& own : bed) {
    const int x = int(own.cell % std::size_t(height.width()));
    const int y = int(own.cell / std::size_t(height.width()));
    if (near_end(end, x, y)) continue;
    for (int ny = y - kept_beside; ny <= y + kept_beside; ++ny) {
      for (int nx = x - kept_beside; nx <= x + kept_beside; ++nx) {
        if (height.contains(nx, ny) && !near_end(end, nx, ny)) upstream.set(nx, ny, 1);
      }
    }
  }
  return upstream;
}

}  // namespace

std::vector<CutCell> lead_out(const Terrain& terrain, const BedEnd& end, std::span<const CutCell> bed,
                              std::span<const LakeBasin> lakes, TouchedTiles& touched) {
  const Grid<float>& height = terrain.height;
  const auto width = std::size_t(height.width());
  const std::size_t start = height.index(end.x, end.y);
  const TiledMap<std::uint8_t> upstream = upstream_cells(height, end, bed);
  const auto leaves = [&](std::size_t cell) {
    const int x = int(cell % width);
    const int y = int(cell / width);
    if (x == 0 || y == 0 || x == height.width() - 1 || y == height.height() - 1) return true;
    if (cell != start && height[cell] < end.bed && !near_end(end, x, y)) return true;
    return std::any_of(lakes.begin(), lakes.end(), [&](const LakeBasin& lake) { return lake.part(x, y) != LakeBasin::outside; });
  };
  const float highest = end.ground + highest_rise;
  std::priority_queue<Visit, std::vector<Visit>, std::greater<>> front;
  std::unordered_map<std::size_t, Best> best{{start, {0, 0, start}}};
  front.push({0, 0, start});
  touched.insert_cell(start);
  for (std::size_t seen = 0; !front.empty() && seen < most_cells; ++seen) {
    const Visit visit = front.top();
    front.pop();
    if (visit.cost > best[visit.cell].cost) continue;
    if (leaves(visit.cell)) {
      std::vector<CutCell> channel;
      for (std::size_t cell = visit.cell; cell != start; cell = best[cell].before) {
        channel.push_back({cell, float(double(end.bed) - channel_fall * best[cell].way)});
      }
      return channel;
    }
    const int x = int(visit.cell % width);
    const int y = int(visit.cell / width);
    for (std::size_t d = 0; d < 8; ++d) {
      const int nx = x + neighbour_dx[d];
      const int ny = y + neighbour_dy[d];
      if (!height.contains(nx, ny)) continue;
      const std::size_t next = height.index(nx, ny);
      touched.insert_cell(next);
      if (height[next] > highest || upstream(nx, ny) != 0) continue;
      const double step = terrain.cell_size / double(neighbour_inverse_distance[d]);
      const double dig = std::max(0.0, double(height[next]) - double(end.bed));
      const double cost = visit.cost + step * (1 + digging_cost * dig);
      const auto found = best.find(next);
      if (found != best.end() && found->second.cost <= cost) continue;
      best[next] = {cost, visit.way + step, visit.cell};
      front.push({cost, visit.way + step, next});
    }
  }
  return {};
}

}  // namespace biotope

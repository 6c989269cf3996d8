#include "render/line_field.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/glm.hpp>
#include <optional>
#include <vector>

#include "core/base/parallel.hpp"
#include "render/trail_lines.hpp"

namespace biotope {

namespace {

/// A point of a line in terrain cells with half its width there, m.
struct LinePoint {
  glm::vec2 at;
  float half_width;
};

/// One round of Chaikin's corner cutting; the ends stay.
std::vector<LinePoint> smoothed(const std::vector<LinePoint>& line) {
  if (line.size() < 3) return line;
  std::vector<LinePoint> out{line.front()};
  for (std::size_t i = 0; i + 1 < line.size(); ++i) {
    const LinePoint& a = line[i];
    const LinePoint& b = line[i + 1];
    out.push_back({glm::mix(a.at, b.at, 0.25F), glm::mix(a.half_width, b.half_width, 0.25F)});
    out.push_back({glm::mix(a.at, b.at, 0.75F), glm::mix(a.half_width, b.half_width, 0.75F)});
  }
  out.push_back(line.back());
  return out;
}

/// Every fine cell within `reach` metres of the segment a-b: visit(x, y, metres inside the line's edge).
template <class Visit>
void along_segment(const LinePoint& a, const LinePoint& b, int width, int height, int scale, double cell_size, float reach,
                   const Visit& visit) {
  const auto fine = [&](glm::vec2 p) { return (p + 0.5F) * float(scale) - 0.5F; };
  const glm::vec2 from = fine(a.at);
  const glm::vec2 to = fine(b.at);
  const float metres = float(cell_size) / float(scale);
  const float margin = (std::max(a.half_width, b.half_width) + reach) / metres;
  const int x0 = std::max(0, int(std::floor(std::min(from.x, to.x) - margin)));
  const int x1 = std::min(width - 1, int(std::ceil(std::max(from.x, to.x) + margin)));
  const int y0 = std::max(0, int(std::floor(std::min(from.y, to.y) - margin)));
  const int y1 = std::min(height - 1, int(std::ceil(std::max(from.y, to.y) + margin)));
  const glm::vec2 along = to - from;
  const float squared = std::max(glm::dot(along, along), 1e-6F);
  for (int y = y0; y <= y1; ++y) {
    for (int x = x0; x <= x1; ++x) {
      const glm::vec2 p(x, y);
      const float t = glm::clamp(glm::dot(p - from, along) / squared, 0.0F, 1.0F);
      visit(x, y, glm::mix(a.half_width, b.half_width, t) - glm::length(p - from - t * along) * metres);
    }
  }
}

std::uint8_t shore_code(float metres) {
  return std::uint8_t(std::lround(128.0F + std::clamp(metres, -shore_reach, shore_reach) * (127.0F / shore_reach)));
}

/// 1 in lakes and sea, where the cells themselves are the shape of the water.
Grid<float> standing_water(const Hydrology& hydrology) {
  Grid<float> mask(hydrology.water.width(), hydrology.water.height());
  for (std::size_t i = 0; i < mask.size(); ++i) {
    mask[i] = hydrology.water[i] == WaterKind::lake || hydrology.water[i] == WaterKind::sea ? 1.0F : 0.0F;
  }
  return mask;
}

/// The cell that a cell's water flows to; nothing where it leaves the map.
std::optional<std::uint32_t> downstream(const Hydrology& hydrology, std::uint32_t cell) {
  constexpr std::array<int, 8> east{1, 1, 0, -1, -1, -1, 0, 1};
  constexpr std::array<int, 8> south{0, 1, 1, 1, 0, -1, -1, -1};
  if (hydrology.receiver.empty() || hydrology.receiver[cell] >= 8) return std::nullopt;
  const int width = hydrology.receiver.width();
  const int x = int(cell) % width + east[hydrology.receiver[cell]];
  const int y = int(cell) / width + south[hydrology.receiver[cell]];
  if (!hydrology.receiver.contains(x, y)) return std::nullopt;
  return std::uint32_t(hydrology.receiver.index(x, y));
}

/// The line of a reach, on to the junction or lake that it flows into; every other cell is left out so that the staircase of D8
/// cells becomes a curve.
std::vector<LinePoint> reach_line(const RiverReach& reach, const Hydrology& hydrology, const FordLook& fords) {
  std::vector<LinePoint> line;
  const int width = hydrology.water.width();
  const auto add = [&](std::uint32_t cell, float discharge) {
    const glm::vec2 at(float(int(cell) % width), float(int(cell) / width));
    const float half_width = 0.5F * std::max(river_width(discharge), 0.7F);
    line.push_back({at, ford_half_width(half_width, fords.share(double(at.x), double(at.y)))});
  };
  for (std::size_t i = 0; i < reach.cells.size(); ++i) {
    if (i % 2 == 0 || i + 1 == reach.cells.size()) add(reach.cells[i], hydrology.discharge[reach.cells[i]]);
  }
  if (reach.cells.empty()) return line;
  if (const auto next = downstream(hydrology, reach.cells.back())) add(*next, hydrology.discharge[reach.cells.back()]);
  return smoothed(smoothed(line));
}

}  // namespace

int line_field_scale(int width, int height, int longest) { return std::clamp(longest / std::max({width, height, 1}), 1, 4); }

Grid<std::uint8_t> shore_field(const Terrain& terrain, const Hydrology& hydrology, int scale, const FordLook& fords) {
  const int width = terrain.height.width() * scale;
  const int height = terrain.height.height() * scale;
  Grid<std::uint8_t> shore(width, height, 0);
  const Grid<float> standing = standing_water(hydrology);
  parallel_rows(0, height, [&](int y) {
    for (int x = 0; x < width; ++x) {
      const float wet = sample_bilinear(standing, (x + 0.5) / scale - 0.5, (y + 0.5) / scale - 0.5);
      if (wet > 0) shore(x, y) = shore_code(wet >= 1 ? shore_reach : (wet - 0.5F) * 1.6F * float(terrain.cell_size));
    }
  });
  for (const RiverReach& reach : hydrology.reaches) {
    const std::vector<LinePoint> line = reach_line(reach, hydrology, fords);
    for (std::size_t i = 0; i + 1 < line.size(); ++i) {
      along_segment(line[i], line[i + 1], width, height, scale, terrain.cell_size, shore_reach,
                    [&](int x, int y, float inside) { shore(x, y) = std::max(shore(x, y), shore_code(inside)); });
    }
  }
  return shore;
}

float soft_edge(const Terrain& terrain, int scale) { return 0.5F + float(terrain.cell_size) / float(scale); }

Grid<std::uint8_t> wear_field(const Terrain& terrain, const TrailNetwork& trails, int scale) {
  const int width = terrain.height.width() * scale;
  const int height = terrain.height.height() * scale;
  Grid<std::uint8_t> wear(width, height, 0);
  const float heaviest = heaviest_weight(trails);
  if (heaviest <= 0) return wear;
  const float soft = soft_edge(terrain, scale);
  for (const TrailRoute& route : trails.routes) {
    for (std::size_t i = 0; i + 1 < route.points.size(); ++i) {
      const float use = trail_use(route.weight[i], heaviest);
      const LinePoint a{{route.points[i].x, route.points[i].y}, trail_half_width(use)};
      const LinePoint b{{route.points[i + 1].x, route.points[i + 1].y}, trail_half_width(use)};
      along_segment(a, b, width, height, scale, terrain.cell_size, soft, [&](int x, int y, float inside) {
        wear(x, y) = std::max(wear(x, y), std::uint8_t(worn_share(inside, use, soft) * 255));
      });
    }
  }
  return wear;
}

}  // namespace biotope

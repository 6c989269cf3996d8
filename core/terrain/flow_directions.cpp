#include <algorithm>
#include <vector>

#include "core/base/parallel.hpp"
#include "core/terrain/flow_routing.hpp"
#include "core/terrain/neighbours.hpp"

namespace biotope {
namespace {

constexpr std::uint8_t undecided = 255;

/// Steepest fall of a cell with eight neighbours, or undecided on a flat.
inline std::uint8_t steepest_inside(const float* cell, const std::array<std::ptrdiff_t, 8>& offsets) {
  float best = 0;
  std::uint8_t direction = undecided;
  for (std::size_t d = 0; d < 8; ++d) {
    const float fall = (*cell - cell[offsets[d]]) * neighbour_inverse_distance[d];
    if (fall > best) {
      best = fall;
      direction = std::uint8_t(d);
    }
  }
  return direction;
}

/// The same on the border, where the ground is taken to go on beyond as it goes inside; water does not leave through an inlet.
std::uint8_t steepest_on_border(const Grid<float>& filled, int x, int y, bool inlet) {
  const float here = filled(x, y);
  float best = 0;
  std::uint8_t direction = inlet ? undecided : leaves_map;
  for (std::size_t d = 0; d < 8; ++d) {
    const int nx = x + neighbour_dx[d];
    const int ny = y + neighbour_dy[d];
    float fall = 0;
    if (filled.contains(nx, ny)) {
      fall = (here - filled(nx, ny)) * neighbour_inverse_distance[d];
      if (fall > best) direction = std::uint8_t(d);
    } else if (!inlet && d % 2 == 0 && filled.contains(x - neighbour_dx[d], y - neighbour_dy[d])) {
      fall = filled(x - neighbour_dx[d], y - neighbour_dy[d]) - here;
      if (fall > best) direction = leaves_map;
    }
    best = std::max(best, fall);
  }
  return direction;
}

/// Leads flats to where they empty: breadth first from the cells that already know their way.
void resolve_flats(const Grid<float>& filled, Grid<std::uint8_t>& receiver) {
  const int width = filled.width();
  std::vector<std::uint32_t> queue;
  const auto spread = [&](int x, int y) {
    for (std::size_t d = 0; d < 8; ++d) {
      const int nx = x + neighbour_dx[d];
      const int ny = y + neighbour_dy[d];
      if (!filled.contains(nx, ny) || receiver(nx, ny) != undecided || filled(nx, ny) != filled(x, y)) continue;
      receiver(nx, ny) = std::uint8_t(opposite_direction(int(d)));
      queue.push_back(std::uint32_t(filled.index(nx, ny)));
    }
  };
  // The first ring in row order, so that the result does not depend on anything but the ground.
  std::vector<std::uint32_t> rim;
  for (int y = 0; y < filled.height(); ++y) {
    for (int x = 0; x < width; ++x) {
      if (receiver(x, y) != undecided) continue;
      for (std::size_t d = 0; d < 8; ++d) {
        const int nx = x + neighbour_dx[d];
        const int ny = y + neighbour_dy[d];
        if (filled.contains(nx, ny) && filled(nx, ny) == filled(x, y) && receiver(nx, ny) != undecided) rim.push_back(std::uint32_t(filled.index(nx, ny)));
      }
    }
  }
  for (const std::uint32_t cell : rim) spread(int(cell % std::uint32_t(width)), int(cell / std::uint32_t(width)));
  for (std::size_t next = 0; next < queue.size(); ++next) {
    spread(int(queue[next] % std::uint32_t(width)), int(queue[next] / std::uint32_t(width)));
  }
}

}  // namespace

Grid<std::uint8_t> flow_directions(const Grid<float>& filled, const Grid<std::uint8_t>& sea, const Grid<std::uint8_t>& inlets) {
  const int width = filled.width();
  const int height = filled.height();
  Grid<std::uint8_t> receiver(width, height);
  const auto offsets = neighbour_offsets(width);
  parallel_rows(0, height, [&](int y) {
    const auto heights = filled.row(y);
    const auto out = receiver.row(y);
    const bool border_row = y == 0 || y == height - 1;
    for (int x = 0; x < width; ++x) {
      const bool border = border_row || x == 0 || x == width - 1;
      if (!sea.empty() && sea(x, y) != 0) {
        out[std::size_t(x)] = leaves_map;
      } else if (border) {
        out[std::size_t(x)] = steepest_on_border(filled, x, y, !inlets.empty() && inlets(x, y) != 0);
      } else {
        out[std::size_t(x)] = steepest_inside(&heights[std::size_t(x)], offsets);
      }
    }
  });
  resolve_flats(filled, receiver);
  return receiver;
}

}  // namespace biotope

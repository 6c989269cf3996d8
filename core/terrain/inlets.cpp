#include <algorithm>
#include <cstddef>

#include "core/terrain/flow_routing.hpp"

namespace biotope {
namespace {

/// A river's entry closes the border this many of its widths to either side. Our choice: about the belt in which it winds.
constexpr float widths_beside = 5;
/// ... and at least this many cells: the noise of a DEM is one or two cells wide. Our choice.
constexpr int least_beside = 2;

bool on_border(const Grid<float>& height, int x, int y) {
  return x == 0 || y == 0 || x == height.width() - 1 || y == height.height() - 1;
}

}  // namespace

Grid<std::uint8_t> find_inlets(const Terrain& terrain, const HydrologyOptions& options) {
  const Grid<float>& height = terrain.height;
  Grid<std::uint8_t> inlets;
  std::ptrdiff_t closed = 0;
  for (const Inflow& inflow : options.inflows) {
    if (!on_border(height, inflow.x, inflow.y)) continue;
    if (inlets.empty()) inlets = Grid<std::uint8_t>(height.width(), height.height());
    const float water = river_width(mean_discharge(inflow.catchment_area, options.runoff));
    const int reach = std::max(least_beside, int(double(widths_beside * water) / terrain.cell_size));
    const Rect beside = intersection({inflow.x - reach, inflow.y - reach, inflow.x + reach + 1, inflow.y + reach + 1}, height.rect());
    for (int y = beside.y0; y < beside.y1; ++y) {
      for (int x = beside.x0; x < beside.x1; ++x) {
        if (!on_border(height, x, y) || inlets(x, y) != 0) continue;
        inlets(x, y) = 1;
        ++closed;
      }
    }
  }
  const int inner = std::max(height.width() - 2, 0) * std::max(height.height() - 2, 0);
  return closed == std::ptrdiff_t(height.size()) - inner ? Grid<std::uint8_t>{} : inlets;
}

}  // namespace biotope

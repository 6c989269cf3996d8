#include <algorithm>
#include <cmath>
#include <vector>

#include "core/base/parallel.hpp"
#include "core/terrain/flow_routing.hpp"
#include "core/terrain/neighbours.hpp"
#include "core/terrain/water_marking.hpp"
#include "core/terrain/water_updates.hpp"

namespace biotope {
namespace {

constexpr double seconds_per_year = 365.25 * 86400;

bool standing(WaterKind kind) { return kind == WaterKind::lake || kind == WaterKind::sea; }

/// Channel cells that flow straight into each of the cells asked about.
int channel_donors(const Hydrology& hydrology, std::size_t cell) {
  const int width = hydrology.receiver.width();
  const int x = int(cell % std::size_t(width));
  const int y = int(cell / std::size_t(width));
  int donors = 0;
  for (int d = 0; d < 8; ++d) {
    const int nx = x + neighbour_dx[std::size_t(d)];
    const int ny = y + neighbour_dy[std::size_t(d)];
    if (!hydrology.receiver.contains(nx, ny) || hydrology.receiver(nx, ny) != opposite_direction(d)) continue;
    donors += hydrology.discharge(nx, ny) > 0 ? 1 : 0;
  }
  return donors;
}

/// Follows the channel from `start` (which may be a junction) to the next junction, lake or border.
RiverReach follow_reach(const Hydrology& hydrology, std::size_t start) {
  RiverReach reach;
  const auto offsets = neighbour_offsets(hydrology.receiver.width());
  std::size_t cell = start;
  while (true) {
    reach.cells.push_back(std::uint32_t(cell));
    // The junction closes the line, but its water is no longer this reach's alone.
    const bool junction = reach.cells.size() > 1 && channel_donors(hydrology, cell) > 1;
    if (!junction) reach.discharge = hydrology.discharge[cell];
    if (junction || hydrology.receiver[cell] == leaves_map) break;
    const std::size_t next = cell + std::size_t(offsets[hydrology.receiver[cell]]);
    if (!(hydrology.discharge[next] > 0)) break;
    cell = next;
  }
  reach.width = river_width(reach.discharge);
  reach.depth = river_depth(reach.discharge);
  return reach;
}

/// Follows the water that enters with an inflow until it leaves the map.
template <class Body>
void each_cell_downstream(const Grid<std::uint8_t>& receiver, const Inflow& inflow, const Body& body) {
  const auto offsets = neighbour_offsets(receiver.width());
  std::size_t cell = receiver.index(inflow.x, inflow.y);
  while (true) {
    body(cell);
    if (receiver[cell] == leaves_map) return;
    cell += std::size_t(offsets[receiver[cell]]);
  }
}

/// What is less than a channel, and what is lost in standing water, is no discharge.
void leave_channels(const HydrologyOptions& options, Hydrology& hydrology, std::size_t cell) {
  if (hydrology.discharge[cell] < float(options.channel_discharge) || standing(hydrology.water[cell]))
    hydrology.discharge[cell] = 0;
}

}  // namespace

float mean_discharge(double catchment_area, double runoff) { return float(catchment_area * runoff / seconds_per_year); }

float river_width(float discharge) { return 4.5F * std::sqrt(discharge); }

float river_depth(float discharge) { return discharge > 0 ? 0.3F * std::pow(discharge, 0.4F) : 0.0F; }

Grid<std::uint32_t> mark_discharge(const Terrain& terrain, const HydrologyOptions& options, Hydrology& hydrology) {
  Grid<std::uint32_t> upstream = upstream_cells(hydrology.receiver);
  Grid<float>& discharge = hydrology.discharge;
  parallel_rows(0, discharge.height(), [&](int y) {
    for (int x = 0; x < discharge.width(); ++x)
      discharge(x, y) = mean_discharge(upstream(x, y) * terrain.cell_area(), options.runoff);
  });
  for (const Inflow& inflow : options.inflows) {
    const float more = mean_discharge(inflow.catchment_area, options.runoff);
    each_cell_downstream(hydrology.receiver, inflow, [&](std::size_t cell) { discharge[cell] += more; });
  }
  parallel_rows(0, discharge.height(), [&](int y) {
    for (int x = 0; x < discharge.width(); ++x) leave_channels(options, hydrology, discharge.index(x, y));
  });
  return upstream;
}

TileSet update_discharge(const Terrain& terrain, const HydrologyOptions& options, const Grid<std::uint32_t>& upstream,
                         const Hydrology& before, DischargeChange change, Hydrology& water) {
  const auto add = [&](std::size_t cell) { change.cells.push_back(std::uint32_t(cell)); };
  for (const Inflow& inflow : change.inflows_before) each_cell_downstream(before.receiver, inflow, add);
  for (const Inflow& inflow : options.inflows) each_cell_downstream(water.receiver, inflow, add);
  Grid<float>& discharge = water.discharge;
  for (const std::uint32_t cell : change.cells)
    discharge[cell] = mean_discharge(upstream[cell] * terrain.cell_area(), options.runoff);
  for (const Inflow& inflow : options.inflows) {
    const float more = mean_discharge(inflow.catchment_area, options.runoff);
    each_cell_downstream(water.receiver, inflow, [&](std::size_t cell) { discharge[cell] += more; });
  }
  TileSet changed(discharge.width(), discharge.height());
  for (const std::uint32_t cell : change.cells) {
    leave_channels(options, water, cell);
    if (discharge[cell] != before.discharge[cell]) changed.insert_cell(cell);
  }
  return changed;
}

void trace_reaches(Hydrology& hydrology) {
  for (std::size_t cell = 0; cell < hydrology.discharge.size(); ++cell) {
    if (hydrology.discharge[cell] > 0 && channel_donors(hydrology, cell) != 1) {
      hydrology.reaches.push_back(follow_reach(hydrology, cell));
    }
  }
}

}  // namespace biotope

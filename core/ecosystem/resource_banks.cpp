#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <set>
#include <tuple>

#include "core/ecosystem/resource_nodes.hpp"

namespace biotope {
namespace {

/// Marks in `wet` the cells of row y where an animal can drink: rivers, lakes, and brooks one steps over; not the sea.
void add_drinkable(const Hydrology& hydrology, int y, std::vector<std::uint8_t>& wet) {
  if (y < 0 || y >= hydrology.water.height()) return;
  const auto water = hydrology.water.row(y);
  const auto discharge = hydrology.discharge.row(y);
  for (std::size_t x = 0; x < wet.size(); ++x) {
    const bool fresh =
        (water[x] == WaterKind::river) | (water[x] == WaterKind::lake) | ((discharge[x] > 0) & (water[x] != WaterKind::sea));
    wet[x] = std::uint8_t(wet[x] | std::uint8_t(fresh));
  }
}

/// Runs of pieces on cells where fresh water is in the cell or in one of its eight neighbours.
RunTable bank_runs(const Hydrology& hydrology, const Partition& partition) {
  return collect_runs(partition.label.width(), partition.label.height(), [&](int y, std::span<std::int64_t> out) {
    std::vector<std::uint8_t> wet(out.size());
    for (int row = y - 1; row <= y + 1; ++row) add_drinkable(hydrology, row, wet);
    const auto piece = partition.label.row(y);
    const std::size_t last = out.size() - 1;
    for (std::size_t x = 0; x <= last; ++x) {
      const bool bank = wet[x] != 0 || (x > 0 && wet[x - 1] != 0) || (x < last && wet[x + 1] != 0);
      out[x] = bank ? piece[x] : -1;
    }
  });
}

/// (species of the level, region): those with something to eat need a place to drink.
using PlacesWithFood = std::set<std::pair<int, int>>;

PlacesWithFood places_with_food(const Partition& partition, const GraphLevel& graph) {
  PlacesWithFood places;
  for (const ResourceNode& node : graph.nodes) {
    const auto& region = partition.pieces[std::size_t(node.piece)].region;
    for (std::size_t i = 0; i < region.size(); ++i) {
      if (region[i] >= 0) places.insert({int(i), region[i]});
    }
  }
  return places;
}

/// Stretches to keep: the longest in each square and piece first, so that they are spread over the map, but before all one for
/// every region that has food.
std::vector<char> choose_banks(const ResourceSources& sources, const std::vector<Area>& banks, const GraphLevel& graph) {
  const int side = patch_side(*sources.ground.terrain, 0);
  std::vector<std::size_t> order(banks.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(), [&](auto a, auto b) { return banks[a].cells > banks[b].cells; });
  std::map<std::tuple<std::int64_t, int, int>, int> in_square;
  std::vector<int> rank(banks.size());
  for (const std::size_t bank : order) {
    rank[bank] = in_square[{banks[bank].value, int(banks[bank].centroid_x()) / side, int(banks[bank].centroid_y()) / side}]++;
  }
  std::stable_sort(order.begin(), order.end(), [&](auto a, auto b) { return rank[a] < rank[b]; });

  PlacesWithFood thirsty = places_with_food(sources.partition, graph);
  const PlacesWithFood all = thirsty;
  std::vector<char> keep(banks.size());
  std::size_t kept = 0;
  const auto regions = [&](std::size_t bank) -> const std::vector<int>& {
    return sources.partition.pieces[std::size_t(banks[bank].value)].region;
  };
  for (const std::size_t bank : order) {
    for (std::size_t i = 0; i < regions(bank).size(); ++i) {
      if (thirsty.erase({int(i), regions(bank)[i]}) > 0) keep[bank] = 1;
    }
    kept += std::size_t(keep[bank]);
  }
  for (const std::size_t bank : order) {
    if (kept >= node_limits(sources.level).banks) break;
    bool useful = false;
    for (std::size_t i = 0; i < regions(bank).size(); ++i) useful = useful || all.contains({int(i), regions(bank)[i]});
    if (!useful || keep[bank]) continue;
    keep[bank] = 1;
    ++kept;
  }
  return keep;
}

}  // namespace

void add_bank_nodes(const ResourceSources& sources, GraphLevel& graph) {
  const double cell_size = sources.ground.terrain->cell_size;
  const RunTable table = bank_runs(*sources.ground.hydrology, sources.partition);
  if (table.runs.empty()) return;
  // An area is left whole up to 1.5 sides, whose diagonal is then just the longest stretch.
  SplitRule rule;
  rule.side = std::max(1, int(longest_bank / (1.5 * std::sqrt(2.0)) / cell_size));
  rule.sliver_cells = std::size_t(std::max(1.0, longest_bank / 6 / cell_size));
  rule.longest = longest_bank / cell_size;
  const Patches patches = split_into_patches(table, connected_areas(table), rule);
  const std::vector<char> keep = choose_banks(sources, patches.patches, graph);

  std::vector<std::int32_t> bank_of_run(patches.runs.runs.size());
  for (std::size_t i = 0; i < bank_of_run.size(); ++i) bank_of_run[i] = std::int32_t(patches.runs.runs[i].value);
  const auto nearest = nearest_to_centroid(patches.runs, bank_of_run, patches.patches);
  std::vector<std::int32_t> node_of_bank(patches.patches.size(), -1);
  for (std::size_t bank = 0; bank < keep.size(); ++bank) {
    if (!keep[bank]) continue;
    node_of_bank[bank] = std::int32_t(graph.nodes.size());
    ResourceNode node = node_of_area(patches.patches[bank], nearest[bank], sources.ground.terrain->cell_area());
    node.kind = NodeKind::bank;
    node.piece = int(patches.patches[bank].value);
    graph.nodes.push_back(std::move(node));
  }
  auto grid = std::make_shared<Grid<std::int32_t>>(table.width, table.height, -1);
  parallel_rows(0, table.height, [&](int y) {
    const auto row = grid->row(y);
    for (const CellRun& run : patches.runs.row(y)) {
      std::fill(row.begin() + run.x0, row.begin() + run.x1, node_of_bank[std::size_t(run.value)]);
    }
  });
  graph.node_of_cell[3] = std::move(grid);
}

}  // namespace biotope

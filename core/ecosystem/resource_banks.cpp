#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <set>
#include <tuple>

#include "core/ecosystem/resource_nodes.hpp"

namespace biotope {
namespace {

/// Fresh water that is this near can be drunk, m: a fringe of trees or a bar of gravel does not keep an animal from it. Our
/// choice.
constexpr double drinking_distance = 20;
/// Ground steeper than this (45 degrees) between bank and water does.
constexpr float steepest_bank = 1;

/// Cells where an animal can drink: rivers, lakes, and brooks one steps over; not the sea.
std::vector<std::size_t> drinkable_cells(const Hydrology& hydrology) {
  const int height = hydrology.water.height();
  const std::size_t width = std::size_t(hydrology.water.width());
  std::vector<std::vector<std::size_t>> of_row(static_cast<std::size_t>(height));
  parallel_rows(0, height, [&](int y) {
    const auto water = hydrology.water.row(y);
    const auto discharge = hydrology.discharge.row(y);
    for (std::size_t x = 0; x < width; ++x) {
      const bool fresh =
          (water[x] == WaterKind::river) | (water[x] == WaterKind::lake) | ((discharge[x] > 0) & (water[x] != WaterKind::sea));
      if (fresh) of_row[std::size_t(y)].push_back(std::size_t(y) * width + x);
    }
  });
  std::vector<std::size_t> all;
  for (const auto& row : of_row) all.insert(all.end(), row.begin(), row.end());
  return all;
}

/// 1 in cells from which water can be drunk: the water, its neighbours, and further cells up to the drinking distance to which
/// no steep ground bars the way.
Grid<std::uint8_t> shores(const Ground& ground) {
  const Grid<float>& slope = ground.derivatives->slope;
  Grid<std::uint8_t> shore(slope.width(), slope.height());
  std::vector<std::size_t> front = drinkable_cells(*ground.hydrology);
  for (const std::size_t cell : front) shore[cell] = 1;
  const int steps = std::max(1, int(drinking_distance / ground.terrain->cell_size));
  for (int step = 0; step < steps && !front.empty(); ++step) {
    std::vector<std::size_t> next;
    for (const std::size_t cell : front) {
      if (step > 0 && slope[cell] > steepest_bank) continue;
      const int x = int(cell % std::size_t(slope.width()));
      const int y = int(cell / std::size_t(slope.width()));
      for (int dy = -1; dy <= 1; ++dy) {
        for (int dx = -1; dx <= 1; ++dx) {
          if (!shore.contains(x + dx, y + dy) || shore(x + dx, y + dy) != 0) continue;
          shore(x + dx, y + dy) = 1;
          next.push_back(std::size_t(y + dy) * std::size_t(slope.width()) + std::size_t(x + dx));
        }
      }
    }
    front = std::move(next);
  }
  return shore;
}

RunTable shore_runs(const Ground& ground) {
  const Grid<std::uint8_t> shore = shores(ground);
  return collect_runs<std::int8_t>(shore.width(), shore.height(), [&](int y, std::span<std::int8_t> out) {
    const auto near = shore.row(y);
    for (std::size_t x = 0; x < out.size(); ++x) out[x] = near[x] != 0 ? 0 : -1;
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

std::shared_ptr<const BankStretches> find_banks(const Ground& ground, const RunTable& pieces,
                                                std::shared_ptr<const RunTable> shore) {
  const double cell_size = ground.terrain->cell_size;
  if (!shore) shore = std::make_shared<const RunTable>(shore_runs(ground));
  const RunTable table = intersected(pieces, *shore, [](std::int64_t piece, std::int64_t) { return piece; });
  // An area is left whole up to 1.5 sides, whose diagonal is then just the longest stretch.
  SplitRule rule;
  rule.side = std::max(1, int(longest_bank / (1.5 * std::sqrt(2.0)) / cell_size));
  rule.sliver_cells = std::size_t(std::max(1.0, longest_bank / 6 / cell_size));
  rule.longest = longest_bank / cell_size;
  auto banks = std::make_shared<BankStretches>();
  banks->shore = std::move(shore);
  banks->patches = split_into_patches(table, connected_areas(table), rule);
  const RunTable& runs = banks->patches.runs;
  std::vector<std::int32_t> bank_of_run(runs.runs.size());
  for (std::size_t i = 0; i < bank_of_run.size(); ++i) bank_of_run[i] = std::int32_t(runs.runs[i].value);
  banks->nearest = nearest_to_centroid(runs, bank_of_run, banks->patches.patches);
  return banks;
}

void add_bank_nodes(const ResourceSources& sources, GraphLevel& graph) {
  const Patches& patches = sources.banks.patches;
  const std::vector<NearestCell>& nearest = sources.banks.nearest;
  if (patches.patches.empty()) return;
  const std::vector<char> keep = choose_banks(sources, patches.patches, graph);
  std::vector<std::int32_t> node_of_bank(patches.patches.size(), -1);
  for (std::size_t bank = 0; bank < keep.size(); ++bank) {
    if (!keep[bank]) continue;
    node_of_bank[bank] = std::int32_t(graph.nodes.size());
    ResourceNode node = node_of_area(patches.patches[bank], nearest[bank], sources.ground.terrain->cell_area());
    node.kind = NodeKind::bank;
    node.piece = int(patches.patches[bank].value);
    graph.nodes.push_back(std::move(node));
  }
  const RunTable& runs = patches.runs;
  graph.node_of_cell[3] =
      std::make_shared<const RunMap>(collect_rows(runs.width, runs.height, [&](int y, std::vector<CellRun>& out) {
        const std::size_t begin = out.size();
        for (const CellRun& run : runs.row(y)) {
          const std::int32_t node = node_of_bank[std::size_t(run.value)];
          if (node >= 0) append_run(out, begin, {run.x0, run.x1, node});
        }
      }));
}

}  // namespace biotope

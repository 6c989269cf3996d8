#include <tbb/enumerable_thread_specific.h>

#include <numeric>

#include "core/ecosystem/eaten_zones.hpp"
#include "core/ecosystem/resource_nodes.hpp"

namespace biotope {

std::vector<std::uint64_t> cover_sums(const RunTable& table, std::size_t groups, std::span<const CoverMap* const> covers) {
  const std::size_t maps = covers.size();
  tbb::enumerable_thread_specific<std::vector<std::uint64_t>> partial([&] { return std::vector<std::uint64_t>(groups * maps); });
  parallel_rows(0, table.height, [&](int y) {
    const auto runs = table.row(y);
    if (runs.empty()) return;
    auto& sums = partial.local();
    std::vector<Cover> cover(static_cast<std::size_t>(table.width));
    for (std::size_t map = 0; map < maps; ++map) {
      covers[map]->read_row(y, 0, cover);
      for (const CellRun& run : runs) {
        sums[std::size_t(run.value) * maps + map] +=
            std::accumulate(cover.begin() + run.x0, cover.begin() + run.x1, std::uint64_t{0});
      }
    }
  });
  std::vector<std::uint64_t> total(groups * maps);
  for (const auto& sums : partial) {
    for (std::size_t i = 0; i < total.size(); ++i) total[i] += sums[i];
  }
  return total;
}

double growth_of(const FoodWeb& web, int plant, std::uint64_t cover_sum, double cell_area) {
  return double(cover_sum) / full_cover * cell_area * double(web.species[std::size_t(plant)].plant().growth);
}

std::vector<std::vector<double>> available_supply(const ResourceSources& sources, std::span<const PreySupply> prey) {
  const std::size_t pieces = sources.partition.pieces.size();
  std::vector<std::vector<double>> available(sources.web.species.size(), std::vector<double>(pieces));
  for (const PreySupply& supply : prey) available[std::size_t(supply.species)][std::size_t(supply.piece)] += supply.available;

  const std::vector<char> edible = edible_to_level(sources.web, sources.level);
  std::vector<int> plants;
  std::vector<const CoverMap*> covers;
  for (std::size_t i = 0; i < sources.plants.size(); ++i) {
    if (!edible[std::size_t(sources.web.levels[0][i])] || !sources.plants[i]) continue;
    plants.push_back(sources.web.levels[0][i]);
    covers.push_back(sources.plants[i].get());
  }
  if (plants.empty()) return available;
  const EatenZones zones(sources.below, plants);
  const Grid<std::int32_t>& label = sources.partition.label;
  RunTable table = collect_runs(label.width(), label.height(), [&](int y, std::span<std::int64_t> out) {
    std::copy(label.row(y).begin(), label.row(y).end(), out.begin());
    zones.refine_row(y, out);
  });
  const std::vector<std::int64_t> values = number_values(table);
  const std::vector<std::uint64_t> sums = cover_sums(table, values.size(), covers);
  for (std::size_t group = 0; group < values.size(); ++group) {
    for (std::size_t plant = 0; plant < plants.size(); ++plant) {
      available[std::size_t(plants[plant])][std::size_t(values[group] / zones.count())] +=
          zones.left(values[group] % zones.count(), plant) *
          growth_of(sources.web, plants[plant], sums[group * plants.size() + plant], sources.ground.terrain->cell_area());
    }
  }
  return available;
}

}  // namespace biotope

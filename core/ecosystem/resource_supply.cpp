#include <tbb/enumerable_thread_specific.h>

#include <algorithm>
#include <cstring>

#include "core/ecosystem/eaten_zones.hpp"
#include "core/ecosystem/resource_nodes.hpp"

namespace biotope {

PresentTiles::PresentTiles(std::span<const std::shared_ptr<const CoverMap>> covers) {
  for (const auto& cover : covers) {
    if (!cover) continue;
    columns_ = cover->tile_columns();
    rows_ = cover->tile_rows();
  }
  const std::size_t tiles_of_map = std::size_t(columns_) * std::size_t(rows_);
  tiles_.assign(covers.size() * tiles_of_map, nullptr);
  background_.resize(covers.size());
  parallel_each(covers.size(), [&](std::size_t map) {
    if (!covers[map]) return;
    if (covers[map]->background() != 0) {
      auto tile = std::make_shared<CoverMap::Tile>();
      tile->fill(covers[map]->background());
      background_[map] = std::move(tile);
    }
    for (std::size_t i = 0; i < tiles_of_map; ++i) {
      const CoverMap::TilePointer& tile = covers[map]->tile(i) ? covers[map]->tile(i) : background_[map];
      if (!tile) continue;
      unsigned any = 0;
      for (const Cover cover : *tile) any |= cover;
      if (any != 0) tiles_[map * tiles_of_map + i] = tile->data();
    }
  });
}

namespace {

/// Runs of a row cut at the columns of tiles.
struct CutRow {
  std::vector<CellRun> runs;
  /// Runs of column c are [start[c], start[c + 1]).
  std::vector<std::size_t> start;

  void cut(std::span<const CellRun> row, int columns) {
    runs.clear();
    start.assign(1, 0);
    const auto begin_column = [&](int column) {
      while (int(start.size()) <= column) start.push_back(runs.size());
    };
    for (const CellRun& run : row) {
      for (int x = run.x0; x < run.x1;) {
        const int column = x / tile_side;
        begin_column(column);
        const int end = std::min(run.x1, (column + 1) * tile_side);
        runs.push_back({x - column * tile_side, end - column * tile_side, run.value});
        x = end;
      }
    }
    begin_column(columns);
  }
};

/// Sum of some covers, eight at a time as the bytes of one number: runs are short and many.
std::uint32_t sum_of(const Cover* cover, int count) {
  constexpr std::uint64_t even_bytes = 0x00ff00ff00ff00ff;
  constexpr std::uint64_t ones = 0x0001000100010001;
  std::uint32_t sum = 0;
  int i = 0;
  for (; i + 8 <= count; i += 8) {
    std::uint64_t eight = 0;
    std::memcpy(&eight, cover + i, sizeof eight);
    // Pairs add up to at most 510, four of them to at most 2040: nothing overflows its 16 bits.
    sum += std::uint32_t((((eight & even_bytes) + ((eight >> 8) & even_bytes)) * ones) >> 48);
  }
  for (; i < count; ++i) sum += cover[i];
  return sum;
}

}  // namespace

std::vector<std::uint64_t> cover_sums(const RunTable& table, std::size_t groups, const PresentTiles& tiles,
                                      std::span<const std::size_t> maps) {
  tbb::enumerable_thread_specific<std::vector<std::uint64_t>> partial(
      [&] { return std::vector<std::uint64_t>(groups * maps.size()); });
  parallel_rows(0, table.height, [&](int y) {
    if (table.row(y).empty()) return;
    auto& sums = partial.local();
    CutRow row;
    row.cut(table.row(y), tiles.columns());
    for (int column = 0; column < tiles.columns(); ++column) {
      const auto first = row.runs.begin() + std::ptrdiff_t(row.start[std::size_t(column)]);
      const auto last = row.runs.begin() + std::ptrdiff_t(row.start[std::size_t(column) + 1]);
      for (std::size_t i = 0; first != last && i < maps.size(); ++i) {
        const Cover* cover = tiles.row(maps[i], column, y);
        if (cover == nullptr) continue;
        for (auto run = first; run != last; ++run) {
          sums[std::size_t(run->value) * maps.size() + i] += sum_of(cover + run->x0, run->x1 - run->x0);
        }
      }
    }
  });
  std::vector<std::uint64_t> total(groups * maps.size());
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
  std::vector<std::size_t> maps;
  for (std::size_t i = 0; i < sources.plants.size(); ++i) {
    if (!edible[std::size_t(sources.web.levels[0][i])] || !sources.plants[i]) continue;
    plants.push_back(sources.web.levels[0][i]);
    maps.push_back(i);
  }
  if (plants.empty()) return available;
  const EatenZones zones(sources.below, plants);
  const Grid<std::int32_t>& label = sources.partition.label;
  RunTable table = collect_runs(label.width(), label.height(), [&](int y, std::span<std::int64_t> out) {
    std::copy(label.row(y).begin(), label.row(y).end(), out.begin());
    zones.refine_row(y, out);
  });
  const std::vector<std::int64_t> values = number_values(table);
  const std::vector<std::uint64_t> sums = cover_sums(table, values.size(), sources.tiles, maps);
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

#include <algorithm>
#include <unordered_map>

#include "core/base/parallel.hpp"
#include "core/base/random.hpp"
#include "core/ecosystem/confinement.hpp"

namespace biotope {
namespace {

constexpr int band_rows = 32;

using Tuple = std::vector<std::int32_t>;
struct TupleHash {
  std::size_t operator()(const Tuple& tuple) const {
    std::uint64_t state = 0;
    for (const std::int32_t label : tuple) state = mix_bits(state ^ std::uint64_t(std::uint32_t(label)));
    return std::size_t(state);
  }
};

/// Tuples of some rows in the order in which they first appear.
struct TupleTable {
  std::vector<Tuple> tuples;
  std::vector<std::size_t> cells;
  std::unordered_map<Tuple, std::int32_t, TupleHash> number;

  std::int32_t find_or_add(const Tuple& tuple) {
    const auto [found, added] = number.try_emplace(tuple, std::int32_t(tuples.size()));
    if (added) {
      tuples.push_back(tuple);
      cells.push_back(0);
    }
    return found->second;
  }
};

/// Labels of a band of rows, numbered within the band.
void label_band(const std::vector<const ConfinementRegions*>& maps, int first_row, int last_row, TupleTable& table,
                Grid<std::int32_t>& label) {
  const std::size_t width = std::size_t(label.width());
  std::vector<std::uint8_t> changes(width);
  Tuple tuple(maps.size());
  for (int y = first_row; y < last_row; ++y) {
    std::fill(changes.begin(), changes.end(), std::uint8_t{0});
    for (const ConfinementRegions* map : maps) {
      const std::int32_t* row = map->label.row(y).data();
      for (std::size_t x = 1; x < width; ++x) changes[x] = std::uint8_t(changes[x] | std::uint8_t(row[x] != row[x - 1]));
    }
    const auto out = label.row(y);
    for (std::size_t x = 0; x < width;) {
      const std::size_t first = x++;
      while (x < width && changes[x] == 0) ++x;
      bool anyone = false;
      for (std::size_t i = 0; i < maps.size(); ++i) {
        tuple[i] = maps[i]->label.row(y)[first];
        anyone = anyone || tuple[i] >= 0;
      }
      const std::int32_t piece = anyone ? table.find_or_add(tuple) : -1;
      if (anyone) table.cells[std::size_t(piece)] += x - first;
      std::fill(out.begin() + std::ptrdiff_t(first), out.begin() + std::ptrdiff_t(x), piece);
    }
  }
}

}  // namespace

Partition finest_partition(std::span<const std::shared_ptr<const ConfinementRegions>> regions, double cell_size) {
  // Species that share a map of regions cannot be told apart by it: each map is read once.
  std::vector<const ConfinementRegions*> maps;
  std::vector<std::size_t> map_of_species;
  for (const auto& own : regions) {
    const auto found = std::find(maps.begin(), maps.end(), own.get());
    map_of_species.push_back(std::size_t(found - maps.begin()));
    if (found == maps.end()) maps.push_back(own.get());
  }
  Partition result;
  if (maps.empty()) return result;
  const int height = maps.front()->label.height();
  result.label = Grid<std::int32_t>(maps.front()->label.width(), height, -1);

  const std::size_t bands = std::size_t((height + band_rows - 1) / band_rows);
  std::vector<TupleTable> tables(bands);
  parallel_each(bands, [&](std::size_t band) {
    const int first = int(band) * band_rows;
    label_band(maps, first, std::min(first + band_rows, height), tables[band], result.label);
  });

  TupleTable all;
  std::vector<std::vector<std::int32_t>> number(bands);
  for (std::size_t band = 0; band < bands; ++band) {
    for (std::size_t i = 0; i < tables[band].tuples.size(); ++i) {
      number[band].push_back(all.find_or_add(tables[band].tuples[i]));
      all.cells[std::size_t(number[band].back())] += tables[band].cells[i];
    }
  }
  parallel_each(bands, [&](std::size_t band) {
    const auto& renumbered = number[band];
    for (int y = int(band) * band_rows; y < std::min(int(band + 1) * band_rows, height); ++y) {
      for (std::int32_t& piece : result.label.row(y)) piece = piece >= 0 ? renumbered[std::size_t(piece)] : -1;
    }
  });
  for (std::size_t i = 0; i < all.tuples.size(); ++i) {
    Partition::Piece& piece = result.pieces.emplace_back();
    piece.cells = all.cells[i];
    piece.area = double(piece.cells) * cell_size * cell_size;
    for (const std::size_t map : map_of_species) piece.region.push_back(all.tuples[i][map]);
  }
  return result;
}

}  // namespace biotope

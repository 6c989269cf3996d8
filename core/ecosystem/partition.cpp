#include <algorithm>
#include <unordered_map>

#include "core/base/parallel.hpp"
#include "core/base/random.hpp"
#include "core/ecosystem/cell_runs.hpp"
#include "core/ecosystem/confinement.hpp"

namespace biotope {
namespace {

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

using RunTables = std::vector<std::shared_ptr<const RunTable>>;

/// Appends the pieces of a row, numbered as they first appear in `table`.
void append_pieces(const RunTables& maps, int y, TupleTable& table, std::vector<CellRun>& out) {
  const std::size_t begin = out.size();
  const int width = maps.front()->width;
  std::vector<std::span<const CellRun>> rows;
  for (const auto& map : maps) rows.push_back(map->row(y));
  Tuple tuple(maps.size());
  for (int x = 0; x < width;) {
    int end = width;
    bool anyone = false;
    for (std::size_t i = 0; i < maps.size(); ++i) {
      while (!rows[i].empty() && rows[i].front().x1 <= x) rows[i] = rows[i].subspan(1);
      const bool inside = !rows[i].empty() && rows[i].front().x0 <= x;
      if (!rows[i].empty()) end = std::min(end, inside ? rows[i].front().x1 : rows[i].front().x0);
      tuple[i] = inside ? std::int32_t(rows[i].front().value) : -1;
      anyone = anyone || inside;
    }
    if (anyone) {
      const std::int32_t piece = table.find_or_add(tuple);
      table.cells[std::size_t(piece)] += std::size_t(end - x);
      append_run(out, begin, {x, end, piece});
    }
    x = end;
  }
}

}  // namespace

Partition finest_partition(std::span<const std::shared_ptr<const ConfinementRegions>> regions, double cell_size) {
  // Species that share a map of regions cannot be told apart by it: each map is read once.
  std::vector<const ConfinementRegions*> known;
  RunTables maps;
  std::vector<std::size_t> map_of_species;
  for (const auto& own : regions) {
    const auto found = std::find(known.begin(), known.end(), own.get());
    map_of_species.push_back(std::size_t(found - known.begin()));
    if (found != known.end()) continue;
    known.push_back(own.get());
    maps.push_back(own->label.shared_runs());
  }
  Partition result;
  if (maps.empty()) return result;

  const int height = maps.front()->height;
  const std::size_t bands = std::size_t((height + band_rows - 1) / band_rows);
  std::vector<TupleTable> tables(bands);
  RunTable runs = collect_rows(maps.front()->width, height, [&](int y, std::vector<CellRun>& out) {
    append_pieces(maps, y, tables[std::size_t(y / band_rows)], out);
  });

  TupleTable all;
  std::vector<std::vector<std::int32_t>> number(bands);
  for (std::size_t band = 0; band < bands; ++band) {
    for (std::size_t i = 0; i < tables[band].tuples.size(); ++i) {
      number[band].push_back(all.find_or_add(tables[band].tuples[i]));
      all.cells[std::size_t(number[band].back())] += tables[band].cells[i];
    }
  }
  parallel_rows(0, height, [&](int y) {
    const auto& renumbered = number[std::size_t(y / band_rows)];
    for (std::size_t i = runs.row_start[std::size_t(y)]; i < runs.row_start[std::size_t(y) + 1]; ++i) {
      runs.runs[i].value = renumbered[std::size_t(runs.runs[i].value)];
    }
  });
  for (std::size_t i = 0; i < all.tuples.size(); ++i) {
    Partition::Piece& piece = result.pieces.emplace_back();
    piece.cells = all.cells[i];
    piece.area = double(piece.cells) * cell_size * cell_size;
    for (const std::size_t map : map_of_species) piece.region.push_back(all.tuples[i][map]);
  }
  result.label = RunMap(std::move(runs));
  return result;
}

}  // namespace biotope

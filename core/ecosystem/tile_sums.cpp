#include "core/ecosystem/tile_sums.hpp"

#include <tbb/enumerable_thread_specific.h>

#include <algorithm>
#include <bit>
#include <cstring>

#include "core/ecosystem/resource_nodes.hpp"

namespace biotope {
namespace {

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

/// Sum of some covers, each times what is lost of it.
std::uint64_t lost_of(const Cover* cover, const std::uint16_t* lost, int count) {
  std::uint64_t sum = 0;
  for (int i = 0; i < count; ++i) sum += std::uint32_t(cover[i]) * lost[i];
  return sum;
}

/// The runs of one tile while they are gathered.
struct GatheredTile {
  std::vector<TileRun> runs;
  /// Number on the whole map of each of the tile's groups.
  std::vector<std::uint32_t> groups;

  void clear() {
    runs.clear();
    groups.clear();
  }
};

/// Cuts the runs of a band of tiles at the tiles' columns and numbers their groups within each tile.
class BandOfTiles {
 public:
  explicit BandOfTiles(int columns) : tiles_(std::size_t(columns)) {}

  void gather(const RunTable& table, int first_row, int last_row) {
    for (GatheredTile& tile : tiles_) tile.clear();
    for (int y = first_row; y < last_row; ++y) {
      for (const CellRun& run : table.row(y)) add(y - first_row, run);
    }
  }
  [[nodiscard]] std::vector<GatheredTile>& tiles() { return tiles_; }

 private:
  void add(int y, const CellRun& run) {
    for (int x = run.x0; x < run.x1;) {
      const int column = x / tile_side;
      const int end = std::min(run.x1, (column + 1) * tile_side);
      GatheredTile& tile = tiles_[std::size_t(column)];
      tile.runs.push_back({std::uint8_t(y), std::uint8_t(x - column * tile_side), std::uint8_t(end - column * tile_side),
                           group_in(tile, std::uint32_t(run.value))});
      x = end;
    }
  }

  /// Groups of a tile are few, and the one wanted is mostly among the last.
  static std::uint16_t group_in(GatheredTile& tile, std::uint32_t group) {
    for (std::size_t i = tile.groups.size(); i-- > 0;) {
      if (tile.groups[i] == group) return std::uint16_t(i);
    }
    tile.groups.push_back(group);
    return std::uint16_t(tile.groups.size() - 1);
  }

  std::vector<GatheredTile> tiles_;
};

TileSums sums_of_tile(const GatheredTile& gathered, const PresentTiles& tiles, std::span<const std::size_t> maps, int column,
                      int first_row) {
  const std::size_t count = gathered.groups.size() * maps.size();
  TileSums sums{gathered.runs, std::vector<std::uint64_t>(count), {}};
  for (std::size_t i = 0; i < maps.size(); ++i) {
    const Cover* cover = tiles.row(maps[i], column, first_row);
    if (cover == nullptr) continue;
    const std::uint16_t* lost = tiles.lost_row(maps[i], column, first_row);
    if (lost != nullptr && sums.lost.empty()) sums.lost.resize(count);
    for (const TileRun& run : gathered.runs) {
      const std::size_t at = run.group * maps.size() + i;
      const std::size_t offset = std::size_t(run.y) * tile_side + run.x0;
      sums.covered[at] += sum_of(cover + offset, run.x1 - run.x0);
      if (lost != nullptr) sums.lost[at] += lost_of(cover + offset, lost + offset, run.x1 - run.x0);
    }
  }
  return sums;
}

void add_to(CoverSums& total, const TileSums& tile, std::span<const std::uint32_t> groups, std::size_t maps) {
  for (std::size_t group = 0; group < groups.size(); ++group) {
    for (std::size_t i = 0; i < maps; ++i) {
      total.covered[groups[group] * maps + i] += tile.covered[group * maps + i];
      if (!tile.lost.empty()) total.lost[groups[group] * maps + i] += tile.lost[group * maps + i];
    }
  }
}

}  // namespace

double CoverSums::growing(std::size_t i) const {
  return lost.empty() ? double(covered[i]) : double(covered[i]) - double(lost[i]) / whole_loss;
}

CoverSums cover_sums(const RunTable& table, std::size_t groups, const PresentTiles& tiles, std::span<const std::size_t> maps,
                     std::span<const char> changed, const SumsOfTiles* before, SumsOfTiles* found) {
  const int columns = tiles.columns();
  const std::size_t bands = std::size_t((table.height + tile_side - 1) / tile_side);
  const std::size_t count = groups * maps.size();
  const CoverSums zero{std::vector<std::uint64_t>(count), std::vector<std::uint64_t>(tiles.nothing_lost() ? 0 : count)};
  const bool reuse = before != nullptr && before->size() == bands * std::size_t(columns) && changed.size() == before->size();
  if (found != nullptr) found->assign(bands * std::size_t(columns), nullptr);
  tbb::enumerable_thread_specific<CoverSums> partial(zero);
  tbb::enumerable_thread_specific<BandOfTiles> gatherer([&] { return BandOfTiles(columns); });
  parallel_each(bands, [&](std::size_t band) {
    CoverSums& total = partial.local();
    BandOfTiles& gathered = gatherer.local();
    const int first_row = int(band) * tile_side;
    gathered.gather(table, first_row, std::min(first_row + tile_side, table.height));
    for (int column = 0; column < columns; ++column) {
      const GatheredTile& own = gathered.tiles()[std::size_t(column)];
      if (own.runs.empty()) continue;
      const std::size_t tile = band * std::size_t(columns) + std::size_t(column);
      std::shared_ptr<const TileSums> sums;
      if (reuse && !changed[tile] && (*before)[tile] && (*before)[tile]->runs == own.runs) sums = (*before)[tile];
      if (!sums) sums = std::make_shared<const TileSums>(sums_of_tile(own, tiles, maps, column, first_row));
      add_to(total, *sums, own.groups, maps.size());
      if (found != nullptr) (*found)[tile] = std::move(sums);
    }
  });
  CoverSums total = zero;
  for (const CoverSums& sums : partial) {
    for (std::size_t i = 0; i < count; ++i) total.covered[i] += sums.covered[i];
    for (std::size_t i = 0; i < total.lost.size(); ++i) total.lost[i] += sums.lost[i];
  }
  return total;
}

namespace {

std::shared_ptr<const PresenceTile> presence_of(const PresentTiles& tiles, std::span<const std::size_t> maps, int column,
                                                int first_row) {
  const int threshold = int(presence_cover * full_cover + 0.5F);
  PresenceTile bits{};
  std::uint64_t any = 0;
  for (int y = 0; y < tile_side; ++y) {
    std::array<std::uint16_t, tile_side> sum{};
    for (const std::size_t map : maps) {
      const Cover* cover = tiles.row(map, column, first_row);
      if (cover == nullptr) continue;
      for (std::size_t x = 0; x < sum.size(); ++x) sum[x] = std::uint16_t(sum[x] + cover[std::size_t(y) * tile_side + x]);
    }
    for (std::size_t x = 0; x < sum.size(); ++x) bits[std::size_t(y)] |= std::uint64_t(sum[x] >= threshold) << x;
    any |= bits[std::size_t(y)];
  }
  return any != 0 ? std::make_shared<const PresenceTile>(bits) : nullptr;
}

/// Appends the parts of [x0, x1) where bits of the tiles along a row are set.
void append_present(const CellRun& run, std::span<const std::shared_ptr<const PresenceTile>> row, std::size_t y,
                    std::size_t begin, std::vector<CellRun>& out) {
  for (int x = run.x0; x < run.x1;) {
    const int column = x / tile_side;
    const int end = std::min(run.x1, (column + 1) * tile_side);
    const PresenceTile* tile = row[std::size_t(column)].get();
    std::uint64_t bits = tile != nullptr ? (*tile)[y] >> (x % tile_side) : 0;
    while (bits != 0) {
      const int skipped = std::countr_zero(bits);
      const int length = std::countr_one(bits >> skipped);
      const int first = x + skipped;
      if (first >= end) break;
      append_run(out, begin, {first, std::min(end, first + length), run.value});
      x = first + length;
      bits = skipped + length < 64 ? bits >> (skipped + length) : 0;
    }
    x = end;
  }
}

}  // namespace

std::vector<std::shared_ptr<const PresenceTile>> presence_tiles(const PresentTiles& tiles, std::span<const std::size_t> maps,
                                                                std::span<const char> changed,
                                                                const std::vector<std::shared_ptr<const PresenceTile>>* before) {
  const std::size_t columns = std::size_t(tiles.columns());
  std::vector<std::shared_ptr<const PresenceTile>> presence(columns * std::size_t(tiles.rows()));
  const bool reuse = before != nullptr && before->size() == presence.size() && changed.size() == presence.size();
  parallel_each(presence.size(), [&](std::size_t i) {
    presence[i] = reuse && !changed[i] ? (*before)[i] : presence_of(tiles, maps, int(i % columns), int(i / columns) * tile_side);
  });
  return presence;
}

RunTable present_parts(const RunTable& table, std::span<const std::shared_ptr<const PresenceTile>> presence) {
  const std::size_t columns = std::size_t((table.width + tile_side - 1) / tile_side);
  return collect_rows(table.width, table.height, [&](int y, std::vector<CellRun>& out) {
    const std::size_t begin = out.size();
    const auto row = presence.subspan(std::size_t(y / tile_side) * columns, columns);
    for (const CellRun& run : table.row(y)) append_present(run, row, std::size_t(y % tile_side), begin, out);
  });
}

}  // namespace biotope

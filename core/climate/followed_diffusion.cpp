#include "core/climate/followed_diffusion.hpp"

#include <algorithm>
#include <cassert>
#include <cstring>

#include "core/base/parallel.hpp"
#include "core/climate/elimination.hpp"

namespace biotope {
namespace {

/// Lines that are eliminated side by side.
constexpr int bundle = 8;

constexpr std::size_t at(int cell) { return std::size_t(cell) * bundle; }

}  // namespace

/// Room for a bundle of lines: cell i of all of them lies from at(i) on.
struct FollowedDiffusion::Room {
  explicit Room(int length) : conductance(at(length)), shares(at(length)), values(at(length)) {}
  std::vector<float> conductance;
  std::vector<float> shares;
  std::vector<float> values;
};

/// A bundle of lines of one pass.
class FollowedDiffusion::Line {
 public:
  Line(Pass& pass, const Grid<float>& in, const Conductance& conductance, Room& room, int first, int count)
      : pass_(pass),
        in_(in),
        conductance_(conductance),
        room_(room),
        first_(first),
        count_(count),
        length_(pass.along_rows ? in.width() : in.height()),
        lines_(pass.along_rows ? in.height() : in.width()),
        tiles_((length_ + tile_side - 1) / tile_side),
        done_(std::size_t(tiles_), 0) {
    if (conductance.cells == nullptr) std::ranges::fill(room.conductance, conductance.uniform);
  }

  /// Eliminates from the asked tiles on as far as it comes out another, and back; marks tiles that are others in `changed`.
  void follow(const std::vector<char>& asked, std::vector<char>& changed) {
    bool another = false;
    for (int tile = 0; tile < tiles_; ++tile) {
      if (asked[std::size_t(tile)] == 0 && !another) continue;
      eliminate(tile);
      another = note_state(tile);
    }
    another = false;
    for (int tile = tiles_; tile-- > 0;) {
      if (done_[std::size_t(tile)] == 0 && !another) continue;
      if (done_[std::size_t(tile)] == 0) eliminate(tile);
      const bool before_is_last = tile + 1 < tiles_ && done_[std::size_t(tile) + 1] == 0;
      if (before_is_last) load(pass_.out, begin(tile + 1), begin(tile + 1) + 1, room_.values);
      another = add_back(tile, changed[std::size_t(tile)]);
      done_[std::size_t(tile)] = 1;
    }
  }

 private:
  [[nodiscard]] int begin(int tile) const { return tile * tile_side; }
  [[nodiscard]] int end(int tile) const { return std::min(length_, begin(tile) + tile_side); }
  [[nodiscard]] std::size_t state(int tile) const { return std::size_t(tile) * std::size_t(lines_) + std::size_t(first_); }

  void load(const Grid<float>& grid, int from, int to, std::vector<float>& out) const {
    if (pass_.along_rows) {
      for (int line = 0; line < count_; ++line) {
        const float* const row = grid.row(first_ + line).data();
        for (int i = from; i < to; ++i) out[at(i) + std::size_t(line)] = row[i];
      }
    } else {
      for (int i = from; i < to; ++i) std::memcpy(&out[at(i)], grid.row(i).data() + first_, sizeof(float) * std::size_t(count_));
    }
  }

  /// The forward elimination of a tile's cells, from where it stood before them.
  void eliminate(int tile) {
    const int from = begin(tile);
    const int to = end(tile);
    load(in_, from, to, room_.values);
    if (conductance_.cells != nullptr) {
      load(*conductance_.cells, std::max(0, from - 1), std::min(length_, to + 1), room_.conductance);
    }
    if (tile > 0) {
      std::copy_n(pass_.shares.data() + state(tile), count_, &room_.shares[at(from - 1)]);
      std::copy_n(pass_.values.data() + state(tile), count_, &room_.values[at(from - 1)]);
    }
    const float none[bundle] = {};
    for (int i = from; i < to; ++i) {
      const bool is_first = i == 0;
      const bool is_last = i + 1 == length_;
      float* const share = room_.shares.data() + at(i);
      float* const value = room_.values.data() + at(i);
      const float* const own = room_.conductance.data() + at(i);
      eliminate_columns({is_first ? own : own - bundle, own, is_last ? own : own + bundle, is_first ? none : share - bundle,
                         is_first ? none : value - bundle, share, value},
                        bundle, is_first ? 0.0F : 1.0F, is_last ? 0.0F : 1.0F);
    }
    done_[std::size_t(tile)] = 1;
  }

  /// Keeps where the elimination stands after a tile; whether that is elsewhere than before.
  bool note_state(int tile) {
    if (tile + 1 == tiles_) return false;
    const float* const share = &room_.shares[at(end(tile) - 1)];
    const float* const value = &room_.values[at(end(tile) - 1)];
    float* const kept_share = pass_.shares.data() + state(tile + 1);
    float* const kept_value = pass_.values.data() + state(tile + 1);
    const bool same = std::equal(share, share + count_, kept_share) && std::equal(value, value + count_, kept_value);
    std::copy_n(share, count_, kept_share);
    std::copy_n(value, count_, kept_value);
    return !same;
  }

  /// The way back through a tile. Whether its first cell, which the tile before reads, is another.
  bool add_back(int tile, char& changed) {
    for (int i = std::min(end(tile), length_ - 1); i-- > begin(tile);) {
      add_back_columns(&room_.values[at(i)], &room_.shares[at(i)], &room_.values[at(i + 1)], bundle);
    }
    bool another = false;
    for (int i = end(tile); i-- > begin(tile);) {
      another = store(i);
      if (another) changed = 1;
    }
    return another;
  }

  /// Puts a cell of each line into the result; whether one is another.
  bool store(int i) {
    bool another = false;
    for (int line = 0; line < count_; ++line) {
      float& out = pass_.along_rows ? pass_.out(i, first_ + line) : pass_.out(first_ + line, i);
      const float value = room_.values[at(i) + std::size_t(line)];
      another |= out != value;
      out = value;
    }
    return another;
  }

  Pass& pass_;
  const Grid<float>& in_;
  const Conductance& conductance_;
  Room& room_;
  int first_;
  int count_;
  int length_;
  int lines_;
  int tiles_;
  std::vector<char> done_;  ///< tiles whose cells are in the room
};

TileSet FollowedDiffusion::run(Pass& pass, const Grid<float>& in, const Conductance& conductance, const TileSet& asked) {
  const int columns = (in.width() + tile_side - 1) / tile_side;
  const int rows = (in.height() + tile_side - 1) / tile_side;
  const int length = pass.along_rows ? in.width() : in.height();
  const int lines = pass.along_rows ? in.height() : in.width();
  const auto tile_of = [&](int strip, int tile) {
    return pass.along_rows ? std::size_t(strip) * std::size_t(columns) + std::size_t(tile)
                           : std::size_t(tile) * std::size_t(columns) + std::size_t(strip);
  };
  const int tiles = pass.along_rows ? columns : rows;
  const int strips = pass.along_rows ? rows : columns;
  std::vector<std::vector<char>> changed(std::size_t(strips), std::vector<char>(std::size_t(tiles), 0));
  parallel_each(std::size_t(strips), [&](std::size_t strip) {
    std::vector<char> wanted(std::size_t(tiles), 0);
    for (int tile = 0; tile < tiles; ++tile) wanted[std::size_t(tile)] = asked.contains(tile_of(int(strip), tile)) ? 1 : 0;
    if (std::ranges::count(wanted, 1) == 0) return;
    Room room(length);
    const int begin = int(strip) * tile_side;
    const int end = std::min(lines, begin + tile_side);
    for (int line = begin; line < end; line += bundle) {
      Line(pass, in, conductance, room, line, std::min(bundle, end - line)).follow(wanted, changed[strip]);
    }
  });
  TileSet others(in.width(), in.height());
  for (int strip = 0; strip < strips; ++strip) {
    for (int tile = 0; tile < tiles; ++tile) {
      if (changed[std::size_t(strip)][std::size_t(tile)] != 0) others.insert(tile_of(strip, tile));
    }
  }
  return others;
}

bool FollowedDiffusion::restart(const Grid<float>& values, const Conductance& conductance,
                                const std::function<bool(int)>& go_on) {
  const TileSet all = TileSet::all(values.width(), values.height());
  const int columns = (values.width() + tile_side - 1) / tile_side;
  const int rows = (values.height() + tile_side - 1) / tile_side;
  passes_.assign(std::size_t(2 * steps_), {});
  const Grid<float>* in = &values;
  for (std::size_t i = 0; i < passes_.size(); ++i) {
    if (i % 2 == 0 && !go_on(int(i / 2))) {
      forget();
      return false;
    }
    Pass& pass = passes_[i];
    pass.along_rows = i % 2 == 0;
    pass.out = Grid<float>(values.width(), values.height());
    const auto states =
        pass.along_rows ? std::size_t(columns) * std::size_t(values.height()) : std::size_t(rows) * std::size_t(values.width());
    pass.shares.assign(states, 0);
    pass.values.assign(states, 0);
    run(pass, *in, conductance, all);
    in = &pass.out;
  }
  return true;
}

TileSet FollowedDiffusion::follow(const Grid<float>& values, const Conductance& conductance, const TileSet& changed) {
  assert(started() && result().width() == values.width() && result().height() == values.height());
  // A cell reads how easily its neighbours let go, in every pass.
  const TileSet always = conductance.cells != nullptr ? changed.grown(1) : TileSet(values.width(), values.height());
  TileSet asked = changed | always;
  const Grid<float>* in = &values;
  for (Pass& pass : passes_) {
    asked = run(pass, *in, conductance, asked) | always;
    in = &pass.out;
  }
  return asked;
}

}  // namespace biotope

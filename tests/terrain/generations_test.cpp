#include <catch2/catch.hpp>
#include <deque>
#include <memory>

#include "core/base/random.hpp"
#include "core/terrain/generations.hpp"

using namespace biotope;

namespace {

/// Writes a number into every cell of some tiles.
void write(Grid<int>& grid, const TileSet& tiles, int number) {
  for (const std::size_t tile : tiles.list()) {
    const Rect cells = tiles.rect(tile);
    for (int y = cells.y0; y < cells.y1; ++y) {
      for (int x = cells.x0; x < cells.x1; ++x) grid(x, y) = number;
    }
  }
}

}  // namespace

TEST_CASE("every version stays as it was, however many readers hold on to it and for how long") {
  const int width = 150;
  const int height = 90;
  for (std::uint64_t sequence = 0; sequence < 40; ++sequence) {
    const bool shares = sequence % 2 == 0;
    GridGenerations<int> versions;
    versions.restart(std::make_shared<Grid<int>>(shares ? Grid<int>::shareable(width, height) : Grid<int>(width, height)));
    struct Held {
      std::shared_ptr<const Grid<int>> version;
      Grid<int> expected;
    };
    std::deque<Held> held;
    held.push_back({versions.newest(), Grid<int>(width, height)});
    for (std::uint64_t step = 0; step < 60; ++step) {
      const auto chance = [&](std::uint64_t what, int most) { return random_int(0, most, {sequence, step, what}); };
      TileSet changed(width, height, small_side);
      for (int i = chance(1, 3); i > 0; --i)
        changed.insert(std::size_t(chance(2 + std::uint64_t(i), int(changed.tile_count()) - 1)));
      if (chance(7, 25) == 0) changed = TileSet::all(width, height, small_side);
      Grid<int> expected = *versions.newest();
      auto next = versions.copy();
      REQUIRE(*next == expected);
      if (chance(8, 9) == 0) continue;  // A run that was stopped: the copy is lost.
      write(*next, changed, int(step) + 1);
      write(expected, changed, int(step) + 1);
      versions.put(std::move(next), changed);
      REQUIRE(*versions.newest() == expected);
      if (chance(9, 1) == 0) held.push_back({versions.newest(), std::move(expected)});
      while (int(held.size()) > chance(10, 6) + 1) held.pop_front();
      if (chance(11, 9) == 0) versions.release_unused();
      for (const Held& one : held) REQUIRE(*one.version == one.expected);
    }
  }
}

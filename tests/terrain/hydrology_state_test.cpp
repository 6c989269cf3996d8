#include "core/terrain/hydrology_state.hpp"

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>

#include "core/base/random.hpp"
#include "tests/terrain/ground.hpp"

using namespace biotope;
using namespace biotope::test;

namespace {

/// Tiles that hold a cell of a disc.
TileSet tiles_of_disc(const Grid<float>& height, int x, int y, int radius) {
  TileSet tiles(height.width(), height.height());
  tiles.insert({x - radius, y - radius, x + radius + 1, y + radius + 1});
  return tiles;
}

/// Raises, digs, flattens or roughens a disc.
void shape(Grid<float>& height, int x, int y, int radius, std::uint64_t number) {
  const int kind = random_int(0, 4, {number, 1});
  const float level = height.clamped(x, y) + float(random_int(-12, 12, {number, 2}));
  for (int cy = std::max(0, y - radius); cy <= std::min(height.height() - 1, y + radius); ++cy) {
    for (int cx = std::max(0, x - radius); cx <= std::min(height.width() - 1, x + radius); ++cx) {
      const double distance = std::hypot(cx - x, cy - y);
      if (distance > radius) continue;
      float& cell = height(cx, cy);
      if (kind == 0) cell += float((radius - distance) * 0.7);
      if (kind == 1) cell -= float((radius - distance) * 0.7);
      if (kind == 2) cell = level;
      if (kind == 3) cell += float(random_unit({number, 3, std::uint64_t(cx), std::uint64_t(cy)}));
      if (kind == 4) cell = std::floor(cell);
    }
  }
}

/// Some cells near a place, as if a lake were drawn there.
std::vector<std::uint32_t> some_cells(const Grid<float>& height, int x, int y, std::uint64_t number) {
  std::vector<std::uint32_t> cells;
  for (int cy = std::max(0, y - 6); cy < std::min(height.height(), y + 6); ++cy) {
    for (int cx = std::max(0, x - 6); cx < std::min(height.width(), x + 6); ++cx) {
      if (random_int(0, 2, {number, std::uint64_t(cx), std::uint64_t(cy)}) == 0)
        cells.push_back(std::uint32_t(height.index(cx, cy)));
    }
  }
  return cells;
}

std::string difference(const Hydrology& a, const Hydrology& b) {
  if (!(a.filled == b.filled)) return "filled";
  if (!(a.receiver == b.receiver)) return "receiver";
  if (!(a.catchment_area == b.catchment_area)) return "catchment area";
  if (!(a.discharge == b.discharge)) return "discharge";
  if (!(a.water == b.water)) return "kind of water";
  if (!(a.water_depth == b.water_depth)) return "depth";
  const auto same_reach = [](const RiverReach& p, const RiverReach& q) {
    return p.cells == q.cells && p.discharge == q.discharge && p.width == q.width && p.depth == q.depth;
  };
  if (!std::equal(a.reaches.begin(), a.reaches.end(), b.reaches.begin(), b.reaches.end(), same_reach)) return "reaches";
  const auto same_ford = [](const Ford& p, const Ford& q) { return p.x == q.x && p.y == q.y && p.depth == q.depth; };
  if (!std::equal(a.fords.begin(), a.fords.end(), b.fords.begin(), b.fords.end(), same_ford)) return "fords";
  return "";
}

/// Cells in which the newest water differs from the one before, but that the log leaves out.
bool log_holds(const Hydrology& before, const Hydrology& now, const TileSet& changed) {
  for (std::size_t tile = 0; tile < changed.tile_count(); ++tile) {
    if (changed.contains(tile)) continue;
    const Rect rect = changed.rect(tile);
    for (int y = rect.y0; y < rect.y1; ++y) {
      for (int x = rect.x0; x < rect.x1; ++x) {
        if (before.filled(x, y) != now.filled(x, y) || before.catchment_area(x, y) != now.catchment_area(x, y) ||
            before.discharge(x, y) != now.discharge(x, y) || before.water(x, y) != now.water(x, y) ||
            before.water_depth(x, y) != now.water_depth(x, y) || before.receiver(x, y) != now.receiver(x, y)) {
          return false;
        }
      }
    }
  }
  return true;
}

/// Edits of a ground one after the other; after each the water must be that of the whole ground.
void follow_edits(Terrain ground, HydrologyOptions options, int edits, std::uint64_t seed) {
  HydrologyState state;
  auto land = std::make_shared<const Terrain>(ground);
  REQUIRE(state.update(land, TileSet::all(ground.height.width(), ground.height.height()), options, {}));
  int followed = 0;
  for (int i = 0; i < edits; ++i) {
    const std::uint64_t number = random_bits({seed, std::uint64_t(i)});
    const int radius = random_int(2, 40, {number, 10});
    const int x = random_int(-5, ground.height.width() + 5, {number, 11});
    const int y = random_int(-5, ground.height.height() + 5, {number, 12});
    shape(ground.height, x, y, radius, number);
    TileSet changed = tiles_of_disc(ground.height, x, y, radius);
    if (i % 7 == 6) options.inflows.push_back({ground.height.width() / 2, ground.height.height() / 2, 2e6 * (i + 1)});
    if (i % 5 == 3) options.lake_cells = some_cells(ground.height, x, y, number);
    const auto before = state.newest();
    const Hydrology copy = *before;
    const std::uint64_t seen = state.changes().version();
    REQUIRE(state.update(std::make_shared<const Terrain>(ground), changed, options, {}));
    followed += state.changes().since(seen).every() ? 0 : 1;
    const auto whole = compute_hydrology(ground, options);
    REQUIRE(whole);
    INFO("seed " << seed << ", edit " << i);
    REQUIRE(difference(*state.newest(), *whole) == "");
    REQUIRE(difference(copy, *before) == "");
    REQUIRE(log_holds(copy, *state.newest(), state.changes().since(seen)));
  }
  CHECK(followed > edits / 2);
}

Terrain sloping(int width, int height, double noise, std::uint64_t seed) {
  Terrain ground = rough_ground(width, height, noise, seed);
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) ground.height(x, y) += 200 + float(height - y) * 0.3F + std::abs(float(x - width / 2)) * 0.4F;
  }
  return ground;
}

}  // namespace

TEST_CASE("water follows painted ground as if it were computed anew") {
  follow_edits(sloping(300, 280, 3, 5), {}, 16, 1);
  follow_edits(sloping(330, 200, 0.2, 6), {}, 12, 2);
}

TEST_CASE("water that enters the map is followed when the ground changes") {
  HydrologyOptions options;
  options.inflows.push_back({150, 0, 3e8});
  follow_edits(sloping(300, 280, 1, 7), options, 14, 3);
}

TEST_CASE("water of a coast is followed, and so is the sea itself") {
  for (std::uint64_t seed = 0; seed < 3; ++seed) {
    // The sea in the south, and bays, lagoons and islands where hollows and hills reach its level.
    Terrain ground = rough_ground(300, 280, 3, 31 + seed, 0);
    for (int y = 0; y < ground.height.height(); ++y) {
      for (int x = 0; x < ground.height.width(); ++x) ground.height(x, y) += 0.12F * float(150 - y);
    }
    follow_edits(ground, {}, 25, 70 + seed);
  }
}

TEST_CASE("water of a plain with many flats and hollows is followed") {
  Terrain plain = sloping(290, 270, 2, 8);
  for (float& height : plain.height.cells()) height = std::floor(height / 4);
  HydrologyOptions options;
  options.lake_area = 10;
  options.lake_depth = 0.1F;
  follow_edits(plain, options, 16, 4);
}

#include "core/climate/environment_state.hpp"

#include <catch2/catch.hpp>

#include <cmath>

#include "core/base/random.hpp"
#include "core/terrain/ground_tiles.hpp"
#include "tests/terrain/ground.hpp"

using namespace biotope;
using namespace biotope::test;

namespace {

Climate weather() {
  Climate climate;
  climate.temperature_mean.fill(9);
  climate.precipitation.fill(60);
  climate.cloud.fill(0.2);
  return climate;
}

/// A cone on the ground, up or down; returns the tiles it touches.
TileSet raise(Grid<float>& height, std::uint64_t number) {
  const int radius = random_int(3, 30, {number, 1});
  const int x = random_int(0, height.width() - 1, {number, 2});
  const int y = random_int(0, height.height() - 1, {number, 3});
  const float by = float(random_int(-40, 60, {number, 4}));
  for (int cy = 0; cy < height.height(); ++cy) {
    for (int cx = 0; cx < height.width(); ++cx) {
      const auto distance = float(std::hypot(cx - x, cy - y));
      if (distance < float(radius)) height(cx, cy) += by * (1 - distance / float(radius));
    }
  }
  TileSet tiles(height.width(), height.height());
  tiles.insert({x - radius, y - radius, x + radius + 1, y + radius + 1});
  return tiles;
}

bool same_layers(const MonthlyMap& a, const MonthlyMap& b) {
  if (a.layers.size() != b.layers.size() || a.offset != b.offset) return false;
  for (std::size_t i = 0; i < a.layers.size(); ++i) {
    if (!(*a.layers[i] == *b.layers[i])) return false;
  }
  return true;
}

/// Tiles whose slopes a change of heights in some tiles can reach.
TileSet slopes_of(const TileSet& heights) { return heights.grown(1); }

}  // namespace

TEST_CASE("horizons of a changed ground are those of the whole ground, and the tiles told hold every change") {
  Terrain ground = rough_ground(150, 130, 10, 3);
  for (const int stride : {1, 2, 4}) {
    HorizonField field(ground, 16, stride);
    for (std::uint64_t edit = 0; edit < 5; ++edit) {
      const Horizons before = field.horizons();
      MovedHorizons moved(ground.height.width(), ground.height.height(), 16);
      field.update(ground, raise(ground.height, edit + 10 * std::uint64_t(stride)), moved);
      const TileSet told = moved.tiles();
      const Horizons whole = compute_horizons(ground, 16, stride);
      for (std::size_t s = 0; s < 16; ++s) {
        REQUIRE(field.horizons().sectors[s] == whole.sectors[s]);
        const Grid<float>& old = before.sectors[s];
        for (int y = 0; y < old.height(); ++y) {
          for (int x = 0; x < old.width(); ++x) {
            if (old(x, y) == whole.sectors[s](x, y)) continue;
            TileSet own(told.width(), told.height(), told.side());
            own.insert({x * stride, y * stride, (x + 1) * stride, (y + 1) * stride});
            REQUIRE((own & told) == own);
            for (const std::size_t tile : own.list()) {
              REQUIRE(moved.before(s, tile).lowest <= old(x, y));
              REQUIRE(moved.before(s, tile).highest >= old(x, y));
            }
          }
        }
      }
    }
  }
}

TEST_CASE("light, warmth and soil follow a changed ground to the bit, near the brush first") {
  Terrain ground = rough_ground(170, 140, 10, 9, 400);
  const Climate climate = weather();
  Derivatives slopes = compute_derivatives(ground);
  Hydrology water = water_of(ground);
  IlluminationState light;
  TemperatureState warmth;
  SoilState soil;
  REQUIRE(light.restart(ground, slopes, climate, {}));
  warmth.restart(ground, climate);
  REQUIRE(soil.restart(ground, slopes, water, climate, {}));
  for (std::uint64_t edit = 0; edit < 6; ++edit) {
    const TileSet heights = raise(ground.height, edit + 70);
    slopes = compute_derivatives(ground);
    water = water_of(ground);
    const TileSet all = TileSet::all(ground.height.width(), ground.height.height());
    const auto shown = light.map();
    const Grid<float> as_shown = *shown.layers[6];
    light.follow(ground, heights, slopes_of(heights));
    light.update(slopes, climate, slopes_of(heights));
    light.update(slopes, climate, light.stale());
    CHECK_FALSE(light.stale().any());
    warmth.update(ground, climate, heights);
    if (edit == 3) soil.forget_passes();
    soil.update(ground, slopes, water, climate, {heights, slopes_of(heights), all});
    const auto whole = compute_environment(ground, slopes, water, climate);
    REQUIRE(whole);
    CHECK(same_layers(light.map(), whole->map(Resource::illumination)));
    CHECK(same_layers(warmth.map(climate), whole->map(Resource::temperature)));
    CHECK(same_layers(soil.moisture(climate), whole->map(Resource::moisture)));
    CHECK(*soil.texture() == *whole->texture);
    CHECK(*soil.geology() == *whole->geology);
    CHECK(*shown.layers[6] == as_shown);
  }
}

TEST_CASE("derivatives of any rectangle are those of the whole ground") {
  const Terrain ground = rough_ground(37, 29, 5, 4);
  const Derivatives whole = compute_derivatives(ground);
  Derivatives pieces{Grid<float>(37, 29), Grid<float>(37, 29), Grid<float>(37, 29), Grid<float>(37, 29)};
  for (int y = 0; y < 29; y += 7) {
    for (int x = 0; x < 37; x += 11) differentiate(ground, {x, y, std::min(x + 11, 37), std::min(y + 7, 29)}, pieces);
  }
  CHECK(pieces.east == whole.east);
  CHECK(pieces.north == whole.north);
  CHECK(pieces.slope == whole.slope);
  CHECK(pieces.curvature == whole.curvature);
}

TEST_CASE("a new version is made in memory that nobody holds, and what is held stays as it was") {
  GridGenerations<float> grids;
  grids.restart(std::make_shared<Grid<float>>(70, 70, 1.0F));
  TileSet first(70, 70);
  first.insert(std::size_t(0));
  const auto held = grids.newest();
  auto next = grids.copy();
  (*next)(5, 5) = 2;
  grids.put(std::move(next), first);
  CHECK((*held)(5, 5) == 1);
  CHECK((*grids.newest())(5, 5) == 2);
  const Grid<float>* free_memory = nullptr;
  {
    auto another = grids.copy();
    free_memory = another.get();
    TileSet last(70, 70);
    last.insert(std::size_t(3));
    (*another)(66, 66) = 3;
    grids.put(std::move(another), last);
  }
  auto third = grids.copy();
  (*third)(0, 0) = 4;
  grids.put(std::move(third), first);
  // The second version is not held: its memory serves again, with what changed since.
  const auto fourth = grids.copy();
  CHECK((*fourth)(5, 5) == 2);
  CHECK((*fourth)(66, 66) == 3);
  CHECK((*fourth)(0, 0) == 4);
  CHECK((*held)(66, 66) == 1);
  CHECK(free_memory != nullptr);
}

TEST_CASE("a log tells all that changed since a version, and everything when that is long ago") {
  ChangeLog log;
  log.note_all(200, 100);
  const auto seen = log.version();
  TileSet one(200, 100);
  one.insert(std::size_t(2));
  TileSet other(200, 100);
  other.insert(std::size_t(5));
  log.note(one);
  log.note(other);
  CHECK(log.since(seen) == (one | other));
  CHECK(log.since(seen + 1) == other);
  CHECK_FALSE(log.since(seen + 2).any());
  CHECK(log.since(0).every());
  for (int i = 0; i < 100; ++i) log.note(one);
  CHECK(log.since(seen).every());
}

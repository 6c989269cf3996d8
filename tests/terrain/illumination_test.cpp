#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/terrain/sun.hpp"
#include "core/terrain/sunlight.hpp"
#include "tests/terrain/ground.hpp"

using namespace biotope;
using namespace biotope::test;

namespace {

std::array<Grid<float>, 12> light_on(Terrain terrain, double latitude) {
  terrain.latitude = latitude;
  return compute_monthly_illumination(terrain, compute_derivatives(terrain)).value();
}

/// Mean over a day of the sine of the sun's height over ground that tilts `tilt` degrees toward the equator, while it is day on
/// the flat.
double analytic_mean(double latitude, double tilt, int month) {
  const double declination = solar_declination(middle_day(month));
  const double half_day = day_length(latitude, middle_day(month)) / 24 * std::numbers::pi;
  const double seen = (latitude - tilt) * std::numbers::pi / 180;
  return (half_day * std::sin(seen) * std::sin(declination) + std::cos(seen) * std::cos(declination) * std::sin(half_day)) /
         std::numbers::pi;
}

Terrain slope_to(double east, double north) {
  return ground(24, 24, 10, [=](double x, double y) { return 500 - east * x - north * y; });
}

constexpr int january = 0, june = 5, december = 11;

}  // namespace

TEST_CASE("flat ground receives the analytic daily mean in every month") {
  const Terrain flat = ground(5, 4, 10, [](double, double) { return 300.0; });
  for (const double latitude : {-60.0, -35.0, 0.0, 20.0, 42.85, 64.0, 75.0, 90.0}) {
    const auto light = light_on(flat, latitude);
    for (int month = 0; month < 12; ++month) {
      for (const float ratio : light[std::size_t(month)].cells()) {
        REQUIRE(ratio == Approx(std::max(0.0, analytic_mean(latitude, 0, month))).epsilon(2e-3).margin(1e-4));
      }
    }
  }
}

TEST_CASE("in the polar night there is no light, in the polar day there is all day long") {
  const auto light = light_on(ground(4, 4, 10, [](double, double) { return 0.0; }), 75);
  CHECK(light[december](1, 1) == 0);
  CHECK(light[june](1, 1) > 0.3F);
}

TEST_CASE("a winter slope to the south is lit like flat ground nearer the equator") {
  for (const double tilt : {10.0, 25.0}) {
    const auto light = light_on(slope_to(0, -std::tan(tilt * std::numbers::pi / 180)), 42.85);
    for (const int month : {january, 10, december}) {
      CHECK(light[std::size_t(month)](12, 12) == Approx(analytic_mean(42.85, tilt, month)).epsilon(0.02));
    }
  }
}

TEST_CASE("slopes to the south are lighter than flat ground, slopes to the north darker, most of all in winter") {
  const auto south = light_on(slope_to(0, 0.5), 42.85);
  const auto north = light_on(slope_to(0, -0.5), 42.85);
  const auto flat = light_on(slope_to(0, 0), 42.85);
  // slope_to(0, 0.5) falls toward the north.
  for (std::size_t month = 0; month < 12; ++month) {
    CHECK(north[month](12, 12) > south[month](12, 12));
    if (month != june) CHECK(south[month](12, 12) < flat[month](12, 12));
  }
  CHECK(north[december](12, 12) > 4 * south[december](12, 12));
  const auto below_the_equator = light_on(slope_to(0, 0.5), -42.85);
  CHECK(below_the_equator[june](12, 12) > flat[december](12, 12));
}

TEST_CASE("mornings and afternoons weigh the same: slopes to the east and west are lit alike") {
  const auto east = light_on(slope_to(0.4, 0), 42.85);
  const auto west = light_on(slope_to(-0.4, 0), 42.85);
  for (std::size_t month = 0; month < 12; ++month) CHECK(east[month](12, 12) == Approx(west[month](11, 12)).epsilon(1e-3));
}

TEST_CASE("a wall shades the ground on its northern side in winter") {
  const Terrain wall = ground(61, 61, 2, [](double, double y) { return y > 59 && y < 61 ? 20.0 : 0.0; });
  const auto light = light_on(wall, 42.85);
  const float shaded = light[december](30, 26);
  const float open = light[december](30, 34);
  CHECK(shaded < 0.2F * open);
  CHECK(light[december](30, 55) == Approx(open).epsilon(0.05));
}

TEST_CASE("the floor of a deep gorge running east sees no winter sun") {
  const Terrain gorge = ground(61, 61, 5, [](double, double y) { return std::abs(y - 150) < 20 ? 0.0 : 100.0; });
  const auto light = light_on(gorge, 42.85);
  CHECK(light[december](30, 30) < 0.02F);
  CHECK(light[june](30, 30) > 0.1F);
  CHECK(light[december](30, 5) > 0.08F);
}

TEST_CASE("the light is a ratio and stops when told to") {
  const Terrain rough = rough_ground(70, 50, 10, 8);
  const auto light = light_on(rough, 42.85);
  for (const Grid<float>& month : light) {
    for (const float ratio : month.cells()) {
      REQUIRE(ratio >= 0);
      REQUIRE(ratio <= 1);
    }
  }
  std::stop_source stop;
  stop.request_stop();
  const TaskContext context{{}, stop.get_token()};
  CHECK_FALSE(compute_monthly_illumination(rough, compute_derivatives(rough), context));
}

TEST_CASE("a wall changes the light of a place in the months in which the sun stands low behind it, and in no other") {
  const Rect place{64, 64, 80, 80};
  const auto changed_by = [&](int wall_y, float height) {
    Terrain land = ground(144, 144, 10, [](double, double) { return 300.0; });
    land.latitude = 45;
    HorizonField field(land);
    const Sunlight sunlight(land.latitude, 144, field.horizons());
    MovedHorizons moved(144, 144, illumination_sectors);
    for (int x = 0; x < 144; ++x) land.height(x, wall_y) += height;
    TileSet tiles(144, 144);
    tiles.insert({0, wall_y, 144, wall_y + 1});
    field.update(land, tiles, moved);
    std::size_t tile = 0;
    while (!(moved.tiles().rect(tile) == place)) ++tile;
    return sunlight.changed_months(field.horizons(), moved, tile, place);
  };
  // Tops of 17 to 22 degrees in the south: the noon of winter stands at 22, that of summer at 68.
  const auto south = changed_by(110, 130);
  CHECK(south[december]);
  CHECK_FALSE(south[june]);
  // In the north the sun stands in no month; low in the east and west of it, in summer.
  const auto north = changed_by(34, 130);
  CHECK_FALSE(north[december]);
  // Where nothing moved, nothing changes.
  CHECK(std::ranges::count(changed_by(110, 0), true) == 0);
}

TEST_CASE("the light of a month that is told unchanged is unchanged to the bit") {
  Terrain land = rough_ground(144, 144, 10, 12, 300);
  land.latitude = 47;
  HorizonField field(land);
  const Sunlight sunlight(land.latitude, 144, field.horizons());
  const Derivatives flat = compute_derivatives(land);
  const auto lit = [&](const Rect& cells) {
    std::array<Grid<float>, 12> light;
    std::array<Grid<float>*, 12> out{};
    for (std::size_t month = 0; month < 12; ++month) {
      light[month] = Grid<float>(144, 144);
      out[month] = &light[month];
    }
    sunlight.illuminate(flat, field.horizons(), cells, out);
    return light;
  };
  int left_alone = 0;
  for (std::uint64_t edit = 0; edit < 12; ++edit) {
    MovedHorizons moved(144, 144, illumination_sectors);
    const int x = random_int(0, 143, {edit, 1});
    const int y = random_int(0, 143, {edit, 2});
    const TileSet all = TileSet::all(144, 144, small_side);
    std::vector<std::array<Grid<float>, 12>> before;
    for (std::size_t tile = 0; tile < all.tile_count(); ++tile) before.push_back(lit(all.rect(tile)));
    land.height(x, y) += float(random_int(-60, 200, {edit, 3}));
    TileSet tiles(144, 144);
    tiles.insert({x, y, x + 1, y + 1});
    field.update(land, tiles, moved);
    for (std::size_t tile = 0; tile < all.tile_count(); ++tile) {
      const auto changed = sunlight.changed_months(field.horizons(), moved, tile, all.rect(tile));
      const auto after = lit(all.rect(tile));
      for (std::size_t month = 0; month < 12; ++month) {
        if (changed[month]) continue;
        REQUIRE(after[month] == before[tile][month]);
        left_alone += moved.tiles().contains(tile) ? 1 : 0;
      }
    }
  }
  CHECK(left_alone > 100);
}

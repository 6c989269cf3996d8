#include "core/climate/snow_cover.hpp"

#include <catch2/catch.hpp>
#include <filesystem>

using namespace biotope;

namespace {

/// The same every month: `temperature` deg C at sea level with a daily swing of 6 degrees, 60 mm a month.
Climate even_climate(double temperature) {
  Climate climate;
  climate.temperature_mean.fill(temperature);
  climate.temperature_min.fill(temperature - 3);
  climate.temperature_max.fill(temperature + 3);
  climate.precipitation.fill(60);
  return climate;
}

/// Coldest in January, warmest in July.
Climate seasonal_climate(double yearly_mean) {
  constexpr MonthlyValues departure{-9, -8, -5, -1, 4, 8, 9, 8, 5, 1, -4, -8};
  Climate climate = even_climate(0);
  for (std::size_t m = 0; m < departure.size(); ++m) {
    climate.temperature_mean[m] = yearly_mean + departure[m];
    climate.temperature_min[m] = climate.temperature_mean[m] - 3;
    climate.temperature_max[m] = climate.temperature_mean[m] + 3;
  }
  return climate;
}

std::vector<Climate> built_in() {
  const auto climates = load_climates(std::filesystem::path(BIOTOPE_SOURCE_DIR) / "assets/climates");
  REQUIRE(climates);
  return *climates;
}

Climate built_in(std::string_view name) {
  for (const Climate& climate : built_in()) {
    if (climate.name == name) return climate;
  }
  FAIL("no climate of that name");
  return {};
}

}  // namespace

TEST_CASE("what falls is snow up to -1 degrees, rain from +3, half of each at +1") {
  CHECK(solid_share(-5) == 1);
  CHECK(solid_share(-1) == 1);
  CHECK(solid_share(1) == Approx(0.5));
  CHECK(solid_share(3) == 0);
  CHECK(solid_share(30) == 0);
}

TEST_CASE("half of what falls is snow where the mean is +1 degrees") {
  const Climate climate = even_climate(7.5);
  const SnowfallHeight fall = snowfall_height(climate, 0);
  CHECK(fall.height == Approx(1000));
  CHECK(fall.spread == Approx(2000 / 6.5));
  CHECK(solid_share(mean_temperature(climate, 0, fall.height)) == Approx(0.5));
  CHECK(solid_share(mean_temperature(climate, 0, fall.height + fall.spread)) == Approx(1));
}

TEST_CASE("frost all year keeps all snow, up to the cap and a year more") {
  const MonthlyValues snow = snow_water(even_climate(-20), 0);
  for (std::size_t m = 1; m < snow.size(); ++m) CHECK(snow[m] > snow[m - 1]);
  CHECK(snow[11] <= 1500 + 12 * 60 + 1);
  CHECK(snow[11] > 12 * 60);
}

TEST_CASE("where it never freezes no snow lies") {
  for (const double snow : snow_water(even_climate(10), 0)) CHECK(snow == 0);
}

TEST_CASE("higher is whiter, shade is whiter than level ground, and that than sun") {
  const Climate climate = seasonal_climate(8);
  for (double height = 0; height < 4000; height += 500) {
    const MonthlyValues low = snow_water(climate, height);
    const MonthlyValues high = snow_water(climate, height + 500);
    const MonthlyValues shaded = snow_water(climate, height, SnowExposure::shaded);
    const MonthlyValues sunny = snow_water(climate, height, SnowExposure::sunny);
    for (std::size_t m = 0; m < low.size(); ++m) {
      CHECK(high[m] >= low[m] - 1e-9);
      CHECK(shaded[m] >= low[m] - 1e-9);
      CHECK(low[m] >= sunny[m] - 1e-9);
    }
  }
}

TEST_CASE("a colder climate has its snow line lower, in every month") {
  const auto warm = snow_lines(seasonal_climate(16));
  const auto cold = snow_lines(seasonal_climate(11));
  for (std::size_t m = 0; m < warm.size(); ++m) {
    // 5 degrees are 769 m at 6.5 degrees a km; the cap on old snow hardly moves it.
    CHECK(cold[m].height == Approx(warm[m].height - 5 / 6.5 * 1000).margin(150));
  }
}

TEST_CASE("the line of winter lies below that of summer; it rises in spring and falls in autumn") {
  for (const Climate& climate : built_in()) {
    INFO(climate.name);
    const auto lines = snow_lines(climate);
    CHECK(lines[0].height < lines[6].height);
    CHECK(lines[1].height < lines[7].height);
    CHECK(lines[4].height <= lines[5].height);
    CHECK(lines[10].height >= lines[11].height);
    for (const SnowLine& line : lines) {
      CHECK(line.spread >= 80);
      CHECK(line.spread <= 450);
      CHECK(line.aspect >= 0);
    }
  }
}

TEST_CASE("the built-in climates have the snow their places are known for") {
  // Grand Canyon: never at the river (about 750 m); the rim at 2100 m and more in winter only.
  for (const SnowLine& line : snow_lines(built_in("hot-dry-canyon"))) CHECK(line.height > 1500);
  // Catalan Pyrenees: white above about 2000 m in winter, bare at 2500 m in August.
  const auto alpine = snow_lines(built_in("alpine"));
  CHECK(alpine[1].height < 2000);
  CHECK(alpine[7].height > 2500);
  // Roussillon at sea level.
  CHECK(snow_lines(built_in("mediterranean"))[0].height > 800);
  CHECK(snow_lines(built_in("ice-age"))[0].height < snow_lines(built_in("mild-humid"))[0].height);
}

TEST_CASE("without cooling by height there is snow everywhere or nowhere") {
  Climate climate = even_climate(-10);
  climate.lapse_rate = 0;
  CHECK(snow_lines(climate)[3].height == -no_snow_line);
  climate = even_climate(15);
  climate.lapse_rate = 0;
  CHECK(snow_lines(climate)[3].height == no_snow_line);
}

// Climate files, and the water balance that follows from a climate.
#include <catch2/catch.hpp>
#include <filesystem>
#include <string>

#include "core/climate/climate.hpp"

namespace biotope {
namespace {

using Catch::Matchers::Contains;

const std::string plain_text =
    R"({"name": "plain", "temperature_mean": [1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12],)"
    R"( "precipitation": [10, 20, 30, 40, 50, 60, 70, 80, 90, 100, 110, 120], "reference_height": 100})";

std::string changed(std::string text, const std::string& from, const std::string& to) {
  const std::size_t at = text.find(from);
  REQUIRE(at != std::string::npos);
  return text.replace(at, from.size(), to);
}

std::string message_of(const std::string& text) {
  const auto climate = parse_climate(text, "plain.json");
  REQUIRE_FALSE(climate);
  return climate.error().message;
}

std::vector<Climate> assets() {
  auto climates = load_climates(std::filesystem::path(BIOTOPE_SOURCE_DIR) / "assets/climates");
  if (!climates) FAIL(climates.error().message);
  return *climates;
}

const Climate& named(const std::vector<Climate>& climates, std::string_view name) {
  for (const Climate& climate : climates) {
    if (climate.name == name) return climate;
  }
  FAIL("no climate " << name);
  return climates.front();
}

double yearly(const MonthlyValues& values) {
  double sum = 0;
  for (const double value : values) sum += value;
  return sum;
}

Climate steady(double temperature, double precipitation) {
  Climate climate;
  climate.temperature_mean.fill(temperature);
  climate.precipitation.fill(precipitation);
  return climate;
}

TEST_CASE("a climate needs means, rain and the height they belong to") {
  const auto climate = parse_climate(plain_text, "plain.json");
  REQUIRE(climate);
  CHECK(climate->temperature_mean[0] == 1);
  CHECK(climate->temperature_min[11] == 7);
  CHECK(climate->temperature_max[11] == 17);
  CHECK(climate->precipitation[11] == 120);
  CHECK(climate->lapse_rate == 6.5);
  CHECK(climate->cloud == MonthlyValues{});
  CHECK(climate->title == "plain");
}

TEST_CASE("a wrong climate is answered with file, key and what was expected") {
  CHECK(message_of(changed(plain_text, "120]", "120, 130]")).find(
            R"(plain.json: "precipitation" must be 12 numbers in 0..5000, got [10, 20, 30)") == 0);
  CHECK_THAT(message_of(changed(plain_text, "[10,", "[-10,")), Contains("\"precipitation\" must be 12 numbers"));
  CHECK(message_of(changed(plain_text, R"(, "reference_height": 100)", "")) ==
        R"(plain.json: "reference_height" is missing; it must be a number in -500..9000)");
  CHECK(message_of(changed(plain_text, "100}", R"(100, "lapse_rat": 5})")) ==
        R"(plain.json: unknown key "lapse_rat"; did you mean "lapse_rate"?)");
  CHECK(message_of(changed(plain_text, "100}", R"(100, "temperature_min": [2, 2, 2, 2, 2, 2, 2, 2, 2, 2, 2, 2]})")) ==
        R"(plain.json: "temperature_min" must not be above "temperature_mean", but it is in month 1)");
  CHECK_THAT(message_of("{\n\"name\": \"plain\",,\n}"), Contains("plain.json:2:"));
}

TEST_CASE("a climate written as JSON reads back equal") {
  for (const Climate& before : assets()) {
    const auto after = parse_climate(climate_to_json(before), "written");
    REQUIRE(after);
    CHECK(*after == before);
  }
}

TEST_CASE("the built-in climates are there, by name, and say where their numbers come from") {
  const std::vector<Climate> climates = assets();
  std::vector<std::string> names;
  for (const Climate& climate : climates) {
    names.push_back(climate.name);
    CHECK_FALSE(climate.source.empty());
    CHECK_FALSE(climate.description.empty());
  }
  CHECK(names == std::vector<std::string>{"alpine", "hot-dry-canyon", "ice-age", "mediterranean", "mild-humid"});
  CHECK(named(climates, "hot-dry-canyon").temperature_max[6] == 41.1);
  CHECK(named(climates, "alpine").reference_height == 1386);
  CHECK(named(climates, "mild-humid").temperature_mean[6] == 20.2);
  CHECK(yearly(named(climates, "ice-age").precipitation) < yearly(named(climates, "mild-humid").precipitation));
}

TEST_CASE("a folder without climates is named") {
  const auto climates = load_climates("no/such/folder");
  REQUIRE_FALSE(climates);
  CHECK_THAT(climates.error().message, Contains("no/such/folder"));
}

TEST_CASE("potential evapotranspiration is Thornthwaite's") {
  // 20 deg C all year at the equator: I = 12 * 4^1.514 = 97.90, a = 2.139, so 16 (200 / 97.90)^2.139 = 73.7 mm a month of 30 days of 12
  // hours, and 897 mm in a year of 365.25 days.
  CHECK(potential_evapotranspiration(steady(20, 50), 0, 0) == Approx(897).epsilon(0.01));
  CHECK(potential_evapotranspiration(steady(-5, 50), 45, 0) == 0);
  CHECK(potential_evapotranspiration(steady(20, 50), 45, 0) > potential_evapotranspiration(steady(20, 50), 45, 1000));
}

TEST_CASE("what does not evaporate runs off") {
  CHECK(yearly_runoff(steady(-5, 50), 45, 0) == Approx(0.6));
  CHECK(yearly_runoff(steady(20, 100), 0, 0) == Approx(1.2 - 0.897).epsilon(0.02));
  // In a desert all the rain evaporates, save the twentieth part that storms carry off.
  CHECK(yearly_runoff(steady(30, 10), 0, 0) == Approx(0.006));
  CHECK(yearly_runoff(steady(10, 0), 45, 0) == 0);
}

TEST_CASE("mountains run off more than the plain, and humid climates more than dry ones") {
  const std::vector<Climate> climates = assets();
  const Climate& mild = named(climates, "mild-humid");
  CHECK(yearly_runoff(mild, 42.85, 1500) > yearly_runoff(mild, 42.85, 0));
  CHECK(yearly_runoff(mild, 42.85, 300) > yearly_runoff(named(climates, "mediterranean"), 42.85, 300));
  CHECK(yearly_runoff(named(climates, "hot-dry-canyon"), 36.1, 780) < 0.05);
}

}  // namespace
}  // namespace biotope

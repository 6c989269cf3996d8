#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include "core/exchange/placements_json.hpp"
#include "tests/exchange/scene_sample.hpp"

using namespace biotope;
using namespace biotope_test;
using Catch::Matchers::Contains;

namespace {

std::string error_of(const char* text) {
  const auto parsed = parse_placements_text(text, "edits.json");
  REQUIRE_FALSE(parsed);
  CHECK_THAT(parsed.error().message, Contains("edits.json"));
  return parsed.error().message;
}

}  // namespace

TEST_CASE("placements come back from JSON as they were, to the bit") {
  const Placements placements = some_placements();
  const auto json = placements_to_json(placements);
  const auto again = parse_placements(json, "here");
  if (!again) FAIL(again.error().message);
  CHECK(*again == placements);
  const auto from_text = parse_placements_text(json.dump(), "here");
  REQUIRE(from_text);
  CHECK(*from_text == placements);
}

TEST_CASE("no placements are an empty object") {
  CHECK(placements_to_json({}).dump() == "{}");
  const auto none = parse_placements_text("{}", "here");
  REQUIRE(none);
  CHECK(*none == Placements{});
}

TEST_CASE("a line of too few points is nothing and is not written") {
  Placements placements;
  placements.water.rivers = {{{{1, 2}}, 1}};
  placements.water.lakes = {{{{1, 2}, {3, 4}}, 3}};
  CHECK(placements_to_json(placements).dump() == "{}");
}

TEST_CASE("missing numbers have their defaults") {
  const auto parsed = parse_placements_text(R"({"fords": [{"at": [3, 4.5]}]})", "here");
  REQUIRE(parsed);
  CHECK(parsed->places.fords == std::vector<PlacedFord>{{{3, 4.5F}, PlacedFord{}.radius}});
}

TEST_CASE("odd placements are refused with file, item and key") {
  CHECK_THAT(error_of(R"({"fords": [{"at": [1, 1]}, {"radius_m": 3}]})"), Contains("fords[1]") && Contains("at"));
  CHECK_THAT(error_of(R"({"fords": [{"at": [1e7, 1]}]})"), Contains("fords[0]") && Contains("million"));
  CHECK_THAT(error_of(R"({"fords": [{"at": [1, null]}]})"), Contains("at"));
  CHECK_THAT(error_of(R"({"fords": [{"at": [1, 1], "radius_m": -1}]})"), Contains("radius_m"));
  CHECK_THAT(error_of(R"({"fords": [{"at": [1, 1], "radius": 1}]})"), Contains("radius_m"));
  CHECK_THAT(error_of(R"({"fords": {}})"), Contains("fords"));
  CHECK_THAT(error_of(R"({"bridges": []})"), Contains("bridges"));
  CHECK_THAT(error_of(R"({"rivers": [{"course": [[1, 1]]}]})"), Contains("rivers[0]") && Contains("2 points"));
  CHECK_THAT(error_of(R"({"rivers": [{"course": [[1, 1], [2]]}]})"), Contains("course[1]"));
  CHECK_THAT(error_of(R"({"lakes": [{"shore": [[1, 1], [2, 2]]}]})"), Contains("3 points"));
  CHECK_THAT(error_of(R"({"waypoints": [{"at": [1, 1], "attraction": 2}]})"), Contains("attraction"));
  CHECK_THAT(error_of(R"({"plans": [{"species": "wolf", "home": [1, 1], "stops": [{"at": [1, 1], "arrive": 9, "leave": 8}]}]})"),
             Contains("stops[0]") && Contains("leave"));
  CHECK_THAT(error_of("[]"), Contains("object"));
  CHECK_THAT(error_of("{"), Contains("JSON"));
}

// Species files: what a valid one means, and what each mistake is answered with.
#include <catch2/catch.hpp>
#include <filesystem>
#include <set>
#include <string>

#include "core/species/species_library.hpp"

namespace biotope {
namespace {

using Catch::Matchers::Contains;

const std::string grass_text =
    R"({"name": "grass", "plant": {"stratum": "herb", "illumination": [5, 9], "temperature": [1, 9], "moisture": [1, 8],)"
    R"( "texture": [1, 9], "growth": 0.3}})";
const std::string deer_text =
    R"({"name": "deer", "animal": {"herd": [5, 14], "mass": [30, 80], "speed": 1.4,)"
    R"( "diet": [{"need": "forage", "amount": 1.3, "foods": {"herbs": 1}}]}})";

std::string file_of(const std::string& species) { return R"({"species": [)" + species + "]}"; }

/// The text with its one occurrence of `from` replaced.
std::string changed(std::string text, const std::string& from, const std::string& to) {
  const std::size_t at = text.find(from);
  REQUIRE(at != std::string::npos);
  return text.replace(at, from.size(), to);
}

std::string message_of(const std::string& text) {
  const auto species = parse_species(text, "species.json");
  REQUIRE_FALSE(species);
  return species.error().message;
}

std::vector<Species> asset(const std::string& name) {
  const auto species = load_species(std::filesystem::path(BIOTOPE_SOURCE_DIR) / "assets/species" / name);
  if (!species) FAIL(species.error().message);
  return *species;
}

const Species& named(const std::vector<Species>& list, std::string_view name) {
  for (const Species& one : list) {
    if (one.name == name) return one;
  }
  FAIL("no species " << name);
  return list.front();
}

TEST_CASE("a plant needs five lines, and the rest has documented defaults") {
  const auto species = parse_species(file_of(grass_text), "species.json");
  REQUIRE(species);
  REQUIRE(species->size() == 1);
  const PlantTraits& grass = species->front().plant();
  CHECK(grass.illumination == Range{5, 9});
  CHECK(grass.stratum == Stratum::herb);
  CHECK(grass.growth == 0.3F);
  CHECK(grass.light_consumption == 0);
  CHECK(grass.geology == std::array<float, 5>{1, 0, 1, 1, 1});
  CHECK(grass.unit_cover == 0.05F);
  CHECK(species->front().scientific_name == "grass");
  CHECK(species->front().common_name == "grass");
}

TEST_CASE("a wrong value is answered with file, species, key and what was expected") {
  CHECK(message_of(file_of(changed(grass_text, "[5, 9]", "[9, 7]"))) ==
        R"(species.json: species "grass": "illumination" must be two numbers low <= high in 1..9, got [9, 7])");
  CHECK(message_of(file_of(changed(grass_text, "[1, 8]", "[0, 8]"))) ==
        R"(species.json: species "grass": "moisture" must be two numbers low <= high in 1..9, got [0, 8])");
  CHECK(message_of(file_of(changed(grass_text, "\"herb\"", "\"moss\""))) ==
        R"(species.json: species "grass": "stratum" must be one of "tree", "shrub", "herb", got "moss")");
  CHECK(message_of(file_of(changed(grass_text, "0.3", "\"much\""))) ==
        R"(species.json: species "grass": "growth" must be a number in 0..10, got "much")");
  CHECK(message_of(file_of(changed(deer_text, "[5, 14]", "[5, 14.5]"))) ==
        R"(species.json: species "deer": "herd" must be two whole numbers low <= high in 1..100000, got [5, 14.5])");
  CHECK(message_of(file_of(changed(deer_text, R"({"herbs": 1})", R"({"herbs": 0})"))) ==
        R"(species.json: species "deer": "diet[0].foods.herbs" must be a preference in 0.001..1000, got 0)");
  CHECK(message_of(file_of(changed(grass_text, "\"grass\"", "\"Long Grass\""))) ==
        R"(species.json: species "Long Grass": "name" must be lower-case letters, digits and '-', got "Long Grass")");
}

TEST_CASE("an unknown key is refused with the nearest known one") {
  CHECK(message_of(file_of(changed(grass_text, "\"illumination\"", "\"illuminaton\""))).find("is missing") != std::string::npos);
  CHECK(message_of(file_of(changed(deer_text, "\"speed\": 1.4", "\"speed\": 1.4, \"max_slop\": 1"))) ==
        R"(species.json: species "deer": unknown key "max_slop"; did you mean "max_slope"?)");
  CHECK(message_of(file_of(changed(deer_text, "\"speed\": 1.4", "\"speed\": 1.4, \"shape\": {\"coat_color\": [0, 0, 0]}"))) ==
        R"(species.json: species "deer": unknown key "shape.coat_color"; did you mean "coat_colour"?)");
  CHECK(message_of(R"({"species": [], "spices": []})") ==
        R"(species.json: "species" must be a list of at least one species, got [])");
  CHECK(message_of(changed(file_of(grass_text), "{\"species\"", "{\"spices\": [], \"species\"")) ==
        R"(species.json: unknown key "spices"; did you mean "species"?)");
}

TEST_CASE("a missing key names itself and what it must be") {
  CHECK(message_of(file_of(changed(grass_text, R"("temperature": [1, 9], )", ""))) ==
        R"(species.json: species "grass": "temperature" is missing; it must be two numbers low <= high in 1..9)");
  CHECK(message_of(file_of(changed(grass_text, R"("name": "grass", )", ""))) ==
        R"(species.json: species 1: "name" is missing; it must be a text)");
  CHECK(message_of(file_of(R"({"name": "ghost"})")) ==
        R"(species.json: species "ghost": has neither "plant" nor "animal"; exactly one of them must hold its traits)");
  CHECK_THAT(message_of(file_of(changed(grass_text, "\"plant\"", "\"animal\": {}, \"plant\""))), Contains("has both"));
  CHECK(message_of(file_of(R"({"name": "ghost", "plnat": {}})")) ==
        R"(species.json: species "ghost": unknown key "plnat"; did you mean "plant"?)");
}

TEST_CASE("broken JSON is answered with line and column") {
  CHECK_THAT(message_of("{\"species\": [\n  {\"name\" \"grass\"}\n]}"), Contains("species.json:2:"));
  CHECK_THAT(message_of("{\"species\": [\n  {\"name\" \"grass\"}\n]}"), Contains("not valid JSON"));
  CHECK_THAT(message_of(""), Contains("species.json:1:"));
  CHECK(message_of(file_of(changed(grass_text, "\"growth\"", "\"moisture\": [1, 2], \"growth\""))) ==
        R"(species.json: key "moisture" is written twice in one object)");
  CHECK_THAT(message_of("[1, 2]"), Contains("expected an object"));
  CHECK_THAT(message_of(file_of("7")), Contains("species 1: expected an object"));
  CHECK_THAT(message_of("{\"species\": [\"\xff\xfe\"]}"), Contains("species.json"));
}

TEST_CASE("two species of one name are refused") {
  CHECK(message_of(file_of(grass_text + "," + grass_text)) ==
        R"(species.json: two species are named "grass"; names must differ)");
}

TEST_CASE("a file that is not there is named") {
  const auto species = load_species("no/such/place.json");
  REQUIRE_FALSE(species);
  CHECK_THAT(species.error().message, Contains("no/such/place.json"));
}

TEST_CASE("species written as JSON read back equal") {
  for (const char* file : {"tautavel.json", "authors-2021.json", "grand-canyon.json"}) {
    const std::vector<Species> before = asset(file);
    const auto after = parse_species(species_to_json(before), "written");
    REQUIRE(after);
    CHECK(*after == before);
  }
}

TEST_CASE("the default list holds the thesis's table A.1 exactly") {
  const std::vector<Species> list = asset("tautavel.json");
  CHECK(std::ranges::count_if(list, &Species::is_plant) == 18);
  const PlantTraits& alnus = named(list, "alnus").plant();
  CHECK(alnus.illumination == Range{7, 9});
  CHECK(alnus.temperature == Range{2, 8});
  CHECK(alnus.moisture == Range{4, 8});
  CHECK(alnus.texture == Range{1, 4});
  CHECK(alnus.light_consumption == 5);
  CHECK(alnus.water_consumption == 5);
  CHECK(alnus.geology == std::array<float, 5>{0, 0.8F, 0, 0, 1});
  const PlantTraits& carpinus = named(list, "carpinus").plant();
  CHECK(carpinus.illumination == Range{6, 7});
  CHECK(carpinus.temperature == Range{6, 7});
  CHECK(carpinus.water_consumption == 4);
  CHECK(named(list, "poaceae").plant().light_consumption == 0.2F);
  CHECK(named(list, "pinus-mugo").plant().temperature == Range{2, 4});
  CHECK(named(list, "corylus").plant().stratum == Stratum::tree);
  CHECK(named(list, "pistacia").plant().stratum == Stratum::shrub);
}

TEST_CASE("the default list holds the thesis's table A.2 with its swapped columns put right") {
  const std::vector<Species> list = asset("tautavel.json");
  CHECK(std::ranges::count_if(list, [](const Species& one) { return !one.is_plant(); }) == 12);
  const AnimalTraits& wolf = named(list, "canis-mosbachensis").animal();
  CHECK(wolf.herd_min == 5);
  CHECK(wolf.herd_max == 9);
  CHECK(wolf.mass_min == 23);
  CHECK(wolf.mass_max == 80);
  CHECK_THAT(named(list, "canis-mosbachensis").sources.at("herd, mass"), Contains("swapped"));
  CHECK(named(list, "vulpes-vulpes").animal().herd_max == 1);
  CHECK(named(list, "rangifer-tarandus").animal().herd_max == 150);
  CHECK(named(list, "rangifer-tarandus").proportions.at("ice-age") == 69.03);
  CHECK(named(list, "cervus-elaphus").proportions.at("mild-humid") == 41.28);
  CHECK(named(list, "ursus-arctos").proportions.at("mild-humid") == 0);
}

TEST_CASE("every species of the built-in lists says where its values come from, and is told apart by colour") {
  for (const char* file : {"tautavel.json", "authors-2021.json", "grand-canyon.json"}) {
    std::set<std::array<float, 3>> colours;
    for (const Species& one : asset(file)) {
      INFO(file << " " << one.name);
      CHECK_FALSE(one.sources.empty());
      CHECK(colours.insert(one.colour).second);
    }
  }
}

}  // namespace
}  // namespace biotope

// Food webs: levels, groups, cycles and desired shares.
#include <catch2/catch.hpp>
#include <filesystem>
#include <string>

#include "core/species/species_library.hpp"

namespace biotope {
namespace {

Species plant(const std::string& name, Stratum stratum = Stratum::herb) {
  Species species;
  species.name = name;
  PlantTraits traits;
  traits.stratum = stratum;
  species.traits = traits;
  return species;
}

Species animal(const std::string& name, const std::vector<std::vector<std::string>>& needs) {
  Species species;
  species.name = name;
  AnimalTraits traits;
  for (const auto& foods : needs) {
    Need need{"need " + std::to_string(traits.diet.size() + 1), {}, 1};
    for (const std::string& food : foods) need.foods.push_back({food, 1});
    traits.diet.push_back(need);
  }
  species.traits = traits;
  return species;
}

FoodWeb web_of(std::vector<Species> species) {
  const auto web = build_food_web(std::move(species));
  if (!web) FAIL(web.error().message);
  return *web;
}

std::string refusal_of(std::vector<Species> species) {
  const auto web = build_food_web(std::move(species));
  REQUIRE_FALSE(web);
  return web.error().message;
}

std::vector<std::string> names(const FoodWeb& web, const std::vector<int>& numbers) {
  std::vector<std::string> list;
  for (const int number : numbers) list.push_back(web.species[std::size_t(number)].name);
  return list;
}

using Names = std::vector<std::string>;

TEST_CASE("a level is one more than the highest level eaten, whatever the order of the list") {
  const FoodWeb web = web_of({animal("lion", {{"wolf", "deer"}}), animal("wolf", {{"herbivores"}}), animal("deer", {{"grass"}}),
                              plant("grass"), animal("bear", {{"berry"}, {"deer"}}), plant("berry", Stratum::shrub)});
  REQUIRE(web.level_count() == 4);
  CHECK(names(web, web.levels[0]) == Names{"grass", "berry"});
  CHECK(names(web, web.levels[1]) == Names{"deer"});
  CHECK(names(web, web.levels[2]) == Names{"wolf", "bear"});
  CHECK(names(web, web.levels[3]) == Names{"lion"});
  CHECK(web.level == std::vector<int>{0, 0, 1, 2, 2, 3});
  CHECK(web.find("bear") == 4);
  CHECK(web.find("dragon") == -1);
}

TEST_CASE("groups hold what their names say, and never the eater itself") {
  const FoodWeb web =
      web_of({plant("grass"), plant("berry", Stratum::shrub), plant("oak", Stratum::tree), animal("deer", {{"plants"}}),
              animal("goat", {{"shrubs"}}), animal("squirrel", {{"trees"}, {"herbs"}}),
              animal("fox", {{"shrubs"}, {"herbivores"}}), animal("eagle", {{"animals"}})});
  const auto foods = [&](const char* eater, std::size_t need) {
    return names(web, web.diets[std::size_t(web.find(eater))][need].foods);
  };
  CHECK(foods("deer", 0) == Names{"grass", "berry", "oak"});
  CHECK(foods("goat", 0) == Names{"berry"});
  CHECK(foods("squirrel", 0) == Names{"oak"});
  CHECK(foods("squirrel", 1) == Names{"grass"});
  CHECK(foods("fox", 1) == Names{"deer", "goat", "squirrel"});
  CHECK(foods("eagle", 0) == Names{"deer", "goat", "squirrel", "fox"});
  CHECK(web.level[std::size_t(web.find("eagle"))] == 3);
}

TEST_CASE("carnivores are the animals that eat animals, omnivores included") {
  const FoodWeb web = web_of({plant("grass"), animal("deer", {{"herbs"}}), animal("bear", {{"herbs"}, {"deer"}}),
                              animal("wolf", {{"deer"}}), animal("tiger", {{"carnivores"}})});
  CHECK(names(web, web.diets[std::size_t(web.find("tiger"))][0].foods) == Names{"bear", "wolf"});
}

TEST_CASE("a species named itself keeps its own preference within a group") {
  Species wolf = animal("wolf", {});
  AnimalTraits traits;
  traits.diet = {{"prey", {{"herbivores", 1}, {"deer", 3}}, 2.5F}};
  wolf.traits = traits;
  const FoodWeb web = web_of({plant("grass"), animal("goat", {{"herbs"}}), animal("deer", {{"herbs"}}), wolf});
  const FoodWeb::ResolvedNeed& need = web.diets[3][0];
  CHECK(names(web, need.foods) == Names{"deer", "goat"});
  CHECK(need.preferences == std::vector<float>{3, 1});
  CHECK(need.amount == 2.5F);
}

TEST_CASE("a diet cycle is refused with its members") {
  CHECK(
      refusal_of({plant("grass"), animal("lion", {{"wolf"}}), animal("wolf", {{"fox"}}), animal("fox", {{"herbs"}, {"lion"}})}) ==
      R"(a diet cycle: "lion" eats "wolf", which eats "fox", which eats "lion"; remove one of these foods)");
  CHECK(refusal_of({plant("grass"), animal("hawk", {{"animals"}}), animal("owl", {{"animals"}})}) ==
        R"(a diet cycle: "hawk" eats "owl" (one of "animals"), which eats "hawk" (one of "animals"); remove one of these foods)");
}

TEST_CASE("a cycle is named without the animals that only lead to it") {
  CHECK(refusal_of({animal("king", {{"lion"}}), animal("lion", {{"wolf"}}), animal("wolf", {{"lion"}})}) ==
        R"(a diet cycle: "lion" eats "wolf", which eats "lion"; remove one of these foods)");
}

TEST_CASE("unknown foods, empty groups, cannibals and group names are refused") {
  CHECK(refusal_of({plant("grass"), animal("deer", {{"gras"}})}) ==
        R"(species "deer", need "need 1": "gras" is neither a species of this list nor a group; did you mean "grass"?)");
  CHECK(refusal_of({plant("grass"), animal("deer", {{"herbs"}, {"trees", "shrubs"}})}) ==
        R"(species "deer", need "need 2": no species of this list belongs to "trees", "shrubs"; add one, or another food)");
  CHECK(refusal_of({plant("grass"), animal("deer", {{"deer"}})}) ==
        R"(species "deer", need "need 1": it cannot eat its own species)");
  CHECK(refusal_of({plant("herbs")}) == R"(species "herbs": this is the name of a group; choose another)");
  CHECK(refusal_of({plant("grass"), plant("grass")}) == R"(two species are named "grass"; names must differ)");
  CHECK(refusal_of({plant("grass"), animal("deer", {})}) == R"(species "deer": an animal needs a diet of at least one need)");
}

TEST_CASE("a need is met when one of its groups has a member") {
  const FoodWeb web = web_of({plant("grass"), animal("deer", {{"herbs", "trees"}})});
  CHECK(names(web, web.diets[1][0].foods) == Names{"grass"});
}

TEST_CASE("desired shares are normalised over the level, by climate and else by default") {
  Species deer = animal("deer", {{"herbs"}});
  deer.proportions = {{"default", 3}, {"ice-age", 0}};
  Species goat = animal("goat", {{"herbs"}});
  goat.proportions = {{"default", 1}, {"ice-age", 20}};
  Species hare = animal("hare", {{"herbs"}});
  hare.proportions = {{"tropics", 5}};
  const FoodWeb web = web_of({plant("grass"), deer, goat, hare});
  CHECK(desired_proportions(web, 1, "mediterranean") == std::vector<double>{0.75, 0.25, 0});
  CHECK(desired_proportions(web, 1, "ice-age") == std::vector<double>{0, 1, 0});
  CHECK(desired_proportions(web, 0, "ice-age").empty());
}

TEST_CASE("who asks for no share is not driven out by those who ask") {
  Species deer = animal("deer", {{"herbs"}});
  const Species goat = animal("goat", {{"herbs"}});
  const Species hare = animal("hare", {{"herbs"}});
  const auto with_deer = [&](double share) {
    deer.proportions = {{"default", share}};
    return desired_proportions(web_of({plant("grass"), deer, goat, hare}), 1, "mediterranean");
  };
  CHECK(with_deer(0.5) == std::vector<double>{0.5, 0.25, 0.25});
  CHECK(with_deer(1) == std::vector<double>{1, 0, 0});
  CHECK(with_deer(6) == std::vector<double>{1.0 / 3, 1.0 / 3, 1.0 / 3});
  CHECK(with_deer(0).empty());
}

TEST_CASE("the built-in lists make webs of plants, herbivores and carnivores") {
  for (const char* file : {"tautavel.json", "authors-2021.json", "grand-canyon.json"}) {
    INFO(file);
    auto species = load_species(std::filesystem::path(BIOTOPE_SOURCE_DIR) / "assets/species" / file);
    REQUIRE(species);
    const FoodWeb web = web_of(std::move(*species));
    REQUIRE(web.level_count() == 3);
    for (const char* climate : {"mild-humid", "ice-age", "mediterranean", "hot-dry-canyon", "alpine"}) {
      CHECK(desired_proportions(web, 0, climate).empty());
      CHECK(desired_proportions(web, 1, climate).size() == web.levels[1].size());
      CHECK(desired_proportions(web, 2, climate).size() == web.levels[2].size());
    }
  }
}

TEST_CASE("the cave bear lives in the mild period and the brown bear in the ice age") {
  auto species = load_species(std::filesystem::path(BIOTOPE_SOURCE_DIR) / "assets/species/tautavel.json");
  REQUIRE(species);
  const FoodWeb web = web_of(std::move(*species));
  CHECK(names(web, web.levels[2]) ==
        Names{"ursus-arctos", "ursus-spelaeus", "lynx-spelaeus", "canis-mosbachensis", "vulpes-vulpes"});
  const auto mild = desired_proportions(web, 2, "mild-humid");
  const auto ice = desired_proportions(web, 2, "ice-age");
  CHECK(mild[0] == 0);
  CHECK(mild[1] == Approx(1.16 / (3 * 1.16 + 1.74)));
  CHECK(ice[0] == Approx(1.77 / (1.77 + 3 * 0.88)));
  CHECK(ice[1] == 0);
}

}  // namespace
}  // namespace biotope

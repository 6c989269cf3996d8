#include "core/species/desired_shares.hpp"

#include <catch2/catch.hpp>
#include <numeric>

namespace biotope {
namespace {

Species plant(const std::string& name) {
  Species species;
  species.name = species.common_name = species.scientific_name = name;
  species.traits = PlantTraits{};
  return species;
}

FoodWeb web_of(std::vector<Species> species) {
  auto web = build_food_web(std::move(species));
  REQUIRE(web);
  return *web;
}

}  // namespace

TEST_CASE("the first share that is asked for leaves the others what they have, in proportion") {
  const std::vector<Species> all{plant("oak"), plant("pine"), plant("grass")};
  const FoodWeb web = web_of(all);
  const std::vector<double> achieved{0.2, 0.2, 0.6};
  const FoodWeb changed = web_of(with_desired_share(all, web, 0, "mild", "oak", 0.5, achieved));
  const auto shares = desired_proportions(changed, 0, "mild");
  CHECK(shares[0] == Approx(0.5));
  CHECK(shares[1] == Approx(0.125));
  CHECK(shares[2] == Approx(0.375));
  CHECK(desired_proportions(web_of(with_desired_share(all, web, 0, "mild", "oak", 0.4, {})), 0, "mild")[2] == Approx(0.3));
}

TEST_CASE("a share of all leaves none, and comes back from there; shares of a climate stay its own") {
  std::vector<Species> all{plant("oak"), plant("pine"), plant("grass")};
  all[1].proportions = {{"ice", 1}, {"default", 3}};
  all[2].proportions = {{"default", 1}};
  const auto whole = with_desired_share(all, web_of(all), 0, "ice", "oak", 1, {});
  CHECK(desired_proportions(web_of(whole), 0, "ice") == std::vector<double>{1, 0, 0});
  CHECK(whole[1].proportions.at("default") == 3);
  const auto back = with_desired_share(whole, web_of(whole), 0, "ice", "oak", 0.5, {});
  CHECK(desired_proportions(web_of(back), 0, "ice") == std::vector<double>{0.5, 0.25, 0.25});
}

TEST_CASE("a level's only species has all of it") {
  const std::vector<Species> all{plant("oak")};
  CHECK(desired_proportions(web_of(with_desired_share(all, web_of(all), 0, "mild", "oak", 0.3, {})), 0, "mild") ==
        std::vector<double>{1});
}

}  // namespace biotope

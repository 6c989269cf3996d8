#include "core/ecosystem/animal_competition.hpp"

#include <catch2/catch.hpp>

#include "animal_scene.hpp"
#include "core/base/random.hpp"

using namespace biotope;
using namespace biotope::test;

namespace {

constexpr double year = 365;

/// Kilograms that the species of a level need in a year.
double needed(const FoodWeb& web, const AnimalLevel& level) {
  double sum = 0;
  for (std::size_t i = 0; i < level.species.size(); ++i) {
    for (const auto& need : web.diets[std::size_t(level.species[i])])
      sum += total(level.population[i]) * double(need.amount) * year;
  }
  return sum;
}

double eaten(const AnimalLevel& level) {
  double sum = 0;
  for (const auto& resource : level.eaten) sum += total(resource);
  return sum;
}

void check_never_more_than_offered(const AnimalLevel& level) {
  for (std::size_t r = 0; r < level.eaten.size(); ++r) {
    for (std::size_t p = 0; p < level.eaten[r].size(); ++p) {
      CHECK(level.eaten[r][p] >= 0);
      CHECK(level.eaten[r][p] <= level.available[r][p]);
    }
  }
}

/// With proportions nobody that was placed lacks more than a herd (and the herds by which others overshoot) of its share.
void check_nobody_lags(const FoodWeb& web, const AnimalLevel& level) {
  double individuals = 0;
  double shares = 0;
  double herds = 0;
  for (std::size_t i = 0; i < level.species.size(); ++i) {
    individuals += total(level.population[i]);
    herds += web.species[std::size_t(level.species[i])].animal().herd_min;
    if (total(level.population[i]) > 0) shares += level.desired[i];
  }
  for (std::size_t i = 0; i < level.species.size(); ++i) {
    const double own = total(level.population[i]);
    const double share = level.desired[i] / shares;
    const int herd = web.species[std::size_t(level.species[i])].animal().herd_min;
    if (own > 0) CHECK(share * individuals <= own + herd + share * herds);
  }
}

}  // namespace

TEST_CASE("a meadow feeds as many herds as its growth allows, and no more") {
  // 100 ha of grass at 0.1 kg / m2: 100,000 kg a year. An animal eats 365 kg, a herd of 10 3650 kg: 27 herds.
  WebBuilder builder;
  const int grass = builder.plant("grass", 0.1F);
  builder.animal("grazer", 1, walker(), {{"grass", {grass}}});
  Landscape land(10, 10);
  land.brook_row(5);
  const auto level = Scene(land, builder.web).solve(1);
  CHECK(total(level->population[0]) == 270);
  CHECK(total(level->eaten[0]) == Approx(270 * year));
  CHECK(level->herds.size() == 27);
  CHECK(level->achieved == std::vector{1.0});
  CHECK(level->warnings.empty());
}

TEST_CASE("without water there are no animals, and the warning says so; one that need not drink stays") {
  WebBuilder builder;
  const int grass = builder.plant("grass", 0.1F);
  builder.animal("grazer", 1, walker(), {{"grass", {grass}}});
  AnimalTraits dry = walker();
  dry.water_visits = 0;
  builder.animal("gazelle", 1, dry, {{"grass", {grass}}});
  const auto level = Scene(Landscape(10, 10), builder.web).solve(1);
  CHECK(total(level->population[0]) == 0);
  CHECK(total(level->population[1]) == 270);
  REQUIRE(level->warnings.size() == 1);
  CHECK(level->warnings[0] == "grazer: no region where it finds food has water to drink");
}

TEST_CASE("needs do not replace each other: the scarcest decides") {
  // Grass for 270 animals, leaves for 40.
  WebBuilder builder;
  const int grass = builder.plant("grass", 0.1F);
  const int leaves = builder.plant("leaves", 0.1F * 40 / 270, Stratum::shrub);
  builder.animal("browser", 1, walker(), {{"grass", {grass}}, {"leaves", {leaves}}});
  Landscape land(10, 10);
  land.brook_row(5);
  const auto level = Scene(land, builder.web).solve(1);
  CHECK(total(level->population[0]) == 40);
}

TEST_CASE("foods of one need replace each other and the preferred one is eaten more") {
  WebBuilder builder;
  const int grass = builder.plant("grass", 0.05F);
  const int herbs = builder.plant("herbs", 0.05F);
  builder.animal("grazer", 1, walker(), {{"fodder", {grass, herbs}, 2.5F, {3, 1}}});
  Landscape land(10, 10);
  land.brook_row(5);
  const auto level = Scene(land, builder.web).solve(1);
  // 100,000 kg together, 9,125 kg a herd: 10 herds, more than either food alone could feed.
  CHECK(total(level->population[0]) == 100);
  CHECK(total(level->eaten[std::size_t(grass)]) > total(level->eaten[std::size_t(herbs)]));
  CHECK(eaten(*level) == Approx(needed(builder.web, *level)));
}

TEST_CASE("species that eat the same share it: the smallest eater does not take everything") {
  WebBuilder builder;
  const int grass = builder.plant("grass", 0.2F);
  builder.animal("deer", 1, walker(5), {{"grass", {grass}, 2}});
  builder.animal("bison", 1, walker(10), {{"grass", {grass}, 8}});
  Landscape land(20, 20);
  land.brook_row(5);
  const auto level = Scene(land, builder.web).solve(1);
  const double deer = total(level->population[0]) * 2;
  const double bison = total(level->population[1]) * 8;
  CHECK(bison > 0.3 * (deer + bison));
  CHECK(deer > 0.3 * (deer + bison));
}

TEST_CASE("with plenty of food the proportions asked for are achieved") {
  WebBuilder builder;
  const int grass = builder.plant("grass", 0.1F);
  builder.animal("bison", 1, walker(10), {{"grass", {grass}, 8}});
  builder.animal("deer", 1, walker(5), {{"grass", {grass}, 2}});
  builder.animal("goat", 1, walker(2), {{"grass", {grass}, 1}});
  Landscape land(80, 80);
  land.brook_row(5);
  const auto level = Scene(land, builder.web).solve(1, {0.1, 0.6, 0.3});
  CHECK(level->desired == std::vector{0.1, 0.6, 0.3});
  for (std::size_t i = 0; i < 3; ++i) CHECK(level->achieved[i] == Approx(level->desired[i]).margin(0.01));
}

TEST_CASE("shares are normalised, and a species without a share is not placed") {
  WebBuilder builder;
  const int grass = builder.plant("grass", 0.1F);
  for (const char* name : {"a", "b", "c"}) builder.animal(name, 1, walker(), {{"grass", {grass}}});
  Landscape land(40, 40);
  land.brook_row(5);
  const auto level = Scene(land, builder.web).solve(1, {3, 1, 0});
  CHECK(level->desired == std::vector{0.75, 0.25, 0.0});
  CHECK(level->achieved[0] == Approx(0.75).margin(0.01));
  CHECK(level->achieved[2] == 0);
}

TEST_CASE("a species that finds no food drops out and the others go on") {
  WebBuilder builder;
  const int grass = builder.plant("grass", 0.1F);
  const int bamboo = builder.plant("bamboo", 0.1F, Stratum::shrub);
  builder.animal("panda", 1, walker(), {{"bamboo", {bamboo}}});
  builder.animal("grazer", 1, walker(), {{"grass", {grass}}});
  Landscape land(10, 10);
  land.brook_row(5);
  Scene scene(land, builder.web);
  scene.cover(1, 0);
  const auto level = scene.solve(1, {0.9, 0.1});
  CHECK(total(level->population[0]) == 0);
  CHECK(total(level->population[1]) == 270);
  CHECK(level->achieved == std::vector{0.0, 1.0});
  REQUIRE(level->warnings.size() == 1);
  CHECK(level->warnings[0] == "panda: a herd of 10 needs 3650 kg of bamboo a year, more than any of its regions offers");
}

TEST_CASE("herds settle in the fittest of their regions, so that regions fill alike") {
  // Two valleys, one twice as large.
  WebBuilder builder;
  const int grass = builder.plant("grass", 0.1F);
  builder.animal("grazer", 1, walker(), {{"grass", {grass}}});
  Landscape land(31, 20);
  land.cliff_column(10);
  land.brook_row(5);
  for (int y = 0; y < 20; ++y) land.hydrology.discharge(10, y) = 0;
  for (const auto& desired : {std::vector<double>{}, std::vector<double>{1}}) {
    const auto level = Scene(land, builder.web).solve(1, desired);
    REQUIRE(level->population[0].size() == 2);
    CHECK(level->population[0][0] == 540);
    CHECK(level->population[0][1] == 1090);
  }
}

TEST_CASE("what is eaten is what was needed, and never more than grows, on random landscapes") {
  for (std::uint64_t seed = 0; seed < 6; ++seed) {
    WebBuilder builder;
    std::vector<int> plants;
    for (int i = 0; i < 5; ++i)
      plants.push_back(builder.plant("p" + std::to_string(i), 0.05F + 0.02F * float(i), Stratum(i % 3)));
    for (int i = 0; i < 4; ++i) {
      AnimalTraits traits = walker(1 + 3 * i, 10 + 5 * i);
      traits.max_slope = 0.7F + 0.08F * float(i);
      builder.animal("a" + std::to_string(i), 1, traits,
                     {{"main", {plants[std::size_t(i)], plants[std::size_t(i + 1)]}, 1.5F, {2, 1}},
                      {"extra", {plants[0], plants[4]}, 0.5F}});
    }
    Landscape land(90, 70, 60);
    land.brook_row(20);
    land.brook_row(50);
    for (std::size_t i = 0; i < land.derivatives.slope.size(); ++i) {
      land.derivatives.slope[i] = float(random_unit({seed, 1, i / 3}));
      land.trees[i] = 0;
    }
    Scene scene(land, builder.web);
    for (std::size_t p = 0; p < plants.size(); ++p) {
      Grid<Cover> cover(90, 70);
      for (std::size_t i = 0; i < cover.size(); ++i) cover[i] = Cover(random_int(0, full_cover, {seed, 2, p, i / 17}));
      scene.cover(p, cover);
    }
    for (const auto& desired : {std::vector<double>{}, std::vector<double>{0.4, 0.3, 0.2, 0.1}}) {
      const auto level = scene.solve(1, desired);
      CHECK(eaten(*level) > 0);
      CHECK(eaten(*level) == Approx(needed(builder.web, *level)).epsilon(1e-6));
      check_never_more_than_offered(*level);
      CHECK(level->shortages.empty());
      if (!desired.empty()) check_nobody_lags(builder.web, *level);
      // Nothing that could be placed was left out: no species finds a whole herd's food in any region with water.
      for (std::size_t i = 0; i < 4; ++i) {
        for (const double population : level->population[i])
          CHECK(std::fmod(population, builder.web.species[5 + i].animal().herd_min) == 0);
      }
    }
  }
}

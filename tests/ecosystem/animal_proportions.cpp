#include <catch2/catch.hpp>

#include "animal_scene.hpp"

using namespace biotope;
using namespace biotope::test;

namespace {

AnimalTraits climber(int herd) {
  AnimalTraits traits = walker(herd);
  traits.max_slope = 1.5F;
  return traits;
}

/// A meadow of 10,000 kg of growth a cell, flat in the first columns and too steep for walkers in the others; a brook crosses it.
Landscape flat_then_steep(int width, int height, int flat_columns) {
  Landscape land(width, height);
  for (int x = flat_columns; x < width; ++x) land.cliff_column(x, 1);
  land.brook_row(height / 2);
  return land;
}

constexpr float growth = 1;
constexpr float kilograms_per_day = 10'000.0F / 365 / 10;  ///< a cell feeds ten animals

}  // namespace

TEST_CASE("a species that runs out of places holds the others at its share") {
  WebBuilder builder;
  const int grass = builder.plant("grass", growth);
  builder.animal("deer", 1, walker(10), {{"grass", {grass}, kilograms_per_day}});
  builder.animal("goat", 1, climber(2), {{"grass", {grass}, kilograms_per_day}});
  // Deer find food on 20 cells, goats on 400: without deer there would be room for 4,000 goats.
  const Scene scene(flat_then_steep(20, 20, 1), builder.web);
  const auto level = scene.solve(1, {0.8, 0.2});
  const double deer = total(level->population[0]);
  const double goats = total(level->population[1]);
  CHECK(deer >= 150);
  CHECK(deer <= 200);
  // Up to the total at which the deer would ask for a herd more.
  CHECK(goats <= 0.25 * (deer + 10) + 1);
  CHECK(goats >= 0.25 * deer - 2);
  REQUIRE(level->warnings.size() == 1);
  CHECK(level->warnings[0] == "deer: finds no place for more than " + std::to_string(int(deer)) +
                                  "; to keep to its share the others stay fewer than the land could feed");
}

TEST_CASE("a rare species in large herds leaves the others room until its share asks for a second herd") {
  WebBuilder builder;
  const int grass = builder.plant("grass", growth);
  builder.animal("bison", 1, walker(50), {{"grass", {grass}, kilograms_per_day}});
  builder.animal("goat", 1, climber(10), {{"grass", {grass}, kilograms_per_day}});
  // 10 cells of flat ground feed 100 animals, shared with goats: one herd of bison. All 500 cells feed 5,000.
  const Scene scene(flat_then_steep(50, 10, 1), builder.web);
  const auto level = scene.solve(1, {0.04, 0.96});
  CHECK(total(level->population[0]) == 50);
  CHECK(total(level->population[1]) == 2400);
}

TEST_CASE("a species without any place neither stops the others nor bends their shares") {
  WebBuilder builder;
  const int grass = builder.plant("grass", growth);
  const int bamboo = builder.plant("bamboo", growth, Stratum::shrub);
  builder.animal("panda", 1, walker(), {{"bamboo", {bamboo}, kilograms_per_day}});
  builder.animal("deer", 1, walker(5), {{"grass", {grass}, kilograms_per_day}});
  builder.animal("goat", 1, climber(2), {{"grass", {grass}, kilograms_per_day}});
  Scene scene(flat_then_steep(20, 20, 20), builder.web);
  scene.cover(1, 0);
  const auto level = scene.solve(1, {0.5, 0.3, 0.2});
  CHECK(level->achieved[0] == 0);
  CHECK(level->achieved[1] == Approx(0.6).margin(0.01));
  CHECK(level->achieved[2] == Approx(0.4).margin(0.01));
  CHECK(total(level->population[1]) + total(level->population[2]) > 3980);
}

TEST_CASE("when all live on the same ground none is held back") {
  WebBuilder builder;
  const int grass = builder.plant("grass", growth);
  builder.animal("deer", 1, walker(5), {{"grass", {grass}, kilograms_per_day}});
  builder.animal("goat", 1, walker(2), {{"grass", {grass}, kilograms_per_day}});
  const auto level = Scene(flat_then_steep(20, 20, 20), builder.web).solve(1, {0.9, 0.1});
  CHECK(total(level->population[0]) + total(level->population[1]) >= 3990);
  CHECK(level->warnings.empty());
}

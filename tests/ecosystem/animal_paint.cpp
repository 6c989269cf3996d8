#include "core/ecosystem/animal_paint.hpp"

#include <catch2/catch.hpp>

#include "animal_scene.hpp"
#include "core/ecosystem/surplus.hpp"

using namespace biotope;
using namespace biotope::test;

namespace {

/// 100 ha of grass that feed 270 grazers, beside a cliff and a strip nobody else uses.
Scene meadow() {
  WebBuilder builder;
  const int grass = builder.plant("grass", 0.1F);
  const int grazer = builder.animal("grazer", 1, walker(10, 20), {{"grass", {grass}}});
  builder.animal("wolf", 2, walker(1), {{"meat", {grazer}, 1}});
  Landscape land(12, 10);
  land.cliff_column(10);
  land.brook_row(5);
  for (int y = 0; y < 10; ++y) land.hydrology.discharge(10, y) = 0;
  for (int y = 0; y < 10; ++y) land.derivatives.slope(11, y) = 2;
  Scene scene(land, builder.web);
  Grid<Cover> cover(12, 10);
  for (std::size_t i = 0; i < cover.size(); ++i) cover[i] = i % 12 < 10 ? full_cover : 0;
  scene.cover(0, cover);
  return scene;
}

double grass_surplus(const Scene& scene, const std::shared_ptr<const AnimalLevel>& level) {
  const std::vector levels{level};
  return surplus_total(scene.web, 0, scene.plants[0].get(), scene.land.terrain.cell_area(), levels).surplus();
}

}  // namespace

TEST_CASE("a region's population is the integral of its painted density") {
  const Scene scene = meadow();
  // Half of the region at 100 per km2, the other as computed: 270 per km2.
  const auto level = scene.solve(1, {}, {paint_rect(12, 10, {0, 0, 5, 10}, 100)});
  CHECK(level->computed_population[0][0] == 270);
  CHECK(level->population[0][0] == Approx(0.5 * 100 + 0.5 * 270));
  const auto half_covered = scene.solve(1, {}, {paint_rect(12, 10, {0, 0, 5, 10}, 100, 0.5F)});
  CHECK(half_covered->population[0][0] == Approx(0.5 * 185 + 0.5 * 270));
}

TEST_CASE("the density map is uniform with the paint on it, and its integral is the population") {
  const Scene scene = meadow();
  const auto paint = paint_rect(12, 10, {2, 2, 7, 9}, 400, 0.8F);
  const auto level = scene.solve(1, {}, {paint});
  const Grid<float> density = animal_density(*level, 0, paint.get());
  CHECK(density(0, 0) == Approx(270));
  CHECK(density(3, 3) == Approx(0.2 * 270 + 0.8 * 400));
  CHECK(density(10, 3) == 0);
  double sum = 0;
  for (const float value : density.cells()) sum += double(value) * 0.01;
  CHECK(sum == Approx(total(level->population[0])));
}

TEST_CASE("painting fewer animals leaves more surplus of their food and less prey") {
  Scene scene = meadow();
  const auto plain = scene.solve(1);
  const auto fewer = scene.solve(1, {}, {paint_rect(12, 10, {0, 0, 10, 10}, 100)});
  CHECK(grass_surplus(scene, plain) == Approx(100000 - 270 * 365));
  CHECK(grass_surplus(scene, fewer) == Approx(100000 - 100 * 365));
  CHECK(fewer->warnings.empty());
  CHECK(fewer->shortages.empty());
  scene.levels = {plain};
  const double wolves = total(scene.solve(2)->population[0]);
  scene.levels = {fewer};
  CHECK(total(scene.solve(2)->population[0]) < wolves);
}

TEST_CASE("all animals painted away leave all food and no herds") {
  const Scene scene = meadow();
  const auto none = scene.solve(1, {}, {paint_rect(12, 10, {0, 0, 12, 10}, 0)});
  CHECK(total(none->population[0]) == 0);
  CHECK(none->herds.empty());
  CHECK(grass_surplus(scene, none) == Approx(100000));
  CHECK(none->warnings.empty());
}

TEST_CASE("paint beyond what grows stays, and the warning names species, place and resource") {
  const Scene scene = meadow();
  const auto level = scene.solve(1, {}, {paint_rect(12, 10, {6, 2, 9, 5}, 2270)});
  // 9 ha get 2000 animals per km2 more: 180 animals.
  CHECK(level->population[0][0] == Approx(270 + 180));
  CHECK(total(level->eaten[0]) == Approx(100000));
  REQUIRE(level->shortages.size() == 1);
  CHECK(level->shortages[0].species == 1);
  CHECK(level->shortages[0].region == 0);
  CHECK(level->shortages[0].resource == "grass");
  CHECK(level->shortages[0].missing == Approx(450 * 365 - 100000));
  REQUIRE(level->warnings.size() == 1);
  CHECK(level->warnings[0] == "grazer: 64 % more grass asked than grows in region 0 (near x 750 m, y 650 m)");
  double herds = 0;
  for (const Herd& herd : level->herds) herds += herd.size;
  CHECK(herds == 450);
}

TEST_CASE("paint where the species cannot live changes nothing but is named") {
  const Scene scene = meadow();
  const auto level = scene.solve(1, {}, {paint_rect(12, 10, {10, 4, 12, 6}, 500)});
  CHECK(level->population == level->computed_population);
  REQUIRE(level->warnings.size() == 1);
  CHECK(level->warnings[0] == "grazer: painted on 4 cells that it cannot reach (near x 1050 m, y 550 m)");
}

TEST_CASE("a painted species does not make the others compete again") {
  WebBuilder builder;
  const int grass = builder.plant("grass", 0.2F);
  builder.animal("deer", 1, walker(5), {{"grass", {grass}, 2}});
  builder.animal("bison", 1, walker(10), {{"grass", {grass}, 8}});
  Landscape land(10, 10);
  land.brook_row(5);
  const Scene scene(land, builder.web);
  const auto plain = scene.solve(1);
  const auto painted_level = scene.solve(1, {}, {paint_rect(10, 10, {0, 0, 10, 10}, 10), nullptr});
  CHECK(total(painted_level->population[0]) == Approx(10));
  CHECK(painted_level->population[1] == plain->population[1]);
  CHECK(painted_level->computed_population == plain->computed_population);
  CHECK(total(painted_level->eaten[0]) == Approx(365 * (10 * 2 + 8 * total(plain->population[1]))));
}

TEST_CASE("paint with coverage 0 is no paint") {
  const Scene scene = meadow();
  const auto plain = scene.solve(1);
  const auto level = scene.solve(1, {}, {paint_rect(12, 10, {0, 0, 12, 10}, 900, 0)});
  CHECK(level->population == plain->population);
  CHECK(level->eaten == plain->eaten);
  CHECK(level->warnings.empty());
}

TEST_CASE("animals painted where there is no water stay, eat only there, and the warning names the water") {
  // Three valleys parted by cliffs; only the first has a brook.
  WebBuilder builder;
  const int grass = builder.plant("grass", 0.1F);
  builder.animal("grazer", 1, walker(10), {{"grass", {grass}}});
  Landscape land(17, 5);
  land.cliff_column(5);
  land.cliff_column(11);
  for (int x = 0; x < 4; ++x) land.hydrology.discharge(x, 2) = 0.02F;
  const Scene scene(land, builder.web);
  const auto plain = scene.solve(1);
  CHECK(plain->population[0] == std::vector{60.0, 0.0, 0.0});
  const auto level = scene.solve(1, {}, {paint_rect(17, 5, {6, 0, 11, 5}, 100)});
  CHECK(level->computed_population == plain->computed_population);
  CHECK(level->population[0][0] == 60);
  CHECK(level->population[0][1] == Approx(25));
  CHECK(level->population[0][2] == 0);
  const auto& eaten = level->eaten[std::size_t(grass)];
  REQUIRE(eaten.size() == 3);
  CHECK(eaten[0] == Approx(60 * 365));
  CHECK(eaten[1] == Approx(25 * 365));
  CHECK(eaten[2] == 0);
  REQUIRE(level->warnings.size() == 1);
  CHECK(level->warnings[0] == "grazer: no water to drink in region 1 (near x 850 m, y 250 m)");
}

TEST_CASE("what each piece gives is kept apart when paint peoples a region that was empty") {
  // Deer reach both valleys, sheep only the second, whose grass alone cannot feed one of their herds.
  WebBuilder builder;
  const int grass = builder.plant("grass", 0.1F);
  AnimalTraits climber = walker(50);
  climber.max_slope = 3;
  builder.animal("deer", 1, climber, {{"grass", {grass}, 2}});
  builder.animal("sheep", 1, walker(300), {{"grass", {grass}, 3}});
  Landscape land(11, 5);
  land.cliff_column(5);
  land.brook_row(2);
  const Scene scene(land, builder.web);
  const auto plain = scene.solve(1);
  CHECK(total(plain->population[0]) > 0);
  CHECK(total(plain->population[1]) == 0);
  const auto level = scene.solve(1, {}, {nullptr, paint_rect(11, 5, {6, 0, 11, 5}, 8)});
  CHECK(level->population[0] == plain->population[0]);
  CHECK(level->population[1][1] == Approx(2));
  CHECK(level->shortages.empty());
  for (std::size_t piece = 0; piece < level->available[0].size(); ++piece) {
    const double more = level->eaten[0][piece] - plain->eaten[0][piece];
    const bool second_valley = level->partition->pieces[piece].region[1] == 1;
    CHECK(more == Approx(second_valley ? 2 * 3 * 365 : 0).margin(1e-6));
  }
}

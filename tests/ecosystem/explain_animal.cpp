#include <catch2/catch.hpp>

#include "animal_scene.hpp"
#include "core/ecosystem/explanation.hpp"

using namespace biotope;
using namespace biotope::test;

namespace {

Scene grazers(Landscape land) {
  WebBuilder builder;
  const int grass = builder.plant("grass", 0.1F);
  builder.animal("grazer", 1, walker(), {{"grass", {grass}}});
  builder.animal("giant", 1, walker(10), {{"grass", {grass}, 200}});
  return {std::move(land), builder.web};
}

bool mentions(const Explanation& explanation, const std::string& text) {
  for (const std::string& detail : explanation.details) {
    if (detail.find(text) != std::string::npos) return true;
  }
  return explanation.headline.find(text) != std::string::npos;
}

}  // namespace

TEST_CASE("a blocked cell is explained by what blocks it, with numbers") {
  Landscape land(10, 10);
  land.derivatives.slope(1, 1) = 1;
  land.hydrology.water_depth(2, 2) = 1.25F;
  land.trees(3, 3) = to_cover(0.8F);
  const Scene scene = grazers(land);
  const auto level = scene.solve(1);
  const Ground ground = scene.land.ground();
  const Explanation steep = explain_animal(scene.web, *level, 1, ground, 1, 1);
  CHECK(steep.headline == "Blocked: too steep");
  CHECK(mentions(steep, "1.00 m per m (45 degrees); it walks up to 0.50 (27 degrees)"));
  const Explanation deep = explain_animal(scene.web, *level, 1, ground, 2, 2);
  CHECK(deep.headline == "Blocked: water too deep");
  CHECK(mentions(deep, "1.25 m deep"));
  const Explanation wooded = explain_animal(scene.web, *level, 1, ground, 3, 3);
  CHECK(wooded.headline == "Blocked: trees too dense");
  CHECK(mentions(wooded, "80 %"));
  CHECK(wooded.fitness == -1);
}

TEST_CASE("a cell in too small a patch of ground is explained as cut off") {
  Landscape land(30, 10, 10);
  land.cliff_column(15);
  for (int x = 0; x < 4; ++x) {
    land.derivatives.slope(x, 3) = 1;
    land.derivatives.slope(3, x) = 1;
  }
  const Scene scene = grazers(land);
  CHECK(explain_animal(scene.web, *scene.solve(1), 1, scene.land.ground(), 1, 1).headline == "Absent: cut off");
}

TEST_CASE("a settled region tells its population, its scarce need and the rivals") {
  Landscape land(10, 10);
  land.brook_row(5);
  const Scene scene = grazers(land);
  const auto level = scene.solve(1, {1, 0});
  const Explanation present = explain_animal(scene.web, *level, 1, scene.land.ground(), 4, 4);
  CHECK(present.headline == "Present: 270 in region 0 (1.00 km2)");
  CHECK(mentions(present, "27 herds; 270 per km2"));
  // 100,000 kg grow, 98,550 are eaten, a herd needs 3,650.
  CHECK(mentions(
      present,
      "Of 100000 kg of grass that grow in reach each year 1450 are left; another herd of 10 needs 3650, 2200 kg are short"));
  const Explanation absent = explain_animal(scene.web, *level, 2, scene.land.ground(), 4, 4);
  CHECK(absent.headline == "Absent: too little grass in region 0 (1.00 km2)");
  CHECK(mentions(absent, "Shares its food with 270 grazer (100 % of what is needed)."));
}

TEST_CASE("missing water is named first") {
  const Scene scene = grazers(Landscape(10, 10));
  const Explanation dry = explain_animal(scene.web, *scene.solve(1), 1, scene.land.ground(), 4, 4);
  CHECK(dry.headline == "Absent: no water to drink in region 0 (1.00 km2)");
}

TEST_CASE("a painted obstacle is named") {
  const Scene scene = grazers(Landscape(10, 10));
  Ground ground = scene.land.ground();
  ground.passage = paint_rect(10, 10, {3, 3, 5, 5}, 1);
  CHECK(explain_animal(scene.web, *scene.solve(1), 1, ground, 4, 4).headline == "Blocked: a painted obstacle");
}

TEST_CASE("an empty place tells what cuts it off from where the species lives") {
  Landscape land(60, 20, 20);
  for (int x = 40; x < 43; ++x) land.river_column(x, 1.4F);
  land.cliff_column(43);
  // Nothing to drink in the west but the river's own bank is in the east: grass grows in the east only.
  Scene scene = grazers(land);
  Grid<Cover> grass(60, 20);
  for (int y = 0; y < 20; ++y) {
    for (int x = 44; x < 60; ++x) grass(x, y) = full_cover;
  }
  scene.cover(0, grass);
  scene.land.brook_row(5);
  const auto level = scene.solve(1, {1, 0});
  REQUIRE(level->population[0].size() == 2);
  CHECK(level->population[0][1] > 0);
  const Explanation west = explain_animal(scene.web, *level, 1, scene.land.ground(), 30, 10);
  CHECK(mentions(west, "by a river deeper than it wades (1.4 m), 200 m to the east."));
  CHECK(mentions(west, "Absent: too little grass"));
  CHECK_FALSE(mentions(explain_animal(scene.web, *level, 1, scene.land.ground(), 50, 10), "Cut off"));
}

TEST_CASE("a pocket tells what shuts it in, and where") {
  Landscape land(60, 20, 10);
  for (int i = 0; i < 5; ++i) {
    land.trees(i, 4) = full_cover;
    land.trees(4, i) = full_cover;
  }
  land.derivatives.slope(4, 2) = 1;
  const Scene scene = grazers(land);
  const Explanation pocket = explain_animal(scene.web, *scene.solve(1), 1, scene.land.ground(), 1, 1);
  CHECK(pocket.headline == "Absent: cut off");
  CHECK(mentions(pocket, "mostly by trees denser than it pushes through (100 %), 30 m to the"));
}

TEST_CASE("what external events take of its food and of its own growth is told") {
  Landscape land(10, 10);
  land.brook_row(5);
  const Scene scene = grazers(land);
  const std::vector<std::shared_ptr<const PaintLayer>> losses{paint_rect(10, 10, {0, 0, 10, 5}, 0.8F),
                                                              paint_rect(10, 10, {0, 0, 10, 10}, 0.1F)};
  auto level = compute_animal_level({scene.web, 1, scene.land.ground(), scene.plants, {}, {1, 0}, {}, losses, 1});
  REQUIRE(level);
  const Explanation told = explain_animal(scene.web, *level, 1, scene.land.ground(), 4, 4);
  CHECK(mentions(told, "Lost to an external event here: 40 % of the grass that would grow in a year."));
  CHECK(mentions(told, "Of its own yearly growth 10 % is lost to an external event."));
}

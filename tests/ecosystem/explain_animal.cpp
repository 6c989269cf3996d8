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
  CHECK(mentions(absent, "Shares its food with 270 grazer."));
}

TEST_CASE("missing water is named first") {
  const Scene scene = grazers(Landscape(10, 10));
  const Explanation dry = explain_animal(scene.web, *scene.solve(1), 1, scene.land.ground(), 4, 4);
  CHECK(dry.headline == "Absent: no water to drink in region 0 (1.00 km2)");
}

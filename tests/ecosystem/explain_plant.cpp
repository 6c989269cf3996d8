#include <catch2/catch.hpp>

#include "core/ecosystem/explanation.hpp"
#include "core/ecosystem/explanation_plant_text.hpp"
#include "tests/ecosystem/plant_scene.hpp"

using namespace biotope;
using Catch::Matchers::Contains;
using plant_scene::constant;
using plant_scene::easy_plant;
using plant_scene::Scene;
using plant_scene::Year;

namespace {

/// A single cell of constant years: index 5 of everything, but for illumination 9.
Scene one_cell() {
  Scene scene(1, 1);
  scene.fill(Resource::illumination, constant(9));
  return scene;
}

/// Explains plant `asked` of a flora in the first cell, as competition leaves it or with covers given by hand (0..240).
Explanation explain(const FoodWeb& web, const Scene& scene, int asked, std::vector<int> covers = {}) {
  const PlantEnvironment environment = scene.environment();
  auto competed = compete_without_proportions(web, environment);
  REQUIRE(competed.has_value());
  std::vector<std::shared_ptr<const CoverMap>> maps;
  for (std::size_t i = 0; i < competed->size(); ++i) {
    CoverMap map = (*competed)[i];
    if (!covers.empty()) map.set(0, 0, Cover(covers[i]));
    maps.push_back(std::make_shared<const CoverMap>(map));
  }
  return explain_plant(web, environment, asked, maps, 0, 0);
}

std::string all_details(const Explanation& explanation) {
  std::string text;
  for (const std::string& detail : explanation.details) text += detail + "\n";
  return text;
}

MonthSet set_of(std::initializer_list<int> list) {
  MonthSet set{};
  for (const int month : list) set[std::size_t(month)] = true;
  return set;
}

}  // namespace

TEST_CASE("Months are told as runs that go round the year's end") {
  CHECK(months_text({}).empty());
  CHECK(months_text(set_of({5})) == "in June");
  CHECK(months_text(set_of({4, 5, 6, 7, 8})) == "from May to September");
  CHECK(months_text(set_of({11, 0, 1})) == "from December to February");
  CHECK(months_text(set_of({2, 4, 5, 9})) == "in March, from May to June and in October");
  CHECK(months_text(set_of({0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11})) == "all year");
}

TEST_CASE("A summer too dry is told with its months, its index and what is missing") {
  Scene scene = one_cell();
  Year year = constant(3);
  for (std::size_t m = 4; m <= 8; ++m) year[m] = 1.4F;
  scene.fill(Resource::moisture, year);
  PlantTraits plant = easy_plant();
  plant.moisture = {2, 5};
  const Explanation partly = explain(plant_scene::web_of({{"pinus", plant}}), scene, 0);
  CHECK(partly.limiting == LimitingFactor::moisture);
  CHECK(partly.fitness == resource_fitness(plant.moisture, year));
  CHECK_THAT(partly.headline, Contains("Present") && Contains("too dry from May to September"));
  CHECK_THAT(all_details(partly), Contains("5 of 12 months too dry") && Contains("index 1.4 in May") &&
                                      Contains("needs 2.0 to 5.0") && Contains("0.6 missing"));

  plant.moisture = {4, 5};
  const Explanation absent = explain(plant_scene::web_of({{"pinus", plant}}), scene, 0);
  CHECK(absent.headline == "Absent: too dry all year");
  CHECK(absent.fitness == 0.0F);
}

TEST_CASE("A place may be too cold in winter and too warm in summer") {
  Scene scene = one_cell();
  Year year = constant(5);
  year[0] = 2;
  year[6] = 8;
  scene.fill(Resource::temperature, year);
  PlantTraits plant = easy_plant();
  plant.temperature = {4, 6};
  const Explanation e = explain(plant_scene::web_of({{"betula", plant}}), scene, 0);
  CHECK_THAT(e.headline, Contains("too cold in January and too warm in July"));
  CHECK_THAT(all_details(e), Contains("2.0 (-10 deg C) in January"));
}

TEST_CASE("Soil and ground are told as they are") {
  Scene scene = one_cell();
  PlantTraits plant = easy_plant();
  plant.geology = {1, 0, 1, 1, 1};
  scene.geology()(0, 0) = Geology::water;
  CHECK(explain(plant_scene::web_of({{"oak", plant}}), scene, 0).headline == "Absent: does not grow in water");
  scene.geology()(0, 0) = Geology::marl;
  plant.texture = {1, 4};
  CHECK(explain(plant_scene::web_of({{"oak", plant}}), scene, 0).headline == "Absent: soil too stony");
}

TEST_CASE("Who takes the ground is named, with covers and fitnesses") {
  PlantTraits oak = easy_plant(Stratum::tree);
  PlantTraits pine = easy_plant(Stratum::tree);
  pine.geology[0] = 0.04F;
  const FoodWeb web = plant_scene::web_of({{"Quercus", oak}, {"Pinus", pine}});
  const Explanation e = explain(web, one_cell(), 1);
  CHECK(e.headline == "Out-competed: Quercus takes the ground first (cover 100 %, fitness 1.00 against 0.04)");
}

TEST_CASE("Who takes the light is named, and the shade told") {
  PlantTraits oak = easy_plant(Stratum::tree);
  oak.light_consumption = 5;
  PlantTraits sage = easy_plant(Stratum::herb);
  sage.illumination = {7, 9};
  const Explanation e = explain(plant_scene::web_of({{"Quercus", oak}, {"Artemisia", sage}}), one_cell(), 1);
  CHECK(e.fitness == 1.0F);
  CHECK(e.headline == "Out-competed: Quercus takes the light first, too dark all year");
  CHECK_THAT(all_details(e), Contains("take 5.0 of its yearly mean illumination index 9.0, most of it Quercus (cover 100 %)"));
}

TEST_CASE("What stops a plant that grows is told") {
  PlantTraits pinus = easy_plant(Stratum::tree);
  CHECK_THAT(all_details(explain(plant_scene::web_of({{"Pinus", pinus}}), one_cell(), 0)), Contains("covers the whole place"));
  pinus.illumination = {7, 9};
  pinus.light_consumption = 5;
  const Explanation e = explain(plant_scene::web_of({{"Pinus", pinus}}), one_cell(), 0);
  CHECK(e.headline == "Present: cover 45 %, fitness 1.00");
  CHECK_THAT(all_details(e), Contains("with its own shade and thirst the place is too dark all year"));
}

TEST_CASE("Cover where a plant would not grow is told as paint, bare ground where it would as well") {
  PlantTraits plant = easy_plant();
  plant.temperature = {6, 9};
  const Explanation painted = explain(plant_scene::web_of({{"palm", plant}}), one_cell(), 0, {72});
  CHECK(painted.headline == "Painted: cover 30 % where it would not grow, too cold all year");
  const Explanation erased = explain(plant_scene::web_of({{"grass", easy_plant()}}), one_cell(), 0, {0});
  CHECK_THAT(erased.headline, Contains("though it could grow here"));
}

TEST_CASE("Every plant of the thesis's flora has an explanation everywhere") {
  const FoodWeb web = plant_scene::thesis_flora();
  Scene scene = one_cell();
  for (int light = 1; light <= 9; light += 2) {
    scene.fill(Resource::illumination, constant(float(light)));
    for (int plant = 0; plant < 18; ++plant) {
      const Explanation e = explain(web, scene, plant);
      CHECK_FALSE(e.headline.empty());
      CHECK_FALSE(e.details.empty());
    }
  }
}

#include <algorithm>
#include <array>
#include <catch2/catch.hpp>
#include <cmath>

#include "render/animal_pick.hpp"
#include "render/plant_placement.hpp"
#include "tests/render/sample_plants.hpp"
#include "tests/ui/small_landscape.hpp"
#include "ui/camera_flight.hpp"
#include "ui/camera_motion.hpp"
#include "ui/commands.hpp"
#include "ui/exploring.hpp"
#include "ui/gamepad.hpp"
#include "ui/herd_day.hpp"
#include "ui/herd_needs.hpp"
#include "ui/plant_pick.hpp"
#include "ui/quality.hpp"
#include "ui/relief_picture.hpp"
#include "ui/show_places.hpp"
#include "ui/weather_control.hpp"

using namespace biotope;

namespace {

/// The small landscape with two herds of deer: one grazes from 6 to 10 and drinks from 11 to 12, the other stays at the water.
std::shared_ptr<MapsSnapshot> with_herds() {
  auto maps = small_landscape();
  auto web = std::make_shared<FoodWeb>(*maps->web);
  AnimalTraits traits;
  traits.diet = {{"herbs", {{"grass", 1}}, 3}, {"leaves", {{"leaf", 1}}, 1}};
  traits.water_visits = 2;
  web->species[1].traits = traits;
  web->diets[1] = {{{0}, {1}, 3}, {{7}, {1}, 1}};
  maps->web = web;
  auto graph = std::make_shared<ResourceAccessGraph>();
  graph->levels.resize(2);
  ResourceNode meadow;
  meadow.kind = NodeKind::vegetation;
  meadow.quantities = {{0, 1000, 800}};
  meadow.x = 10;
  meadow.y = 10;
  ResourceNode bank;
  bank.kind = NodeKind::bank;
  bank.x = 30;
  bank.y = 30;
  graph->levels[1].nodes = {meadow, bank};
  maps->graph = graph;
  auto plans = std::make_shared<std::vector<DailyPlan>>(2);
  for (DailyPlan& plan : *plans) plan.species = 1;
  (*plans)[0].stops = {{0, 6, 10}, {1, 11, 12}};
  (*plans)[0].active = {{5, 21}};
  (*plans)[0].way = {{6, {10, 10}}, {10, {10, 10}}, {11, {30, 30}}, {12, {30, 30}}, {30, {10, 10}}};
  (*plans)[1].herd = 1;
  (*plans)[1].stops = {{1, 0, 24}};
  (*plans)[1].way = {{0, {30, 30}}, {24, {30, 30}}};
  maps->plans = plans;
  return maps;
}

}  // namespace

TEST_CASE("a herd's outlook says what it does until when, and which needs its day meets") {
  const auto maps = with_herds();
  const HerdOutlook morning = herd_outlook(*maps, (*maps->plans)[0], 7);
  CHECK(morning.doing == "feeding");
  CHECK(morning.until == Approx(10));
  CHECK(morning.awake == Approx(16));
  REQUIRE(morning.needs.size() == 3);
  CHECK(morning.needs[0].name == "Water");
  CHECK(morning.needs[0].met());
  CHECK(morning.needs[0].hours == Approx(1));
  CHECK_FALSE(morning.needs[0].now);
  CHECK(morning.needs[1].name == "Herbs");
  CHECK(morning.needs[1].met());
  CHECK(morning.needs[1].hours == Approx(4));
  CHECK(morning.needs[1].now);
  CHECK_FALSE(morning.needs[2].met());
  const HerdOutlook under_way = herd_outlook(*maps, (*maps->plans)[0], 10.5);
  CHECK(under_way.doing == "walking");
  CHECK(under_way.until == Approx(11));
  CHECK(herd_outlook(*maps, (*maps->plans)[0], 11.5).doing == "drinking");
}

TEST_CASE("a need that painted numbers outgrow is not met") {
  const auto maps = with_herds();
  auto level = std::make_shared<AnimalLevel>(*maps->animals[0]);
  level->herds = {{1, 0, 5}, {1, 0, 5}};
  level->shortages = {{1, 0, "grass", 400}};
  maps->animals[0] = level;
  const HerdOutlook outlook = herd_outlook(*maps, (*maps->plans)[0], 7);
  CHECK_FALSE(outlook.needs[1].met());
  CHECK(outlook.needs[1].short_supply);
  CHECK(outlook.needs[0].met());
}

TEST_CASE("a predator's stops are named by the herds it visits, and its need counts herds") {
  const auto maps = with_herds();
  auto graph = std::make_shared<ResourceAccessGraph>(*maps->graph);
  graph->levels.resize(3);
  ResourceNode prey;
  prey.kind = NodeKind::prey;
  prey.group = 1;
  ResourceNode bank;
  bank.kind = NodeKind::bank;
  graph->levels[2].nodes = {prey, bank};
  maps->graph = graph;
  auto web = std::make_shared<FoodWeb>(*maps->web);
  Species wolf;
  wolf.name = "wolf";
  wolf.common_name = "Wolf";
  AnimalTraits traits;
  traits.water_visits = 0;
  traits.diet = {{"prey", {{"deer", 1}}, 5}};
  wolf.traits = traits;
  web->species.push_back(wolf);
  web->diets.push_back({{{1}, {1}, 5}});
  maps->web = web;
  auto plans = std::make_shared<std::vector<DailyPlan>>(*maps->plans);
  DailyPlan pack;
  pack.level = 2;
  pack.species = 2;
  pack.active = {{4, 10}};
  pack.way = {{4, {1, 1}}, {28, {1, 1}}};
  pack.stops = {{0, 4.5F, 6}, {1, 6.5F, 7}, {0, 7.5F, 10}, {0, 10, 28}};
  pack.pursuits = {{4.5F, 6, 1}, {7.5F, 9.75F, 0}};
  plans->push_back(pack);
  maps->plans = plans;
  CHECK(herd_name(*maps, 0) == "Cervus 1");
  CHECK(herd_name(*maps, 1) == "Cervus 2");
  CHECK(herd_name(*maps, 9) == "nobody");
  CHECK(stop_name(*maps, pack, pack.stops[0]) == "Cervus 2");
  CHECK(stop_name(*maps, pack, pack.stops[1]) == "Water");
  CHECK(stop_name(*maps, pack, pack.stops[2]) == "Cervus 1");
  CHECK(stop_name(*maps, pack, pack.stops[3]) == "Resting place");
  CHECK(pursuit_text(*maps, pack, 5) == "Follows Cervus 2 until 06:00; 2 herds in its day");
  CHECK(pursuit_text(*maps, pack, 12) == "Follows no herd now; 2 herds in its day");
  CHECK(pursuit_text(*maps, (*plans)[0], 12).empty());
  const HerdOutlook outlook = herd_outlook(*maps, pack, 8);
  CHECK(outlook.doing == "hunting");
  CHECK(outlook.where == "Cervus 1");
  REQUIRE(outlook.needs.size() == 1);
  CHECK(outlook.needs[0].herds == 2);
  CHECK(outlook.needs[0].hours == Approx(3.75));
  CHECK(outlook.needs[0].now);
}

TEST_CASE("next and previous go through a species' herds and come around") {
  EditorState state;
  state.shown = with_herds();
  state.document = state.shown->document;
  CHECK(neighbouring_plan(state, 1) == 0);
  CHECK(neighbouring_plan(state, -1) == 1);
  state.view.visible_species = {true, false};
  CHECK(neighbouring_plan(state, 1) == -1);
}

TEST_CASE("while no herd is chosen, next and previous go through those of the chosen species") {
  EditorState state;
  auto maps = with_herds();
  auto plans = std::make_shared<std::vector<DailyPlan>>(*maps->plans);
  DailyPlan other = plans->front();
  other.species = plans->front().species + 1;
  plans->insert(plans->begin() + 1, other);
  maps->plans = plans;
  state.shown = maps;
  state.document = maps->document;
  state.selected_species = other.species;
  CHECK(neighbouring_plan(state, 1) == 1);
  CHECK(neighbouring_plan(state, -1) == 1);
  // A species without herds leaves the choice to all that are seen.
  state.selected_species = other.species + 1;
  CHECK(neighbouring_plan(state, 1) == 0);
}

TEST_CASE("a plan that is not there, or on a level that is not, is neither chosen nor placed") {
  EditorState state;
  const auto maps = with_herds();
  state.shown = maps;
  state.document = maps->document;
  CHECK_FALSE(choose_plan(state, -1));
  CHECK_FALSE(choose_plan(state, 2));
  CHECK_FALSE(choose_plan(state, 1000000));
  CHECK_FALSE(state.herd_day.herd);
  auto plans = std::make_shared<std::vector<DailyPlan>>(*maps->plans);
  plans->front().level = 9;
  maps->plans = plans;
  CHECK_FALSE(herd_place(*maps, 0, 12));
  CHECK_FALSE(herd_place(*maps, 2, 12));
}

TEST_CASE("the grass is shown where it grows") {
  const auto maps = small_landscape();
  CHECK_FALSE(good_place_of_plant(*maps, 1, {0, 0}));
  const auto place = good_place_of_plant(*maps, 0, {60, 60});
  REQUIRE(place);
  CHECK(place->x == 3);
  CHECK(place->y == 4);
}

TEST_CASE("a click on a trunk finds its tree, one beside it none") {
  const auto maps = test::level_landscape();
  test::cover(*maps, 0, 0.3F);
  const PlantPlacement placement(maps);
  const auto trees = placement.block(Stratum::tree, 2, 2);
  REQUIRE_FALSE(trees.empty());
  // At the stem of the tallest no other crown is higher.
  const PlantInstance& tree =
      *std::max_element(trees.begin(), trees.end(), [](const auto& a, const auto& b) { return a.scale < b.scale; });
  const glm::dvec3 foot(double(tree.x), double(tree.y), double(tree.z));
  // From right above there is nothing else in the way.
  const auto hit = pick_plant(placement, foot + glm::dvec3(0.05, 0, 60), {0, 0, -1}, 60);
  REQUIRE(hit);
  CHECK(glm::length(hit->foot - foot) < 0.01);
  CHECK(hit->species == maps->web->levels[0][std::size_t(tree.plant)]);
  CHECK_FALSE(pick_plant(placement, foot + glm::dvec3(0, 0, 60), {0, 0, 1}, 60));
  CHECK_FALSE(pick_plant(placement, foot + glm::dvec3(0.05, 0, 60), {0, 0, -1}, 20));
  std::vector<bool> hidden(maps->web->species.size(), true);
  hidden[std::size_t(hit->species)] = false;
  const auto other = pick_plant(placement, foot + glm::dvec3(0.05, 0, 60), {0, 0, -1}, 60, hidden);
  CHECK((!other || other->species != hit->species));
}

TEST_CASE("an eye among leaves sees nothing, one beside the crown sees past it, and from above a place is clear") {
  const auto maps = test::level_landscape();
  test::cover(*maps, 0, 0.3F);
  const PlantPlacement placement(maps);
  const auto trees = placement.block(Stratum::tree, 2, 2);
  REQUIRE_FALSE(trees.empty());
  const PlantInstance& tree = trees.front();
  const PlantShape& shape = maps->web->species[std::size_t(maps->web->levels[0][std::size_t(tree.plant)])].plant().shape;
  const double height = double(shape.height) * double(tree.scale);
  const glm::dvec3 foot(double(tree.x), double(tree.y), double(tree.z));
  const glm::dvec3 leaves = foot + glm::dvec3(0, 0, 0.5 * (1 + double(shape.trunk_fraction)) * height);
  const PlantsAround around(placement, foot, 80);
  const glm::dvec3 sky(0, 0, 500);
  CHECK_FALSE(around.free(leaves, leaves + sky));
  CHECK(around.free(leaves + glm::dvec3(0, 0, 60), leaves + sky));
  // Straight through the crown the ground is hidden.
  CHECK_FALSE(around.free(leaves + glm::dvec3(0, 0, 60), foot));
  std::vector<bool> hidden(maps->web->species.size(), false);
  CHECK(PlantsAround(placement, foot, 80, hidden).free(leaves, leaves + sky));
}

TEST_CASE("a view from a steeper slant looks at the same place from higher up") {
  const auto maps = test::level_landscape();
  const Terrain& terrain = maps->terrain();
  const float middle = float(terrain.height.width()) / 2;
  const glm::dvec3 place = place_of(terrain, {middle, middle}) + glm::dvec3(0, 0, 1);
  const Camera low = view_of_place(terrain, place, 30, {});
  const Camera high = view_of_place(terrain, place, 30, {}, {}, 60);
  CHECK(low.pitch == Approx(-18).margin(0.5));
  CHECK(high.pitch == Approx(-60).margin(0.5));
  CHECK(glm::length(low.position - place) == Approx(30));
  CHECK(glm::length(high.position - place) == Approx(30));
}

TEST_CASE("a level is chosen that keeps its pace, and never less than low") {
  const auto level = [](double seconds, bool software = false) {
    const std::array<double, 3> measured{seconds * 3, seconds, seconds * 1.2};
    return measured_level(measured, software);
  };
  CHECK(level(0.5) == QualityLevel::low);
  CHECK(level(0.015) == QualityLevel::low);
  CHECK(level(0.007) == QualityLevel::medium);
  CHECK(level(0.003) == QualityLevel::high);
  CHECK(level(0.001) == QualityLevel::ultra);
  CHECK(level(0.08, true) == QualityLevel::low);
  CHECK(level(0.015, true) == QualityLevel::medium);
  CHECK(measured_level({}, false) == QualityLevel::low);
}

TEST_CASE("every named weather is found again by its values, whatever snow and wind direction") {
  for (const NamedWeather& named : named_weathers()) {
    auto weather = weather_named(named.name);
    REQUIRE(weather);
    weather->snow_cover = false;
    weather->wind_direction = 10;
    CHECK(name_of_weather(*weather) == &named);
    weather->fog += 0.05F;
    CHECK(name_of_weather(*weather) == nullptr);
  }
}

TEST_CASE("a stick that rests moves nothing, and a stick at its end moves whole") {
  CHECK(stick_value(0.1F) == 0);
  CHECK(stick_value(-0.12F) == 0);
  CHECK(stick_value(1) == Approx(1));
  CHECK(stick_value(-1) == Approx(-1));
  CHECK(stick_value(0.5F) > 0);
  CHECK(stick_value(0.5F) < 0.5);
}

TEST_CASE("the little map has the land's shape and shows its water") {
  const auto maps = small_landscape();
  auto water = std::make_shared<Hydrology>();
  water->water_depth = Grid<float>(70, 66);
  for (int y = 0; y < 66; ++y) water->water_depth(35, y) = 2;
  maps->hydrology = water;
  const ReliefPicture picture = make_relief_picture(*maps, 70);
  CHECK(picture.width == 70);
  CHECK(picture.height == 66);
  const auto blue_over_red = [&](int x) {
    return int(picture.rgba[(std::size_t(30) * 70 + x) * 4 + 2]) - int(picture.rgba[(std::size_t(30) * 70 + x) * 4]);
  };
  CHECK(blue_over_red(35) > 40);
  CHECK(blue_over_red(10) < 20);
}

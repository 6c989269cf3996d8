#include <tbb/global_control.h>

#include <algorithm>
#include <catch2/catch.hpp>

#include "core/base/random.hpp"
#include "tests/movement/movement_scene.hpp"

using namespace biotope;
using biotope::test::MovementScene;

namespace {

AnimalTraits traits_of(float speed, Activity activity) {
  AnimalTraits traits;
  traits.mass_min = 80;
  traits.mass_max = 120;
  traits.speed = speed;
  traits.max_slope = 0.8F;
  traits.activity = activity;
  traits.water_visits = 1;
  return traits;
}

/// Two pastures with a wall between them: five resources (0 to 4) in the western one, of 1.2 km, and two (5 and 6) in the eastern
/// one; four herds of deer in the west, two in the east, and wolves on both sides.
MovementScene pastures() {
  MovementScene scene(200, 100, 10);
  for (int y = 0; y < 100; ++y) scene.blocked(120, y) = 1;
  const int deer = scene.animal("deer", 1, traits_of(1.2F, Activity::diurnal), {0});
  const int wolf = scene.animal("wolf", 2, traits_of(1.6F, Activity::crepuscular), {deer});
  std::vector<ResourceNode> nodes{MovementScene::node(NodeKind::bank, 60, 50, 3000, 0)};
  for (const auto& [x, y] : {std::array{10, 10}, std::array{110, 10}, std::array{10, 90}, std::array{110, 90},
                             std::array{140, 20}, std::array{180, 80}}) {
    nodes.push_back(MovementScene::node(NodeKind::vegetation, x, y, 60000, 3000));
  }
  nodes.push_back(MovementScene::node(NodeKind::bank, 160, 50, 3000, 0));
  AnimalLevel grazers = scene.level(1, nodes);
  for (int i = 0; i < 6; ++i) grazers.herds.push_back({deer, i % 3 == 2, 10 + i});
  scene.add(std::move(grazers));
  std::vector<ResourceNode> prey{nodes[0], MovementScene::node(NodeKind::prey, 60, 60, 1e6, 5000, deer)};
  AnimalLevel hunters = scene.level(2, prey, 8);
  hunters.herds = {{wolf, 0, 4}, {wolf, 0, 5}};
  scene.add(std::move(hunters));
  return scene;
}

PathPoint at_node(const MovementScene& scene, int node, std::size_t level = 0) {
  const ResourceNode& place = scene.levels[level]->graph->nodes[std::size_t(node)];
  return {float(place.x), float(place.y)};
}

std::vector<DailyPlan> plans_with(const MovementScene& scene, const std::vector<PlanEdit>& edits) {
  auto result = compute_daily_plans(scene.web, scene.levels, scene.movement, scene.ground, 1, {}, nullptr, edits);
  REQUIRE(result);
  return std::move(*result);
}

bool same(const DailyPlan& a, const DailyPlan& b) {
  const auto same_point = [](const auto& p, const auto& q) { return p.hour == q.hour && p.at == q.at; };
  const auto same_stop = [](const auto& p, const auto& q) {
    return p.node == q.node && p.arrive == q.arrive && p.leave == q.leave;
  };
  return a.herd == b.herd && a.species == b.species && a.pursuits == b.pursuits &&
         std::equal(a.way.begin(), a.way.end(), b.way.begin(), b.way.end(), same_point) &&
         std::equal(a.stops.begin(), a.stops.end(), b.stops.begin(), b.stops.end(), same_stop);
}

/// What must hold of every plan: ascending hours, closed after a day, on open ground, no faster than the animal walks (or trots
/// after its herd).
void check_is_a_day(const MovementScene& scene, const DailyPlan& plan) {
  const auto& animal = scene.web.species[std::size_t(plan.species)].animal();
  const double fastest =
      double(animal.speed) * std::exp(0.05 * double(animal.slope_sensitivity)) * (plan.pursuits.empty() ? 1.0 : 1.5);
  REQUIRE(plan.way.size() >= 2);
  CHECK(plan.way.back().hour == Approx(plan.way.front().hour + 24));
  CHECK(plan.way.back().at == plan.way.front().at);
  for (std::size_t i = 0; i < plan.way.size(); ++i) {
    const auto& b = plan.way[i];
    REQUIRE(scene.blocked(int(std::lround(b.at.x)), int(std::lround(b.at.y))) == 0);
    if (i == 0) continue;
    const auto& a = plan.way[i - 1];
    REQUIRE(a.hour <= b.hour);
    REQUIRE(std::hypot(double(b.at.x - a.at.x), double(b.at.y - a.at.y)) * 10 <=
            fastest * (double(b.hour) - double(a.hour) + 1e-5) * 3600);
  }
  for (std::size_t i = 0; i < plan.stops.size(); ++i) {
    CHECK(plan.stops[i].arrive <= plan.stops[i].leave);
    if (i > 0) CHECK(plan.stops[i - 1].leave <= plan.stops[i].arrive);
  }
}

}  // namespace

TEST_CASE("an edited herd visits the edit's stops in order, at their hours") {
  const MovementScene scene = pastures();
  // Deer number 1 in the west is herd 1; from the bank (60, 50) a meadow is 640 m away: nine minutes.
  const PlanEdit edit{
      "deer",
      {30, 30},
      1,
      {{at_node(scene, 1), 5, 8}, {at_node(scene, 0), 9, 9.5F}, {at_node(scene, 4), 11, 15}, {at_node(scene, 2), 16, 18}}};
  const auto plans = plans_with(scene, {edit});
  REQUIRE(plans.size() == 8);
  const DailyPlan& plan = plans[1];
  CHECK(plan.edited);
  CHECK(plan.unreachable_stops.empty());
  CHECK(plan.shifted_stops.empty());
  REQUIRE(plan.stops.size() == 4);
  const int nodes[] = {1, 0, 4, 2};
  for (std::size_t i = 0; i < 4; ++i) {
    CHECK(plan.stops[i].node == nodes[i]);
    CHECK(plan.stops[i].arrive == Approx(edit.stops[i].arrive));
    CHECK(double(plan.stops[i].leave) >= double(edit.stops[i].leave) - 1e-4);
    for (const float hour : {edit.stops[i].arrive + 0.01F, edit.stops[i].leave - 0.01F}) {
      const HerdState state = herd_state(plan, *scene.levels[0]->graph, double(hour), 10);
      CHECK(std::hypot(double(state.at.x - edit.stops[i].at.x), double(state.at.y - edit.stops[i].at.y)) * 10 <= 121);
    }
  }
  check_is_a_day(scene, plan);
}

TEST_CASE("an edit changes its herd and who follows it, and no other grazer") {
  const MovementScene scene = pastures();
  const auto before = plans_with(scene, {});
  const PlanEdit edit{"deer", {30, 30}, 2, {{at_node(scene, 1), 6, 12}, {at_node(scene, 0), 13, 14}}};
  const auto after = plans_with(scene, {edit});
  // The third deer herd of the west is herd 3 of the level.
  REQUIRE(before.size() == after.size());
  for (std::size_t i = 0; i < 6; ++i) CHECK(same(before[i], after[i]) == (i != 3));
  for (std::size_t i = 6; i < 8; ++i) {
    REQUIRE(!after[i].pursuits.empty());
    for (double hour = 5; hour < 9; hour += 0.25) {
      const HerdPursuit* pursuit = pursuit_at(after[i], hour);
      if (pursuit == nullptr) continue;
      const DailyPlan& herd = after[std::size_t(pursuit->plan)];
      const PathPoint a = herd_state(after[i], *scene.levels[1]->graph, hour, 10).at;
      const PathPoint b = herd_state(herd, *scene.levels[0]->graph, hour, 10).at;
      CHECK(std::hypot(a.x - b.x, a.y - b.y) * 10 < 500);
    }
  }
}

TEST_CASE("a herd that cannot be in time comes late, and what follows is later until there is time") {
  const MovementScene scene = pastures();
  // 1.28 km from corner to corner takes 18 minutes; the edit gives it one.
  const PlanEdit edit{
      "deer",
      {30, 30},
      0,
      {{at_node(scene, 1), 5, 8}, {at_node(scene, 4), 8.016F, 9}, {at_node(scene, 0), 9.02F, 9.5F}, {at_node(scene, 2), 12, 13}}};
  const DailyPlan plan = plans_with(scene, {edit})[0];
  REQUIRE(plan.stops.size() == 4);
  const double walk = std::hypot(100, 80) * 10 / 1.2 / 3600;
  CHECK(plan.stops[0].leave == Approx(8));
  CHECK(plan.stops[1].arrive == Approx(8 + walk).epsilon(0.005));
  // It stays as long as was asked.
  CHECK(double(plan.stops[1].leave - plan.stops[1].arrive) == Approx(9 - 8.016).epsilon(0.001));
  CHECK(plan.stops[2].arrive > 9.1F);
  CHECK(plan.stops[3].arrive == Approx(12));
  CHECK(plan.shifted_stops == std::vector<int>{1, 2});
  check_is_a_day(scene, plan);
}

TEST_CASE("stops out of reach are left out and told") {
  const MovementScene scene = pastures();
  const PlanEdit edit{
      "deer",
      {30, 30},
      0,
      {{at_node(scene, 5), 5, 6}, {at_node(scene, 1), 7, 9}, {at_node(scene, 6), 10, 11}, {at_node(scene, 0), 12, 13}}};
  const DailyPlan plan = plans_with(scene, {edit})[0];
  CHECK(plan.edited);
  CHECK(plan.unreachable_stops == std::vector<int>{0, 2});
  REQUIRE(plan.stops.size() == 2);
  CHECK(plan.stops[0].node == 1);
  CHECK(plan.stops[0].arrive == Approx(7));
  CHECK(plan.stops[1].node == 0);
  check_is_a_day(scene, plan);
  // None is left: the herd stands still.
  const DailyPlan still = plans_with(scene, {{"deer", {30, 30}, 0, {{at_node(scene, 5), 5, 6}}}})[0];
  CHECK(still.stops.empty());
  CHECK(still.unreachable_stops == std::vector<int>{0});
  check_is_a_day(scene, still);
}

TEST_CASE("more walking than a day holds leaves out the last stops") {
  MovementScene scene = pastures();
  std::get<AnimalTraits>(scene.web.species[1].traits).speed = 0.05F;
  const PlanEdit edit{"deer", {30, 30}, 0, {{at_node(scene, 1), 5, 6}, {at_node(scene, 3), 8, 9}, {at_node(scene, 0), 12, 13}}};
  // 0.8 km to the other meadow and 0.64 km to the bank and back each: at 5 cm/s 11.6 h, at 2.2 cm/s 26 h, or 20 h without the
  // bank.
  const DailyPlan plan = plans_with(scene, {edit})[0];
  CHECK(plan.stops.size() == 3);
  check_is_a_day(scene, plan);
  std::get<AnimalTraits>(scene.web.species[1].traits).speed = 0.022F;
  const DailyPlan shorter = plans_with(scene, {edit})[0];
  CHECK(shorter.stops.size() == 2);
  CHECK(shorter.unreachable_stops == std::vector<int>{2});
  check_is_a_day(scene, shorter);
}

TEST_CASE("a plan turned into an edit asks for the same day") {
  const MovementScene scene = pastures();
  const auto plans = plans_with(scene, {});
  for (std::size_t i = 0; i < 6; ++i) {
    const auto edit = edit_of_plan(plans[i], scene.web, scene.levels);
    REQUIRE(edit);
    CHECK(edit->species == "deer");
    CHECK(edit->number == int(i / 3 * 2 + i % 3) - (i % 3 == 2 ? int(i / 3) + 2 : 0));
    CHECK(find_planned_herd(*edit, scene.web, scene.levels) == NamedHerd{0, int(i)});
    const auto again = plans_with(scene, {*edit});
    REQUIRE(again[i].edited);
    CHECK(again[i].unreachable_stops.empty());
    CHECK(again[i].shifted_stops.empty());
    REQUIRE(again[i].stops.size() == plans[i].stops.size());
    for (std::size_t k = 0; k < plans[i].stops.size(); ++k) {
      CHECK(again[i].stops[k].node == plans[i].stops[k].node);
      CHECK(again[i].stops[k].arrive == Approx(plans[i].stops[k].arrive).margin(1e-4));
      CHECK(again[i].stops[k].leave == Approx(plans[i].stops[k].leave).margin(1e-3));
    }
    const auto twice = edit_of_plan(again[i], scene.web, scene.levels);
    REQUIRE(twice);
    CHECK(twice->number == edit->number);
    REQUIRE(twice->stops.size() == edit->stops.size());
    for (std::size_t k = 0; k < edit->stops.size(); ++k) {
      CHECK(twice->stops[k].at == edit->stops[k].at);
      CHECK(twice->stops[k].arrive == Approx(edit->stops[k].arrive).margin(1e-4));
    }
  }
}

TEST_CASE("an edit names nobody when its herd is gone, and several edits of one herd end with the last") {
  const MovementScene scene = pastures();
  CHECK_FALSE(find_planned_herd({"deer", {30, 30}, 4, {}}, scene.web, scene.levels));
  CHECK_FALSE(find_planned_herd({"elk", {30, 30}, 0, {}}, scene.web, scene.levels));
  CHECK(find_planned_herd({"deer", {150, 30}, 1, {}}, scene.web, scene.levels) == NamedHerd{0, 5});
  // A home cell on which a rock has come to lie.
  CHECK(find_planned_herd({"deer", {120, 30}, 1, {}}, scene.web, scene.levels).has_value());
  CHECK(find_planned_herd({"wolf", {30, 30}, 1, {}}, scene.web, scene.levels) == NamedHerd{1, 1});
  const PlanEdit one{"deer", {30, 30}, 0, {{at_node(scene, 1), 5, 6}}};
  const PlanEdit other{"deer", {40, 30}, 0, {{at_node(scene, 2), 7, 8}}};
  const auto plans = plans_with(scene, {one, other});
  REQUIRE(plans[0].stops.size() == 1);
  CHECK(plans[0].stops[0].node == 2);
}

TEST_CASE("an edited predator follows nobody") {
  const MovementScene scene = pastures();
  const PlanEdit edit{"wolf", {30, 30}, 0, {{at_node(scene, 1, 1), 16, 20}, {at_node(scene, 0, 1), 21, 21.5F}}};
  const auto plans = plans_with(scene, {edit});
  CHECK(plans[6].edited);
  CHECK(plans[6].pursuits.empty());
  REQUIRE(plans[6].stops.size() == 2);
  CHECK(plans[6].stops[1].arrive == Approx(21));
  CHECK(!plans[7].pursuits.empty());
  check_is_a_day(scene, plans[6]);
}

TEST_CASE("a day may pass midnight") {
  const MovementScene scene = pastures();
  const PlanEdit edit{"deer", {30, 30}, 0, {{at_node(scene, 1), 22, 25}, {at_node(scene, 0), 2, 3}, {at_node(scene, 4), 12, 14}}};
  const DailyPlan plan = plans_with(scene, {edit})[0];
  REQUIRE(plan.stops.size() == 3);
  CHECK(plan.stops[0].arrive == Approx(22));
  CHECK(plan.stops[1].arrive == Approx(26));
  CHECK(plan.stops[2].arrive == Approx(36));
  CHECK(plan.shifted_stops.empty());
  check_is_a_day(scene, plan);
}

TEST_CASE("a herd that has no plan gets one by an edit") {
  MovementScene scene(60, 60, 10);
  const int deer = scene.animal("deer", 1, traits_of(1.2F, Activity::diurnal), {0});
  AnimalLevel level = scene.level(
      1, {MovementScene::node(NodeKind::bank, 10, 10, 3000, 0), MovementScene::node(NodeKind::vegetation, 50, 50, 60000, 3000)});
  for (std::size_t i = 0; i < most_plans + 40; ++i) level.herds.push_back({deer, 0, 1});
  scene.add(std::move(level));
  const auto planned = planned_herds(scene.levels, 1);
  int left_out = 0;
  while (std::binary_search(planned[0].begin(), planned[0].end(), left_out)) ++left_out;
  const auto plans = plans_with(scene, {{"deer", {5, 5}, left_out, {{{10, 10}, 6, 7}, {{50, 50}, 9, 12}}}});
  CHECK(plans.size() == most_plans + 1);
  const auto found = std::find_if(plans.begin(), plans.end(), [&](const DailyPlan& plan) { return plan.herd == left_out; });
  REQUIRE(found != plans.end());
  CHECK(found->edited);
  CHECK(found->stops.size() == 2);
}

TEST_CASE("whatever is asked, the day is one that can be walked, the same for any number of threads") {
  const MovementScene scene = pastures();
  for (std::uint64_t round = 0; round < 40; ++round) {
    std::vector<PlanEdit> edits;
    for (std::uint64_t e = 0; e < 2; ++e) {
      PlanEdit edit{"deer", {30, 30}, random_int(0, 3, {round, e, 1}), {}};
      const int stops = random_int(0, 7, {round, e, 2});
      for (std::uint64_t s = 0; s < std::uint64_t(stops); ++s) {
        const auto arrive = float(24 * random_unit({round, e, s, 3}));
        edit.stops.push_back({{float(random_int(0, 199, {round, e, s, 4})), float(random_int(0, 99, {round, e, s, 5}))},
                              arrive,
                              arrive + float(6 * random_unit({round, e, s, 6}))});
      }
      edits.push_back(std::move(edit));
    }
    const auto plans = plans_with(scene, edits);
    for (const DailyPlan& plan : plans) {
      check_is_a_day(scene, plan);
      CHECK((!plan.edited || plan.pursuits.empty()));
    }
    const tbb::global_control control(tbb::global_control::max_allowed_parallelism, 1);
    const auto alone = plans_with(scene, edits);
    REQUIRE(alone.size() == plans.size());
    for (std::size_t i = 0; i < plans.size(); ++i) CHECK(same(plans[i], alone[i]));
  }
}

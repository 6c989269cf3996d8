#include <algorithm>
#include <catch2/catch.hpp>
#include <set>

#include "tests/movement/movement_scene.hpp"

using namespace biotope;
using biotope::test::MovementScene;

namespace {

AnimalTraits walker(Activity activity, float speed, int herd_max) {
  AnimalTraits traits;
  traits.mass_min = 30;
  traits.mass_max = 60;
  traits.speed = speed;
  traits.max_slope = 0.8F;
  traits.activity = activity;
  traits.water_visits = 1;
  traits.herd_max = herd_max;
  return traits;
}

struct Country {
  MovementScene scene{200, 100, 20};
  int deer = 0;
  int goat = 0;
  int wolf = 0;

  /// 4 km of plain, a wall with no gate across its middle; herds of deer on both sides, goats in the west, and one predator a
  /// side. A prey node's kilograms are what there is of it: `deer_share` of the west's.
  explicit Country(int deer_herds, int goat_herds = 0, double deer_share = 0.5, Activity activity = Activity::cathemeral,
                   int pack_size = 6) {
    for (int y = 0; y < 100; ++y) scene.blocked(100, y) = 1;
    deer = scene.animal("deer", 1, walker(Activity::diurnal, 1.2F, 20), {0});
    goat = scene.animal("goat", 1, walker(Activity::diurnal, 1.2F, 20), {0});
    wolf = scene.animal("wolf", 2, walker(activity, 2.2F, pack_size), {deer, goat});
    std::vector<ResourceNode> banks;
    for (const int x : {20, 50, 85, 115, 150, 180}) banks.push_back(MovementScene::node(NodeKind::bank, x, 50, 4000, 0));
    std::vector<ResourceNode> nodes = banks;
    for (int i = 0; i < 24; ++i)
      nodes.push_back(
          MovementScene::node(NodeKind::vegetation, (i < 12 ? 5 : 108) + 7 * (i % 12), 8 + (i * 37) % 84, 60000, 2000));
    AnimalLevel grazers = scene.level(1, nodes);
    for (int i = 0; i < deer_herds; ++i) {
      grazers.herds.push_back({deer, 0, 10});
      grazers.herds.push_back({deer, 1, 10});
    }
    for (int i = 0; i < goat_herds; ++i) grazers.herds.push_back({goat, 0, 10});
    scene.add(std::move(grazers));
    nodes = banks;
    const auto prey = [&](int x, int group, double kilograms, int region) {
      nodes.push_back(MovementScene::node(NodeKind::prey, x, 30, 1e6, kilograms, group));
      nodes.back().prey_region = region;
    };
    prey(50, deer, 10000 * deer_share, 0);
    prey(150, deer, 5000, 1);
    if (goat_herds > 0) prey(60, goat, 10000 * (1 - deer_share), 0);
    AnimalLevel hunters = scene.level(2, nodes, 8);
    hunters.herds = {{wolf, 0, pack_size}, {wolf, 1, pack_size}};
    scene.add(std::move(hunters));
  }
};

const GraphLevel& graph_of(const Country& country, const DailyPlan& plan) {
  return *country.scene.levels[std::size_t(plan.level - 1)]->graph;
}

std::vector<DailyPlan> packs(const std::vector<DailyPlan>& plans) {
  std::vector<DailyPlan> found;
  std::copy_if(plans.begin(), plans.end(), std::back_inserter(found), [](const DailyPlan& plan) { return plan.level == 2; });
  return found;
}

std::set<int> herds_of(const DailyPlan& plan) {
  std::set<int> herds;
  for (const HerdPursuit& pursuit : plan.pursuits) herds.insert(pursuit.plan);
  return herds;
}

bool active(const DailyPlan& plan, double hour) {
  return std::any_of(plan.active.begin(), plan.active.end(), [&](const DailyPlan::Span& span) {
    const double since = hour - double(span.from);
    return since - 24 * std::floor(since / 24) <= double(span.until - span.from);
  });
}

double kilometres(const DailyPlan& plan) {
  double cells = 0;
  for (std::size_t i = 1; i < plan.way.size(); ++i)
    cells += std::hypot(double(plan.way[i].at.x - plan.way[i - 1].at.x), double(plan.way[i].at.y - plan.way[i - 1].at.y));
  return cells * 0.02;
}

double hours_with(const DailyPlan& plan, const std::vector<DailyPlan>& plans, int species) {
  double hours = 0;
  for (const HerdPursuit& pursuit : plan.pursuits) {
    if (plans[std::size_t(pursuit.plan)].species == species) hours += double(pursuit.until - pursuit.from);
  }
  return hours;
}

}  // namespace

TEST_CASE("a pack's day goes from herd to herd where several live in its region, and comes back to where it began") {
  const Country country(5, 0, 1, GENERATE(Activity::diurnal, Activity::crepuscular, Activity::nocturnal, Activity::cathemeral));
  const auto plans = country.scene.plans();
  const auto wolves = packs(plans);
  REQUIRE(wolves.size() == 2);
  for (const DailyPlan& plan : wolves) {
    CHECK(herds_of(plan).size() >= 4);
    double last = double(plan.way.front().hour);
    for (const HerdPursuit& pursuit : plan.pursuits) {
      CHECK(double(pursuit.from) >= last);
      CHECK(pursuit.until > pursuit.from);
      CHECK(active(plan, double(pursuit.from)));
      CHECK(active(plan, double(pursuit.until)));
      last = double(pursuit.until);
    }
    CHECK(last <= double(plan.way.front().hour) + 24);
    CHECK(plan.way.back().at == plan.way.front().at);
    CHECK(plan.way.back().hour == Approx(plan.way.front().hour + 24));
    // A day's walk of some kilometres, not of a migration.
    CHECK(kilometres(plan) > 3);
    CHECK(kilometres(plan) < 45);
  }
}

TEST_CASE("with one herd in its region a pack keeps to it whenever it is active") {
  const Country country(1);
  const auto plans = country.scene.plans();
  for (const DailyPlan& plan : packs(plans)) {
    REQUIRE(herds_of(plan).size() == 1);
    for (double hour = 0; hour < 24; hour += 0.1) CHECK((pursuit_at(plan, hour) != nullptr) == active(plan, hour));
  }
}

TEST_CASE("packs never leave their region, and visit herds of their own side only") {
  const Country country(6);
  for (std::uint64_t seed = 1; seed <= 5; ++seed) {
    const auto plans = country.scene.plans(seed);
    for (const DailyPlan& plan : packs(plans)) {
      const bool west = plan.way.front().at.x < 100;
      CHECK(west == (country.scene.levels[1]->herds[std::size_t(plan.herd)].region == 0));
      for (const auto& point : plan.way) CHECK((point.at.x < 100) == west);
      for (const int herd : herds_of(plan)) CHECK((plans[std::size_t(herd)].way.front().at.x < 100) == west);
    }
  }
}

TEST_CASE("a pack has each herd in sight all the time it follows it, rests while it is not active, and drinks") {
  const Country country(5, 2);
  for (std::uint64_t seed = 1; seed <= 5; ++seed) {
    const auto plans = country.scene.plans(seed);
    for (const DailyPlan& plan : packs(plans)) {
      int resting = 0;
      int asleep = 0;
      for (double hour = 0; hour < 24; hour += 0.02) {
        const HerdState state = herd_state(plan, graph_of(country, plan), hour, 20);
        if (!active(plan, hour)) {
          ++asleep;
          resting += state.speed == 0;
        }
        const HerdPursuit* pursuit = pursuit_at(plan, hour);
        if (pursuit == nullptr) continue;
        const DailyPlan& herd = plans[std::size_t(pursuit->plan)];
        const PathPoint there = herd_state(herd, graph_of(country, herd), hour, 20).at;
        CHECK(std::hypot(double(state.at.x - there.x), double(state.at.y - there.y)) * 20 < 500);
      }
      // But for who is still on its way home.
      CHECK(resting > 0.85 * asleep);
      const auto& nodes = country.scene.levels[1]->graph->nodes;
      CHECK(std::any_of(plan.stops.begin(), plan.stops.end(),
                        [&](const PlanStop& stop) { return nodes[std::size_t(stop.node)].kind == NodeKind::bank; }));
    }
  }
}

TEST_CASE("a pack spends more of its hunting hours with what it lives on most") {
  const auto hours = [](double deer_share) {
    const Country country(4, 4, deer_share);
    std::pair<double, double> sum{0, 0};
    for (std::uint64_t seed = 1; seed <= 8; ++seed) {
      const auto plans = country.scene.plans(seed);
      const DailyPlan west = packs(plans).front();
      sum.first += hours_with(west, plans, country.deer);
      sum.second += hours_with(west, plans, country.goat);
    }
    return sum;
  };
  const auto [much_deer, few_goats] = hours(0.95);
  const auto [few_deer, much_goats] = hours(0.05);
  CHECK(much_deer > few_goats);
  CHECK(much_goats > few_deer);
}

TEST_CASE("who hunts alone stalks longer and walks less than a pack that courses") {
  const auto day = [](int pack_size) {
    const Country country(6, 0, 1, Activity::cathemeral, pack_size);
    std::pair<double, double> sum{0, 0};
    for (std::uint64_t seed = 1; seed <= 4; ++seed) {
      for (const DailyPlan& plan : packs(country.scene.plans(seed))) {
        sum.first += kilometres(plan);
        sum.second += double(plan.pursuits.size());
      }
    }
    return sum;
  };
  const auto [pack_kilometres, pack_visits] = day(6);
  const auto [lone_kilometres, lone_visits] = day(1);
  CHECK(pack_kilometres > lone_kilometres);
  CHECK(pack_visits > 1.3 * lone_visits);
}

TEST_CASE("a pursuit is found at its hours on any day, and none between two") {
  DailyPlan plan;
  plan.way = {{18, {0, 0}}, {42, {0, 0}}};
  plan.pursuits = {{19, 20, 3}, {23.5F, 25, 4}};
  CHECK(pursuit_at(plan, 18.5) == nullptr);
  REQUIRE(pursuit_at(plan, 19.5) != nullptr);
  CHECK(pursuit_at(plan, 19.5)->plan == 3);
  CHECK(pursuit_at(plan, 21) == nullptr);
  REQUIRE(pursuit_at(plan, 0.5) != nullptr);
  CHECK(pursuit_at(plan, 0.5)->plan == 4);
  CHECK(pursuit_at(plan, 0.5 - 48) == pursuit_at(plan, 24.5));
  CHECK(pursuit_at(plan, 1.5) == nullptr);
}

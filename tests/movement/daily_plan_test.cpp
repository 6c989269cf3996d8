#include <tbb/global_control.h>

#include <algorithm>
#include <catch2/catch.hpp>

#include "tests/movement/movement_scene.hpp"

using namespace biotope;
using biotope::test::MovementScene;

namespace {

AnimalTraits traits_of(Activity activity, float speed, int water_visits) {
  AnimalTraits traits;
  traits.mass_min = 80;
  traits.mass_max = 120;
  traits.speed = speed;
  traits.max_slope = 0.8F;
  traits.activity = activity;
  traits.water_visits = water_visits;
  return traits;
}

/// Herds of deer on rolling ground with water in the middle, and packs of wolves.
MovementScene valley(Activity activity, std::size_t herds = 6) {
  MovementScene scene(150, 120, 10, [](int x, int y) { return 0.03F * float((x - 75) * (x - 75)) * 0.3F + 0.4F * float(y); });
  for (int y = 0; y < 120; ++y) scene.blocked(75, y) = y % 40 > 8;
  const int deer = scene.animal("deer", 1, traits_of(activity, 1.2F, 2), {0});
  const int wolf = scene.animal("wolf", 2, traits_of(Activity::crepuscular, 1.6F, 1), {deer});
  std::vector<ResourceNode> nodes;
  for (int i = 0; i < 4; ++i) nodes.push_back(MovementScene::node(NodeKind::bank, 70 + 10 * (i % 2), 20 + 25 * i, 1500, 0));
  const std::vector<ResourceNode> banks = nodes;
  for (int i = 0; i < 8; ++i)
    nodes.push_back(MovementScene::node(NodeKind::vegetation, 15 + 17 * i, 15 + (i * 47) % 90, 40000, 1000 + 500 * i));
  AnimalLevel grazers = scene.level(1, nodes);
  for (std::size_t i = 0; i < herds; ++i) grazers.herds.push_back({deer, 0, 10 + int(i)});
  scene.add(std::move(grazers));
  nodes = banks;
  nodes.push_back(MovementScene::node(NodeKind::prey, 60, 60, 1e6, 5000, deer));
  AnimalLevel hunters = scene.level(2, nodes, 8);
  hunters.herds = {{wolf, 0, 4}, {wolf, 0, 4}};
  scene.add(std::move(hunters));
  return scene;
}

int water_stops(const MovementScene& scene, const DailyPlan& plan) {
  const auto& nodes = scene.levels[std::size_t(plan.level - 1)]->graph->nodes;
  return int(std::count_if(plan.stops.begin(), plan.stops.end(),
                           [&](const PlanStop& stop) { return nodes[std::size_t(stop.node)].kind == NodeKind::bank; }));
}

const GraphLevel& graph_of(const MovementScene& scene, const DailyPlan& plan) {
  return *scene.levels[std::size_t(plan.level - 1)]->graph;
}

bool active(const DailyPlan& plan, double hour) {
  return std::any_of(plan.active.begin(), plan.active.end(), [&](const auto& span) {
    return (hour >= double(span.from) && hour < double(span.until)) ||
           (hour + 24 >= double(span.from) && hour + 24 < double(span.until));
  });
}

}  // namespace

TEST_CASE("every herd has a plan that is closed over a day, with ascending times, on passable ground") {
  const MovementScene scene =
      valley(GENERATE(Activity::diurnal, Activity::crepuscular, Activity::nocturnal, Activity::cathemeral));
  const auto plans = scene.plans();
  REQUIRE(plans.size() == 8);
  for (const DailyPlan& plan : plans) {
    REQUIRE(!plan.stops.empty());
    REQUIRE(plan.way.size() >= 2);
    CHECK(plan.way.back().hour == Approx(plan.way.front().hour + 24));
    CHECK(plan.way.back().at.x == plan.way.front().at.x);
    CHECK(plan.way.back().at.y == plan.way.front().at.y);
    for (std::size_t i = 0; i < plan.stops.size(); ++i) {
      CHECK(plan.stops[i].arrive <= plan.stops[i].leave);
      if (i > 0) CHECK(plan.stops[i - 1].leave <= plan.stops[i].arrive);
    }
    for (std::size_t i = 0; i < plan.way.size(); ++i) {
      if (i > 0) REQUIRE(plan.way[i - 1].hour <= plan.way[i].hour);
      REQUIRE(scene.blocked(int(std::lround(plan.way[i].at.x)), int(std::lround(plan.way[i].at.y))) == 0);
    }
  }
}

TEST_CASE("herds visit several resources, and water as often as they must") {
  const MovementScene scene =
      valley(GENERATE(Activity::diurnal, Activity::crepuscular, Activity::nocturnal, Activity::cathemeral));
  for (const DailyPlan& plan : scene.plans()) {
    if (plan.level != 1) continue;
    CHECK(water_stops(scene, plan) == 2);
    CHECK(plan.stops.size() >= 5);
  }
}

TEST_CASE("a walk is never faster than the species walks; a predator that fell behind its herd trots, half as fast again") {
  const MovementScene scene = valley(Activity::diurnal);
  for (const DailyPlan& plan : scene.plans()) {
    const auto& animal = scene.web.species[std::size_t(plan.species)].animal();
    // The easiest slope is -0.05.
    const double fastest =
        double(animal.speed) * std::exp(0.05 * double(animal.slope_sensitivity)) * (plan.pursuits.empty() ? 1.0 : 1.5);
    for (std::size_t i = 1; i < plan.way.size(); ++i) {
      const auto& a = plan.way[i - 1];
      const auto& b = plan.way[i];
      const double metres = std::hypot(b.at.x - a.at.x, b.at.y - a.at.y) * 10;
      REQUIRE(metres <= fastest * (double(b.hour) - double(a.hour) + 1e-5) * 3600);
    }
  }
}

TEST_CASE("the state is a function of the hour of the day alone") {
  const MovementScene scene = valley(Activity::crepuscular);
  for (const DailyPlan& plan : scene.plans()) {
    for (double hour = -30; hour < 30; hour += 0.71) {
      const HerdState a = herd_state(plan, graph_of(scene, plan), hour, 10);
      const HerdState b = herd_state(plan, graph_of(scene, plan), hour + 24, 10);
      CHECK(a.at.x == Approx(b.at.x).margin(0.01));
      CHECK(a.at.y == Approx(b.at.y).margin(0.01));
      CHECK(a.activity == b.activity);
      CHECK(a.heading >= 0);
      CHECK(a.heading < 6.2832F);
    }
  }
}

TEST_CASE("a herd drinks at banks, feeds at meadows, walks between and rests at night") {
  const MovementScene scene = valley(Activity::diurnal, 1);
  const DailyPlan plan = scene.plans().front();
  const GraphLevel& graph = graph_of(scene, plan);
  for (std::size_t i = 0; i < plan.stops.size(); ++i) {
    const double middle = 0.5 * (double(plan.stops[i].arrive) + double(plan.stops[i].leave));
    const HerdActivity doing = herd_state(plan, graph, middle, 10).activity;
    const bool bank = graph.nodes[std::size_t(plan.stops[i].node)].kind == NodeKind::bank;
    CHECK(doing == (bank ? HerdActivity::drinking : active(plan, middle) ? HerdActivity::feeding : HerdActivity::resting));
    if (i == 0) continue;
    const double between = 0.5 * (double(plan.stops[i - 1].leave) + double(plan.stops[i].arrive));
    const HerdState walking = herd_state(plan, graph, between, 10);
    CHECK(walking.activity == HerdActivity::walking);
    CHECK(walking.speed > 0);
  }
  CHECK(herd_state(plan, graph, 2, 10).activity == HerdActivity::resting);
  CHECK(herd_state(plan, graph, 2, 10).speed == 0);
}

TEST_CASE("headings are clockwise from north") {
  DailyPlan plan;
  plan.way = {{0, {0, 10}}, {1, {0, 0}}, {2, {10, 0}}, {3, {10, 10}}, {4, {0, 10}}, {24, {0, 10}}};
  const GraphLevel graph;
  CHECK(herd_state(plan, graph, 0.5, 36).heading == Approx(0).margin(1e-5));
  CHECK(herd_state(plan, graph, 1.5, 36).heading == Approx(1.5707963));
  CHECK(herd_state(plan, graph, 2.5, 36).heading == Approx(3.1415926));
  CHECK(herd_state(plan, graph, 3.5, 36).heading == Approx(4.7123889));
  CHECK(herd_state(plan, graph, 0.5, 36).speed == Approx(0.1));
  // At rest it looks where it walked last.
  CHECK(herd_state(plan, graph, 12, 36).heading == Approx(4.7123889));
  CHECK(herd_state(plan, graph, 12, 36).speed == 0);
}

TEST_CASE("predators stay within 500 m of each herd they follow, not on top of it; packs are at different herds") {
  const MovementScene scene = valley(Activity::crepuscular);
  const auto plans = scene.plans();
  for (const DailyPlan& plan : plans) {
    if (plan.level != 2) continue;
    double sum = 0;
    int followed = 0;
    int awake = 0;
    for (double hour = 0; hour < 24; hour += 0.05) {
      awake += active(plan, hour);
      const HerdPursuit* pursuit = pursuit_at(plan, hour);
      if (pursuit == nullptr) continue;
      CHECK(active(plan, hour));
      const DailyPlan& herd = plans[std::size_t(pursuit->plan)];
      const PathPoint a = herd_state(plan, graph_of(scene, plan), hour, 10).at;
      const PathPoint b = herd_state(herd, graph_of(scene, herd), hour, 10).at;
      const double metres = std::hypot(a.x - b.x, a.y - b.y) * 10;
      CHECK(metres < 500);
      sum += metres;
      ++followed;
    }
    REQUIRE(followed > 0);
    CHECK(2 * followed > awake);
    CHECK(sum / followed > 50);
    CHECK(water_stops(scene, plan) >= 1);
  }
  int together = 0;
  for (double hour = 0; hour < 24; hour += 0.05) {
    const HerdPursuit* a = pursuit_at(plans[6], hour);
    const HerdPursuit* b = pursuit_at(plans[7], hour);
    together += a != nullptr && b != nullptr && a->plan == b->plan;
  }
  CHECK(together * 0.05 < 1.5);
}

TEST_CASE("plans are the same for any number of threads, and others for another seed") {
  const MovementScene scene = valley(Activity::diurnal);
  const auto with_threads = [&](std::size_t threads, std::uint64_t seed) {
    const tbb::global_control control(tbb::global_control::max_allowed_parallelism, threads);
    return scene.plans(seed);
  };
  const auto same = [](const std::vector<DailyPlan>& a, const std::vector<DailyPlan>& b) {
    bool equal = a.size() == b.size();
    for (std::size_t i = 0; equal && i < a.size(); ++i) {
      equal = a[i].way.size() == b[i].way.size() && a[i].stops.size() == b[i].stops.size() && a[i].pursuits == b[i].pursuits;
      for (std::size_t k = 0; equal && k < a[i].way.size(); ++k) {
        equal =
            a[i].way[k].hour == b[i].way[k].hour && a[i].way[k].at.x == b[i].way[k].at.x && a[i].way[k].at.y == b[i].way[k].at.y;
      }
    }
    return equal;
  };
  const auto plans = with_threads(1, 1);
  CHECK(same(plans, with_threads(2, 1)));
  CHECK_FALSE(same(plans, with_threads(2, 2)));
}

TEST_CASE("a herd without any resource stands still in its region") {
  MovementScene scene(30, 30, 10);
  const int deer = scene.animal("deer", 1, traits_of(Activity::diurnal, 1.2F, 2), {0});
  AnimalLevel level = scene.level(1, {});
  level.herds = {{deer, 0, 5}};
  scene.add(std::move(level));
  const auto plans = scene.plans();
  REQUIRE(plans.size() == 1);
  CHECK(plans[0].stops.empty());
  const HerdState state = herd_state(plans[0], *scene.levels[0]->graph, 13, 10);
  CHECK(state.activity == HerdActivity::resting);
  CHECK(state.speed == 0);
}

TEST_CASE("a predator rests when it is not active, while the herd moves on") {
  // Deer are on their feet from 5 to 21, wolves from 4 to 10 and from 16 to 22.
  const MovementScene scene = valley(Activity::diurnal);
  for (const DailyPlan& plan : scene.plans()) {
    if (plan.level != 2) continue;
    REQUIRE(!plan.pursuits.empty());
    double longest = 0;
    double still = 0;
    for (double hour = 10; hour < 16; hour += 0.01) {
      still = herd_state(plan, graph_of(scene, plan), hour, 10).speed == 0 ? still + 0.01 : 0;
      longest = std::max(longest, still);
    }
    CHECK(longest > 3);
  }
}

TEST_CASE("herds walk on the trails") {
  const MovementScene scene = valley(Activity::diurnal);
  const TrailNetwork network = scene.trails();
  const auto share_on_trails = [&](const std::vector<DailyPlan>& plans) {
    int walking = 0;
    int on_trail = 0;
    for (const DailyPlan& plan : plans) {
      if (plan.level != 1) continue;
      for (double hour = 0; hour < 24; hour += 0.02) {
        const HerdState state = herd_state(plan, graph_of(scene, plan), hour, 10);
        if (state.activity != HerdActivity::walking) continue;
        ++walking;
        double nearest = 1e9;
        for (const TrailRoute& route : network.routes) {
          for (const PathPoint& point : route.points)
            nearest = std::min(nearest, std::hypot(double(point.x - state.at.x), double(point.y - state.at.y)));
        }
        on_trail += nearest * 10 < 12;
      }
    }
    REQUIRE(walking > 100);
    return double(on_trail) / walking;
  };
  CHECK(share_on_trails(scene.plans_on(network)) > 0.8);
  CHECK(share_on_trails(scene.plans_on(network)) > share_on_trails(scene.plans()) + 0.1);
}

TEST_CASE("of very many herds an even number of each species gets a plan, the same ones whatever lives elsewhere") {
  MovementScene scene(30, 30, 10);
  for (int y = 0; y < 30; ++y) scene.blocked(15, y) = 1;
  const int deer = scene.animal("deer", 1, traits_of(Activity::diurnal, 1.2F, 2), {0});
  const int goat = scene.animal("goat", 1, traits_of(Activity::diurnal, 1.2F, 2), {0});
  AnimalLevel level = scene.level(1, {});
  for (int i = 0; i < 400; ++i) level.herds.push_back({deer, i % 2, 5});
  for (int i = 0; i < 20; ++i) level.herds.push_back({goat, 0, 5});
  const auto chosen_of = [&](const AnimalLevel& animals, std::size_t most) {
    const std::vector<std::shared_ptr<const AnimalLevel>> levels{std::make_shared<const AnimalLevel>(animals)};
    return planned_herds(levels, 7, most).front();
  };
  CHECK(chosen_of(level, 1000).size() == 420);
  const auto chosen = chosen_of(level, 100);
  CHECK(chosen.size() == 100);
  CHECK(std::is_sorted(chosen.begin(), chosen.end()));
  const auto is = [&](int species, int region) {
    return [&level, species, region](int herd) {
      const Herd& one = level.herds[std::size_t(herd)];
      return one.species == species && one.region == region;
    };
  };
  CHECK(std::count_if(chosen.begin(), chosen.end(), is(goat, 0)) == 20);
  CHECK(std::count_if(chosen.begin(), chosen.end(), is(deer, 0)) > 20);
  CHECK(std::count_if(chosen.begin(), chosen.end(), is(deer, 1)) > 20);
  AnimalLevel later = level;
  later.herds.insert(later.herds.begin(), Herd{goat, 1, 5});
  later.herds.pop_back();
  auto shifted = chosen_of(later, 100);
  std::vector<int> of_deer;
  for (const int herd : chosen) {
    if (herd < 400) of_deer.push_back(herd + 1);
  }
  std::erase_if(shifted, [](int herd) { return herd == 0 || herd > 400; });
  CHECK(shifted == of_deer);
}

#include <algorithm>
#include <iomanip>
#include <map>
#include <set>
#include <sstream>
#include <string>

#include "tests/sample/solved_valley.hpp"

using namespace biotope;
using namespace biotope::test;

namespace {

/// What the herds of a species do in a day, on the mean.
struct Day {
  int herds = 0;
  double kilometres = 0;
  /// Hours by HerdActivity.
  std::array<double, 5> hours{};
};

std::map<std::string, Day> played_days(const HerdWorld& world) {
  std::map<std::string, Day> days;
  constexpr double step = 60;
  for (const DailyPlan& plan : *world.plans) {
    Day& day = days[world.web->species[std::size_t(plan.species)].name];
    ++day.herds;
    for (std::size_t i = 0; i + 1 < plan.way.size(); ++i)
      day.kilometres += length(world.place_of(plan.way[i + 1].at) - world.place_of(plan.way[i].at)) / 1000;
    for (double seconds = 0; seconds < day_seconds; seconds += step)
      day.hours[std::size_t(world.state(plan, seconds).activity)] += step / 3600;
  }
  for (auto& [name, day] : days) {
    day.kilometres /= day.herds;
    for (double& hours : day.hours) hours /= day.herds;
  }
  return days;
}

std::string table(const std::map<std::string, Day>& days) {
  std::ostringstream text;
  text << std::fixed << std::setprecision(1) << "species, herds: km, hours at rest, drinking, feeding, walking, hunting\n";
  for (const auto& [name, day] : days) {
    text << name << ", " << day.herds << ": " << day.kilometres;
    for (const double hours : day.hours) text << ", " << hours;
    text << "\n";
  }
  return text.str();
}

double hours(const Day& day, HerdActivity activity) { return day.hours[std::size_t(activity)]; }

/// Members of a herd on ground where something that it eats grows, as a share.
double share_on_food(const MapsSnapshot& maps, const HerdWorld& world, const DailyPlan& plan,
                     const std::vector<HerdAnimal>& herd) {
  const auto& plants = maps.web->levels[0];
  int on_food = 0;
  for (const HerdAnimal& animal : herd) {
    const HerdWorld::Cell cell = world.cell_of(animal.place);
    const auto grows = [&](int food) {
      const auto plant = std::find(plants.begin(), plants.end(), food);
      return plant != plants.end() && (*maps.cover[std::size_t(plant - plants.begin())])(cell.x, cell.y) > 0;
    };
    bool any = false;
    for (const auto& need : maps.web->diets[std::size_t(plan.species)])
      any = any || std::any_of(need.foods.begin(), need.foods.end(), grows);
    on_food += any;
  }
  return double(on_food) / double(herd.size());
}

}  // namespace

TEST_CASE("a played day: herds walk, feed and rest as long as such animals do, by order of magnitude") {
  const auto maps = solved_valley();
  const auto days = played_days(*world_of(*maps));
  INFO(table(days));
  // Measured: wisents 1 to 10 km a day (Perzanowski et al. 2017), feral horses 8 to 28 km (Hampson et al. 2010), lynxes 3 to 14
  // km (Jedrzejewski et al. 2002), wolves 22 to 28 km (Jedrzejewski et al. 2001); red deer are on their feet 8 to 13 h (Kamler et
  // al. 2007; captive hinds the longer).
  const std::map<std::string, std::pair<double, double>> measured{{"bison-priscus", {1, 10}},
                                                                  {"equus-mosbachensis", {8, 28}},
                                                                  {"lynx-spelaeus", {2.8, 14}},
                                                                  {"canis-mosbachensis", {22, 28}}};
  for (const auto& [name, day] : days) {
    INFO(name);
    CHECK(day.kilometres > 1.5);
    CHECK((day.kilometres < 20 || measured.contains(name)));
    CHECK(hours(day, HerdActivity::resting) > 5);
    CHECK(hours(day, HerdActivity::resting) < 15);
    CHECK(hours(day, HerdActivity::drinking) > 0.25);
    CHECK(hours(day, HerdActivity::drinking) < 2.5);
    CHECK(hours(day, HerdActivity::walking) < 4);
    double sum = 0;
    for (const double hours : day.hours) sum += hours;
    CHECK(sum == Approx(24).margin(1e-6));
    const auto known = measured.find(name);
    if (known == measured.end()) continue;
    CHECK(day.kilometres > 0.5 * known->second.first);
    CHECK(day.kilometres < 1.5 * known->second.second);
  }
}

TEST_CASE("a played day: predators go from herd to herd, packs to many") {
  const auto maps = solved_valley();
  const auto world = world_of(*maps);
  for (const DailyPlan& plan : *world->plans) {
    if (plan.pursuits.empty()) continue;
    INFO(world->web->species[std::size_t(plan.species)].name << ", herd " << plan.herd);
    std::set<int> herds;
    for (const HerdPursuit& pursuit : plan.pursuits) herds.insert(pursuit.plan);
    CHECK(herds.size() >= 2);
    CHECK((herds.size() >= 6 || plan.size == 1));
  }
}

TEST_CASE("every herd drinks on every day, unless no bank is in its region; no node holds more than it has room for") {
  const auto maps = solved_valley();
  const auto world = world_of(*maps);
  for (const DailyPlan& plan : *world->plans) {
    const auto& nodes = world->graph_of(plan).nodes;
    const auto banks = std::count_if(plan.stops.begin(), plan.stops.end(),
                                     [&](const PlanStop& stop) { return nodes[std::size_t(stop.node)].kind == NodeKind::bank; });
    INFO(world->web->species[std::size_t(plan.species)].name << ", herd " << plan.herd);
    CHECK((banks > 0 || world->traits(plan).water_visits == 0));
    for (std::size_t i = 0; i < plan.stops.size(); ++i) {
      CHECK(plan.stops[i].arrive <= plan.stops[i].leave);
      if (i > 0) CHECK(plan.stops[i - 1].leave <= plan.stops[i].arrive);
    }
  }
}

TEST_CASE("individuals do what their plan says: near its place, lying only while they rest, feeding where their food grows") {
  const auto maps = solved_valley();
  const auto world = world_of(*maps);
  std::map<int, int> largest;
  for (int p = 0; p < int(world->plans->size()); ++p) {
    const DailyPlan& plan = (*world->plans)[std::size_t(p)];
    const auto known = largest.try_emplace(plan.species, p).first;
    if ((*world->plans)[std::size_t(known->second)].size < plan.size) known->second = p;
  }
  HerdSimulation simulation(world);
  for (const auto& [species, p] : largest) {
    const DailyPlan& plan = (*world->plans)[std::size_t(p)];
    INFO(world->web->species[std::size_t(species)].name);
    double on_food = 0;
    int feeding = 0;
    for (double hour = 0; hour < 24; hour += 0.25) {
      const HerdRequest request{p, 0};
      const auto herd = simulation.animals(std::span(&request, 1), hour).front();
      const HerdState state = world->state(plan, hour * 3600);
      Place middle{};
      double lying = 0;
      for (const HerdAnimal& animal : herd) {
        middle = middle + animal.place * (1.0 / double(herd.size()));
        lying += double(animal.lying) / double(herd.size());
      }
      INFO("at " << hour);
      const double at_water = state.activity == HerdActivity::drinking ? 160 : 0;
      const double rush = plan.pursuits.empty() ? 0 : 300;
      CHECK(length(middle - world->place_of(state.at)) < 60 + 0.35 * double(plan.size) + at_water + rush + fright_distance);
      // What a herd does is averaged over two minutes.
      const HerdActivity before = world->state(plan, hour * 3600 - 90).activity;
      if (state.activity == before && state.activity != HerdActivity::resting && state.activity != HerdActivity::walking)
        CHECK(lying < 0.05);
      if (state.activity != HerdActivity::feeding || before != HerdActivity::feeding) continue;
      ++feeding;
      on_food += share_on_food(*maps, *world, plan, herd);
    }
    if (feeding > 0) CHECK(on_food / feeding > 0.9);
  }
}

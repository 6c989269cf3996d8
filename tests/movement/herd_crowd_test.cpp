#include <tbb/global_control.h>

#include <algorithm>
#include <catch2/catch.hpp>

#include "core/movement/herd_bodies.hpp"
#include "tests/movement/herd_scene.hpp"

using namespace biotope;
using biotope::test::all_herds;
using biotope::test::Grove;
using biotope::test::meadow;
using biotope::test::same;

namespace {

using Herds = std::vector<std::vector<HerdAnimal>>;

/// Two pastures and two banks for four herds, in an open wood.
std::shared_ptr<HerdWorld> crowded() { return meadow(2, std::make_shared<const Grove>(9.0)); }

std::vector<HerdBody> bodies_of(std::span<const HerdCast> casts, const Herds& herds) {
  std::vector<HerdBody> bodies;
  for (std::size_t r = 0; r < herds.size(); ++r) {
    for (const HerdAnimal& animal : herds[r]) {
      bodies.push_back(
          herd_body(casts[r], double(animal.size), animal.place, double(animal.heading), double(animal.speed), bodies.size()));
    }
  }
  return bodies;
}

std::vector<HerdCast> casts_of(const std::shared_ptr<const HerdWorld>& world) {
  std::vector<HerdCast> casts;
  for (std::size_t p = 0; p < world->plans->size(); ++p) casts.push_back(cast_herd(world, int(p), {}));
  return casts;
}

/// A herd of one kind on flat dry ground without regions.
struct OpenGround {
  std::shared_ptr<HerdWorld> world = meadow();
  HerdCast deer = cast_herd(world, 0, {});
  OpenGround() { deer.region = {}; }
  [[nodiscard]] HerdBody at(Place place, double heading, double speed, std::uint64_t name, double size = 1) const {
    return herd_body(deer, size, place, heading, speed, name);
  }
};

}  // namespace

TEST_CASE("Two that stand in each other are moved apart, the heavier less; whatever is far away changes no bit") {
  const OpenGround ground;
  std::vector<HerdBody> pair{ground.at({200, 200}, 0, 0, 1), ground.at({200.2, 200}, 0, 0, 2, 0.6)};
  REQUIRE(overlap(pair[0], pair[1]) > 0.1);
  std::vector<HerdBody> more = pair;
  for (int i = 0; i < 40; ++i) more.push_back(ground.at({260.0 + 0.3 * i, 200}, 0.1 * i, 0, std::uint64_t(3 + i)));
  settle(*ground.world, pair);
  settle(*ground.world, more);
  CHECK(overlap(pair[0], pair[1]) < 0.02);
  CHECK(length(pair[0].at - Place{200, 200}) < length(pair[1].at - Place{200.2, 200}));
  CHECK(more[0].at == pair[0].at);
  CHECK(more[1].at == pair[1].at);
  // Side by side is near enough; who has room stays.
  std::vector<HerdBody> apart{ground.at({200, 200}, 0, 0, 1), ground.at({201, 200}, 0, 0, 2)};
  settle(*ground.world, apart);
  CHECK(apart[0].at == Place{200, 200});
}

TEST_CASE("One across another, and one exactly upon another, are moved apart too") {
  const OpenGround ground;
  for (const Place second : {Place{200, 200}, Place{200.3, 200.1}}) {
    std::vector<HerdBody> pair{ground.at({200, 200}, 0, 0, 1), ground.at(second, 1.4, 0, 2)};
    settle(*ground.world, pair);
    CHECK(overlap(pair[0], pair[1]) < 0.05);
  }
}

TEST_CASE("Who walks goes around a trunk in a bow; who stands at one stands beside it") {
  OpenGround ground;
  ground.world->details = std::make_shared<const Grove>(40.0);
  std::vector<Stem> stems;
  ground.world->details->stems({150, 150}, {250, 250}, stems);
  REQUIRE(!stems.empty());
  const Stem stem = stems.front();
  Place before{};
  double farthest = 0;
  for (double ahead = -8; ahead < 8; ahead += 0.1) {
    std::vector<HerdBody> one{ground.at(stem.at + Place{0.07, ahead}, 0, 1.4, 1)};
    settle(*ground.world, one);
    REQUIRE(overlap(one[0], stem) < 0.01);
    if (ahead > -8) REQUIRE(length(one[0].at - before) < 0.2);
    farthest = std::max(farthest, std::abs(one[0].at.x - stem.at.x));
    before = one[0].at;
  }
  CHECK(farthest < 1.0);
  CHECK(before == stem.at + Place{0.07, before.y - stem.at.y});
  std::vector<HerdBody> standing{ground.at(stem.at + Place{0.05, 0.1}, 0, 0, 1)};
  settle(*ground.world, standing);
  CHECK(overlap(standing[0], stem) < 0.01);
}

TEST_CASE("No two animals of any herds stand in each other, and none in a trunk, at any hour") {
  const auto world = crowded();
  const auto requests = all_herds(*world);
  const auto casts = casts_of(world);
  HerdSimulation simulation(world);
  for (double hour = 0.013; hour < 24; hour += 0.53) {
    INFO("hour " << hour);
    const std::vector<HerdBody> bodies = bodies_of(casts, simulation.animals(requests, hour));
    double deepest = 0;
    double in_trunk = 0;
    for (std::size_t i = 0; i < bodies.size(); ++i) {
      for (std::size_t k = 0; k < i; ++k) deepest = std::max(deepest, overlap(bodies[i], bodies[k]));
      std::vector<Stem> stems;
      world->details->stems(bodies[i].at - Place{4, 4}, bodies[i].at + Place{4, 4}, stems);
      for (const Stem& stem : stems) in_trunk = std::max(in_trunk, overlap(bodies[i], stem));
    }
    CHECK(deepest < 0.12);
    CHECK(in_trunk < 0.12);
  }
}

TEST_CASE("In a crowd, too, the same hour shows the same bits, in any order of hours and of herds, on any number of threads") {
  const auto world = crowded();
  const auto requests = all_herds(*world);
  const std::vector<double> hours{7.3, 12.004, 7.301, 18.5, 3.2};
  std::vector<Herds> forward;
  {
    HerdSimulation simulation(world);
    for (const double hour : hours) forward.push_back(simulation.animals(requests, hour));
  }
  const tbb::global_control one_thread(tbb::global_control::max_allowed_parallelism, 1);
  for (std::size_t h = hours.size(); h-- > 0;) {
    HerdSimulation other(world);
    for (std::size_t r = requests.size(); r-- > 0;) {
      const std::vector<HerdAnimal> alone = other.animals(int(r), hours[h]);
      for (std::size_t m = 0; m < alone.size(); ++m) REQUIRE(same(alone[m], forward[h][r][m]));
    }
  }
}

TEST_CASE("In a crowd and among trunks nobody jumps: from one second to the next each moves no farther than it trots, or flees") {
  const auto world = crowded();
  const auto requests = all_herds(*world);
  HerdSimulation simulation(world);
  double farthest = 0;
  for (const double from : {0.5, 6.9, 9.2, 13.0, 16.4}) {
    Herds before = simulation.animals(requests, from);
    for (double since = 1; since < 90; since += 1) {
      const Herds now = simulation.animals(requests, from + since / 3600);
      for (std::size_t r = 0; r < now.size(); ++r) {
        for (std::size_t i = 0; i < now[r].size(); ++i) {
          const double moved = length(now[r][i].place - before[r][i].place);
          const double runs = std::max(double(now[r][i].speed), double(before[r][i].speed));
          farthest = std::max(farthest, moved - runs);
          REQUIRE(moved < runs + 1.9 * 1.4);
        }
      }
      before = now;
    }
  }
  INFO("farthest aside in a second: " << farthest);
  CHECK(farthest < 2.66);
}

TEST_CASE(
    "In another world whose plans are the same, herds go on whose surroundings are; all are where a new simulation has them") {
  const auto before = meadow(2);
  const auto requests = all_herds(*before);
  const double hour = 7.3;
  HerdSimulation simulation(before);
  static_cast<void>(simulation.animals(requests, hour));
  const std::size_t all = simulation.bytes();
  REQUIRE(all > 0);
  const auto check = [&](const std::shared_ptr<HerdWorld>& world, bool some_kept, bool all_kept) {
    // The same plans: only what is around is different.
    world->plans = before->plans;
    world->graph = before->graph;
    world->levels = before->levels;
    world->web = before->web;
    HerdSimulation following(before);
    static_cast<void>(following.animals(requests, hour));
    following.follow(world);
    CHECK((following.bytes() > 0) == some_kept);
    CHECK((following.bytes() == all) == all_kept);
    HerdSimulation fresh(world);
    for (const double h : {hour, hour + 0.004, 18.5}) {
      const Herds a = following.animals(requests, h);
      const Herds b = fresh.animals(requests, h);
      for (std::size_t r = 0; r < a.size(); ++r) {
        for (std::size_t i = 0; i < a[r].size(); ++i) REQUIRE(same(a[r][i], b[r][i]));
      }
    }
  };
  // Far from all of them; at the bank where all drink; trunks everywhere.
  check(meadow(2, nullptr, {149, 119}), true, true);
  check(meadow(2, nullptr, {57, 55}), false, false);
  check(meadow(2, std::make_shared<const Grove>(9.0)), false, false);
}

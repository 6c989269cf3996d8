// Individuals of herds: how long until the animals around a place are there after the clock jumped, and what a frame costs while
// it runs.
//   bench_animals [INPUT]   INPUT: sample:valley (the default), a DEM or a scene

#include <sys/resource.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <string>
#include <vector>

#include "core/exchange/open_input.hpp"
#include "core/movement/herd_simulation.hpp"
#include "core/pipeline/solve.hpp"

using namespace biotope;

namespace {

using Clock = std::chrono::steady_clock;

double milliseconds_since(Clock::time_point start) {
  return std::chrono::duration<double, std::milli>(Clock::now() - start).count();
}

/// Milliseconds of processor time that this process used so far, over all its threads.
double processor_milliseconds() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  const auto milliseconds = [](const timeval& time) { return double(time.tv_sec) * 1e3 + double(time.tv_usec) * 1e-3; };
  return milliseconds(usage.ru_utime) + milliseconds(usage.ru_stime);
}

int size_of(const HerdWorld& world, const std::vector<HerdRequest>& herds) {
  int sum = 0;
  for (const HerdRequest& herd : herds) sum += (*world.plans)[std::size_t(herd.plan)].size;
  return sum;
}

/// Herds within 300 m of the herd that has most others around it.
std::vector<HerdRequest> most_crowded(const HerdWorld& world, double hour) {
  std::vector<Place> places;
  for (const DailyPlan& plan : *world.plans) places.push_back(world.place_of(world.state(plan, hour * 3600).at));
  std::vector<HerdRequest> best;
  for (const Place& middle : places) {
    std::vector<HerdRequest> near;
    for (std::size_t i = 0; i < places.size(); ++i) {
      if (length(places[i] - middle) < 300) near.push_back({int(i), 1});
    }
    if (near.size() > best.size()) best = std::move(near);
  }
  return best;
}

void scrub(HerdSimulation& simulation) {
  std::vector<double> waits;
  std::size_t herds = 0;
  int animals = 0;
  for (int i = 0; i < 24; ++i) {
    const double hour = std::fmod(3.3 + i * 0.618034 * 24, 24.0);
    const std::vector<HerdRequest> near = most_crowded(simulation.world(), hour);
    herds = std::max(herds, near.size());
    animals = std::max(animals, size_of(simulation.world(), near));
    const auto start = Clock::now();
    static_cast<void>(simulation.animals(near, hour));
    waits.push_back(milliseconds_since(start));
  }
  std::sort(waits.begin(), waits.end());
  std::printf("clock set to another hour, up to %zu herds with %d animals around: median %.1f ms, longest %.1f ms\n", herds,
              animals, waits[waits.size() / 2], waits.back());
}

void play(HerdSimulation& simulation, float boids, const char* what) {
  std::vector<HerdRequest> all;
  for (std::size_t i = 0; i < simulation.world().plans->size(); ++i) all.push_back({int(i), boids});
  static_cast<void>(simulation.animals(all, 9));
  constexpr int frames = 300;
  const double before = processor_milliseconds();
  for (int i = 1; i <= frames; ++i) static_cast<void>(simulation.animals(all, 9 + i / 30.0 / 3600));
  std::printf("%s, all %d animals, 30 frames a second: %.2f ms of processor time a frame, %.1f MiB of runs\n", what,
              size_of(simulation.world(), all), (processor_milliseconds() - before) / frames,
              double(simulation.bytes()) / 1048576);
}

}  // namespace

int main(int count, char** arguments) {
  const std::string input = count > 1 ? arguments[1] : "sample:valley";
  const auto document = open_input(input);
  if (!document) {
    std::printf("%s\n", document.error().message.c_str());
    return 1;
  }
  SolveCache cache;
  const auto maps = solve(*document, &cache);
  if (!maps) {
    std::printf("%s\n", maps.error().message.c_str());
    return 1;
  }
  auto world = std::make_shared<HerdWorld>();
  world->web = (*maps)->web;
  world->ground = (*maps)->ground();
  world->levels = (*maps)->animals;
  world->graph = (*maps)->graph;
  world->plans = (*maps)->plans;
  world->seed = (*maps)->document.seed;
  HerdSimulation simulation(world);
  scrub(simulation);
  play(simulation, 1, "boids");
  play(simulation, 0, "guides alone");
  return 0;
}

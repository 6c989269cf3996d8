// Individuals of herds: how long until the animals around a place are there after the clock jumped, what a frame costs while it
// runs, and what it costs to draw 2,000 animals that are in sight.
//   bench_animals [INPUT] [WIDTHxHEIGHT]   INPUT: sample:valley (the default), a DEM or a scene; 960x540

#include <epoxy/gl.h>
#include <sys/resource.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <memory>
#include <string>
#include <vector>

#include "core/exchange/open_input.hpp"
#include "core/movement/herd_simulation.hpp"
#include "core/pipeline/solve.hpp"
#include "render/animal_surroundings.hpp"
#include "render/landscape_renderer.hpp"
#include "render/offscreen_context.hpp"

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
  std::vector<double> works;
  std::size_t herds = 0;
  int animals = 0;
  for (int i = 0; i < 24; ++i) {
    const double hour = std::fmod(3.3 + i * 0.618034 * 24, 24.0);
    const std::vector<HerdRequest> near = most_crowded(simulation.world(), hour);
    herds = std::max(herds, near.size());
    animals = std::max(animals, size_of(simulation.world(), near));
    const auto start = Clock::now();
    const double before = processor_milliseconds();
    static_cast<void>(simulation.animals(near, hour));
    waits.push_back(milliseconds_since(start));
    works.push_back(processor_milliseconds() - before);
  }
  std::sort(waits.begin(), waits.end());
  std::sort(works.begin(), works.end());
  std::printf(
      "clock set to another hour, up to %zu herds with %d animals around: median %.1f ms, longest %.1f ms (processor "
      "time %.1f and %.1f ms)\n",
      herds, animals, waits[waits.size() / 2], waits.back(), works[works.size() / 2], works.back());
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

/// Milliseconds of processor time that the calling thread used so far.
double thread_milliseconds() {
  rusage usage{};
  getrusage(RUSAGE_THREAD, &usage);
  const auto milliseconds = [](const timeval& time) { return double(time.tv_sec) * 1e3 + double(time.tv_usec) * 1e-3; };
  return milliseconds(usage.ru_utime) + milliseconds(usage.ru_stime);
}

/// What a window's thread does in the frame in which the clock jumps, beside what it does in any, and how long until the animals
/// of the hour are there. Nothing but the animals is drawn, and that small.
void scrub_in_window(const std::shared_ptr<const MapsSnapshot>& maps, const Camera& camera) {
  auto renderer = LandscapeRenderer::create();
  if (!renderer) return;
  const RenderTarget target(16, 9);
  LandscapeOptions options;
  options.plants = options.shadows = false;
  options.quality = 1;
  (*renderer)->set_snapshot(maps);
  (*renderer)->finish_loading(camera, options);
  target.bind();
  const auto hour_of = [](int i) { return std::fmod(3.3 + i * 0.618034 * 24, 24.0); };
  // What the light of an hour needs for the first time (shaders of the night among it) is no matter of animals.
  options.animals = false;
  for (int i = 0; i < 24; ++i) {
    options.hour = hour_of(i);
    (*renderer)->finish_loading(camera, options);
    (*renderer)->draw(camera, options, 16, 9);
  }
  options.animals = true;
  options.hour = 9;
  (*renderer)->draw(camera, options, 16, 9);
  const auto frame = [&] {
    const double before = thread_milliseconds();
    (void)(*renderer)->bring_in(options);
    (*renderer)->draw(camera, options, 16, 9);
    return thread_milliseconds() - before;
  };
  std::vector<double> works;
  std::vector<double> waits;
  for (int i = 0; i < 24; ++i) {
    const double at_rest = std::min(frame(), frame());
    options.hour = hour_of(i);
    const auto start = Clock::now();
    double most = frame();
    while (!(*renderer)->complete()) most = std::max(most, frame());
    waits.push_back(milliseconds_since(start));
    works.push_back(std::max(0.0, most - at_rest));
  }
  std::sort(works.begin(), works.end());
  std::sort(waits.begin(), waits.end());
  std::printf(
      "clock set to another hour in a window: its thread computes median %.1f, most %.1f ms more in a frame; the animals are "
      "there after "
      "median %.1f, longest %.1f ms\n",
      works[works.size() / 2], works.back(), waits[waits.size() / 2], waits.back());
}

/// The same landscape with as many times as many animals in each herd.
std::shared_ptr<const MapsSnapshot> with_larger_herds(const MapsSnapshot& maps, int times) {
  auto more = std::make_shared<MapsSnapshot>(maps);
  std::vector<DailyPlan> plans = *maps.plans;
  for (DailyPlan& plan : plans) plan.size *= times;
  more->plans = std::make_shared<const std::vector<DailyPlan>>(std::move(plans));
  return more;
}

/// From 60 m above the ground 250 m south of the herd that has most animals around it.
Camera over_the_herds(const MapsSnapshot& maps, double hour) {
  HerdWorld world;
  world.graph = maps.graph;
  world.ground = maps.ground();
  std::vector<Place> places;
  for (const DailyPlan& plan : *maps.plans) places.push_back(world.place_of(world.state(plan, hour * 3600).at));
  Place best;
  int most = -1;
  for (const Place& middle : places) {
    int sum = 0;
    for (std::size_t i = 0; i < places.size(); ++i) sum += length(places[i] - middle) < 350 ? (*maps.plans)[i].size : 0;
    if (sum > most) {
      most = sum;
      best = middle;
    }
  }
  Camera camera;
  camera.position = {best.x, best.y - 250, double(ground_height(maps.terrain(), best.x, best.y)) + 60};
  camera.pitch = -12;
  return camera;
}

struct DrawnFrames {
  double median = 0;
  double worst = 0;
  LandscapeStatistics statistics;
};

/// Frames during which the day passes.
DrawnFrames frames(LandscapeRenderer& renderer, const RenderTarget& target, const Camera& camera, LandscapeOptions options) {
  constexpr int count = 8;
  std::vector<double> times;
  renderer.finish_loading(camera, options);
  for (int i = 0; i < count + 3; ++i) {
    options.hour += 1 / 30.0 / 3600;
    const auto start = Clock::now();
    target.bind();
    renderer.draw(camera, options, target.width(), target.height());
    glFinish();
    if (i >= 3) times.push_back(milliseconds_since(start));
  }
  std::sort(times.begin(), times.end());
  return {times[times.size() / 2], times.back(), renderer.statistics()};
}

void draw(const std::shared_ptr<const MapsSnapshot>& snapshot, int width, int height) {
  const MapsSnapshot& maps = *snapshot;
  const auto context = OffscreenContext::create();
  auto renderer = LandscapeRenderer::create();
  if (!context || !renderer) {
    std::printf("no OpenGL: %s\n", (context ? renderer.error() : context.error()).message.c_str());
    return;
  }
  std::printf("drawn by %s, %d x %d\n", reinterpret_cast<const char*>(glGetString(GL_RENDERER)), width, height);
  const RenderTarget target(width, height);
  constexpr double hour = 9;
  const Camera camera = over_the_herds(maps, hour);
  scrub_in_window(snapshot, camera);
  // The sample has fewer animals than that in sight: herds grow until there are enough.
  int times = 4;
  for (const float quality : {0.5F, 1.0F}) {
    LandscapeOptions options;
    options.hour = hour;
    options.quality = quality;
    DrawnFrames all;
    for (; times <= 64; times *= 2) {
      (*renderer)->set_snapshot(with_larger_herds(maps, times));
      all = frames(**renderer, target, camera, options);
      if (all.statistics.animals >= 2000) break;
    }
    options.animals = false;
    const DrawnFrames none = frames(**renderer, target, camera, options);
    std::printf(
        "quality %.1f, %zu animals in sight: frame p50 %.1f worst %.1f ms (without animals %.1f ms); for the animals %d draw "
        "calls, %zu "
        "triangles\n",
        double(quality), all.statistics.animals, all.median, all.worst, none.median,
        all.statistics.draw_calls - none.statistics.draw_calls, all.statistics.triangles - none.statistics.triangles);
    std::fflush(stdout);
  }
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
  world->details = std::make_shared<AnimalSurroundings>(nullptr, (*maps)->terrain().cell_size, PlantPlacement(*maps));
  HerdSimulation simulation(world);
  scrub(simulation);
  play(simulation, 1, "boids");
  play(simulation, 0, "guides alone");
  int width = 960;
  int height = 540;
  if (count > 2 && std::sscanf(arguments[2], "%dx%d", &width, &height) != 2) return 2;
  draw(*maps, width, height);
  return 0;
}

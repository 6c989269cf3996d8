#include "tests/bench/big_scene.hpp"

#include <epoxy/gl.h>
#include <sys/resource.h>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <ctime>
#include <numeric>
#include <thread>

#include "render/offscreen_context.hpp"

namespace biotope {

namespace {

using Clock = std::chrono::steady_clock;

constexpr double frames_a_second = 60;

double milliseconds_since(Clock::time_point begin) {
  return std::chrono::duration<double, std::milli>(Clock::now() - begin).count();
}

/// Milliseconds of processor time of this thread.
double thread_milliseconds() {
  timespec time{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
  return double(time.tv_sec) * 1e3 + double(time.tv_nsec) * 1e-6;
}

/// Milliseconds of processor time of all threads.
double process_milliseconds() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  const auto milliseconds = [](const timeval& time) { return double(time.tv_sec) * 1e3 + double(time.tv_usec) * 1e-3; };
  return milliseconds(usage.ru_utime) + milliseconds(usage.ru_stime);
}

/// From above the south, looking over the land to the north.
Camera over_the_land(const Terrain& terrain) {
  Camera camera;
  camera.position = {0.5 * terrain.width_metres(), 0.03 * terrain.height_metres(), 0};
  camera.position.z = double(ground_height(terrain, camera.position.x, camera.position.y)) + 140;
  camera.pitch = -8;
  camera.vertical_field = 50;
  return camera;
}

struct Row {
  std::vector<double> times;
  void print(const char* what) {
    std::sort(times.begin(), times.end());
    const auto share = [&](double part) { return times[std::min(times.size() - 1, std::size_t(part * double(times.size())))]; };
    std::printf("  %s p50 %6.1f p95 %6.1f worst %6.1f", what, share(0.5), share(0.95), times.back());
  }
};

/// Frames of a camera that goes on at a speed (m/s).
void measure(LandscapeRenderer& renderer, const char* name, Camera camera, LandscapeOptions options, double speed, int width,
             int height, int frames) {
  const RenderTarget target(width, height);
  renderer.finish_loading(camera, options);
  Row window;
  Row all;
  Row whole;
  std::size_t most_bytes = 0;
  const auto frame = [&] {
    options.seconds += 1 / frames_a_second;
    options.hour += 1 / frames_a_second / 3600;
    camera.position += speed / frames_a_second * glm::dvec3(camera.forward().x, camera.forward().y, 0);
    target.bind();
    (void)renderer.bring_in(options);
    renderer.draw(camera, options, width, height);
    glFinish();
  };
  // As a window's frames follow each other: other threads work between them.
  auto next = Clock::now();
  const auto wait = [&] {
    std::this_thread::sleep_until(next);
    next = std::max(next + std::chrono::microseconds(int(1e6 / frames_a_second)), Clock::now());
  };
  constexpr double warm_up = 2000;  // ms
  for (const auto begin = Clock::now(); milliseconds_since(begin) < warm_up; frame()) wait();
  for (int i = 0; i < frames; ++i) {
    wait();
    const double thread = thread_milliseconds();
    const double process = process_milliseconds();
    const auto begin = Clock::now();
    frame();
    whole.times.push_back(milliseconds_since(begin));
    window.times.push_back(thread_milliseconds() - thread);
    all.times.push_back(process_milliseconds() - process);
    most_bytes = std::max(most_bytes, renderer.statistics().instance_bytes);
  }
  const LandscapeStatistics& drawn = renderer.statistics();
  std::printf("%-8s %8zu plants, %5zu animals, %4d calls, %5.2f million triangles, ", name, drawn.plants, drawn.animals,
              drawn.draw_calls, double(drawn.triangles) / 1e6);
  std::printf("instances %5.1f MB (most %5.1f, allowed %5.1f)\n", double(drawn.instance_bytes) / 1e6, double(most_bytes) / 1e6,
              double(drawn.most_instance_bytes) / 1e6);
  window.print("window's thread");
  all.print("| all threads");
  whole.print("| passed");
  std::printf(" ms\n");
  std::fflush(stdout);
}

/// Paints a value over a whole map.
void paint_all(Document& document, const LayerId& layer, float value) {
  const Grid<float>& height = document.terrain->height;
  PaintLayer paint(height.width(), height.height());
  PaintLayer::Tile tile;
  tile.fill({value, 1});
  const auto shared = std::make_shared<const PaintLayer::Tile>(tile);
  for (std::size_t t = 0; t < paint.tile_count(); ++t) paint.set_tile(t, shared);
  document.layers[layer] = std::make_shared<const PaintLayer>(std::move(paint));
}

}  // namespace

Document crowded(const MapsSnapshot& solved, const Crowding& crowding) {
  Document document = solved.document;
  const FoodWeb& web = *solved.web;
  const Terrain& terrain = solved.terrain();
  for (const auto& [stratum, covered] : {std::pair(Stratum::tree, crowding.trees), std::pair(Stratum::shrub, crowding.shrubs)}) {
    const auto grows = [&](int s) { return web.species[std::size_t(s)].plant().stratum == stratum; };
    const auto kinds = std::count_if(web.levels[0].begin(), web.levels[0].end(), grows);
    for (const int s : web.levels[0]) {
      if (!grows(s) || covered <= 0) continue;
      paint_all(document, {LayerKind::plant_density, web.species[std::size_t(s)].name}, covered / float(kinds));
    }
  }
  const double square_kilometres = terrain.width_metres() * terrain.height_metres() / 1e6;
  for (const auto& level : solved.animals) {
    for (std::size_t s = 0; s < level->species.size(); ++s) {
      const double individuals = std::accumulate(level->population[s].begin(), level->population[s].end(), 0.0);
      paint_all(document, {LayerKind::animal_density, web.species[std::size_t(level->species[s])].name},
                float(double(crowding.animals) * individuals / square_kilometres));
    }
  }
  return document;
}

void measure_big_scene(LandscapeRenderer& renderer, const std::shared_ptr<const MapsSnapshot>& snapshot, float quality, int width,
                       int height, int frames) {
  LandscapeOptions options;
  options.quality = quality;
  options.hour = 8;
  renderer.set_snapshot(snapshot);
  const Camera camera = over_the_land(snapshot->terrain());
  std::printf("quality %.1f, %d x %d, %d frames\n", double(quality), width, height, frames);
  measure(renderer, "standing", camera, options, 0, width, height, frames);
  measure(renderer, "walking", camera, options, 1.5, width, height, frames);
  measure(renderer, "flying", camera, options, 60, width, height, frames);
}

}  // namespace biotope

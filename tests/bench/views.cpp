// How long pictures of the landscape take: the first view at eye height and the one from above, at each quality, while the camera
// turns and walks and leaves and water move; how soon plants answer an edit; what a graphics card is asked to hold.
//   bench_views [SAMPLE] [WIDTHxHEIGHT] [FRAMES] [QUALITY] [big]   SAMPLE: valley (the default), valley-1m, alpine, canyon;
//   960x540; 60; all qualities, or one at eye height alone. 'processor' is the time of all threads: it tells programs apart where
//   others run. big: only the scene of a million plants and two thousand animals (big_scene.hpp); trees=SHARE, shrubs=SHARE and
//   animals=TIMES make it more or less crowded.
#include <epoxy/gl.h>
#include <sys/resource.h>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <string>
#include <vector>

#include "core/exchange/open_input.hpp"
#include "core/pipeline/solve.hpp"
#include "render/landscape_renderer.hpp"
#include "render/offscreen_context.hpp"
#include "tests/bench/big_scene.hpp"

using namespace biotope;

namespace {

using Clock = std::chrono::steady_clock;

double milliseconds_since(Clock::time_point begin) {
  return std::chrono::duration<double, std::milli>(Clock::now() - begin).count();
}

/// Milliseconds of processor time that this process used so far, over all its threads.
double processor_milliseconds() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  const auto milliseconds = [](const timeval& time) { return double(time.tv_sec) * 1e3 + double(time.tv_usec) * 1e-3; };
  return milliseconds(usage.ru_utime) + milliseconds(usage.ru_stime);
}

struct Size {
  int width = 960;
  int height = 540;
};

/// What is measured.
struct Wanted {
  std::vector<float> qualities{0.5F, 1.0F, 2.0F, 4.0F};
  int frames = 60;
  bool rest = false;
  bool calm = false;
  bool big = false;
  Crowding crowding;
  LandscapeOptions options;
};

void leave_out(Wanted& wanted, const std::string& word) {
  LandscapeOptions& options = wanted.options;
  if (word == "shadows") options.shadows = false;
  if (word == "edges") options.smooth_edges = false;
  if (word == "mirror") options.reflections = false;
  if (word == "occlusion") options.occlusion = false;
  if (word == "plants") options.plants = false;
  if (word == "animals") options.animals = false;
  if (word == "rest") wanted.rest = true;
  if (word == "calm") wanted.calm = true;
  if (word == "big") wanted.big = true;
  (void)std::sscanf(word.c_str(), "trees=%f", &wanted.crowding.trees);
  (void)std::sscanf(word.c_str(), "shrubs=%f", &wanted.crowding.shrubs);
  (void)std::sscanf(word.c_str(), "animals=%f", &wanted.crowding.animals);
}

double share_of(const std::vector<double>& sorted, double part) {
  return sorted[std::min(sorted.size() - 1, std::size_t(part * double(sorted.size())))];
}

struct Times {
  std::vector<double> sorted;
  double processor = 0;  ///< ms a frame
};

/// Frames of a camera that walks 0.15 m and turns 0.4 degrees from one to the next.
Times walk(LandscapeRenderer& renderer, const RenderTarget& target, Camera camera, LandscapeOptions options, Size size,
           const Wanted& wanted, int frames) {
  Times times;
  const double before = processor_milliseconds();
  for (int i = 0; i < frames; ++i) {
    if (!wanted.rest) {
      camera.heading += 0.4F;
      camera.position += 0.15 * glm::dvec3(camera.forward().x, camera.forward().y, 0);
    }
    if (!wanted.calm) options.seconds += 1.0 / 25;
    const auto begin = Clock::now();
    target.bind();
    renderer.draw(camera, options, size.width, size.height);
    glFinish();
    times.sorted.push_back(milliseconds_since(begin));
  }
  times.processor = (processor_milliseconds() - before) / frames;
  std::sort(times.sorted.begin(), times.sorted.end());
  return times;
}

void measure(LandscapeRenderer& renderer, const char* name, const Camera& camera, Size size, const Wanted& wanted) {
  const RenderTarget target(size.width, size.height);
  for (const float quality : wanted.qualities) {
    LandscapeOptions options = wanted.options;
    options.quality = quality;
    renderer.finish_loading(camera, options);
    (void)walk(renderer, target, camera, options, size, wanted, 5);
    const Times times = walk(renderer, target, camera, options, size, wanted, wanted.frames);
    const LandscapeStatistics& drawn = renderer.statistics();
    std::printf(
        "%-6s quality %.1f  p50 %6.1f  p90 %6.1f  p99 %6.1f  worst %6.1f ms  %5.1f frames/s  processor %6.1f ms  "
        "%4d calls, %8zu triangles, %8zu plants, %5zu animals, %6.1f MB\n",
        name, double(quality), share_of(times.sorted, 0.5), share_of(times.sorted, 0.9), share_of(times.sorted, 0.99),
        times.sorted.back(), 1000 / share_of(times.sorted, 0.5), times.processor, drawn.draw_calls, drawn.triangles, drawn.plants,
        drawn.animals, double(drawn.instance_bytes) / 1e6);
    std::fflush(stdout);
  }
}

/// From a finished edit to a picture with its plants: a tree species painted away around the camera.
void measure_edit(LandscapeRenderer& renderer, const std::shared_ptr<const MapsSnapshot>& before, const Camera& camera,
                  Size size) {
  const RenderTarget target(size.width, size.height);
  LandscapeOptions options;
  options.quality = 0.5F;
  renderer.finish_loading(camera, options);
  const Terrain& terrain = before->terrain();
  const int x = int(camera.position.x / terrain.cell_size);
  const int y = terrain.height.height() - 1 - int(camera.position.y / terrain.cell_size);
  std::vector<double> times;
  for (int i = 0; i < 10; ++i) {
    auto edited = std::make_shared<MapsSnapshot>(*before);
    edited->revision = before->revision + std::uint64_t(i) + 1;
    CoverMap map = *edited->cover.front();
    for (int row = std::max(0, y - 25); row < std::min(map.height(), y + 25); ++row) {
      for (int column = std::max(0, x - 25); column < std::min(map.width(), x + 25); ++column)
        map.set(column, row, to_cover(0.05F * float(i)));
    }
    edited->cover.front() = std::make_shared<const CoverMap>(std::move(map));
    const auto begin = Clock::now();
    renderer.set_snapshot(edited);
    int frames = 0;
    do {
      target.bind();
      renderer.draw(camera, options, size.width, size.height);
      glFinish();
      ++frames;
    } while (!renderer.complete() && frames < 500);
    times.push_back(milliseconds_since(begin));
  }
  std::sort(times.begin(), times.end());
  std::printf("edit   200 m around the camera until its picture is whole: p50 %.1f  worst %.1f ms\n", share_of(times, 0.5),
              times.back());
}

}  // namespace

int main(int count, char** arguments) {
  const std::string sample = count > 1 ? arguments[1] : "valley";
  Size size;
  if (count > 2 && std::sscanf(arguments[2], "%dx%d", &size.width, &size.height) != 2) return 2;
  Wanted wanted;
  if (count > 3) wanted.frames = std::max(1, std::atoi(arguments[3]));
  if (count > 4) wanted.qualities = {float(std::atof(arguments[4]))};
  for (int i = 5; i < count; ++i) leave_out(wanted, arguments[i]);
  const auto context = OffscreenContext::create();
  if (!context) {
    std::printf("%s\n", context.error().message.c_str());
    return 1;
  }
  std::printf("%s, %d x %d, drawn by %s\n", sample.c_str(), size.width, size.height,
              reinterpret_cast<const char*>(glGetString(GL_RENDERER)));
  auto document = open_input("sample:" + sample, {}, {});
  auto snapshot = document ? solve(*document, nullptr, {}) : tl::unexpected(document.error());
  auto renderer = LandscapeRenderer::create();
  if (!snapshot || !renderer) {
    std::printf("%s\n", (snapshot ? renderer.error() : snapshot.error()).message.c_str());
    return 1;
  }
  if (wanted.big) {
    snapshot = solve(crowded(**snapshot, wanted.crowding), nullptr, {});
    if (!snapshot) return 1;
    measure_big_scene(**renderer, *snapshot, wanted.qualities.front(), size.width, size.height, wanted.frames);
    return 0;
  }
  (*renderer)->set_snapshot(*snapshot);
  measure(**renderer, "eye", first_view(**snapshot), size, wanted);
  measure(**renderer, "above", overview(**snapshot), size, wanted);
  if (count <= 4) measure_edit(**renderer, *snapshot, first_view(**snapshot), size);
  return 0;
}

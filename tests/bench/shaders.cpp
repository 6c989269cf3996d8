// What a change of shaders costs or saves: the first view at eye height, drawn with each of several folders of shaders in turn,
// so that whatever else runs on the machine weighs on all alike. Times are processor time: of all threads, and of the thread that
// draws, which is nearly all that is done per vertex where a processor draws.
//   bench_shaders SAMPLE QUALITY ROUNDS FOLDER...   the first folder is what the others are compared with
#include <epoxy/gl.h>
#include <time.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <memory>
#include <string>
#include <vector>

#include "core/exchange/open_input.hpp"
#include "core/pipeline/solve.hpp"
#include "render/landscape_renderer.hpp"
#include "render/offscreen_context.hpp"

using namespace biotope;

namespace {

double milliseconds_of(clockid_t clock) {
  timespec time{};
  clock_gettime(clock, &time);
  return 1e3 * double(time.tv_sec) + 1e-6 * double(time.tv_nsec);
}

struct Variant {
  std::string folder;
  std::unique_ptr<LandscapeRenderer> renderer;
  std::vector<double> all;      ///< ms a frame
  std::vector<double> drawing;  ///< of the thread that draws
};

double median(std::vector<double> values) {
  std::sort(values.begin(), values.end());
  return values[values.size() / 2];
}

/// The fastest tenth: what the machine does when it is least disturbed.
double low(std::vector<double> values) {
  std::sort(values.begin(), values.end());
  return values[values.size() / 10];
}

void draw(Variant& variant, const Camera& camera, const LandscapeOptions& options, const RenderTarget& target) {
  const double all = milliseconds_of(CLOCK_PROCESS_CPUTIME_ID);
  const double drawing = milliseconds_of(CLOCK_THREAD_CPUTIME_ID);
  target.bind();
  variant.renderer->draw(camera, options, 960, 540);
  glFinish();
  variant.all.push_back(milliseconds_of(CLOCK_PROCESS_CPUTIME_ID) - all);
  variant.drawing.push_back(milliseconds_of(CLOCK_THREAD_CPUTIME_ID) - drawing);
}

}  // namespace

int main(int count, char** arguments) {
  if (count < 5) {
    std::printf("bench_shaders SAMPLE QUALITY ROUNDS FOLDER...\n");
    return 2;
  }
  const auto context = OffscreenContext::create();
  auto document = open_input(std::string("sample:") + arguments[1], {}, {});
  auto snapshot = document ? solve(*document, nullptr, {}) : tl::unexpected(document.error());
  if (!context || !snapshot) {
    std::printf("%s\n", (context ? snapshot.error() : context.error()).message.c_str());
    return 1;
  }
  LandscapeOptions options;
  options.quality = float(std::atof(arguments[2]));
  const int rounds = std::max(1, std::atoi(arguments[3]));
  const RenderTarget target(960, 540);
  const Camera camera = first_view(**snapshot);
  std::vector<Variant> variants;
  for (int i = 4; i < count; ++i) {
    setenv("BIOTOPE_SHADERS", arguments[i], 1);
    auto renderer = LandscapeRenderer::create();
    if (!renderer) {
      std::printf("%s\n", renderer.error().message.c_str());
      return 1;
    }
    variants.push_back({arguments[i], std::move(*renderer), {}, {}});
    Variant& variant = variants.back();
    variant.renderer->set_snapshot(*snapshot);
    variant.renderer->finish_loading(camera, options);
    for (int warm = 0; warm < 2; ++warm) draw(variant, camera, options, target);
    variant.all.clear();
    variant.drawing.clear();
  }
  for (int round = 0; round < rounds; ++round) {
    for (Variant& variant : variants) draw(variant, camera, options, target);
  }
  for (const Variant& variant : variants) {
    std::printf("%-40s all threads: median %6.1f low %6.1f ms (%5.1f %%)   drawing thread: median %6.1f low %6.1f ms\n",
                variant.folder.c_str(), median(variant.all), low(variant.all), 100 * low(variant.all) / low(variants.front().all),
                median(variant.drawing), low(variant.drawing));
  }
  return 0;
}

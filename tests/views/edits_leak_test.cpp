#include <epoxy/gl.h>

#include <catch2/catch.hpp>
#include <fstream>
#include <string>

#include "render/landscape_renderer.hpp"
#include "render/offscreen_context.hpp"
#include "tests/render/sample_plants.hpp"

using namespace biotope;
using namespace biotope::test;

namespace {

/// Buffers, textures, arrays, framebuffers and programs that are alive in the current context.
int live_objects() {
  int count = 0;
  for (GLuint name = 1; name < 20000; ++name) {
    count += (glIsBuffer(name) ? 1 : 0) + (glIsTexture(name) ? 1 : 0) + (glIsVertexArray(name) ? 1 : 0) +
             (glIsFramebuffer(name) ? 1 : 0) + (glIsProgram(name) ? 1 : 0);
  }
  return count;
}

/// Memory of this process, MB.
double resident_megabytes() {
  std::ifstream status("/proc/self/statm");
  long pages = 0;
  long resident = 0;
  status >> pages >> resident;
  return double(resident) * 4096 / 1e6;
}

}  // namespace

TEST_CASE("a thousand edits leave nothing behind: neither OpenGL objects nor memory") {
  const auto context = OffscreenContext::create();
  if (!context) {
    WARN("No OpenGL here: " << context.error().message);
    return;
  }
  auto renderer = LandscapeRenderer::create();
  if (!renderer) FAIL(renderer.error().message);
  const RenderTarget target(64, 48);
  target.bind();
  Camera camera;
  camera.position = {256, 120, 112};
  LandscapeOptions options;
  options.quality = 0.5F;
  auto base = level_landscape();
  cover(*base, 0, 0.2F);
  base->hydrology = river(62, 66);

  const auto edit = [&](int number) {
    auto snapshot = std::make_shared<MapsSnapshot>(*base);
    snapshot->revision = std::uint64_t(number) + 1;
    const int at = number % 90;
    cover(*snapshot, std::size_t(number % 4), {at, at, at + 30, at + 30}, 0.3F);
    (*renderer)->set_snapshot(snapshot);
    if (number % 5 == 0) (*renderer)->finish_loading(camera, options);
    (*renderer)->draw(camera, options, 64, 48);
  };
  for (int i = 0; i < 100; ++i) edit(i);
  (*renderer)->finish_loading(camera, options);
  const int objects = live_objects();
  const double megabytes = resident_megabytes();
  const std::size_t instances = (*renderer)->statistics().instance_bytes;
  for (int i = 100; i < 1000; ++i) edit(i);
  (*renderer)->finish_loading(camera, options);
  CHECK(live_objects() <= objects + 4);
  CHECK(resident_megabytes() < megabytes + 25);
  CHECK(double((*renderer)->statistics().instance_bytes) < 1.5 * double(instances) + 1e6);
  CHECK(glGetError() == GL_NO_ERROR);
}

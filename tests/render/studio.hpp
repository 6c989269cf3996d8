#pragma once

#include <epoxy/gl.h>

#include <catch2/catch.hpp>
#include <cstdlib>
#include <memory>

#include "render/landscape_renderer.hpp"
#include "render/offscreen_context.hpp"

namespace biotope::test {

/// A renderer in a context of its own with a small picture to draw on.
struct Studio {
  std::unique_ptr<OffscreenContext> context;
  std::unique_ptr<LandscapeRenderer> renderer;
  std::unique_ptr<RenderTarget> target;
  LandscapeOptions options;
  Camera camera;
  int width = 0;
  int height = 0;

  /// False, with a warning, where there is no OpenGL.
  bool open(int pixels_across, int pixels_down) {
    auto made = OffscreenContext::create();
    if (!made) {
      WARN("No OpenGL here: " << made.error().message);
      return false;
    }
    context = std::move(*made);
    auto drawn = LandscapeRenderer::create();
    if (!drawn) FAIL(drawn.error().message);
    renderer = std::move(*drawn);
    width = pixels_across;
    height = pixels_down;
    target = std::make_unique<RenderTarget>(width, height);
    camera.heading = 0;
    return true;
  }
  Image draw() {
    target->bind();
    renderer->finish_loading(camera, options);
    renderer->draw(camera, options, width, height);
    CHECK(glGetError() == GL_NO_ERROR);
    return target->read();
  }
};

/// Pixels whose colours are more than `least` apart, over all three channels.
inline int different(const Image& a, const Image& b, int least = 6) {
  int count = 0;
  for (std::size_t i = 0; i < a.rgba.size(); i += 4) {
    int sum = 0;
    for (std::size_t c = 0; c < 3; ++c) sum += std::abs(int(a.rgba[i + c]) - int(b.rgba[i + c]));
    count += sum > least ? 1 : 0;
  }
  return count;
}

}  // namespace biotope::test

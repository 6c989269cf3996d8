#include "render/fall_renderer.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace biotope {

namespace {

/// Quads of a downpour at medium quality. Our choice: a software renderer draws them in a few milliseconds.
constexpr float quads_of_downpour = 5000;

/// Boxes around the eye: near drops are few and large, far ones many and fine.
struct FallBox {
  float half_side;  ///< m
  float share;      ///< of all quads
  float brightness;
  float size;
};
constexpr std::array<FallBox, 2> boxes{{{3.5F, 0.35F, 0.8F, 1.0F}, {14.0F, 0.65F, 0.75F, 1.6F}}};

}  // namespace

int falling_count(const Weather& weather, float quality) {
  if (weather.precipitation <= 0) return 0;
  return int(std::lround(quads_of_downpour * std::sqrt(weather.precipitation) * std::clamp(quality, 0.4F, 2.0F)));
}

Result<FallRenderer> FallRenderer::create() {
  auto program = load_shader_program("landscape/weather_fall.vert", "landscape/weather_fall.frag");
  if (!program) return tl::unexpected(program.error());
  FallRenderer renderer;
  renderer.program_ = std::move(*program);
  renderer.empty_ = make_vertex_array();
  return renderer;
}

int FallRenderer::draw(const Weather& weather, float quality) const {
  const int count = falling_count(weather, quality);
  if (count == 0) return 0;
  program_.use();
  glBindVertexArray(empty_.name());
  glEnable(GL_BLEND);
  // The picture's alpha stays whole.
  glBlendFuncSeparate(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA, GL_ZERO, GL_ONE);
  glDepthMask(GL_FALSE);
  int drawn = 0;
  for (const FallBox& box : boxes) {
    const int quads = int(box.share * float(count));
    program_.set("box", glm::vec4(box.half_side, box.brightness, box.size, 0));
    glDrawArraysInstanced(GL_TRIANGLE_STRIP, 0, 4, quads);
    drawn += quads;
  }
  glDepthMask(GL_TRUE);
  glDisable(GL_BLEND);
  return drawn;
}

}  // namespace biotope

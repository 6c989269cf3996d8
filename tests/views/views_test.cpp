// Pictures of a computed landscape: compared with those that were looked at and kept in tests/views/expected, with the number of
// draw calls, plants and animals beside each. When a change of look is wanted, look at the new ones and keep them:
// BIOTOPE_KEEP_PICTURES=1 build/test/tests/test_views
#include <epoxy/gl.h>

#include <catch2/catch.hpp>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <vector>

#include "render/offscreen_context.hpp"
#include "tests/views/fixed_views.hpp"
#include "tests/views/image_comparison.hpp"
#include "tests/views/sample_maps.hpp"

using namespace biotope;
using namespace biotope::test;

namespace {

constexpr int width = 640;
constexpr int height = 360;

std::filesystem::path expected_file(const std::string& name) {
  return std::filesystem::path(BIOTOPE_SOURCE_DIR) / "tests/views/expected" / name;
}

bool keeps() { return std::getenv("BIOTOPE_KEEP_PICTURES") != nullptr; }

/// A count may be another by a tenth, or by a few where there are few.
void check_count(const char* what, std::size_t seen, std::size_t expected) {
  INFO(what);
  CHECK(double(seen) == Approx(double(expected)).epsilon(0.1).margin(6));
}

/// Compares what a view drew with what was kept beside its picture, or keeps it.
void compare_counts(const std::string& name, const LandscapeStatistics& counts) {
  const std::filesystem::path file = expected_file(name + ".txt");
  if (keeps()) {
    std::ofstream(file) << "draw calls " << counts.draw_calls << "\nplants " << counts.plants << "\nanimals " << counts.animals
                        << "\n";
    return;
  }
  std::ifstream text(file);
  std::string word;
  std::size_t calls = 0;
  std::size_t plants = 0;
  std::size_t animals = 0;
  text >> word >> word >> calls >> word >> plants >> word >> animals;
  if (!text) {
    FAIL_CHECK("There are no counts in " << file.string());
    return;
  }
  check_count("draw calls", std::size_t(counts.draw_calls), calls);
  check_count("plants", counts.plants, plants);
  check_count("animals", counts.animals, animals);
}

Image picture_of(LandscapeRenderer& renderer, const RenderTarget& target, const FixedView& view) {
  renderer.finish_loading(view.camera, view.options);
  target.bind();
  renderer.draw(view.camera, view.options, width, height);
  CHECK(glGetError() == GL_NO_ERROR);
  return halved(target.read());
}

/// Compares a picture with the one that was kept, or keeps it.
void compare(const FixedView& view, const Image& picture) {
  if (keeps()) {
    REQUIRE(write_png(expected_file(view.name + ".png"), picture));
    return;
  }
  const auto expected = read_png(expected_file(view.name + ".png"));
  if (!expected) FAIL_CHECK(expected.error().message);
  if (!expected) return;
  REQUIRE(expected->width == picture.width);
  REQUIRE(expected->height == picture.height);
  const ImageDifference apart = difference(picture, *expected);
  if (apart.mean >= 3 || apart.unlike >= 0.01) {
    const std::string seen = view.name + "-seen.png";
    CHECK(write_png(seen, picture));
    UNSCOPED_INFO("what was drawn is in " << std::filesystem::absolute(seen).string());
  }
  CHECK(apart.mean < 3);
  CHECK(apart.unlike < 0.01);
}

void compare_all(const std::shared_ptr<const MapsSnapshot>& snapshot, const std::vector<FixedView>& views) {
  auto renderer = LandscapeRenderer::create();
  if (!renderer) FAIL(renderer.error().message);
  (*renderer)->set_snapshot(snapshot);
  const RenderTarget target(width, height);
  for (const FixedView& view : views) {
    INFO(view.name);
    const Image picture = picture_of(**renderer, target, view);
    compare_counts(view.name, (*renderer)->statistics());
    CHECK((*renderer)->statistics().triangles < 3000000);
    compare(view, picture);
  }
}

}  // namespace

TEST_CASE("pictures with one leaf moved are alike, pictures with another sky are not") {
  Image picture{64, 64, std::vector<std::uint8_t>(64 * 64 * 4, 100)};
  Image leaf = picture;
  leaf.rgba[4 * 700] = 160;
  CHECK(difference(picture, leaf).worst < 2);
  Image sky = picture;
  for (std::size_t i = 0; i < 64 * 32 * 4; ++i) sky.rgba[i] = 140;
  CHECK(difference(picture, sky).mean == Approx(20));
  CHECK(difference(picture, sky).unlike == Approx(0.5));
}

TEST_CASE("every view of the samples looks as it did when it was last looked at") {
  const auto context = OffscreenContext::create();
  if (!context) {
    WARN("No OpenGL here: " << context.error().message);
    return;
  }
  const auto valley = sample("valley");
  const auto views = fixed_views(*valley);
  CHECK(views.size() >= 14);
  compare_all(valley, views);
  const auto alpine = sample("alpine");
  compare_all(alpine, snow_views(*alpine));
}

#include "render/landscape_renderer.hpp"

#include <epoxy/gl.h>

#include <chrono>
#include <cstdlib>
#include <filesystem>

#include "render/image.hpp"
#include "render/offscreen_context.hpp"
#include "tests/render/sample_plants.hpp"
#include "tests/render/studio.hpp"

using namespace biotope;
using namespace biotope::test;

namespace {

struct WoodStudio : Studio {
  bool make() {
    if (!open(192, 128)) return false;
    camera.position = {256, 120, 112};
    options.quality = 0.5F;
    return true;
  }
};

std::shared_ptr<MapsSnapshot> wooded_landscape() {
  auto snapshot = level_landscape();
  cover(*snapshot, 0, {0, 0, cells, 64}, 0.4F);
  cover(*snapshot, 2, 0.1F);
  cover(*snapshot, 3, 0.6F);
  snapshot->hydrology = river(62, 66);
  return snapshot;
}

double brightness(const Image& image) {
  double sum = 0;
  for (std::size_t i = 0; i < image.rgba.size(); i += 4) sum += image.rgba[i] + image.rgba[i + 1] + image.rgba[i + 2];
  return sum / double(image.rgba.size()) * 4 / 3;
}

/// Pixels that differ visibly.
int visibly_different(const Image& a, const Image& b) { return different(a, b, 12); }

}  // namespace

TEST_CASE("a picture written as PNG is read back the same") {
  Image image{5, 3, {}};
  for (int i = 0; i < 60; ++i) image.rgba.push_back(std::uint8_t(i % 4 == 3 ? 255 : 4 * i));
  const auto file = std::filesystem::temp_directory_path() / "biotope-render-test.png";
  REQUIRE(write_png(file, image));
  const auto read = read_png(file);
  REQUIRE(read);
  CHECK(read->width == 5);
  CHECK(read->height == 3);
  CHECK(read->rgba == image.rgba);
  std::filesystem::remove(file);
}

TEST_CASE("views of many kinds draw without an OpenGL error") {
  WoodStudio studio;
  if (!studio.make()) return;
  (void)studio.draw();  // nothing loaded
  const auto bare = level_landscape();
  bare->web = nullptr;
  bare->cover.clear();
  studio.renderer->set_snapshot(bare);
  (void)studio.draw();
  const auto snapshot = wooded_landscape();
  studio.renderer->set_snapshot(snapshot);
  for (const float pitch : {-89.0F, -30.0F, 0.0F, 60.0F}) {
    studio.camera.pitch = pitch;
    (void)studio.draw();
  }
  studio.camera = overview(*snapshot);
  (void)studio.draw();
  studio.camera = first_view(*snapshot);
  studio.options.brush = glm::vec3(64, 64, 5);
  studio.options.month = 0;
  (void)studio.draw();
}

TEST_CASE("noon is brighter than night") {
  WoodStudio studio;
  if (!studio.make()) return;
  studio.renderer->set_snapshot(wooded_landscape());
  studio.options.hour = 12;
  const double noon = brightness(studio.draw());
  studio.options.hour = 0;
  CHECK(noon > 1.8 * brightness(studio.draw()));
}

TEST_CASE("the same camera twice gives the same picture, wherever one has been between") {
  WoodStudio studio;
  if (!studio.make()) return;
  studio.renderer->set_snapshot(wooded_landscape());
  const Image first = studio.draw();
  studio.camera.position = {60, 400, 130};
  studio.options.month = 10;
  (void)studio.draw();
  studio.camera.position = {256, 120, 112};
  studio.options.month = 5;
  CHECK(visibly_different(first, studio.draw()) == 0);
}

TEST_CASE("hiding plants, a species, water or the summer changes the picture") {
  WoodStudio studio;
  if (!studio.make()) return;
  studio.renderer->set_snapshot(wooded_landscape());
  const Image all = studio.draw();
  const auto drawn = studio.renderer->statistics().plants;
  CHECK(drawn > 100);
  studio.options.plants = false;
  CHECK(visibly_different(all, studio.draw()) > 1000);
  CHECK(studio.renderer->statistics().plants == 0);
  studio.options.plants = true;
  studio.options.visible_species = {false, true, true, true};
  CHECK(visibly_different(all, studio.draw()) > 500);
  CHECK(studio.renderer->statistics().plants < drawn);
  studio.options.visible_species.clear();
  studio.options.water = false;
  CHECK(visibly_different(all, studio.draw()) > 100);
  studio.options.water = true;
  studio.options.month = 0;
  CHECK(visibly_different(all, studio.draw()) > 500);
  studio.options.month = 5;
  CHECK(visibly_different(all, studio.draw()) == 0);
}

TEST_CASE("plants appear over a few frames without finish_loading") {
  WoodStudio studio;
  if (!studio.make()) return;
  studio.renderer->set_snapshot(wooded_landscape());
  studio.target->bind();
  // The ground comes from a thread that stands back: on a busy machine that takes as long as it takes.
  const auto until = std::chrono::steady_clock::now() + std::chrono::seconds(60);
  do {
    studio.renderer->draw(studio.camera, studio.options, 192, 128);
  } while (!studio.renderer->complete() && std::chrono::steady_clock::now() < until);
  CHECK(studio.renderer->complete());
  const Image slow = studio.target->read();
  CHECK(visibly_different(slow, studio.draw()) == 0);
}

TEST_CASE("a ray meets level ground where geometry says, and the sky nowhere") {
  const auto snapshot = level_landscape();
  const Terrain& terrain = snapshot->terrain();
  const auto hit = pick_ground(terrain, {100, 100, 110}, {1, 0, -1});
  REQUIRE(hit);
  CHECK(hit->x == Approx(110).margin(0.01));
  CHECK(hit->y == Approx(100).margin(0.01));
  CHECK(hit->z == Approx(100).margin(0.01));
  CHECK_FALSE(pick_ground(terrain, {100, 100, 110}, {1, 0, 0.1F}));
  CHECK_FALSE(pick_ground(terrain, {100, 100, 110}, {1, 0, -1}, 5));
  CHECK(ground_height(terrain, 250, 250) == 100);
}

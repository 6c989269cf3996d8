#include <epoxy/gl.h>

#include <catch2/catch.hpp>
#include <chrono>
#include <cstdlib>

#include "render/map_renderer.hpp"
#include "render/offscreen_context.hpp"

using namespace biotope;

namespace {

constexpr int side = 64;

std::shared_ptr<MapsSnapshot> flat_landscape() {
  auto terrain = std::make_shared<Terrain>();
  terrain->height = Grid<float>(side, side, 100);
  auto snapshot = std::make_shared<MapsSnapshot>();
  snapshot->document.terrain = terrain;
  return snapshot;
}

std::array<int, 3> pixel(const Image& image, int x, int y) {
  const std::size_t at = (std::size_t(y) * std::size_t(image.width) + std::size_t(x)) * 4;
  return {image.rgba[at], image.rgba[at + 1], image.rgba[at + 2]};
}

int difference(const std::array<int, 3>& a, const std::array<int, 3>& b) {
  return std::abs(a[0] - b[0]) + std::abs(a[1] - b[1]) + std::abs(a[2] - b[2]);
}

/// A renderer in a context of its own, and 128 x 128 pixels to draw on: a cell is two pixels, cell 0 begins at pixel 0.
struct Table {
  std::unique_ptr<OffscreenContext> context;
  std::unique_ptr<MapRenderer> renderer;
  std::unique_ptr<RenderTarget> target;
  MapOptions options;

  bool make() {
    auto made = OffscreenContext::create();
    if (!made) {
      WARN("No OpenGL here: " << made.error().message);
      return false;
    }
    context = std::move(*made);
    auto drawn = MapRenderer::create();
    REQUIRE(drawn);
    renderer = std::move(*drawn);
    target = std::make_unique<RenderTarget>(128, 128);
    options.view = {side / 2.0 - 0.5, side / 2.0 - 0.5, 2};
    options.contours = false;
    return true;
  }
  Image draw() {
    target->bind();
    renderer->finish_loading(options);
    renderer->draw(options, 128, 128);
    return target->read();
  }
};

}  // namespace

TEST_CASE("without a landscape the map is empty, with one it covers its cells and no more") {
  Table table;
  if (!table.make()) return;
  const auto empty = pixel(table.draw(), 64, 64);
  table.renderer->set_snapshot(flat_landscape());
  table.options.view.pixels_per_cell = 1;
  const Image image = table.draw();
  CHECK(table.renderer->complete());
  CHECK(difference(pixel(image, 64, 64), empty) > 60);
  CHECK(difference(pixel(image, 64, 64), pixel(image, 2, 2)) > 60);
  CHECK(difference(pixel(image, 40, 40), pixel(image, 90, 90)) < 6);  // flat ground has one tone
}

TEST_CASE("the northern edge is at the top, and an overlay's cells are where they belong") {
  Table table;
  if (!table.make()) return;
  table.renderer->set_snapshot(flat_landscape());
  const auto bare = pixel(table.draw(), 20, 20);
  auto cells = std::make_shared<Grid<float>>(side, side, 0.0F);
  for (int y = 0; y < 20; ++y) {
    for (int x = 0; x < 20; ++x) (*cells)(x, y) = 1;
  }
  table.options.overlay = MapOverlay{cells, 0, 1, ColourMap::greens, 1, 0};
  const Image image = table.draw();
  CHECK(difference(pixel(image, 20, 20), bare) > 60);
  CHECK(difference(pixel(image, 20, 100), bare) < 6);  // clear where the map is zero
  CHECK(difference(pixel(image, 100, 20), bare) < 6);
}

TEST_CASE("a patch uploads the cells of its rectangle and no others") {
  Table table;
  if (!table.make()) return;
  table.renderer->set_snapshot(flat_landscape());
  auto cells = std::make_shared<Grid<float>>(side, side, 0.0F);
  table.options.overlay = MapOverlay{cells, 0, 1, ColourMap::greens, 1, 0};
  const Image before = table.draw();
  for (float& cell : cells->cells()) cell = 1;
  table.renderer->patch_overlay(*cells, {0, 0, 20, 20});
  const Image after = table.draw();
  CHECK(difference(pixel(after, 20, 20), pixel(before, 20, 20)) > 60);
  CHECK(difference(pixel(after, 100, 100), pixel(before, 100, 100)) == 0);
}

TEST_CASE("unknown values are clear, not the lowest colour") {
  Table table;
  if (!table.make()) return;
  table.renderer->set_snapshot(flat_landscape());
  const auto bare = pixel(table.draw(), 64, 64);
  auto cells = std::make_shared<Grid<float>>(side, side, NAN);
  table.options.overlay = MapOverlay{cells, 0, 1, ColourMap::inferno, 1, NAN};
  CHECK(difference(pixel(table.draw(), 64, 64), bare) < 6);
}

TEST_CASE("paint is hatched where it covers") {
  Table table;
  if (!table.make()) return;
  table.renderer->set_snapshot(flat_landscape());
  const Image plain = table.draw();
  PaintLayer layer(side, side);
  for (int y = 10; y < 50; ++y) {
    for (int x = 10; x < 50; ++x) layer.set(x, y, {1, 1});
  }
  table.options.hatched = std::make_shared<PaintLayer>(layer);
  const Image hatched = table.draw();
  int changed = 0;
  for (int x = 30; x < 90; ++x) changed += difference(pixel(plain, x, 60), pixel(hatched, x, 60)) > 10 ? 1 : 0;
  CHECK(changed > 5);
  CHECK(changed < 55);
  CHECK(difference(pixel(plain, 4, 4), pixel(hatched, 4, 4)) == 0);
}

TEST_CASE("a slope that faces the light from the north-west is brighter than one that turns away") {
  Table table;
  if (!table.make()) return;
  auto snapshot = flat_landscape();
  auto terrain = std::make_shared<Terrain>(*snapshot->document.terrain);
  terrain->cell_size = 4;
  for (int y = 0; y < side; ++y) {
    for (int x = 0; x < side; ++x) terrain->height(x, y) = x < side / 2 ? float(2 * x) : float(2 * (side - x));
  }
  snapshot->document.terrain = terrain;
  table.renderer->set_snapshot(snapshot);
  const Image image = table.draw();
  const auto west = pixel(image, 32, 64);  // rises to the east, so it faces west
  const auto east = pixel(image, 96, 64);
  CHECK(west[0] + west[1] + west[2] > east[0] + east[1] + east[2] + 30);
}

TEST_CASE("a brush that redraws a part of the map leaves the picture that drawing all of it makes") {
  Table table;
  if (!table.make()) return;
  auto snapshot = flat_landscape();
  auto terrain = std::make_shared<Terrain>(*snapshot->document.terrain);
  for (int y = 0; y < side; ++y) {
    for (int x = 0; x < side; ++x) terrain->height(x, y) = float(x * x + 3 * y) / 7;
  }
  snapshot->document.terrain = terrain;
  table.renderer->set_snapshot(snapshot);
  table.options.contours = true;
  table.options.line_step = 0.2F;
  auto cells = std::make_shared<Grid<float>>(side, side, 0.0F);
  auto paint = std::make_shared<PaintLayer>(side, side);
  table.options.overlay = MapOverlay{cells, 0, 1, ColourMap::greens, 1, 0};
  table.options.hatched = std::make_shared<PaintLayer>(*paint);
  for (const double zoom : {2.0, 0.6, 5.0}) {
    table.options.view.pixels_per_cell = zoom;
    (void)table.draw();
    for (int y = 20; y < 40; ++y) {
      for (int x = 30; x < 44; ++x) {
        (*cells)(x, y) += 0.1F + 0.002F * float(x);
        paint->set(x, y, {1, 1});
      }
    }
    table.renderer->patch_overlay(*cells, {30, 20, 44, 40});
    table.options.hatched = std::make_shared<PaintLayer>(*paint);
    const Image part = table.draw();
    table.options.dark = false;
    (void)table.draw();
    table.options.dark = true;
    CHECK(part.rgba == table.draw().rgba);
  }
}

TEST_CASE("the map is never waited for: without finish_loading it is there after some frames, and the same") {
  Table table;
  if (!table.make()) return;
  table.renderer->set_snapshot(flat_landscape());
  auto cells = std::make_shared<Grid<float>>(side, side, 0.6F);
  table.options.overlay = MapOverlay{cells, 0, 1, ColourMap::greens, 1, 0};
  table.target->bind();
  const auto until = std::chrono::steady_clock::now() + std::chrono::seconds(60);
  do {
    table.renderer->draw(table.options, 128, 128);
  } while (!table.renderer->complete() && std::chrono::steady_clock::now() < until);
  const Image by_and_by = table.target->read();
  CHECK(table.renderer->complete());
  CHECK(by_and_by.rgba == table.draw().rgba);
  CHECK(glGetError() == GL_NO_ERROR);
}

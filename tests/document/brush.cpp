#include "core/document/brush.hpp"

#include <catch2/catch.hpp>

using namespace biotope;

namespace {

const LayerId layer{LayerKind::plant_density, "pinus"};

Document blank_document() {
  Document document;
  Terrain terrain;
  terrain.height = Grid<float>(128, 128, 0.0F);
  document.terrain = std::make_shared<const Terrain>(std::move(terrain));
  return document;
}

float value_at(const Document& document, const Grid<float>& computed, int x, int y) {
  const auto found = document.layers.find(layer);
  return painted(computed(x, y), found == document.layers.end() ? Paint{} : (*found->second)(x, y));
}

}  // namespace

TEST_CASE("Adding never passes the brush's value and never lowers") {
  Document document = blank_document();
  const Grid<float> computed(128, 128, 0.3F);
  Brush brush{.mode = BrushMode::add, .radius = 20, .strength = 0.7F, .hardness = 0.5F, .value = 0.8F};
  Stroke stroke(layer, &computed);
  float last = 0.3F;
  for (int i = 0; i < 10; ++i) {
    stroke.dab(document, brush, 64, 64);
    const float now = value_at(document, computed, 64, 64);
    CHECK(now >= last);
    CHECK(now <= 0.8F + 1e-5F);
    last = now;
  }
  CHECK(last == Approx(0.8F).margin(1e-3));
  CHECK(value_at(document, computed, 64, 90) == Approx(0.3F));
}

TEST_CASE("Subtracting reaches the floor and no lower") {
  Document document = blank_document();
  const Grid<float> computed(128, 128, 0.5F);
  Brush brush{.mode = BrushMode::subtract, .radius = 10, .strength = 1, .hardness = 1, .value = 1, .floor = 0};
  Stroke stroke(layer, &computed);
  stroke.dab(document, brush, 30, 30);
  CHECK(value_at(document, computed, 30, 30) == Approx(0).margin(1e-6));
  CHECK(value_at(document, computed, 41, 30) == Approx(0.5F));
}

TEST_CASE("Restoring brings the computed map back, cell by cell") {
  Document document = blank_document();
  const Grid<float> computed(128, 128, 0.5F);
  Stroke paint(layer, &computed);
  paint.dab(document, {.mode = BrushMode::set, .radius = 15, .strength = 1, .hardness = 0.2F, .value = 1}, 50, 50);
  CHECK(value_at(document, computed, 50, 50) == Approx(1));
  Stroke restore(layer, &computed);
  restore.dab(document, {.mode = BrushMode::restore_computed, .radius = 30, .strength = 1, .hardness = 1}, 50, 50);
  for (int y = 30; y < 70; ++y) {
    for (int x = 30; x < 70; ++x) REQUIRE(value_at(document, computed, x, y) == computed(x, y));
  }
}

TEST_CASE("Smoothing keeps a flat map flat and lowers a peak") {
  Document document = blank_document();
  Grid<float> computed(128, 128, 0.2F);
  computed(60, 60) = 1;
  Stroke stroke(layer, &computed);
  stroke.dab(document, {.mode = BrushMode::smooth, .radius = 10, .strength = 1, .hardness = 1}, 60, 60);
  CHECK(value_at(document, computed, 60, 60) < 0.5F);
  CHECK(value_at(document, computed, 66, 66) == Approx(0.2F));
}

TEST_CASE("A stroke is one step that dabs evenly along its way and outside the map changes nothing") {
  Document document = blank_document();
  const Grid<float> computed(128, 128, 0.0F);
  const Brush brush{.mode = BrushMode::set, .radius = 5, .strength = 1, .hardness = 1, .value = 1};
  Stroke stroke(layer, &computed);
  stroke.move_to(document, brush, 10, 64);
  stroke.move_to(document, brush, 110, 64);
  for (int x = 10; x <= 108; ++x) REQUIRE(value_at(document, computed, x, 64) == Approx(1));
  auto command = stroke.finish(document);
  REQUIRE(command);
  command->revert(document);
  CHECK(document.layers.empty());

  Stroke outside(layer, &computed);
  CHECK(outside.dab(document, brush, -50, -50).empty());
  CHECK(outside.finish(document) == nullptr);
}

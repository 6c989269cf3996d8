#include <array>
#include <catch2/catch.hpp>
#include <cmath>
#include <limits>

#include "core/base/random.hpp"
#include "core/document/brush.hpp"
#include "tests/document/brush_random.hpp"

using namespace biotope;

namespace {

constexpr std::array kinds{LayerKind::resource, LayerKind::plant_density, LayerKind::animal_density, LayerKind::geology,
                           LayerKind::loss,     LayerKind::passage,       LayerKind::ground};

Paint paint_at(const Document& document, const LayerId& layer, int x, int y) {
  const auto found = document.layers.find(layer);
  return found == document.layers.end() ? Paint{} : (*found->second)(x, y);
}

std::vector<StrokeTarget> target(const LayerId& layer, const Grid<float>& computed, const Grid<float>& source) {
  return {StrokeTarget{layer, &computed, 1, {}, {}, &source}};
}

bool near(Paint a, Paint b) { return std::abs(a.value - b.value) < 1e-3F && std::abs(a.coverage - b.coverage) < 1e-4F; }

}  // namespace

TEST_CASE("A dab changes nothing outside its radius, and says where it changed something") {
  const Grid<float> computed = random_map(150, 110, 3);
  for (std::uint64_t number = 0; number < 120; ++number) {
    const LayerId layer{LayerKind::ground, "height"};
    Document document = flat_document(150, 110);
    const Brush brush = random_brush(number, LayerKind::ground);
    const float x = float(random_unit({number, 20})) * 190 - 20;
    const float y = float(random_unit({number, 21})) * 150 - 20;
    Stroke stroke(target(layer, computed, computed), nullptr);
    const Rect changed = stroke.dab(document, brush, x, y);
    for (int cy = 0; cy < 110; ++cy) {
      for (int cx = 0; cx < 150; ++cx) {
        const bool outside = std::hypot(float(cx) - x, float(cy) - y) >= brush.radius + 1e-3F;
        const Paint paint = paint_at(document, layer, cx, cy);
        REQUIRE_FALSE((outside && paint != Paint{}));
        REQUIRE_FALSE((!changed.contains(cx, cy) && paint != Paint{}));
        REQUIRE((paint == Paint{} || paint.coverage > 0));
      }
    }
  }
}

TEST_CASE("A mirrored dab on a mirrored map gives mirrored paint") {
  constexpr int width = 150;
  const Grid<float> computed = random_map(width, 100, 5);
  Grid<float> mirrored(width, 100);
  for (int y = 0; y < 100; ++y) {
    for (int x = 0; x < width; ++x) mirrored(x, y) = computed(width - 1 - x, y);
  }
  const LayerId layer{LayerKind::ground, "height"};
  for (std::uint64_t number = 0; number < 60; ++number) {
    Brush brush = random_brush(number, LayerKind::ground);
    if (brush.mode == BrushMode::noise) continue;  // noise has a place of its own
    const float x = float(random_int(0, 2 * width, {number, 22})) / 2;
    const float y = float(random_int(0, 200, {number, 23})) / 2;
    Document one = flat_document(width, 100);
    Document other = flat_document(width, 100);
    Stroke(target(layer, computed, computed), nullptr).dab(one, brush, x, y);
    Stroke(target(layer, mirrored, mirrored), nullptr).dab(other, brush, float(width - 1) - x, y);
    for (int cy = 0; cy < 100; ++cy) {
      for (int cx = 0; cx < width; ++cx) REQUIRE(near(paint_at(one, layer, cx, cy), paint_at(other, layer, width - 1 - cx, cy)));
    }
  }
}

TEST_CASE("Final values stay in the legal range of their layer under any strokes") {
  for (const LayerKind kind : kinds) {
    const LayerId layer{kind, "any"};
    const Range legal = legal_range(kind);
    Grid<float> computed(100, 100, kind == LayerKind::resource ? 4.0F : kind == LayerKind::geology ? 1.0F : 0.2F);
    const Grid<float> source = random_map(100, 100, 8);
    Document document = flat_document(100, 100);
    Stroke stroke(target(layer, computed, source), nullptr);
    for (std::uint64_t number = 0; number < 60; ++number) {
      Brush brush = random_brush(number, kind);
      brush.value *= 3;  // a person may ask for more than there can be
      stroke.dab(document, brush, float(random_unit({number, 20})) * 100, float(random_unit({number, 21})) * 100);
    }
    for (int y = 0; y < 100; ++y) {
      for (int x = 0; x < 100; ++x) {
        const Paint paint = paint_at(document, layer, x, y);
        const float value = painted(computed(x, y), paint);
        REQUIRE(value >= legal.low - 1e-5F);
        REQUIRE(value <= legal.high + std::abs(legal.high) * 1e-6F);
        REQUIRE((paint.coverage >= 0 && paint.coverage <= 1));
        if (kind == LayerKind::geology) REQUIRE(paint.value == std::round(paint.value));
      }
    }
  }
}

TEST_CASE("Copies of the document never change while a stroke goes on") {
  const Grid<float> computed = random_map(150, 110, 3);
  const LayerId layer{LayerKind::ground, "height"};
  Document document = flat_document(150, 110);
  Stroke stroke(target(layer, computed, computed), nullptr);
  std::vector<Document> copies;
  std::vector<Grid<Paint>> as_they_were;
  for (std::uint64_t number = 0; number < 80; ++number) {
    stroke.move_to(document, random_brush(number, LayerKind::ground), float(random_unit({number, 20})) * 150,
                   float(random_unit({number, 21})) * 110);
    // Some states are kept, some are not: both ways of writing are taken.
    if (number % 3 != 0 || !document.layers.contains(layer)) continue;
    copies.push_back(document);
    as_they_were.push_back(document.layers.at(layer)->to_grid());
  }
  REQUIRE(copies.size() > 10);
  for (std::size_t i = 0; i < copies.size(); ++i) REQUIRE(copies[i].layers.at(layer)->to_grid() == as_they_were[i]);
}

TEST_CASE("A stroke over several frames is the stroke in one, whoever looks at the document in between") {
  const Grid<float> computed = random_map(150, 110, 3);
  const LayerId layer{LayerKind::ground, "height"};
  for (std::uint64_t number = 0; number < 30; ++number) {
    const Brush brush = random_brush(number, LayerKind::ground);
    const std::vector<StrokePoint> points = random_points(number, 150, 110);
    Document one = flat_document(150, 110);
    Document other = flat_document(150, 110);
    Stroke at_once(target(layer, computed, computed), nullptr);
    for (const auto& point : points) at_once.move_to(one, brush, point.x, point.y, point.pressure);
    Stroke in_frames(target(layer, computed, computed), nullptr);
    std::vector<Document> published;
    for (const auto& point : points) {
      published.push_back(other);
      in_frames.move_to(other, brush, point.x, point.y, point.pressure);
    }
    REQUIRE(one.layers.contains(layer) == other.layers.contains(layer));
    if (one.layers.contains(layer)) REQUIRE(one.layers.at(layer)->to_grid() == other.layers.at(layer)->to_grid());
  }
}

TEST_CASE("Numbers that are none, and places far away, paint nothing and do not hang") {
  const Grid<float> computed(64, 64, 1.0F);
  const LayerId layer{LayerKind::ground, "height"};
  Document document = flat_document(64, 64);
  const float nan = std::numeric_limits<float>::quiet_NaN();
  const float infinite = std::numeric_limits<float>::infinity();
  Stroke stroke(layer, &computed);
  Brush brush{.mode = BrushMode::raise, .radius = 10, .strength = 1};
  for (const float bad : {nan, infinite, -infinite, 1e30F}) {
    CHECK(stroke.dab(document, brush, bad, 10).empty());
    CHECK(stroke.dab(document, brush, 10, bad).empty());
    CHECK(stroke.dab(document, brush, 10, 10, bad == infinite || bad == 1e30F ? 0 : bad).empty());
  }
  for (const float bad : {nan, -1.0F, 0.0F}) {
    brush.radius = bad;
    CHECK(stroke.dab(document, brush, 10, 10).empty());
  }
  brush.radius = 10;
  stroke.move_to(document, brush, 1e30F, 1e30F);
  stroke.move_to(document, brush, nan, 5);
  stroke.move_to(document, brush, 1e30F, -1e30F);
  CHECK(document.layers.empty());
}

#include <catch2/catch.hpp>
#include <cmath>

#include "core/document/brush.hpp"

using namespace biotope;

namespace {

const LayerId ground{LayerKind::ground, "height"};
const LayerId rock{LayerKind::geology, "class"};
const LayerId oak{LayerKind::plant_density, "oak"};

Document blank_document(int side = 128) {
  Document document;
  Terrain terrain;
  terrain.height = Grid<float>(side, side, 0.0F);
  document.terrain = std::make_shared<const Terrain>(std::move(terrain));
  return document;
}

Paint paint_at(const Document& document, const LayerId& layer, int x, int y) {
  const auto found = document.layers.find(layer);
  return found == document.layers.end() ? Paint{} : (*found->second)(x, y);
}

float value_at(const Document& document, const LayerId& layer, const Grid<float>& computed, int x, int y) {
  return painted(computed(x, y), paint_at(document, layer, x, y));
}

void one_dab(Document& document, const LayerId& layer, const Grid<float>& computed, const Brush& brush, float x, float y,
             float pressure = 1) {
  Stroke stroke(layer, &computed);
  stroke.dab(document, brush, x, y, pressure);
}

/// A blurred step from 0 to 10 along x.
Grid<float> slope_at_64() {
  Grid<float> map(128, 128);
  for (int y = 0; y < 128; ++y) {
    for (int x = 0; x < 128; ++x) map(x, y) = std::clamp(float(x - 54) * 0.5F, 0.0F, 10.0F);
  }
  return map;
}

}  // namespace

TEST_CASE("Raising and lowering move the ground by value times weight, each dab again") {
  Document document = blank_document();
  const Grid<float> computed(128, 128, 100.0F);
  const Brush up{.mode = BrushMode::raise, .radius = 8, .strength = 0.5F, .hardness = 1, .value = 5};
  one_dab(document, ground, computed, up, 40, 40);
  CHECK(value_at(document, ground, computed, 40, 40) == Approx(102.5F));
  CHECK(value_at(document, ground, computed, 46, 40) == Approx(102.5F));
  CHECK(paint_at(document, ground, 48, 40) == Paint{});
  one_dab(document, ground, computed, up, 40, 40);
  CHECK(value_at(document, ground, computed, 40, 40) == Approx(105.0F));
  Brush down = up;
  down.mode = BrushMode::lower;
  down.value = 400;
  one_dab(document, ground, computed, down, 40, 40);
  CHECK(value_at(document, ground, computed, 40, 40) == Approx(-95.0F));
}

TEST_CASE("Falloff curves have their own weight half way to the rim") {
  const Grid<float> computed(128, 128, 0.0F);
  const auto half_way = [&](Falloff falloff, float hardness, int x) {
    Document document = blank_document();
    one_dab(document, ground, computed,
            {.mode = BrushMode::raise, .radius = 20, .strength = 1, .hardness = hardness, .value = 1, .falloff = falloff}, 50,
            50);
    return value_at(document, ground, computed, x, 50);
  };
  CHECK(half_way(Falloff::linear, 0, 60) == Approx(0.5F));
  CHECK(half_way(Falloff::smooth, 0, 60) == Approx(0.5F));
  CHECK(half_way(Falloff::sphere, 0, 60) == Approx(std::sqrt(0.75F)));
  CHECK(half_way(Falloff::sharp, 0, 60) == Approx(0.25F));
  // With half of it hard, the curve begins there.
  CHECK(half_way(Falloff::linear, 0.5F, 60) == Approx(1.0F));
  CHECK(half_way(Falloff::linear, 0.5F, 65) == Approx(0.5F));
  for (const Falloff falloff : {Falloff::smooth, Falloff::linear, Falloff::sphere, Falloff::sharp}) {
    CHECK(half_way(falloff, 0, 50) == 1.0F);
    CHECK(half_way(falloff, 0, 70) == 0.0F);
  }
}

TEST_CASE("Noise goes up and down, never by more than its value, and is the same for the same seed") {
  const Grid<float> computed(128, 128, 50.0F);
  Brush brush{.mode = BrushMode::noise, .radius = 50, .strength = 1, .hardness = 1, .value = 3, .noise_size = 7, .noise_seed = 4};
  Document one = blank_document();
  Document again = blank_document();
  Document other = blank_document();
  one_dab(one, ground, computed, brush, 64, 64);
  one_dab(again, ground, computed, brush, 64, 64);
  brush.noise_seed = 5;
  one_dab(other, ground, computed, brush, 64, 64);
  float least = 50;
  float greatest = 50;
  double sum = 0;
  int cells = 0;
  for (int y = 34; y < 94; ++y) {
    for (int x = 34; x < 94; ++x, ++cells) {
      const float value = value_at(one, ground, computed, x, y);
      // Coherent: neighbours are near each other.
      REQUIRE(std::abs(value - value_at(one, ground, computed, x + 1, y)) < 2.0F);
      least = std::min(least, value);
      greatest = std::max(greatest, value);
      sum += double(value) - 50;
    }
  }
  CHECK(least >= 47.0F);
  CHECK(least < 49.0F);
  CHECK(greatest <= 53.0F);
  CHECK(greatest > 51.0F);
  CHECK(std::abs(sum / cells) < 0.3);
  CHECK(*one.layers.at(ground) == *again.layers.at(ground));
  CHECK_FALSE(*one.layers.at(ground) == *other.layers.at(ground));
}

TEST_CASE("Cloning copies another map from an offset, and nothing from beyond its border") {
  Grid<float> source(128, 128);
  for (int y = 0; y < 128; ++y) {
    for (int x = 0; x < 128; ++x) source(x, y) = float(x) + 1000 * float(y);
  }
  const Grid<float> computed(128, 128, -1.0F);
  Document document = blank_document();
  StrokeTarget target;
  target.layer = ground;
  target.computed = &computed;
  target.clone_source = &source;
  Stroke stroke({target}, nullptr);
  stroke.dab(document, {.mode = BrushMode::clone, .radius = 6, .strength = 1, .hardness = 1, .clone_offset = {10, -20}}, 115, 60);
  CHECK(value_at(document, ground, computed, 115, 60) == Approx(125 + 1000 * 40));
  CHECK(value_at(document, ground, computed, 117, 57) == Approx(127 + 1000 * 37));
  CHECK(paint_at(document, ground, 118, 60) == Paint{});
  Stroke nothing({StrokeTarget{ground, &computed, 1, {}, {}, nullptr}}, nullptr);
  CHECK(nothing.dab(document, {.mode = BrushMode::clone, .radius = 6, .strength = 1}, 20, 20).empty());
}

TEST_CASE("Smoothing widens with the brush, keeps a slope a slope, and keeps the mean of rough ground") {
  Grid<float> peak(128, 128, 0.0F);
  peak(64, 64) = 100;
  const auto after = [&](float radius) {
    Document document = blank_document();
    one_dab(document, ground, peak, {.mode = BrushMode::smooth, .radius = radius, .strength = 1, .hardness = 1}, 64, 64);
    return value_at(document, ground, peak, 64, 64);
  };
  CHECK(smoothing_reach(3) == 1);
  CHECK(after(8) == Approx(100.0F / 9));
  CHECK(smoothing_reach(48) == 6);
  CHECK(after(48) == Approx(100.0F / 169));

  const Grid<float> slope = slope_at_64();
  Document document = blank_document();
  one_dab(document, ground, slope, {.mode = BrushMode::smooth, .radius = 30, .strength = 1, .hardness = 1}, 64, 64);
  CHECK(value_at(document, ground, slope, 64, 64) == Approx(slope(64, 64)));

  Grid<float> rough(128, 128);
  for (int y = 0; y < 128; ++y) {
    for (int x = 0; x < 128; ++x) rough(x, y) = 500 + float((x * 7 + y * 13) % 11);
  }
  Document smoothed = blank_document();
  one_dab(smoothed, ground, rough, {.mode = BrushMode::smooth, .radius = 40, .strength = 0.8F, .hardness = 0}, 64, 64);
  double before = 0;
  double now = 0;
  double spread = 0;
  for (int y = 20; y < 108; ++y) {
    for (int x = 20; x < 108; ++x) {
      before += double(rough(x, y));
      now += double(value_at(smoothed, ground, rough, x, y));
      if (std::hypot(x - 64, y - 64) < 5)
        spread = std::max(spread, std::abs(double(value_at(smoothed, ground, rough, x, y)) - 505));
    }
  }
  CHECK(now == Approx(before).epsilon(1e-5));
  CHECK(spread < 2);
}

TEST_CASE("A dab of smoothing on flat ground leaves no paint") {
  Document document = blank_document();
  const Grid<float> flat(128, 128, 0.3F);
  Stroke stroke(oak, &flat);
  CHECK(stroke.dab(document, {.mode = BrushMode::smooth, .radius = 30, .strength = 1}, 60, 60).empty());
  CHECK(document.layers.empty());
  CHECK(stroke.finish(document) == nullptr);
}

TEST_CASE("Sharpening steepens an edge and never passes the values around it") {
  Document document = blank_document();
  const Grid<float> slope = slope_at_64();
  Stroke stroke(ground, &slope);
  const Brush brush{.mode = BrushMode::sharpen, .radius = 40, .strength = 0.7F, .hardness = 1};
  for (int i = 0; i < 100; ++i) stroke.dab(document, brush, 64, 64);
  CHECK(value_at(document, ground, slope, 50, 64) == Approx(0).margin(1e-4));
  CHECK(value_at(document, ground, slope, 78, 64) == Approx(10).margin(1e-4));
  float steepest = 0;
  for (int y = 30; y < 98; ++y) {
    for (int x = 30; x < 98; ++x) {
      const float value = value_at(document, ground, slope, x, y);
      REQUIRE(value >= -1e-4F);
      REQUIRE(value <= 10 + 1e-4F);
      steepest = std::max(steepest, value_at(document, ground, slope, x + 1, y) - value);
    }
  }
  CHECK(steepest > 2.0F);
}

TEST_CASE("Pressure makes dabs smaller and fainter where it is asked to") {
  const Grid<float> computed(128, 128, 0.0F);
  Brush brush{.mode = BrushMode::raise, .radius = 20, .strength = 1, .hardness = 1, .value = 8};
  Document faint = blank_document();
  one_dab(faint, ground, computed, brush, 50, 50, 0.25F);
  CHECK(value_at(faint, ground, computed, 50, 50) == Approx(2.0F));
  CHECK(value_at(faint, ground, computed, 65, 50) == Approx(2.0F));
  brush.pressure_sizes = true;
  brush.pressure_strengthens = false;
  Document small = blank_document();
  one_dab(small, ground, computed, brush, 50, 50, 0.25F);
  CHECK(value_at(small, ground, computed, 54, 50) == Approx(8.0F));
  CHECK(paint_at(small, ground, 56, 50) == Paint{});
  Document none = blank_document();
  one_dab(none, ground, computed, brush, 50, 50, 0);
  CHECK(none.layers.empty());
}

TEST_CASE("Spacing counts in radii, and pressure changes evenly along a line") {
  const Grid<float> computed(128, 128, 0.0F);
  Document document = blank_document();
  const Brush brush{.mode = BrushMode::raise, .radius = 4, .strength = 1, .hardness = 1, .value = 1, .spacing = 5};
  Stroke stroke(ground, &computed);
  stroke.move_to(document, brush, 10, 50, 0);
  stroke.move_to(document, brush, 90, 50, 1);
  CHECK(value_at(document, ground, computed, 30, 50) == Approx(0.25F));
  CHECK(value_at(document, ground, computed, 50, 50) == Approx(0.5F));
  CHECK(value_at(document, ground, computed, 90, 50) == Approx(1.0F));
  CHECK(paint_at(document, ground, 40, 50) == Paint{});
}

TEST_CASE("A stamp gives the dab its shape, and turns clockwise") {
  // The north-western quarter of the stamp is full, the north-eastern one half full.
  auto stamp = std::make_shared<Grid<float>>(8, 8, 0.0F);
  for (int y = 0; y < 4; ++y) {
    for (int x = 0; x < 8; ++x) (*stamp)(x, y) = x < 4 ? 1.0F : 0.5F;
  }
  const Grid<float> computed(128, 128, 0.0F);
  /// North-west, north-east, south-east and south-west of the centre.
  const auto quarters = [&](float turn) {
    Document document = blank_document();
    one_dab(document, ground, computed,
            {.mode = BrushMode::raise, .radius = 20, .strength = 1, .value = 2, .stamp = stamp, .stamp_turn = turn}, 64, 64);
    std::vector<int> values;
    for (const auto& [dx, dy] : {std::pair{-10, -10}, {10, -10}, {10, 10}, {-10, 10}}) {
      values.push_back(int(std::lround(value_at(document, ground, computed, 64 + dx, 64 + dy))));
    }
    return values;
  };
  CHECK(quarters(0) == std::vector{2, 1, 0, 0});
  CHECK(quarters(90) == std::vector{0, 2, 1, 0});
  CHECK(quarters(180) == std::vector{0, 0, 2, 1});
  CHECK(quarters(-90) == std::vector{1, 0, 0, 2});
}

TEST_CASE("A stamp that turns by chance turns with the place and the seed only") {
  auto stamp = std::make_shared<Grid<float>>(8, 8, 0.0F);
  for (int y = 0; y < 8; ++y) (*stamp)(0, y) = 1;
  const Grid<float> computed(128, 128, 0.0F);
  Brush brush{.mode = BrushMode::raise,
              .radius = 10,
              .strength = 1,
              .value = 1,
              .noise_seed = 3,
              .stamp = stamp,
              .stamp_turns_by_chance = true};
  const auto stamped = [&](float x) {
    Document document = blank_document();
    one_dab(document, ground, computed, brush, x, 64);
    Grid<float> around(29, 29);
    for (int dy = -14; dy <= 14; ++dy) {
      for (int dx = -14; dx <= 14; ++dx) around(dx + 14, dy + 14) = value_at(document, ground, computed, int(x) + dx, 64 + dy);
    }
    return around;
  };
  const Grid<float> here = stamped(40);
  CHECK(here == stamped(40));
  CHECK_FALSE(here == stamped(80));
  brush.noise_seed = 9;
  CHECK_FALSE(here == stamped(40));
}

TEST_CASE("Classes of rock are never mixed") {
  const Grid<float> computed(128, 128, 0.0F);
  Document document = blank_document();
  one_dab(document, rock, computed, {.mode = BrushMode::set, .radius = 20, .strength = 1, .hardness = 0.3F, .value = 2}, 50, 64);
  one_dab(document, rock, computed, {.mode = BrushMode::set, .radius = 20, .strength = 0.3F, .hardness = 0.3F, .value = 4}, 64,
          64);
  CHECK(paint_at(document, rock, 50, 64).value == 2.0F);
  CHECK(paint_at(document, rock, 64, 64).value == 4.0F);
  for (int y = 30; y < 100; ++y) {
    for (int x = 20; x < 100; ++x) {
      const Paint paint = paint_at(document, rock, x, y);
      REQUIRE((paint == Paint{} || paint.value == 2.0F || paint.value == 4.0F));
      REQUIRE(paint.coverage <= 1.0F);
    }
  }
  const Document before = document;
  for (const BrushMode mode : {BrushMode::add, BrushMode::subtract, BrushMode::smooth, BrushMode::sharpen, BrushMode::noise,
                               BrushMode::raise, BrushMode::lower}) {
    one_dab(document, rock, computed, {.mode = mode, .radius = 20, .strength = 1, .value = 1}, 60, 64);
  }
  CHECK(document.layers == before.layers);
  one_dab(document, rock, computed, {.mode = BrushMode::set, .radius = 5, .strength = 1, .hardness = 1, .value = 77}, 50, 64);
  CHECK(paint_at(document, rock, 50, 64).value == float(geology_classes - 1));
  one_dab(document, rock, computed, {.mode = BrushMode::restore_computed, .radius = 60, .strength = 1, .hardness = 1}, 60, 64);
  CHECK(document.layers.empty());
}

TEST_CASE("Several layers are painted at once, each with its weight and value, and locked ones not at all") {
  const LayerId pine{LayerKind::plant_density, "pine"};
  const LayerId beech{LayerKind::plant_density, "beech"};
  const Grid<float> computed(128, 128, 0.0F);
  Document document = blank_document();
  document.layer_states[beech].locked = true;
  StrokeTarget strong{oak, &computed, 1, {}, {}, nullptr};
  StrokeTarget weak{pine, &computed, 0.5F, 0.4F, {}, nullptr};
  StrokeTarget locked{beech, &computed, 1, {}, {}, nullptr};
  Stroke stroke({strong, weak, locked}, nullptr);
  stroke.dab(document, {.mode = BrushMode::set, .radius = 10, .strength = 1, .hardness = 1, .value = 0.8F}, 60, 60);
  CHECK(value_at(document, oak, computed, 60, 60) == Approx(0.8F));
  CHECK(value_at(document, pine, computed, 60, 60) == Approx(0.2F));
  CHECK_FALSE(document.layers.contains(beech));
  auto command = stroke.finish(document);
  REQUIRE(command);
  CHECK(command->name() == "Paint oak and 1 more");
  command->revert(document);
  CHECK(document.layers.empty());
  command->apply(document);
  CHECK(value_at(document, pine, computed, 60, 60) == Approx(0.2F));
}

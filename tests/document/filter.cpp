#include <catch2/catch.hpp>
#include <cmath>

#include "core/base/random.hpp"
#include "core/document/brush.hpp"
#include "core/document/brush_filter.hpp"
#include "tests/document/brush_random.hpp"

using namespace biotope;

namespace {

FilterCondition between(FilterQuantity quantity, float low, float high, float softness = 0, bool inverted = false) {
  FilterCondition condition;
  condition.quantity = quantity;
  condition.low = low;
  condition.high = high;
  condition.softness = softness;
  condition.inverted = inverted;
  return condition;
}

}  // namespace

TEST_CASE("A condition passes its interval and fades outside over its softness") {
  const auto slope = between(FilterQuantity::slope, 10, 20, 4);
  CHECK(condition_weight(slope, 10) == 1.0F);
  CHECK(condition_weight(slope, 20) == 1.0F);
  CHECK(condition_weight(slope, 9) == Approx(0.75F));
  CHECK(condition_weight(slope, 22) == Approx(0.5F));
  CHECK(condition_weight(slope, 25) == 0.0F);
  CHECK(condition_weight(between(FilterQuantity::slope, 10, 20, 4, true), 22) == Approx(0.5F));
  CHECK(condition_weight(between(FilterQuantity::slope, 10, 20, 0, true), 15) == 0.0F);
  CHECK(condition_weight(between(FilterQuantity::slope, 20, 10), 15) == 1.0F);
  CHECK(condition_weight(slope, std::nanf("")) == 0.0F);
}

TEST_CASE("Aspect wraps around north, and flat ground faces nowhere") {
  const auto north = between(FilterQuantity::aspect, 315, 45, 10);
  CHECK(condition_weight(north, 0) == 1.0F);
  CHECK(condition_weight(north, 330) == 1.0F);
  CHECK(condition_weight(north, 359.9F) == 1.0F);
  CHECK(condition_weight(north, 40) == 1.0F);
  CHECK(condition_weight(north, 50) == Approx(0.5F));
  CHECK(condition_weight(north, 310) == Approx(0.5F));
  CHECK(condition_weight(north, 180) == 0.0F);
  CHECK(condition_weight(north, -1) == 0.0F);
  const auto east = between(FilterQuantity::aspect, 45, 135);
  CHECK(condition_weight(east, 90) == 1.0F);
  CHECK(condition_weight(east, 0) == 0.0F);
  CHECK(condition_weight(east, 300) == 0.0F);
  CHECK(condition_weight(between(FilterQuantity::aspect, 0, 360), 200) == 1.0F);
  // Softness reaches across north.
  CHECK(condition_weight(between(FilterQuantity::aspect, 2, 90, 10), 357) == Approx(0.5F));
}

TEST_CASE("A filter is the product of its conditions, and what is not known lets everything pass") {
  FilterMaps maps;
  maps.slope = std::make_shared<const Grid<float>>(4, 4, 22.0F);
  maps.altitude = std::make_shared<const Grid<float>>(4, 4, 900.0F);
  const LayerId moisture{LayerKind::resource, "moisture"};
  maps.values[moisture] = std::make_shared<const Grid<float>>(4, 4, 7.0F);
  BrushFilter filter;
  CHECK(filter_weight(filter, maps, 1, 1) == 1.0F);
  filter.conditions.push_back(between(FilterQuantity::slope, 10, 20, 4));
  filter.conditions.push_back(between(FilterQuantity::altitude, 1000, 2000, 200));
  CHECK(filter_weight(filter, maps, 1, 1) == Approx(0.25F));
  filter.conditions.push_back(between(FilterQuantity::water_distance, 0, 5));
  CHECK(filter_weight(filter, maps, 1, 1) == Approx(0.25F));
  FilterCondition wet = between(FilterQuantity::map, 1, 3);
  wet.map = moisture;
  filter.conditions.push_back(wet);
  CHECK(filter_weight(filter, maps, 1, 1) == 0.0F);
}

TEST_CASE("A filter of weight 0 changes nothing, and half a weight does half as much") {
  const Grid<float> computed(128, 128, 100.0F);
  FilterMaps maps;
  maps.altitude = std::make_shared<const Grid<float>>(computed);
  const LayerId ground{LayerKind::ground, "height"};
  for (std::uint64_t number = 0; number < 40; ++number) {
    Brush brush = random_brush(number, LayerKind::ground);
    brush.filter.conditions.push_back(between(FilterQuantity::altitude, 200, 300, 50));
    Document document = flat_document(128, 128);
    Stroke stroke({StrokeTarget{ground, &computed, 1, {}, {}, &computed}}, &maps);
    CHECK(stroke.dab(document, brush, 64, 64).empty());
    CHECK(document.layers.empty());
  }
  Brush brush{.mode = BrushMode::raise, .radius = 10, .strength = 1, .hardness = 1, .value = 6};
  brush.filter.conditions.push_back(between(FilterQuantity::altitude, 110, 300, 20));
  Document document = flat_document(128, 128);
  Stroke({StrokeTarget{ground, &computed, 1, {}, {}, nullptr}}, &maps).dab(document, brush, 64, 64);
  CHECK(painted(100, (*document.layers.at(ground))(64, 64)) == Approx(103.0F));
}

TEST_CASE("The selection weighs every dab, unless the filter does not ask for it") {
  const Grid<float> computed(128, 128, 0.0F);
  const LayerId ground{LayerKind::ground, "height"};
  Brush brush{.mode = BrushMode::raise, .radius = 30, .strength = 1, .hardness = 1, .value = 10};
  Document document = flat_document(128, 128);
  SelectionMask mask = rectangle_selection(128, 128, {50, 50}, {70, 70});
  mask.set(60, 60, 51);
  document.selection = std::make_shared<const SelectionMask>(std::move(mask));
  Stroke stroke(ground, &computed);
  stroke.dab(document, brush, 64, 64);
  CHECK((*document.layers.at(ground))(55, 55).value == 10.0F);
  CHECK((*document.layers.at(ground))(60, 60).value == Approx(2.0F));
  CHECK((*document.layers.at(ground))(49, 55) == Paint{});
  CHECK((*document.layers.at(ground))(71, 70) == Paint{});
  brush.filter.use_selection = false;
  stroke.dab(document, brush, 64, 64);
  CHECK((*document.layers.at(ground))(49, 55).value == 10.0F);
}

TEST_CASE("Distances are those of a search over all wet cells") {
  for (std::uint64_t number = 0; number < 30; ++number) {
    const int width = random_int(1, 90, {number, 1});
    const int height = random_int(1, 40, {number, 2});
    // From none to about one in four.
    const int wet_cells = number % 3 == 0 ? int(number) / 3 : random_int(0, width * height / 4, {number, 3});
    Grid<std::uint8_t> wet(width, height);
    std::vector<std::pair<int, int>> places;
    for (std::uint64_t i = 0; i < std::uint64_t(wet_cells); ++i) {
      places.emplace_back(random_int(0, width - 1, {number, 4, i}), random_int(0, height - 1, {number, 5, i}));
      wet(places.back().first, places.back().second) = 1;
    }
    const Grid<float> distances = distance_to(wet, 2.5);
    for (int y = 0; y < height; ++y) {
      for (int x = 0; x < width; ++x) {
        int nearest = -1;
        for (const auto& [wx, wy] : places) {
          const int squared = (wx - x) * (wx - x) + (wy - y) * (wy - y);
          if (nearest < 0 || squared < nearest) nearest = squared;
        }
        REQUIRE(distances(x, y) == (nearest < 0 ? no_distance : float(std::sqrt(double(nearest)) * 2.5)));
      }
    }
  }
}

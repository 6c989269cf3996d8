#include <catch2/catch.hpp>
#include <cmath>
#include <set>

#include "tests/ui/small_landscape.hpp"
#include "ui/canvas_menu.hpp"
#include "ui/map_cache.hpp"
#include "ui/map_furniture.hpp"

using namespace biotope;

TEST_CASE("each tab offers its maps, every one with a title of its own") {
  const auto snapshot = small_landscape();
  for (int tab = 0; tab < tab_count; ++tab) {
    std::set<std::string> titles;
    for (const MapEntry& entry : maps_of_tab(Tab(tab), snapshot->web.get(), 3)) {
      CAPTURE(entry.title);
      CHECK(titles.insert(entry.title).second);
      CHECK(describe_map(entry.id, snapshot->web.get()).title == entry.title);
    }
    CHECK_FALSE(titles.empty());
  }
  CHECK(maps_of_tab(Tab::plants, nullptr, -1).size() == 4);  // terrain and three groups while species are not known
}

TEST_CASE("a monthly map names its month, a yearly one says so") {
  CHECK(describe_map({MapKind::moisture, 0, 3}, nullptr).title == "Moisture, April");
  CHECK(describe_map({MapKind::moisture, 0, -1}, nullptr).title == "Moisture, yearly mean");
}

TEST_CASE("a layer of paint and its map lead to each other") {
  const auto snapshot = small_landscape();
  const FoodWeb& web = *snapshot->web;
  for (const LayerId& layer : {LayerId{LayerKind::plant_density, "grass"}, LayerId{LayerKind::animal_density, "deer"},
                               LayerId{LayerKind::resource, "temperature"}}) {
    CHECK(layer_of_map(map_of_layer(layer, web), web) == layer);
  }
  CHECK_FALSE(layer_of_map({MapKind::slope}, web));
  CHECK_FALSE(layer_of_map({MapKind::plant_cover, 99}, web));
}

TEST_CASE("species have names for people") {
  const auto snapshot = small_landscape();
  CHECK(display_name(snapshot->web->species[0]) == "Grass");
  CHECK(display_name(snapshot->web->species[1]) == "Cervus");
}

TEST_CASE("the height map is the terrain itself") {
  const auto snapshot = small_landscape();
  const MapValues values = build_map(*snapshot, {MapKind::height});
  REQUIRE(values.cells);
  CHECK(values.low == 0);
  CHECK(values.high == 69);
  CHECK(values.cells.get() == &snapshot->terrain().height);
}

TEST_CASE("a cover map holds fractions") {
  const auto snapshot = small_landscape();
  const MapValues values = build_map(*snapshot, {MapKind::plant_cover, 0});
  REQUIRE(values.cells);
  CHECK((*values.cells)(3, 4) == Approx(0.5));
  CHECK(values.high == Approx(0.5));
  CHECK(value_at(*snapshot, {MapKind::plant_cover, 0}, 3, 4) == Approx(0.5));
}

TEST_CASE("a map whose parts are not computed is unknown, not zero") {
  const auto snapshot = small_landscape();
  CHECK_FALSE(build_map(*snapshot, {MapKind::slope}).cells);
  CHECK_FALSE(build_map(*snapshot, {MapKind::temperature}).cells);
  CHECK_FALSE(build_map(*snapshot, {MapKind::plant_cover, 7}).cells);
  CHECK(std::isnan(value_at(*snapshot, {MapKind::slope}, 1, 1)));
  CHECK(std::isnan(value_at(*snapshot, {MapKind::height}, -1, 1)));
}

TEST_CASE("what lies under paint on animals is the computed density of each region") {
  const auto snapshot = small_landscape();
  const auto computed = computed_under(*snapshot, {LayerKind::animal_density, "deer"});
  REQUIRE(computed);
  CHECK((*computed)(0, 0) == Approx(12 / (40 * 66 * 100 / 1e6)));
  CHECK((*computed)(40, 0) == 0);
  CHECK((*computed)(60, 0) == 0);
  CHECK_FALSE(computed_under(*snapshot, {LayerKind::plant_density, "nobody"}));
}

TEST_CASE("a place lists what is there, plants first, and leaves out what is not") {
  const auto snapshot = small_landscape();
  const auto here = present_at(*snapshot, 3, 4);
  REQUIRE(here.size() == 2);
  CHECK(here[0].species == 0);
  CHECK(here[0].amount == Approx(0.5));
  CHECK(here[1].species == 1);
  CHECK(present_at(*snapshot, 60, 4).empty());
  CHECK(present_at(*snapshot, -5, 4).empty());
}

TEST_CASE("the cache answers at once with nothing, later with the map, and makes it only once") {
  const auto snapshot = small_landscape();
  MapCache cache;
  const MapId id{MapKind::plant_cover, 0};
  CHECK_FALSE(cache.request(snapshot, id).values.cells);
  cache.wait_idle();
  const auto first = cache.request(snapshot, id);
  REQUIRE(first.values.cells);
  CHECK(first.current);
  CHECK(cache.value(id, 3, 4) == Approx(0.5));
  CHECK_FALSE(cache.value(id, 300, 4));
  CHECK(cache.request(snapshot, id).values.cells == first.values.cells);
}

TEST_CASE("a newer landscape shows the old map, marked as old, until its own is made") {
  const auto snapshot = small_landscape();
  MapCache cache;
  const MapId id{MapKind::plant_cover, 0};
  (void)cache.request(snapshot, id);
  cache.wait_idle();
  const auto next = std::make_shared<MapsSnapshot>(*snapshot);
  CHECK(cache.request(next, id).current);  // the same cover, by pointer
  CoverMap cover = *next->cover[0];
  cover.set(3, 4, 240);
  next->cover[0] = std::make_shared<CoverMap>(cover);
  const auto old = cache.request(next, id);
  CHECK_FALSE(old.current);
  CHECK((*old.values.cells)(3, 4) == Approx(0.5));
  cache.wait_idle();
  CHECK((*cache.request(next, id).values.cells)(3, 4) == Approx(1));
}

TEST_CASE("a colour scale always has a width") {
  const MapEntry cover = describe_map({MapKind::plant_cover, 0}, nullptr);
  CHECK(scale_range(cover, 0, 0).high > 0);
  CHECK(scale_range(cover, 0, 0.4F).high == 1);
  const MapEntry height = describe_map({MapKind::height}, nullptr);
  const ScaleRange flat = scale_range(height, 100, 100);
  CHECK(flat.high > flat.low);
  CHECK(flat.low == 100);
}

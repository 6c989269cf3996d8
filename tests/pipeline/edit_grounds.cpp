#include "core/pipeline/edit_grounds.hpp"

#include <catch2/catch.hpp>

#include <cmath>

#include "core/pipeline/snapshot_difference.hpp"
#include "core/pipeline/solve.hpp"
#include "tests/scenes/small_valley.hpp"

using namespace biotope;

namespace {

Document valley() {
  auto document = scenes::small_document(std::string(BIOTOPE_SOURCE_DIR) + "/assets");
  if (!document) FAIL(document.error().message);
  return *document;
}

std::shared_ptr<const MapsSnapshot> solved(const Document& document) {
  auto maps = solve(document);
  if (!maps) FAIL(maps.error().message);
  return *maps;
}

/// Paint of one value all over.
std::shared_ptr<const PaintLayer> flat_paint(const Document& document, float value) {
  const auto& height = document.terrain->height;
  return std::make_shared<const PaintLayer>(tiled(Grid<Paint>(height.width(), height.height(), Paint{value, 1})));
}

/// One layer of every kind that the small valley has.
std::vector<LayerId> every_layer(const MapsSnapshot& maps) {
  const FoodWeb& web = *maps.web;
  const std::string plant = web.species[std::size_t(web.levels[0][0])].name;
  const std::string animal = web.species[std::size_t(web.levels[1][0])].name;
  const std::string hunter = web.species[std::size_t(web.levels[2][0])].name;
  return {{LayerKind::resource, "illumination"}, {LayerKind::resource, "temperature"}, {LayerKind::resource, "moisture"},
          {LayerKind::resource, "texture"},      {LayerKind::plant_density, plant},    {LayerKind::animal_density, animal},
          {LayerKind::animal_density, hunter},   {LayerKind::geology, "class"},        {LayerKind::loss, plant},
          {LayerKind::passage, "all"},           {LayerKind::ground, "height"}};
}

}  // namespace

TEST_CASE("Every layer has a computed map of the terrain's size under it") {
  const auto maps = solved(valley());
  const EditGrounds grounds = edit_grounds(maps);
  for (const LayerId& layer : every_layer(*maps)) {
    INFO(int(layer.kind) << " " << layer.name);
    const auto map = grounds.computed(layer);
    REQUIRE(map);
    CHECK(map->rect() == maps->terrain().height.rect());
    CHECK(grounds.computed(layer) == map);
    CHECK(computed_map_source(*maps, layer));
  }
  CHECK((*grounds.computed({LayerKind::ground, "height"}))(7, 9) == maps->document.terrain->height(7, 9));
  CHECK((*grounds.computed({LayerKind::passage, "all"}))(7, 9) == 0);
  CHECK((*grounds.computed({LayerKind::geology, "class"}))(7, 9) == float((*maps->environment->geology)(7, 9)));
  CHECK((*grounds.computed({LayerKind::resource, "moisture"}))(7, 9) == maps->environment->map(Resource::moisture).mean(7, 9));
}

TEST_CASE("Under its own paint a layer's computed map stays as it is") {
  const Document plain = valley();
  const auto before = solved(plain);
  for (const LayerId& layer : every_layer(*before)) {
    if (layer.kind == LayerKind::ground) continue;  // a flat ground would be another valley; it is tested below
    INFO(int(layer.kind) << " " << layer.name);
    Document painted = plain;
    painted.layers[layer] = flat_paint(plain, 1);
    // Paint never reaches what is computed below it, so there is no need to go further than the map's own level.
    const auto after = solved(painted);
    CHECK(*computed_map(*after, layer) == *computed_map(*before, layer));
  }
  Document raised = plain;
  const auto& height = plain.terrain->height;
  Grid<Paint> paint(height.width(), height.height());
  for (std::size_t i = 0; i < paint.size(); ++i) paint[i] = {height[i] + 50, 1};
  raised.layers[{LayerKind::ground, "height"}] = std::make_shared<const PaintLayer>(tiled(paint));
  const auto after = solved(raised);
  CHECK(*computed_map(*after, {LayerKind::ground, "height"}) == height);
  CHECK((*filter_map(*after, FilterQuantity::altitude))(3, 4) == Approx(height(3, 4) + 50));
}

TEST_CASE("Layers that do not exist have no map") {
  const auto maps = solved(valley());
  CHECK_FALSE(computed_map(*maps, {LayerKind::plant_density, "dodo"}));
  CHECK_FALSE(computed_map(*maps, {LayerKind::animal_density, "dodo"}));
  CHECK_FALSE(computed_map(*maps, {LayerKind::resource, "gold"}));
  CHECK_FALSE(computed_map(*maps, {LayerKind::animal_density, maps->web->species[std::size_t(maps->web->levels[0][0])].name}));
  // They never will: waiting for them would wait for ever.
  CHECK(holds(*maps, {{{LayerKind::plant_density, "dodo"}}, {}}));
}

TEST_CASE("Filter maps tell slope, altitude, aspect and distance to water of the ground") {
  MapsSnapshot maps;
  Terrain terrain;
  terrain.cell_size = 2;
  terrain.height = Grid<float>(5, 5);
  // Falls 2 m a cell of 2 m to the east: 45 degrees, facing east.
  for (int y = 0; y < 5; ++y) {
    for (int x = 0; x < 5; ++x) terrain.height(x, y) = 100 - 2 * float(x);
  }
  maps.document.terrain = maps.land = std::make_shared<const Terrain>(terrain);
  CHECK_FALSE(filter_map(maps, FilterQuantity::slope));
  CHECK_FALSE(filter_map(maps, FilterQuantity::water_distance));
  maps.derivatives = std::make_shared<const Derivatives>(compute_derivatives(terrain));
  Hydrology water;
  water.water = Grid<WaterKind>(5, 5, WaterKind::dry);
  water.water(0, 2) = WaterKind::river;
  maps.hydrology = std::make_shared<const Hydrology>(water);
  CHECK((*filter_map(maps, FilterQuantity::slope))(2, 2) == Approx(45));
  CHECK((*filter_map(maps, FilterQuantity::aspect))(2, 2) == Approx(90));
  CHECK((*filter_map(maps, FilterQuantity::altitude))(3, 1) == 94);
  CHECK((*filter_map(maps, FilterQuantity::water_distance))(3, 2) == Approx(6));
  CHECK((*filter_map(maps, FilterQuantity::water_distance))(3, 6 - 2) == Approx(std::hypot(6.0, 4.0)));
  const FilterCondition slope{FilterQuantity::slope, {}, 0, 30, 0, false};
  const EditGrounds grounds = edit_grounds(std::make_shared<const MapsSnapshot>(maps), std::span(&slope, 1));
  CHECK(grounds.filters.slope);
  CHECK_FALSE(grounds.filters.aspect);
}

TEST_CASE("Only edits that read computed maps need them") {
  StrokeEdit stroke;
  stroke.targets = {{{LayerKind::plant_density, "quercus"}, 1, {}, {}}};
  stroke.brush.mode = BrushMode::add;
  CHECK(needs_of(stroke).computed.size() == 1);
  stroke.brush.mode = BrushMode::set;
  CHECK(needs_of(stroke).empty());
  stroke.brush.mode = BrushMode::restore_computed;
  CHECK(needs_of(stroke).empty());
  stroke.brush.filter.conditions.push_back({FilterQuantity::map, {LayerKind::resource, "moisture"}, 0, 1, 0, false});
  CHECK(needs_of(stroke).computed == std::vector<LayerId>{{LayerKind::resource, "moisture"}});
  CHECK(needs_of(ClearEdit{{LayerKind::ground, "height"}}).empty());
  CHECK(needs_of(MixEdit{{LayerKind::loss, "a"}, {LayerKind::loss, "b"}, nullptr, LayerMix::over}).empty());
  CHECK_FALSE(needs_of(MixEdit{{LayerKind::loss, "a"}, {LayerKind::loss, "b"}, nullptr, LayerMix::maximum}).empty());
  SelectEdit select;
  select.shape = SelectEdit::Shape::range;
  select.range.quantity = FilterQuantity::slope;
  CHECK(needs_of(select).conditions.size() == 1);
  MapsSnapshot bare;
  bare.document = valley();
  CHECK_FALSE(holds(bare, needs_of(select)));
  CHECK(holds(bare, {{{LayerKind::ground, "height"}}, {}}));
}

TEST_CASE("Snapshots of the same document do not differ, and a difference is named") {
  Document document = valley();
  const auto maps = solved(document);
  CHECK(snapshot_difference(*maps, *solved(document)).empty());
  const std::string plant = maps->web->species[std::size_t(maps->web->levels[0][0])].name;
  document.layers[{LayerKind::plant_density, plant}] = flat_paint(document, 0.5F);
  CHECK(snapshot_difference(*maps, *solved(document)) == "cover of " + plant);
  document = maps->document;
  document.seed = 2;
  CHECK_FALSE(snapshot_difference(*maps, *solved(document)).empty());
}

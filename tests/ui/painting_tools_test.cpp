#include <catch2/catch.hpp>
#include <cmath>

#include "tests/ui/small_landscape.hpp"
#include "ui/edit_actions.hpp"
#include "ui/editor_actions.hpp"
#include "ui/layer_actions.hpp"
#include "ui/mask_outline.hpp"
#include "ui/paint_targets.hpp"
#include "ui/tool_gestures.hpp"

using namespace biotope;

namespace {

const LayerId grass{LayerKind::plant_density, "grass"};
const LayerId herb{LayerKind::plant_density, "herb"};
const LayerId ground{LayerKind::ground, "height"};

/// An editor on the small landscape with two grasses, without a worker; a hard brush of 3 cells paints 'grass'.
void show_small(EditorState& state) {
  auto snapshot = small_landscape();
  auto web = std::make_shared<FoodWeb>(*snapshot->web);
  Species second = web->species[0];
  second.name = "herb";
  web->species.push_back(second);
  web->level = {0, 1, 0};
  web->levels = {{0, 2}, {1}};
  web->diets.resize(3);
  snapshot->web = web;
  auto species = std::make_shared<std::vector<Species>>(web->species);
  snapshot->document.species = species;
  snapshot->land = snapshot->document.terrain;
  snapshot->computed_cover.push_back(snapshot->computed_cover[0]);
  snapshot->cover = snapshot->computed_cover;
  state.document = snapshot->document;
  state.has_document = true;
  state.ground.height_range = {0, 69};
  state.newest = state.shown = snapshot;
  state.brush.radius = 3;
  state.brush.strength = 1;
  state.brush.hardness = 1;
  state.tool = Tool::add;
  select_species(state, 0);
  state.view.tab = Tab::plants;
}

float value_of(const EditorState& state, const LayerId& layer, int x, int y, float computed = 0) {
  const auto paint = active_paint(state.document, layer);
  return painted(computed, paint ? (*paint)(x, y) : Paint{});
}

void click(EditorState& state, PathPoint at, ToolKeys keys = {}) {
  press_tool(state, at, keys);
  release_tool(state);
}

void drag(EditorState& state, std::initializer_list<PathPoint> points, ToolKeys keys = {}) {
  press_tool(state, *points.begin(), keys);
  for (const PathPoint& point : points) drag_tool(state, point);
  release_tool(state);
}

}  // namespace

TEST_CASE("Shift draws a straight line from the last point, as one step") {
  EditorState state;
  show_small(state);
  click(state, {10, 10});
  CHECK(value_of(state, grass, 30, 10) == 0);
  click(state, {50, 10}, {.control = false, .shift = true});
  for (int x = 10; x <= 50; ++x) {
    CAPTURE(x);
    CHECK(value_of(state, grass, x, 10) == Approx(1));
  }
  CHECK(value_of(state, grass, 30, 20) == 0);
  CHECK(state.history.names().size() == 2);
}

TEST_CASE("Ctrl takes the value under the pointer, and then paints it elsewhere") {
  EditorState state;
  show_small(state);
  CHECK(chosen_value(state, grass, ValueUse::reach) == 1);
  click(state, {3, 4}, {.control = true, .shift = false});
  CHECK(chosen_value(state, grass, ValueUse::reach) == Approx(0.5));
  CHECK(state.history.names().empty());
  click(state, {30, 30});
  CHECK(value_of(state, grass, 30, 30) == Approx(0.5));
}

TEST_CASE("several species are painted by their weights, as one step") {
  EditorState state;
  show_small(state);
  toggle_species(state, 2);
  state.paint.weights["grass"] = 0.75F;
  state.paint.weights["herb"] = 0.25F;
  click(state, {40, 40});
  CHECK(value_of(state, grass, 40, 40) == Approx(0.75));
  CHECK(value_of(state, herb, 40, 40) == Approx(0.25));
  REQUIRE(state.history.names().size() == 1);
  undo(state);
  CHECK(value_of(state, grass, 40, 40) == 0);
  CHECK(value_of(state, herb, 40, 40) == 0);
}

TEST_CASE("an event takes from each species what its weight says, up to the brush's value") {
  EditorState state;
  show_small(state);
  toggle_species(state, 2);
  show_map(state, {MapKind::loss, 0});
  REQUIRE(paint_target(state) == LayerId{LayerKind::loss, "grass"});
  REQUIRE(painted_layers(state).size() == 2);
  choose_value(state, {LayerKind::loss, "grass"}, ValueUse::reach, 0.8F);
  state.paint.weights["herb"] = 0.5F;
  click(state, {40, 40});
  CHECK(value_of(state, {LayerKind::loss, "grass"}, 40, 40) == Approx(0.8));
  CHECK(value_of(state, {LayerKind::loss, "herb"}, 40, 40) == Approx(0.4));
}

TEST_CASE("a locked or hidden layer says why it cannot be painted, and stays as it is") {
  EditorState state;
  show_small(state);
  set_layer_locked(state, grass, true);
  CHECK_FALSE(paint_hindrance(state).empty());
  click(state, {40, 40});
  state.tool = Tool::fill;
  click(state, {40, 40});
  CHECK_FALSE(state.document.layers.contains(grass));
  set_layer_locked(state, grass, false);
  CHECK(state.document.layer_states.empty());
  set_layer_hidden(state, grass, true);
  CHECK_FALSE(paint_hindrance(state).empty());
  undo(state);
  CHECK(paint_hindrance(state).empty());
}

TEST_CASE("fill paints what is selected and nothing else") {
  EditorState state;
  show_small(state);
  state.tool = Tool::select_rectangle;
  drag(state, {{10, 10}, {20, 20}});
  REQUIRE(state.document.selection);
  state.tool = Tool::fill;
  choose_value(state, grass, ValueUse::reach, 0.6F);
  click(state, {60, 60});
  CHECK(value_of(state, grass, 15, 15) == Approx(0.6));
  CHECK(value_of(state, grass, 40, 40) == 0);
  CHECK(state.history.names().size() == 2);
  undo(state);
  CHECK(value_of(state, grass, 15, 15) == 0);
  undo(state);
  CHECK_FALSE(state.document.selection);
}

TEST_CASE("a selection grows with Shift, shrinks with Ctrl, and goes with a click beside it") {
  EditorState state;
  show_small(state);
  state.tool = Tool::select_rectangle;
  drag(state, {{10, 10}, {20, 20}});
  drag(state, {{30, 10}, {40, 20}}, {.control = false, .shift = true});
  CHECK(selected(state.document.selection.get(), 15, 15) == 1);
  CHECK(selected(state.document.selection.get(), 35, 15) == 1);
  CHECK(selected(state.document.selection.get(), 25, 15) == 0);
  drag(state, {{5, 5}, {25, 25}}, {.control = true, .shift = false});
  CHECK(selected(state.document.selection.get(), 15, 15) == 0);
  CHECK(selected(state.document.selection.get(), 35, 15) == 1);
  select_shape(state, SelectEdit::Shape::inverse);
  CHECK(selected(state.document.selection.get(), 35, 15) == 0);
  CHECK(selected(state.document.selection.get(), 60, 60) == 1);
  click(state, {5, 5});
  CHECK_FALSE(state.document.selection);
}

TEST_CASE("a lasso selects what is inside its line") {
  EditorState state;
  show_small(state);
  state.tool = Tool::select_lasso;
  drag(state, {{10, 10}, {30, 10}, {20, 30}});
  CHECK(selected(state.document.selection.get(), 20, 15) == 1);
  CHECK(selected(state.document.selection.get(), 11, 28) == 0);
}

TEST_CASE("brushes stay inside the selection, and nothing is painted while nothing is selected") {
  EditorState state;
  show_small(state);
  state.tool = Tool::select_rectangle;
  drag(state, {{0, 0}, {30, 65}});
  state.tool = Tool::add;
  click(state, {30, 30});
  CHECK(value_of(state, grass, 29, 30) == Approx(1));
  CHECK(value_of(state, grass, 32, 30) == 0);
  select_shape(state, SelectEdit::Shape::nothing);
  CHECK_FALSE(paint_hindrance(state).empty());
}

TEST_CASE("a gradient goes from one value to the other along its line") {
  EditorState state;
  show_small(state);
  state.tool = Tool::gradient;
  state.paint.gradient_end = 0;
  drag(state, {{10, 30}, {20, 30}, {60, 30}});
  CHECK(value_of(state, grass, 5, 30) == Approx(1));
  CHECK(value_of(state, grass, 35, 50) == Approx(0.5).margin(0.02));
  CHECK(value_of(state, grass, 65, 30) == Approx(0).margin(0.001));
  CHECK(state.history.names().size() == 1);
}

TEST_CASE("a stroke that is cancelled leaves nothing") {
  EditorState state;
  show_small(state);
  press_tool(state, {40, 40}, {});
  drag_tool(state, {50, 40});
  REQUIRE(tool_active(state));
  cancel_tool(state);
  CHECK_FALSE(tool_active(state));
  CHECK(value_of(state, grass, 40, 40) == 0);
  CHECK(state.history.names().empty());
}

TEST_CASE("the terrain's tab paints the ground: up, down, flat and carved") {
  EditorState state;
  show_small(state);
  state.view.tab = Tab::terrain;
  REQUIRE(paint_target(state) == ground);
  state.brush.radius = 4;
  SECTION("a pass raises by the metres that were asked for") {
    choose_value(state, ground, ValueUse::pass, 5);
    drag(state, {{10, 30}, {50, 30}});
    CHECK(value_of(state, ground, 30, 30, 30) == Approx(35).margin(1));
  }
  SECTION("erasing digs") {
    state.tool = Tool::erase;
    drag(state, {{10, 30}, {50, 30}});
    CHECK(value_of(state, ground, 30, 30, 30) < 27);
  }
  SECTION("flattening brings everything to the height of the beginning") {
    state.tool = Tool::flatten;
    drag(state, {{30, 30}, {40, 30}});
    CHECK(value_of(state, ground, 39, 30, 39) == Approx(30).margin(0.2));
    CHECK(value_of(state, ground, 28, 30, 28) == Approx(30).margin(0.2));
  }
  SECTION("a trench is as deep as was asked along the whole line") {
    state.tool = Tool::carve;
    choose_value(state, ground, ValueUse::depth, 2);
    drag(state, {{10, 30}, {50, 30}});
    for (int x = 16; x <= 44; x += 7) CHECK(value_of(state, ground, x, 30, float(x)) == Approx(x - 2).margin(0.5));
  }
}

TEST_CASE("clone copies from where Ctrl pointed, and the distance stays") {
  EditorState state;
  show_small(state);
  click(state, {20, 20});
  state.tool = Tool::clone;
  click(state, {20, 20}, {.control = true, .shift = false});
  click(state, {50, 50});
  CHECK(value_of(state, grass, 50, 50) == Approx(1));
  CHECK(value_of(state, grass, 20, 20) == Approx(1));
  CHECK(state.paint.clone_offset == PathPoint{-30, -30});
}

TEST_CASE("each tab paints its own: a plant is not painted on the animals' tab") {
  EditorState state;
  show_small(state);
  CHECK(paint_target(state) == grass);
  state.view.tab = Tab::animals;
  CHECK_FALSE(paint_target(state));
  CHECK_FALSE(paint_hindrance(state).empty());
  select_species(state, 1);
  CHECK(paint_target(state) == LayerId{LayerKind::animal_density, "deer"});
  state.view.tab = Tab::climate;
  show_map(state, {MapKind::texture});
  CHECK(paint_target(state) == LayerId{LayerKind::resource, "texture"});
  show_map(state, {MapKind::geology});
  CHECK(paint_target(state) == LayerId{LayerKind::geology, "class"});
  state.tool = Tool::flatten;
  CHECK(paint_target(state) == ground);
}

TEST_CASE("walls are painted as obstacles, gates as ways open to all, and erased again") {
  EditorState state;
  show_small(state);
  const LayerId passage{LayerKind::passage, "all"};
  state.view.tab = Tab::animals;
  show_map(state, {MapKind::passage});
  REQUIRE(paint_target(state) == passage);
  click(state, {30, 30});
  CHECK(value_of(state, passage, 30, 30) == Approx(1));
  state.paint.opens_passages = true;
  click(state, {30, 30});
  CHECK(value_of(state, passage, 30, 30) == Approx(-1));
  state.tool = Tool::erase;
  click(state, {30, 30});
  CHECK(value_of(state, passage, 30, 30) == 0);
}

TEST_CASE("paint is copied to another layer, and to a scene of another size") {
  EditorState state;
  show_small(state);
  click(state, {40, 40});
  copy_layer(state, grass);
  paste_layer(state, herb, LayerMix::replace);
  CHECK(value_of(state, herb, 40, 40) == Approx(1));
  CHECK(state.history.names().size() == 2);
  PaintLayer small(35, 33);
  small.set(20, 20, {0.5F, 1});
  const PaintLayer large = resampled_paint(small, 70, 66);
  CHECK(large(40, 40) == Paint{0.5F, 1});
  CHECK(large(41, 41) == Paint{0.5F, 1});
  CHECK(large(42, 41) == Paint{});
}

TEST_CASE("paint pasted into another kind of layer keeps its place in the range") {
  EditorState state;
  show_small(state);
  PaintLayer half(70, 66);
  half.set(5, 5, {0.5F, 1});
  state.copied = CopiedPaint{grass, std::make_shared<PaintLayer>(half), "Grass"};
  const LayerId moisture{LayerKind::resource, "moisture"};
  paste_layer(state, moisture, LayerMix::replace);
  REQUIRE(state.document.layers.contains(moisture));
  CHECK((*state.document.layers.at(moisture))(5, 5).value == Approx(5));
}

TEST_CASE("back to computed is one step") {
  EditorState state;
  show_small(state);
  click(state, {40, 40});
  clear_paint(state, grass);
  CHECK(value_of(state, grass, 40, 40) == 0);
  CHECK(listed_layers(state.document).empty());
  undo(state);
  CHECK(value_of(state, grass, 40, 40) == Approx(1));
  REQUIRE(listed_layers(state.document).size() == 1);
}

TEST_CASE("every edit is told once it is done") {
  EditorState state;
  show_small(state);
  std::vector<std::string> told;
  state.edit_listener = [&](EditorState& s, const Edit& edit) { told.push_back(edit_name(edit, s.document)); };
  click(state, {40, 40});
  click(state, {40, 40}, {.control = true, .shift = false});
  state.tool = Tool::select_rectangle;
  drag(state, {{10, 10}, {20, 20}});
  change_document(state, "Seed", [](Document& document) { document.seed = 5; });
  CHECK(told.size() == 3);
  CHECK(told == state.history.names());
}

TEST_CASE("a selection's outline goes around it once and along the map's edge") {
  SelectionMask mask(20, 20, 0);
  for (int y = 0; y < 4; ++y) {
    for (int x = 5; x < 9; ++x) mask.set(x, y, 255);
  }
  const auto pieces = outline_of(mask, {0, 0, 20, 20}, 1);
  REQUIRE(pieces.size() == 4);
  float length = 0;
  for (const OutlinePiece& piece : pieces) length += std::abs(piece.x1 - piece.x0) + std::abs(piece.y1 - piece.y0);
  CHECK(length == Approx(16));
  CHECK(outline_of(mask, {6, 1, 8, 3}, 1).empty());  // deep inside there is no border
}

TEST_CASE("the film lies where a filter keeps the brush away") {
  BrushFilter filter;
  filter.conditions = {{FilterQuantity::altitude, {}, 0, 9, 0, false}};
  Grid<float> height(20, 1);
  for (int x = 0; x < 20; ++x) height(x, 0) = float(x);
  FilterMaps maps;
  maps.altitude = std::make_shared<Grid<float>>(height);
  const auto runs = film_of(filter, maps, nullptr, {0, 0, 20, 1}, 1);
  REQUIRE(runs.size() == 1);
  CHECK(runs[0].cells == Rect{10, 0, 20, 1});
  CHECK(runs[0].level == 4);
}

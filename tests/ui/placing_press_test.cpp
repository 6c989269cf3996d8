#include <catch2/catch.hpp>

#include "tests/ui/small_landscape.hpp"
#include "ui/commands.hpp"
#include "ui/editor_actions.hpp"
#include "ui/herd_day.hpp"
#include "ui/placing_actions.hpp"

using namespace biotope;

namespace {

constexpr PointerButton held{true, false, true};
constexpr PointerButton let_go{false, true, false};
constexpr PointerButton resting{false, false, false};

void show(EditorState& state) {
  const auto snapshot = small_landscape();
  state.document = snapshot->document;
  state.document.species = std::make_shared<const std::vector<Species>>(snapshot->web->species);
  state.has_document = true;
  state.newest = state.shown = snapshot;
  state.document.placements.places.fords = {{{20, 20}, 12}};
}

/// Presses on the ford in a view.
void press_ford(EditorState& state, PlacingView view) {
  REQUIRE(press_placing(state, {20, 20}, 3));
  state.placing.took_press = true;
  state.placing.pressed_on = view;
}

PathPoint ford(const EditorState& state) { return state.document.placements.places.fords.front().at; }

}  // namespace

TEST_CASE("Delete means the selected thing wherever the pointer is, while the select tool is in the hand") {
  EditorState state;
  show(state);
  const CommandTable commands(editor_commands());
  const EditorCommand* remove = commands.of_keys(*parse_shortcut("Delete"));
  REQUIRE(remove);
  const LayerId grass{LayerKind::plant_density, "grass"};
  PaintLayer paint(70, 66);
  paint.set(4, 4, {0.5F, 1});
  state.document.layers[grass] = std::make_shared<const PaintLayer>(paint);
  select_species(state, 0);
  state.placing.selected = PlacedItem{PlacedKind::ford, 0};
  run(*remove, state);
  CHECK(state.document.placements.places.fords.empty());
  CHECK(state.document.layers.contains(grass));
  CHECK(state.history.names() == std::vector<std::string>{"Remove Ford"});
}

TEST_CASE("another tool drops the selected thing: Delete is then about paint") {
  EditorState state;
  show(state);
  state.placing.selected = PlacedItem{PlacedKind::ford, 0};
  state.tool = Tool::add;
  CHECK_FALSE(removes_thing(state));
  follow_document(state);
  CHECK_FALSE(state.placing.selected);
  state.tool = Tool::select;
  CHECK_FALSE(removes_thing(state));
  CHECK(state.document.placements.places.fords.size() == 1);
}

TEST_CASE("a whole layer taken off by one key is told, with the way back") {
  EditorState state;
  show(state);
  const LayerId grass{LayerKind::plant_density, "grass"};
  PaintLayer paint(70, 66);
  paint.set(4, 4, {0.5F, 1});
  state.document.layers[grass] = std::make_shared<const PaintLayer>(paint);
  select_species(state, 0);
  state.tool = Tool::add;
  const CommandTable commands(editor_commands());
  run(*commands.of_keys(*parse_shortcut("Delete")), state);
  CHECK(state.history.size() == 1);
  CHECK(state.notice.find("All paint of") != std::string::npos);
  CHECK(state.notice.find("Ctrl+Z") != std::string::npos);
  CHECK(state.tool == Tool::add);
}

TEST_CASE("a drag belongs to the view it began on, also when it ends over no ground") {
  EditorState state;
  show(state);
  press_ford(state, PlacingView::landscape);
  // The map, drawn first, has a cell for every pointer; it is not the one that was pressed.
  CHECK(follow_press(state, PlacingView::map, PathPoint{69, 0}, held));
  CHECK(follow_press(state, PlacingView::landscape, PathPoint{30, 25}, held));
  CHECK(follow_press(state, PlacingView::map, PathPoint{69, 0}, let_go));
  CHECK(follow_press(state, PlacingView::landscape, std::nullopt, let_go));
  CHECK(ford(state) == PathPoint{30, 25});
  CHECK(state.history.size() == 1);
  CHECK_FALSE(follow_press(state, PlacingView::map, PathPoint{69, 0}, resting));
}

TEST_CASE("the view of a press takes its release, so that no click follows on it") {
  EditorState state;
  show(state);
  state.placing.took_press = true;
  state.placing.pressed_on = PlacingView::landscape;
  CHECK(follow_press(state, PlacingView::map, PathPoint{1, 1}, let_go));
  CHECK(state.placing.took_press);
  CHECK(follow_press(state, PlacingView::landscape, PathPoint{20, 20}, let_go));
  CHECK_FALSE(state.placing.took_press);
}

TEST_CASE("where the view of a press is gone, the other one lets go") {
  EditorState state;
  show(state);
  press_ford(state, PlacingView::landscape);
  CHECK(follow_press(state, PlacingView::landscape, PathPoint{30, 25}, held));
  CHECK(follow_press(state, PlacingView::map, PathPoint{5, 5}, resting));
  CHECK(ford(state) == PathPoint{30, 25});
  CHECK_FALSE(state.placing.held);
}

TEST_CASE("a stop of a day stays on the map, wherever the pointer goes") {
  EditorState state;
  show(state);
  PlanEdit day;
  day.species = "deer";
  day.stops = {{{10, 10}, 6, 8}};
  state.herd_day.herd = day;
  state.herd_day.held_stop = 0;
  drag_day(state, {-300, 900});
  REQUIRE(state.herd_day.preview);
  CHECK(state.herd_day.preview->stops[0].at == PathPoint{0, 65});
}

#include <catch2/catch.hpp>

#include "tests/ui/small_landscape.hpp"
#include "ui/crop_selection.hpp"
#include "ui/editor_actions.hpp"
#include "ui/layer_actions.hpp"
#include "ui/map_furniture.hpp"
#include "ui/outdated_area.hpp"
#include "ui/panels/climate_chart.hpp"
#include "ui/trail_figures.hpp"

using namespace biotope;

namespace {

const LayerId grass{LayerKind::plant_density, "grass"};
const LayerId herb{LayerKind::plant_density, "herb"};

Brush flat_brush() {
  Brush brush;
  brush.radius = 4;
  brush.strength = 1;
  brush.hardness = 1;
  brush.value = 0.5F;
  return brush;
}

/// An editor on the small landscape with two grasses, without a worker.
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
  snapshot->computed_cover.push_back(snapshot->computed_cover[0]);
  snapshot->cover = snapshot->computed_cover;
  state.document = snapshot->document;
  state.has_document = true;
  state.newest = state.shown = snapshot;
}

}  // namespace

TEST_CASE("one movement paints several species in equal parts and is taken back as one step") {
  EditorState state;
  show_small(state);
  state.brush = flat_brush();
  state.tool = Tool::add;
  select_species(state, 0);
  toggle_species(state, 2);
  begin_stroke(state, 40, 40);
  end_stroke(state);
  REQUIRE(state.document.layers.contains(grass));
  REQUIRE(state.document.layers.contains(herb));
  const Paint first = (*state.document.layers.at(grass))(40, 40);
  const Paint second = (*state.document.layers.at(herb))(40, 40);
  CHECK(painted(0, first) == Approx(0.5).margin(0.01));
  CHECK(painted(0, second) == Approx(painted(0, first)));
  CHECK(state.history.names().size() == 1);
  undo(state);
  for (const auto& [id, layer] : state.document.layers) CHECK((*layer)(40, 40).coverage == 0);
  redo(state);
  CHECK((*state.document.layers.at(herb))(40, 40) == second);
}

TEST_CASE("no brush changes a locked species, alone or beside another") {
  EditorState state;
  show_small(state);
  state.brush = flat_brush();
  state.tool = Tool::add;
  const Species& species = state.shown->web->species[2];
  set_species_locked(state, species, true);
  REQUIRE(state.history.names() == std::vector<std::string>{"Lock " + display_name(species)});
  select_species(state, 2);
  CHECK_FALSE(paint_hindrance(state).empty());
  begin_stroke(state, 40, 40);
  end_stroke(state);
  CHECK(state.document.layers.empty());
  select_species(state, 0);
  toggle_species(state, 2);
  begin_stroke(state, 40, 40);
  end_stroke(state);
  CHECK(state.document.layers.contains(grass));
  CHECK_FALSE(state.document.layers.contains(herb));
}

TEST_CASE("plants and animals are never painted together, and the selected one can leave the group") {
  EditorState state;
  show_small(state);
  select_species(state, 0);
  toggle_species(state, 1);
  CHECK(state.selected_species == 1);
  CHECK(state.also_selected.empty());
  select_species(state, 0);
  toggle_species(state, 2);
  toggle_species(state, 0);
  CHECK(state.selected_species == 2);
  CHECK(state.also_selected.empty());
}

TEST_CASE("on the tabs of plants and animals a species is always selected, and each tab remembers its own") {
  EditorState state;
  show_small(state);
  state.view.tab = Tab::climate;
  select_for_tab(state);
  CHECK(state.selected_species == -1);
  state.view.tab = Tab::plants;
  const MapId shown = shown_map(state);
  select_for_tab(state);
  CHECK(state.selected_species == 0);
  // The map one looks at stays, and yet the brush has something to paint.
  CHECK(shown_map(state) == shown);
  CHECK(paint_target(state) == grass);
  select_species(state, 2);
  select_for_tab(state);
  CHECK(state.selected_species == 2);
  state.view.tab = Tab::animals;
  select_for_tab(state);
  CHECK(state.selected_species == 1);
  state.view.tab = Tab::plants;
  select_for_tab(state);
  CHECK(state.selected_species == 2);
}

TEST_CASE("a dropped terrain is looked at first, a scene is opened, and unsaved work is asked about") {
  EditorState state;
  show_small(state);
  open_or_import(state, "/somewhere/valley.tif");
  CHECK(state.dialogs.import_file);
  CHECK(state.import_path == "/somewhere/valley.tif");
  CHECK_FALSE(state.loading.running());
  state.edits = 1;
  open_or_import(state, "/somewhere/scene.biotope");
  CHECK(state.dialogs.unsaved);
  CHECK_FALSE(state.loading.running());
  REQUIRE(state.after_unsaved);
}

TEST_CASE("what is being computed again is around the tiles whose paint differs") {
  const auto snapshot = small_landscape();
  Document document = snapshot->document;
  CHECK(outdated_area(document, *snapshot).empty());
  auto paint = std::make_shared<PaintLayer>(70, 66);
  paint->set(2, 3, {1, 1});
  document.layers[grass] = paint;
  const Rect area = outdated_area(document, *snapshot);
  CHECK(area.contains(2, 3));
  CHECK(intersection(area, {0, 0, 70, 66}) == area);
  CHECK(area != Rect{0, 0, 70, 66});
  document.seed += 1;
  CHECK(outdated_area(document, *snapshot) == Rect{0, 0, 70, 66});
}

TEST_CASE("the busiest routes come first and lengths add up by use") {
  TrailNetwork trails;
  TrailRoute quiet;
  quiet.points = {{0, 0}, {10, 0}};
  quiet.weight = {5, 5};
  quiet.length = 100;
  TrailRoute busy = quiet;
  busy.weight = {1000, 1000};
  TrailRoute middling = quiet;
  middling.weight = {50, 50};
  trails.routes = {quiet, busy, middling};
  const TrailFigures figures = trail_figures(trails, 10, 2);
  CHECK(figures.busiest == 1000);
  REQUIRE(figures.most_used.size() == 2);
  CHECK(figures.most_used[0].index == 1);
  CHECK(figures.most_used[1].index == 2);
  CHECK(figures.heavy_length == Approx(100));
  CHECK(figures.middle_length == Approx(100));
  CHECK(figures.light_length == Approx(100));
  CHECK(trail_figures({}, 10, 2).most_used.empty());
}

TEST_CASE("a part drawn over the picture becomes cells of the file, in whatever direction it was drawn") {
  const auto cells = cropped_cells({74.5F, 49.5F}, {24.5F, 24.5F}, 100, 100, 400, 400);
  REQUIRE(cells);
  CHECK(*cells == Rect{100, 100, 300, 200});
  CHECK(cropped_cells({-50, -50}, {500, 500}, 100, 100, 400, 300) == Rect{0, 0, 400, 300});
  CHECK_FALSE(cropped_cells({10, 10}, {11, 60}, 100, 100, 400, 400));
}

TEST_CASE("a month dragged warmer keeps its minimum and maximum around it; rain is never negative") {
  Climate climate;
  climate.temperature_mean[3] = 10;
  climate.temperature_min[3] = 4;
  climate.temperature_max[3] = 15;
  const Climate warmer = with_month(climate, ClimateQuantity::temperature, 3, 12);
  CHECK(warmer.temperature_mean[3] == Approx(12));
  CHECK(warmer.temperature_min[3] == Approx(6));
  CHECK(warmer.temperature_max[3] == Approx(17));
  CHECK(warmer.temperature_mean[4] == climate.temperature_mean[4]);
  CHECK(with_month(climate, ClimateQuantity::precipitation, 3, -5).precipitation[3] == 0);
}

TEST_CASE("scales of amounts end at round numbers and cover always runs to the whole ground") {
  CHECK(round_up(0.9F) == 1);
  CHECK(round_up(1) == 1);
  CHECK(round_up(1.2F) == 2);
  CHECK(round_up(230) == 500);
  CHECK(round_up(0) == 0);
  const MapEntry cover = describe_map({MapKind::plant_cover, 0}, nullptr);
  CHECK(scale_range(cover, 0, 0.03F).high == 1);
  const MapEntry density = describe_map({MapKind::animal_density, 0}, nullptr);
  CHECK(scale_range(density, 0, 3.7F).high == scale_range(density, 0, 4.6F).high);
  CHECK(line_step({0, 1}) > 0);
}

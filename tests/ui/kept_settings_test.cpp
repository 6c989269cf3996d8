#include <unistd.h>

#include <catch2/catch.hpp>
#include <cmath>
#include <filesystem>
#include <fstream>

#include "tests/ui/small_landscape.hpp"
#include "ui/brush_presets.hpp"
#include "ui/brush_stamps.hpp"
#include "ui/chain_changes.hpp"
#include "ui/commands.hpp"
#include "ui/drape_texels.hpp"
#include "ui/dropped_files.hpp"
#include "ui/editor_actions.hpp"
#include "ui/image_import.hpp"
#include "ui/keep_settings.hpp"

using namespace biotope;

namespace {

struct Folder {
  std::filesystem::path path = std::filesystem::temp_directory_path() / ("biotope-kept-" + std::to_string(getpid()));
  Folder() { std::filesystem::create_directories(path); }
  ~Folder() { std::filesystem::remove_all(path); }
};

void show(EditorState& state) {
  const auto snapshot = small_landscape();
  state.document = snapshot->document;
  state.has_document = true;
  state.newest = state.shown = snapshot;
}

}  // namespace

TEST_CASE("the brush in the hand survives a restart: all of its shape, pressure, filter and stamp") {
  const Folder folder;
  EditorState state;
  show(state);
  state.settings_file = folder.path / "settings.json";
  state.brush.radius = 33;
  state.brush.strength = 0.3F;
  state.brush.falloff = Falloff::sharp;
  state.brush.spacing = 1.5F;
  state.brush.pressure_sizes = true;
  state.brush.pressure_strengthens = false;
  state.brush.noise_size = 40;
  state.brush.stamp_turn = 30;
  state.brush.stamp_turns_by_chance = true;
  state.brush.filter.conditions = {{FilterQuantity::slope, {}, 3, 17, 2, true}};
  state.paint.stamp = built_in_stamps().front().name;
  state.settings.recent = {"sample:valley"};
  keep_settings(state);
  CHECK(state.messages.empty());

  EditorState later;
  later.settings = load_settings(state.settings_file);
  later.settings_file = state.settings_file;
  later.brush = later.settings.brush;
  take_up_brush(later);
  CHECK(later.settings.recent == state.settings.recent);
  CHECK(later.brush.radius == 33);
  CHECK(later.brush.strength == 0.3F);
  CHECK(later.brush.falloff == Falloff::sharp);
  CHECK(later.brush.spacing == 1.5F);
  CHECK(later.brush.pressure_sizes);
  CHECK_FALSE(later.brush.pressure_strengthens);
  CHECK(later.brush.noise_size == 40);
  CHECK(later.brush.stamp_turn == 30);
  CHECK(later.brush.stamp_turns_by_chance);
  CHECK(later.brush.filter == state.brush.filter);
  CHECK(later.paint.stamp == state.paint.stamp);
  CHECK(later.brush.stamp);
}

TEST_CASE("settings that cannot be written are told once") {
  const Folder folder;
  std::ofstream(folder.path / "in-the-way") << "x";
  EditorState state;
  state.settings_file = folder.path / "in-the-way" / "settings.json";
  keep_settings(state);
  keep_settings(state);
  CHECK(state.messages.size() == 1);
}

TEST_CASE("a brush thrown away can be taken back to where it stood") {
  const Folder folder;
  EditorState state;
  show(state);
  state.settings_file = folder.path / "settings.json";
  for (const char* name : {"A", "B", "C"}) keep_preset(state, name);
  remove_preset(state, "B");
  CHECK(load_presets(folder.path / "brushes.json").size() == 2);
  take_back_preset(state);
  const auto names = load_presets(folder.path / "brushes.json");
  REQUIRE(names.size() == 3);
  CHECK(names[1].name == "B");
  take_back_preset(state);
  CHECK(own_presets(state).size() == 3);
}

TEST_CASE("of several dropped files the scene is opened, and the others are named") {
  EditorState state;
  show(state);
  state.edits = 1;
  drop_files(state, {"/a/height.tif", "/a/valley.biotope", "/a/c.tif"});
  CHECK(state.dialogs.unsaved);
  CHECK(state.notice.find("valley.biotope") != std::string::npos);
  CHECK(state.notice.find("2 other files") != std::string::npos);
  EditorState one;
  show(one);
  drop_files(one, {"/a/height.tif"});
  CHECK(one.dialogs.import_file);
  CHECK(one.notice.empty());
}

TEST_CASE("an image is offered over the layer's usual range, and numbers as they are") {
  EditorState state;
  show(state);
  const LayerId moisture{LayerKind::resource, "moisture"};
  ImageFacts picture{640, 480, true, 255, true};
  ImageImport import = offered_import(state, moisture, "a.png", picture);
  CHECK_FALSE(import.as_they_are);
  CHECK(reading_range(import) == ValueRange{1, 9});
  import.range = {2, 5};
  CHECK(reading_range(import) == ValueRange{2, 5});
  import.as_they_are = true;
  CHECK(reading_range(import) == ValueRange{0, 255});
  const ImageImport numbers = offered_import(state, moisture, "a.tif", {64, 48, false, 255, true});
  CHECK(numbers.as_they_are);
  CHECK_FALSE(reading_range(numbers));
  CHECK_FALSE(reading_range(offered_import(state, {LayerKind::geology, "class"}, "a.png", picture)));
}

TEST_CASE("the palette knows placing tools, copying and brushes, and every key names one command") {
  const CommandTable commands(editor_commands());
  for (const char* id : {"place.river", "place.ford", "place.waypoint", "paint.copy", "paint.paste", "brush.presets",
                         "brush.preset.1", "select.painted", "lock.add", "lock.nothing", "view.drape"}) {
    CAPTURE(id);
    CHECK(commands.find(id) != nullptr);
  }
  CHECK_FALSE(commands.keys("brush.presets").empty());
  for (const EditorCommand& command : commands.all()) {
    if (command.keys.empty()) continue;
    CAPTURE(command.id, command.keys);
    CHECK(commands.of_keys(commands.shortcut(command.id)) == &command);
  }
}

TEST_CASE("an answer is told of the edit that was answered, not of the newest step") {
  ChainChanges changes;
  const std::vector<SpeciesFigures> before(1);
  std::vector<SpeciesFigures> after(1);
  after[0].amount = 2;
  changes.follow(before, 1, 1, false);
  changes.note_posted(2, "Paint oak");
  changes.note_posted(3, "Paint birch");
  changes.follow(after, 2, 3, false);
  CHECK(changes.answered_edit() == "Paint oak");
  changes.follow(after, 3, 3, false);
  CHECK(changes.answered_edit() == "Paint birch");

  EditorState state;
  show(state);
  change_document(state, "Title", [](Document& document) { document.title = "x"; });
  CHECK(last_edit_words(state.history, 0, false) == "Title");
  undo(state);
  CHECK(last_edit_words(state.history, 1, false) == "Undo: Title");
  CHECK(last_edit_words(state.history, 1, true) == "the stroke so far");
}

TEST_CASE("the map over the 3D view shows a cell's colour, and only where it is not clear") {
  DrapeSource source;
  auto cells = std::make_shared<Grid<float>>(8, 8, 0.0F);
  (*cells)(3, 4) = 1;
  source.overlay = MapOverlay{cells, 0, 1, ColourMap::viridis, 1, 0};
  Grid<Rgba> texels(8, 8);
  colour_drape(source, 1, cells->rect(), texels);
  CHECK(texels(0, 0)[3] == 0);
  CHECK(texels(3, 4)[3] == 255);
  const auto yellow = colour_of(ColourMap::viridis, 1);
  for (std::size_t part = 0; part < 3; ++part) CHECK(std::abs(float(texels(3, 4)[part]) - 255 * yellow[part]) < 5);

  // Of a change only its cells are made again.
  (*cells)(0, 0) = 1;
  (*cells)(7, 7) = 1;
  colour_drape(source, 1, {0, 0, 2, 2}, texels);
  CHECK(texels(0, 0)[3] == 255);
  CHECK(texels(7, 7)[3] == 0);

  SelectionMask locked(8, 8);
  locked.set(5, 5, 255);
  source.locked_area = std::make_shared<const SelectionMask>(locked);
  source.overlay.reset();
  colour_drape(source, 1, {0, 0, 8, 8}, texels);
  CHECK(texels(5, 5)[3] > 100);
  CHECK(texels(3, 4)[3] == 0);
  CHECK(drape_step(2048, 100) == 1);
  CHECK(drape_step(4096, 4096) == 2);
}

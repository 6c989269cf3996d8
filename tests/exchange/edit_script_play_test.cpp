#include <catch2/catch.hpp>

#include <filesystem>
#include <fstream>

#include "core/exchange/edit_script_files.hpp"
#include "core/exchange/edit_script_play.hpp"
#include "core/pipeline/edit_grounds.hpp"
#include "core/pipeline/snapshot_difference.hpp"
#include "tests/exchange/edit_script_scene.hpp"
#include "tests/exchange/raster_files.hpp"
#include "tests/exchange/scene_sample.hpp"

using namespace biotope;
using namespace biotope_test;
using Catch::Matchers::Contains;
using Catch::Matchers::StartsWith;

namespace {

EditScript parsed(const std::string& edits) {
  auto script = parse_edit_script(R"({"format": "biotope-edits", "version": 1, "edits": [)" + edits + "]}", "edits.json");
  if (!script) FAIL(script.error().message);
  return *script;
}

Document played(const Document& start, const std::string& edits, SolveCache* cache = nullptr, const PlayOptions& options = {}) {
  SolveCache own;
  auto document = play(start, parsed(edits), options, cache ? *cache : own);
  if (!document) FAIL(document.error().message);
  return *document;
}

std::string error_of(const std::string& edits, const PlayOptions& options = {}) {
  SolveCache cache;
  const auto document = play(valley(), parsed(edits), options, cache);
  REQUIRE_FALSE(document);
  CHECK_THAT(document.error().message, StartsWith(options.label + ": edit "));
  return document.error().message;
}

std::shared_ptr<const MapsSnapshot> solved(const Document& document, SolveCache* cache = nullptr) {
  auto maps = solve(document, cache);
  if (!maps) FAIL(maps.error().message);
  return *maps;
}

/// The first plant, grazer and hunter of the small valley.
struct Names {
  std::string plant, other_plant, grazer, hunter;
};
Names names_of(const Document& document) {
  const auto web = build_food_web(*document.species);
  const auto name = [&](std::size_t level, std::size_t i) { return web->species[std::size_t(web->levels[level][i])].name; };
  return {name(0, 0), name(0, 1), name(1, 0), name(2, 0)};
}

/// One after the other: every kind of edit, every kind of layer, and undo and redo between.
std::string every_kind(const Names& names) {
  const std::string plant = "\"plant-density:" + names.plant + "\"";
  const std::string other = "\"plant-density:" + names.other_plant + "\"";
  return R"(
{"edit": "stroke", "targets": [{"layer": )" +
         plant + R"(}, {"layer": )" + other + R"(, "weight": 0.5, "value": 0.3}],
 "brush": {"mode": "add", "radius": 14, "value": 0.8, "filter": {"conditions": [{"quantity": "slope", "low": 0, "high": 25, "softness": 5}]}},
 "points": [[30, 30], [60, 45, 0.5], [90, 40, 0.8]]},
{"edit": "stroke", "targets": [{"layer": "resource:moisture"}], "brush": {"mode": "set", "radius": 20, "value": 8}, "points": [[100, 90], [120, 95]]},
{"edit": "stroke", "targets": [{"layer": "animal-density:)" +
         names.grazer + R"("}], "brush": {"mode": "add", "radius": 25, "value": 60},
 "points": [[80, 60]]},
{"edit": "stroke", "targets": [{"layer": "animal-density:)" +
         names.hunter + R"("}], "brush": {"mode": "smooth", "radius": 25}, "points": [[90, 70], [70, 60]]},
{"edit": "select", "shape": "rectangle", "points": [[10, 10], [120, 100]]},
{"edit": "select", "shape": "lasso", "mode": "subtract", "points": [[20, 20], [50, 20], [30, 60]]},
{"edit": "fill", "targets": [{"layer": "resource:texture"}], "brush": {"mode": "noise", "value": 2, "noise_size": 9}},
{"edit": "undo", "steps": 2},
{"edit": "redo"},
{"edit": "fill", "targets": [{"layer": "loss:)" +
         names.plant + R"("}], "brush": {"mode": "set", "value": 0.2},
 "gradient": {"from": [0, 0], "to": [100, 50], "end_value": 0.9}},
{"edit": "select", "shape": "range", "mode": "intersect", "range": {"quantity": "map", "map": "resource:moisture", "low": 3, "high": 9, "softness": 1}},
{"edit": "fill", "targets": [{"layer": "geology:class"}], "brush": {"mode": "set", "value": 3, "strength": 1}},
{"edit": "stroke", "targets": [{"layer": "passage:all"}], "brush": {"mode": "set", "value": 1, "radius": 4, "strength": 1,
 "filter": {"use_selection": false}}, "points": [[20, 64], [140, 64]]},
{"edit": "stroke", "targets": [{"layer": "ground:height"}], "brush": {"mode": "raise", "value": 3, "radius": 15, "stamp": "stamps/leaf.png"},
 "points": [[60, 90], [70, 92]]},
{"edit": "select", "shape": "painted", "layer": "ground:height"},
{"edit": "lock", "how": "add"},
{"edit": "select", "shape": "everything"},
{"edit": "stroke", "targets": [{"layer": )" +
         other + R"(}], "brush": {"mode": "clone", "radius": 12, "clone_offset": [20, -5]},
 "clone_from": )" +
         plant + R"(, "points": [[40, 100], [60, 100]]},
{"edit": "image", "layer": "resource:temperature", "file": "warm.png", "low": 3, "high": 7, "opacity": 0.5},
{"edit": "mix", "into": )" +
         other + R"(, "from": )" + plant + R"(, "mix": "maximum"},
{"edit": "set", "name": "Draw water and ways", "seed": 11, "placements": {"rivers": [{"course": [[30, 5], [40, 40], [78, 80]], "discharge_m3_s": 0.5}],
 "fords": [{"at": [80, 40], "radius_m": 30}], "waypoints": [{"at": [110, 40], "attraction": 0.5}]}},
{"edit": "group", "name": "Together", "edits": [{"edit": "clear", "layer": "resource:texture"}, {"edit": "set", "use_proportions": {"1": false}},
 {"edit": "mix", "into": "resource:illumination", "from": "resource:moisture", "mix": "replace"}]},
{"edit": "set", "layer_states": [{"layer": "passage:all", "hidden": true}, {"layer": "ground:height", "locked": true}],
 "inflows": [{"x": 80, "y": 0, "catchment_area_m2": 1e8}]},
{"edit": "stroke", "targets": [{"layer": )" +
         plant + R"(}], "brush": {"mode": "restore-computed", "radius": 10, "strength": 1}, "points": [[60, 45]]},
{"edit": "stroke", "targets": [{"layer": )" +
         plant + R"(}], "brush": {"mode": "sharpen", "radius": 10}, "points": [[90, 45]]})";
}

}  // namespace

TEST_CASE("a script of every kind of edit: maps kept up to date equal those from scratch, to the bit") {
  const TemporaryFolder folder;
  std::filesystem::create_directories(folder / "stamps");
  RasterRecipe picture;
  picture.driver = "PNG";
  picture.type = GDT_Byte;
  write_raster(folder / "warm.png", {{0, 255}, {128, 60}}, picture);
  write_raster(folder / "stamps/leaf.png", {{0, 255, 0}, {255, 255, 255}, {0, 255, 0}}, picture);
  const PlayOptions options{"edits.json", folder.path()};
  const Document start = valley();
  const std::string edits = every_kind(names_of(start));
  SolveCache cache;
  const Document result = played(start, edits, &cache, options);
  CHECK(result.layers.size() >= 8);
  CHECK(result.seed == 11);
  CHECK_FALSE(result.layers.contains({LayerKind::resource, "texture"}));
  CHECK(snapshot_difference(*solved(result, &cache), *solved(result)).empty());
  // The same again gives the same, whatever the cache held before.
  biotope_test::require_same(result, played(start, edits, &cache, options));
}

TEST_CASE("undo and redo play as they were recorded, also over edits that change nothing") {
  const Document start = valley();
  const std::string first = R"({"edit": "set", "seed": 5}, )";
  const std::string nothing = R"({"edit": "clear", "layer": "ground:height"}, )";
  const std::string second = R"({"edit": "set", "seed": 6})";
  CHECK(played(start, first + nothing + second).seed == 6);
  CHECK(played(start, first + nothing + second + R"(, {"edit": "undo"})").seed == 5);
  CHECK(played(start, first + nothing + second + R"(, {"edit": "undo", "steps": 2})").seed == 5);
  CHECK(played(start, first + nothing + second + R"(, {"edit": "undo", "steps": 3})").seed == start.seed);
  CHECK(played(start, first + nothing + second + R"(, {"edit": "undo", "steps": 3}, {"edit": "redo", "steps": 3})").seed == 6);
  CHECK_THAT(error_of(first + R"({"edit": "undo", "steps": 2})"), Contains("edit 2 (undo)") && Contains("nothing left to undo"));
  CHECK_THAT(error_of(first + R"({"edit": "redo"})"), Contains("edit 2 (redo)") && Contains("nothing left to redo"));
}

TEST_CASE("a stroke played is the stroke painted on the same maps") {
  const Document start = valley();
  const LayerId layer{LayerKind::plant_density, names_of(start).plant};
  StrokeEntry entry;
  entry.edit.targets = {{layer, 1, {}, {}}};
  entry.edit.brush.radius = 17;
  entry.edit.points = {{20, 30, 1}, {70, 44, 0.4F}};
  EditScript script;
  script.entries.push_back({entry});
  SolveCache cache;
  const auto result = play(start, script, {}, cache);
  REQUIRE(result);
  const auto maps = solved(start);
  const auto ground = computed_map(*maps, layer);
  Document live = start;
  Stroke stroke(layer, ground.get());
  stroke.move_to(live, entry.edit.brush, 20, 30, 1);
  stroke.move_to(live, entry.edit.brush, 70, 44, 0.4F);
  CHECK(*result->layers.at(layer) == *live.layers.at(layer));
}

TEST_CASE("every entry is told of as it is done, with the command that does it") {
  Document start = valley();
  SolveCache cache;
  Document followed = start;
  History history;
  std::vector<std::string> names;
  const auto script =
      parsed(R"({"edit": "set", "name": "Seed", "seed": 5}, {"edit": "select", "shape": "nothing"}, {"edit": "undo", "steps": 2},
                                {"edit": "redo"})");
  const auto result = play(start, script, {}, cache, {}, [&](const PlayedEntry& step) {
    CHECK(step.count == 4);
    if (step.command) {
      history.perform(followed, shared_command(step.command));
      names.push_back(step.command->name());
    }
    for (int i = 0; i < step.steps; ++i) history.redo(followed);
    for (int i = 0; i > step.steps; --i) history.undo(followed);
    CHECK(followed.seed == step.document->seed);
  });
  REQUIRE(result);
  CHECK(names == std::vector<std::string>{"Seed", "Select nothing"});
  CHECK(followed.seed == 5);
  CHECK(history.position() == 1);
}

TEST_CASE("what cannot be played says which edit and why, and a stop is a stop") {
  CHECK_THAT(error_of(R"({"edit": "clear", "layer": "plant-density:dodo"})"), Contains("edit 1 (clear)") && Contains("dodo"));
  CHECK_THAT(
      error_of(
          R"({"edit": "stroke", "targets": [{"layer": "plant-density:dodo"}], "brush": {"mode": "add"}, "points": [[1, 1]]})"),
      Contains("edit 1 (stroke)") && Contains("dodo"));
  CHECK_THAT(error_of(R"({"edit": "set", "species": {"removed": ["dodo"]}})"), Contains("dodo"));
  CHECK_THAT(error_of(R"({"edit": "image", "layer": "ground:height", "file": "none.png"})", {"a.json", "/tmp"}),
             Contains("none.png"));
  CHECK_THAT(error_of(R"({"edit": "group", "edits": [{"edit": "set", "seed": 3}, {"edit": "clear", "layer": "loss:dodo"}]})"),
             Contains("edit 1 (group), part 2 (clear)"));
  CHECK_THAT(
      error_of(
          R"({"edit": "set", "layer_states": [{"layer": "ground:height", "locked": true}]}, {"edit": "clear", "layer": "ground:height"})"),
      Contains("edit 2") && Contains("locked"));
  SolveCache cache;
  EditScript small = parsed(R"({"edit": "select", "shape": "nothing"})");
  small.width = small.height = 64;
  const auto misfit = play(valley(), small, {}, cache);
  REQUIRE_FALSE(misfit);
  CHECK_THAT(misfit.error().message, Contains("64 x 64") && Contains("160 x 128"));
  std::stop_source source;
  source.request_stop();
  TaskContext context;
  context.stop = source.get_token();
  const auto stopped = play(valley(), parsed(R"({"edit": "select", "shape": "nothing"})"), {}, cache, context);
  REQUIRE_FALSE(stopped);
  CHECK(stopped.error().message == stopped_message);
}

TEST_CASE("a script is saved with its files and plays from another folder") {
  const TemporaryFolder folder;
  const Document start = valley();
  const auto& height = start.terrain->height;
  PaintLayer paint(height.width(), height.height());
  paint.set(5, 6, {0.25F, 1});
  Grid<float> image(height.width(), height.height(), std::nanf(""));
  for (int y = 8; y < 12; ++y) {
    for (int x = 7; x < 12; ++x) image(x, y) = 1.0F / 3;
  }
  const std::string plant = names_of(start).plant;
  EditScript script;
  script.width = height.width();
  script.height = height.height();
  script.entries.push_back(
      {MixEntry{{LayerKind::plant_density, plant}, {LayerKind::plant_density, plant}, LayerMix::over, "paint-1.tif"}});
  script.entries.push_back({ImageEntry{{LayerKind::loss, plant}, "image-1.tif", {}, {}, 1, {}}});
  ScriptAttachments attachments;
  attachments.paints["paint-1.tif"] = std::make_shared<const PaintLayer>(paint);
  attachments.rasters["image-1.tif"] = std::make_shared<const Grid<float>>(image);
  REQUIRE(save_edit_script(folder / "session.json", script, attachments));
  std::filesystem::create_directories(folder / "elsewhere");
  std::filesystem::rename(folder / "session.json", folder / "elsewhere/session.json");
  const auto missing = load_edit_script(folder / "elsewhere/session.json");
  REQUIRE_FALSE(missing);
  CHECK_THAT(missing.error().message, Contains("edit 1 (mix)") && Contains("paint-1.tif"));
  std::filesystem::rename(folder / "session-files", folder / "elsewhere/session-files");
  const auto loaded = load_edit_script(folder / "elsewhere/session.json");
  REQUIRE(loaded);
  SolveCache cache;
  const auto result = play(start, *loaded, {"session.json", folder / "elsewhere"}, cache);
  if (!result) FAIL(result.error().message);
  CHECK((*result->layers.at({LayerKind::plant_density, plant}))(5, 6) == Paint{0.25F, 1});
  CHECK((*result->layers.at({LayerKind::loss, plant}))(7, 8) == Paint{1.0F / 3, 1});
  CHECK((*result->layers.at({LayerKind::loss, plant}))(0, 0) == Paint{});
}

TEST_CASE("a link that leads out of the script's folder is not followed") {
  const TemporaryFolder folder;
  std::filesystem::create_directories(folder / "inside");
  std::ofstream(folder / "secret.png") << "secret";
  std::filesystem::create_symlink(folder / "secret.png", folder / "inside/leaf.png");
  const auto found = script_file(folder / "inside", "leaf.png");
  REQUIRE_FALSE(found);
  CHECK_THAT(found.error().message, Contains("leads out"));
  CHECK(script_file(folder.path(), "secret.png"));
}

#include <unistd.h>

#include <algorithm>
#include <catch2/catch.hpp>
#include <set>

#include "tests/ui/small_landscape.hpp"
#include "ui/brush_presets.hpp"
#include "ui/brush_stamps.hpp"
#include "ui/editor_actions.hpp"
#include "ui/paint_targets.hpp"

using namespace biotope;

namespace {

/// A folder of its own that goes with the test.
struct Scratch {
  std::filesystem::path path = std::filesystem::temp_directory_path() / ("biotope-presets-test-" + std::to_string(getpid()));
  Scratch() { std::filesystem::create_directories(path); }
  ~Scratch() { std::filesystem::remove_all(path); }
};

BrushPreset odd_preset() {
  BrushPreset preset;
  preset.name = "Bank \"wet\" é";
  preset.tool = Tool::noise;
  preset.size = 42.5F;
  preset.brush.strength = 0.3F;
  preset.brush.hardness = 0.7F;
  preset.brush.falloff = Falloff::sphere;
  preset.brush.spacing = 0.5F;
  preset.brush.noise_size = 33;
  preset.brush.stamp_turn = 15;
  preset.brush.stamp_turns_by_chance = true;
  preset.brush.filter.use_selection = false;
  preset.brush.filter.conditions = {{FilterQuantity::water_distance, {}, 0, 40, 8, true},
                                    {FilterQuantity::map, {LayerKind::resource, "moisture"}, 3, 7, 0.5F, false}};
  preset.stamp = "Patches";
  preset.target = LayerId{LayerKind::loss, ""};
  preset.value = 0.8F;
  preset.all_plants = true;
  return preset;
}

}  // namespace

TEST_CASE("presets survive a restart with everything they hold") {
  const Scratch scratch;
  const std::filesystem::path file = scratch.path / "deep" / "brushes.json";
  CHECK(load_presets(file).empty());
  REQUIRE(save_presets(file, {odd_preset()}));
  const std::vector<BrushPreset> read = load_presets(file);
  REQUIRE(read.size() == 1);
  const BrushPreset wanted = odd_preset();
  CHECK(read[0].name == wanted.name);
  CHECK(read[0].tool == wanted.tool);
  CHECK(read[0].size == wanted.size);
  CHECK(read[0].brush.strength == wanted.brush.strength);
  CHECK(read[0].brush.hardness == wanted.brush.hardness);
  CHECK(read[0].brush.falloff == wanted.brush.falloff);
  CHECK(read[0].brush.spacing == wanted.brush.spacing);
  CHECK(read[0].brush.noise_size == wanted.brush.noise_size);
  CHECK(read[0].brush.stamp_turn == wanted.brush.stamp_turn);
  CHECK(read[0].brush.stamp_turns_by_chance);
  CHECK(read[0].brush.filter == wanted.brush.filter);
  CHECK(read[0].stamp == wanted.stamp);
  CHECK(read[0].target == wanted.target);
  CHECK(read[0].value == wanted.value);
  CHECK(read[0].all_plants);
}

TEST_CASE("a damaged presets file costs no more than what is damaged") {
  CHECK(presets_from_json("{ not json").empty());
  CHECK(presets_from_json("[1]").empty());
  const auto read = presets_from_json(
      R"({"brushes": [7, {"tool": "add"}, {"name": "A", "strength": 99, "size_m": "big", "tool": "fly",
          "filter": {"conditions": [{"of": "mood"}, {"of": "slope", "low": 5, "high": 9}]}}]})");
  REQUIRE(read.size() == 1);
  CHECK(read[0].name == "A");
  CHECK(read[0].brush.strength == 1);
  CHECK(read[0].size == BrushPreset().size);
  CHECK(read[0].tool == Tool::add);
  REQUIRE(read[0].brush.filter.conditions.size() == 1);
  CHECK(read[0].brush.filter.conditions[0].high == 9);
}

TEST_CASE("every built-in brush has a name of its own and a stamp that exists") {
  std::set<std::string> names;
  for (const BrushPreset& preset : built_in_presets()) {
    CAPTURE(preset.name);
    CHECK(names.insert(preset.name).second);
    CHECK(is_brush(preset.tool));
    if (!preset.stamp.empty()) CHECK(load_stamp(preset.stamp));
  }
  CHECK(names.contains("Wall"));
  CHECK_FALSE(load_stamp("/nowhere/at all.png"));
}

TEST_CASE("stamps are weights that are somewhere strong") {
  for (const BrushStamp& stamp : built_in_stamps()) {
    CAPTURE(stamp.name);
    const auto cells = stamp.weights->cells();
    CHECK(*std::min_element(cells.begin(), cells.end()) >= 0);
    CHECK(*std::max_element(cells.begin(), cells.end()) <= 1);
    CHECK(*std::max_element(cells.begin(), cells.end()) > 0.9F);
  }
}

TEST_CASE("a brush that is kept comes back as it was, of the same size on the ground") {
  const Scratch scratch;
  EditorState state;
  const auto snapshot = small_landscape();
  state.document = snapshot->document;
  state.has_document = true;
  state.newest = state.shown = snapshot;
  state.settings_file = scratch.path / "settings.json";
  state.view.tab = Tab::climate;
  state.view.shown[std::size_t(Tab::climate)] = {MapKind::moisture};
  state.tool = Tool::set;
  state.brush.radius = 7;
  state.brush.strength = 0.4F;
  choose_value(state, {LayerKind::resource, "moisture"}, ValueUse::reach, 6);
  keep_preset(state, "Mine");
  CHECK(std::filesystem::exists(scratch.path / "brushes.json"));

  EditorState later;
  later.document = snapshot->document;
  later.has_document = true;
  later.newest = later.shown = snapshot;
  later.settings_file = state.settings_file;
  REQUIRE(own_presets(later).size() == 1);
  use_preset(later, own_presets(later).front());
  CHECK(later.tool == Tool::set);
  CHECK(later.brush.radius == Approx(7));
  CHECK(later.brush.strength == 0.4F);
  CHECK(paint_target(later) == LayerId{LayerKind::resource, "moisture"});
  CHECK(chosen_value(later, {LayerKind::resource, "moisture"}, ValueUse::reach) == 6);
  remove_preset(later, "Mine");
  CHECK(load_presets(scratch.path / "brushes.json").empty());
}

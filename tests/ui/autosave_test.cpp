#include "ui/autosave.hpp"

#include <unistd.h>

#include <catch2/catch.hpp>
#include <chrono>
#include <fstream>
#include <thread>

#include "tests/scenes/small_valley.hpp"
#include "tests/ui/small_landscape.hpp"
#include "ui/editor_actions.hpp"

using namespace biotope;

namespace {

const double autosave_seconds = double(Settings().autosave_seconds);

/// A folder of its own that goes with the test.
struct Scratch {
  std::filesystem::path path = std::filesystem::temp_directory_path() / ("biotope-autosave-test-" + std::to_string(getpid()));
  Scratch() { std::filesystem::create_directories(path); }
  ~Scratch() { std::filesystem::remove_all(path); }
};

/// An editor on a landscape that can be saved, painting grass.
void show_small(EditorState& state) {
  const auto whole = scenes::small_document(std::string(BIOTOPE_SOURCE_DIR) + "/assets");
  REQUIRE(whole);
  auto snapshot = small_landscape();
  snapshot->document.species = whole->species;
  snapshot->document.climate = whole->climate;
  state.document = snapshot->document;
  state.has_document = true;
  state.newest = state.shown = snapshot;
  state.tool = Tool::add;
  state.brush.radius = 5;
  state.brush.strength = 1;
  select_species(state, 0);
}

/// Frames until what is being written is there.
void finish_copy(Autosave& autosave, EditorState& state, double now) {
  for (int i = 0; i < 2000; ++i) {
    autosave.tick(state, now);
    std::error_code error;
    if (std::filesystem::exists(autosave.file(), error) || !state.messages.empty()) break;
    std::this_thread::sleep_for(std::chrono::milliseconds(2));
  }
  std::this_thread::sleep_for(std::chrono::milliseconds(20));
  autosave.tick(state, now);
}

const LayerId grass{LayerKind::plant_density, "grass"};

}  // namespace

TEST_CASE("what is painted while a copy is written waits no longer for the next one") {
  const Scratch scratch;
  EditorState state;
  show_small(state);
  Autosave autosave(scratch.path);
  begin_stroke(state, 30, 30);
  autosave.tick(state, 200);
  autosave.tick(state, 200 + autosave_seconds);
  // Painted on at once.
  autosave.tick(state, 201 + autosave_seconds);
  finish_copy(autosave, state, 202 + autosave_seconds);
  const auto first = std::filesystem::last_write_time(autosave.file());
  for (int i = 0; i < 2000 && std::filesystem::last_write_time(autosave.file()) == first; ++i) {
    autosave.tick(state, 201.5 + 2 * autosave_seconds);
    std::this_thread::sleep_for(std::chrono::milliseconds(2));
  }
  CHECK(std::filesystem::last_write_time(autosave.file()) != first);
}

TEST_CASE("work is copied while a stroke is being painted, and the copy goes when the work is saved") {
  const Scratch scratch;
  EditorState state;
  show_small(state);
  Autosave autosave(scratch.path);
  autosave.tick(state, 100);
  autosave.tick(state, 200);
  CHECK_FALSE(std::filesystem::exists(autosave.file()));

  begin_stroke(state, 30, 30);
  REQUIRE(state.painting.stroking());
  REQUIRE(state.document.layers.contains(grass));
  autosave.tick(state, 200);
  autosave.tick(state, 200 + autosave_seconds - 1);
  CHECK_FALSE(std::filesystem::exists(autosave.file()));
  finish_copy(autosave, state, 200 + autosave_seconds);
  REQUIRE(std::filesystem::exists(autosave.file()));
  // As after a kill: the stroke is there, half as it is.
  const auto rescued = load_scene(autosave.file());
  REQUIRE(rescued);
  CHECK(*rescued->layers.at(grass) == *state.document.layers.at(grass));

  end_stroke(state);
  REQUIRE(state.dirty());
  state.saved_edits = state.edits;
  autosave.tick(state, 300);
  CHECK_FALSE(std::filesystem::exists(autosave.file()));
}

TEST_CASE("a copy that cannot be written is told once, tried again, and costs no work") {
  const Scratch scratch;
  EditorState state;
  show_small(state);
  const auto folder = scratch.path / "full";
  Autosave autosave(folder);
  std::filesystem::remove_all(folder);
  state.edits = 5;
  autosave.tick(state, 0);
  finish_copy(autosave, state, 21);
  REQUIRE(state.messages.size() == 1);
  CHECK(state.dirty());
  std::filesystem::create_directories(folder);
  state.messages.clear();
  autosave.tick(state, 22);
  finish_copy(autosave, state, 45);
  CHECK(std::filesystem::exists(autosave.file()));
  CHECK(state.messages.empty());
}

TEST_CASE("what several sessions left is offered one after the other") {
  const Scratch scratch;
  const auto old = scratch.path / "recovery-2147483000-17.biotope";
  const auto newer = scratch.path / "recovery-2147483001.biotope";
  std::ofstream(old) << "x";
  std::ofstream(newer) << "x";
  std::filesystem::last_write_time(old, std::filesystem::file_time_type::clock::now() - std::chrono::hours(2));
  EditorState state;
  Autosave autosave(scratch.path);
  REQUIRE(abandoned_files(scratch.path) == std::vector<std::filesystem::path>{newer, old});
  state.recovery_file = newer;
  state.dialogs.recovery = true;
  autosave.tick(state, 0);
  CHECK(state.recovery_file == newer);
  // Thrown away.
  std::filesystem::remove(newer);
  state.dialogs.recovery = false;
  autosave.tick(state, 1);
  CHECK(state.recovery_file == old);
  CHECK(state.dialogs.recovery);
}

TEST_CASE("work is not thrown away by closing the question whether to open it") {
  const Scratch scratch;
  const auto left = scratch.path / "recovery-2147483000-17.biotope";
  std::ofstream(left) << "x";
  EditorState state;
  Autosave autosave(scratch.path);
  state.recovery_file = left;
  state.dialogs.recovery = true;
  autosave.tick(state, 0);
  state.dialogs.recovery = false;
  autosave.tick(state, 1);
  autosave.tick(state, 2);
  CHECK(std::filesystem::exists(left));
  CHECK(find_abandoned(scratch.path) == left);
}

TEST_CASE("rescued work stays on the disk until it is in this editor's own copy") {
  const Scratch scratch;
  const auto left = scratch.path / "recovery-2147483000-17.biotope";
  EditorState state;
  show_small(state);
  REQUIRE(save_scene(left, state.document));
  Autosave autosave(scratch.path);
  state.recovery_file = left;
  state.rescued = true;
  state.edits = 1;
  autosave.tick(state, 0);
  CHECK(std::filesystem::exists(left));
  finish_copy(autosave, state, 21);
  CHECK(std::filesystem::exists(autosave.file()));
  CHECK_FALSE(std::filesystem::exists(left));
}

TEST_CASE("a process number that is used again does not hide what was left under it") {
  const Scratch scratch;
  // This process runs, but it did not start one tick after the machine did.
  const auto left = scratch.path / ("recovery-" + std::to_string(getpid()) + "-1.biotope");
  std::ofstream(left) << "x";
  CHECK(find_abandoned(scratch.path) == left);
  EditorState state;
  const Autosave autosave(scratch.path);
  CHECK(autosave.file() != left);
  std::ofstream(autosave.file()) << "x";
  CHECK(abandoned_files(scratch.path).size() == 1);
}

TEST_CASE("halves of copies go when their editor is gone") {
  const Scratch scratch;
  std::ofstream(scratch.path / ".recovery-2147483000-17-2147483000-3.tmp.biotope.Xa3f") << "x";
  std::ofstream(scratch.path / (".recovery-" + std::to_string(getpid()) + "-1-" + std::to_string(getpid()) + "-3.tmp.biotope"))
      << "x";
  const Autosave autosave(scratch.path);
  CHECK_FALSE(std::filesystem::exists(scratch.path / ".recovery-2147483000-17-2147483000-3.tmp.biotope.Xa3f"));
  CHECK(std::distance(std::filesystem::directory_iterator(scratch.path), {}) == 1);
}

TEST_CASE("a save that fails leaves the work unsaved and does not go on with what waited for it") {
  const Scratch scratch;
  EditorState state;
  show_small(state);
  state.worker = std::make_unique<Worker>();
  state.tool = Tool::select;
  state.shown.reset();
  state.newest.reset();
  state.edits = 3;
  bool went_on = false;
  const auto save_to = [&](const std::filesystem::path& file) {
    state.after_saved = [&](EditorState&) { went_on = true; };
    save_as(state, file);
    for (int i = 0; i < 2000 && state.saving.running(); ++i) {
      update(state, 0, 0.01);
      std::this_thread::sleep_for(std::chrono::milliseconds(2));
    }
  };
  save_to(scratch.path / "nowhere" / "a.biotope");
  CHECK(state.dirty());
  CHECK_FALSE(went_on);
  CHECK(state.messages.size() == 1);
  // A name under which nothing came to be is not kept: saving asks again.
  CHECK(state.scene_file.empty());
  CHECK(state.settings.recent.empty());
  save_to(scratch.path / "a.biotope");
  CHECK(state.scene_file == scratch.path / "a.biotope");
  CHECK_FALSE(state.dirty());
  CHECK(went_on);
  CHECK(load_scene(scratch.path / "a.biotope"));
}

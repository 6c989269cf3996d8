#include "ui/edit_recorder.hpp"

#include <unistd.h>
#include <catch2/catch.hpp>

#include <filesystem>

#include "core/base/random.hpp"
#include "core/document/history.hpp"
#include "core/exchange/edit_script_files.hpp"
#include "core/exchange/edit_script_play.hpp"
#include "core/pipeline/edit_grounds.hpp"
#include "tests/scenes/small_valley.hpp"

using namespace biotope;

namespace {

Document valley() {
  auto document = scenes::small_document(std::string(BIOTOPE_SOURCE_DIR) + "/assets");
  if (!document) FAIL(document.error().message);
  return *document;
}

/// An editor without a window: a document, its history and a recorder, as the editor ties them together.
struct Desk {
  Document document = valley();
  History history;
  EditRecorder recorder;

  [[nodiscard]] std::size_t step() const { return history.dropped() + history.position(); }
  void start() { recorder.start(document, step()); }
  void perform(const Edit& edit, std::string_view merge_key = {}) {
    // Edits of this test read the document alone, so that no map need be computed.
    auto maps = std::make_shared<MapsSnapshot>();
    maps->document = document;
    const EditNeeds needs = needs_of(edit);
    REQUIRE(holds(*maps, needs));
    auto command = make_command(document, edit, edit_grounds(maps, needs));
    if (!command) FAIL(command.error().message);
    if (!*command) return;
    history.perform(document, std::move(*command), merge_key);
    recorder.record(edit, document, step());
  }
  void change(const std::string& name, const std::function<void(Document&)>& made, std::string_view merge_key = {}) {
    perform(PartsEdit{name, made}, merge_key);
  }
  void undo() {
    if (history.undo(document)) recorder.record_undo(document, step());
  }
  void redo() {
    if (history.redo(document)) recorder.record_redo(document, step());
  }
};

/// What a recording makes of the document it was begun with, by way of files.
Document replayed(const Document& start, const EditRecorder& recorder) {
  const auto folder = std::filesystem::temp_directory_path() / ("biotope-recorder-" + std::to_string(::getpid()));
  std::filesystem::create_directories(folder);
  const Status saved = save_edit_script(folder / "session.json", recorder.script(), recorder.attachments());
  if (!saved) FAIL(saved.error().message);
  const auto script = load_edit_script(folder / "session.json");
  if (!script) FAIL(script.error().message);
  SolveCache cache;
  auto document = play(start, *script, {"session.json", folder}, cache);
  std::filesystem::remove_all(folder);
  if (!document) FAIL(document.error().message);
  return *document;
}

void require_same_work(const Document& a, const Document& b) {
  REQUIRE(patch_between(a, b).empty());
  REQUIRE(a.layers.size() == b.layers.size());
  for (const auto& [layer, paint] : a.layers) {
    INFO(layer.name);
    REQUIRE(*paint == *b.layers.at(layer));
  }
  REQUIRE((a.selection == nullptr) == (b.selection == nullptr));
  if (a.selection) REQUIRE(*a.selection == *b.selection);
  REQUIRE((a.locked_area == nullptr) == (b.locked_area == nullptr));
  if (a.locked_area) REQUIRE(*a.locked_area == *b.locked_area);
}

StrokeEdit stroke(float x, float y, float value) {
  StrokeEdit edit;
  edit.targets = {{{LayerKind::loss, "quercus"}, 1, {}, {}}};
  edit.brush.mode = BrushMode::set;
  edit.brush.radius = 9;
  edit.brush.value = value;
  edit.points = {{x, y, 1}, {x + 30, y + 5, 0.5F}};
  return edit;
}

}  // namespace

TEST_CASE("what is recorded plays to the same document") {
  Desk desk;
  const Document before = desk.document;
  desk.start();
  desk.perform(stroke(20, 20, 0.5F));
  desk.change("Seed", [](Document& d) { d.seed = 9; });
  desk.perform(SelectEdit{SelectEdit::Shape::rectangle, SelectionMode::replace, {{10, 10}, {90, 70}}, {}});
  FillEdit fill;
  fill.targets = {{{LayerKind::passage, "all"}, 1, {}, {}}};
  fill.brush.mode = BrushMode::set;
  desk.perform(fill);
  StrokeEdit stamped = stroke(40, 60, 0.9F);
  stamped.brush.stamp = std::make_shared<const Grid<float>>(4, 4, 0.5F);
  desk.perform(stamped);
  desk.perform(stamped);
  desk.perform(MixEdit{{LayerKind::loss, "quercus"}, {LayerKind::passage, "all"}, nullptr, LayerMix::subtract});
  CHECK(desk.recorder.count() == 7);
  CHECK(desk.recorder.attachments().rasters.size() == 1);
  CHECK(desk.recorder.unsaved());
  require_same_work(replayed(before, desk.recorder), desk.document);
}

TEST_CASE("a slider that is dragged is one entry, as it is one step") {
  Desk desk;
  const Document before = desk.document;
  desk.start();
  for (std::uint64_t seed = 2; seed < 20; ++seed)
    desk.change(
        "Seed", [seed](Document& d) { d.seed = seed; }, "seed");
  CHECK(desk.history.size() == 1);
  CHECK(desk.recorder.count() == 1);
  desk.undo();
  desk.redo();
  desk.change("Title", [](Document& d) { d.title = "t"; });
  require_same_work(replayed(before, desk.recorder), desk.document);
}

TEST_CASE("undo beyond the beginning of the recording is written as what it changed") {
  Desk desk;
  desk.perform(stroke(20, 20, 0.5F));
  desk.change("Seed", [](Document& d) { d.seed = 9; });
  desk.perform(SelectEdit{SelectEdit::Shape::rectangle, SelectionMode::replace, {{10, 10}, {90, 70}}, {}});
  const Document before = desk.document;
  desk.start();
  desk.perform(stroke(50, 30, 0.7F));
  for (int i = 0; i < 4; ++i) desk.undo();
  require_same_work(replayed(before, desk.recorder), desk.document);
  for (int i = 0; i < 4; ++i) desk.redo();
  require_same_work(replayed(before, desk.recorder), desk.document);
  desk.undo();
  desk.perform(ClearEdit{{LayerKind::loss, "quercus"}});
  require_same_work(replayed(before, desk.recorder), desk.document);
}

TEST_CASE("a change of layers, selection and parts at once is one entry and one step") {
  Desk desk;
  desk.perform(stroke(20, 20, 0.5F));
  desk.change("Lock", [](Document& d) { d.layer_states[{LayerKind::loss, "quercus"}].locked = true; });
  const Document before = desk.document;
  desk.start();
  desk.change("All at once", [](Document& d) {
    d.layers[{LayerKind::ground, "height"}] = std::make_shared<const PaintLayer>(tiled(Grid<Paint>(160, 128, Paint{200, 0.5F})));
    d.layers.erase({LayerKind::loss, "quercus"});
    d.selection = std::make_shared<const SelectionMask>(rectangle_selection(160, 128, {3, 3}, {20.5F, 40}));
    d.title = "changed";
  });
  CHECK(desk.recorder.count() == 1);
  const Document after = desk.document;
  require_same_work(replayed(before, desk.recorder), after);
  desk.undo();
  require_same_work(replayed(before, desk.recorder), before);
}

TEST_CASE("random sessions with undo and redo, recorded from the middle, play to the same document") {
  for (std::uint64_t session = 0; session < 12; ++session) {
    INFO("session " << session);
    Desk desk;
    Document before = desk.document;
    for (std::uint64_t i = 0; i < 30; ++i) {
      if (i == 8) {
        before = desk.document;
        desk.start();
      }
      const auto dice = [&](int high, std::uint64_t what) { return random_int(0, high, {session, i, what}); };
      const int kind = dice(8, 0);
      if (kind <= 2) {
        desk.undo();
      } else if (kind == 3) {
        desk.redo();
      } else if (kind == 4) {
        desk.change(
            "Seed", [&](Document& d) { d.seed = std::uint64_t(dice(3, 1)); }, dice(1, 2) == 1 ? "seed" : "");
      } else if (kind == 5) {
        const auto corner = PathPoint{float(dice(100, 1)), float(dice(100, 2))};
        desk.perform(SelectEdit{SelectEdit::Shape(dice(3, 3) == 0 ? 0 : 2), SelectionMode(dice(3, 4)), {{5, 5}, corner}, {}});
      } else if (kind == 6) {
        desk.perform(LockEdit{LockEdit::How(dice(3, 5))});
      } else {
        desk.perform(stroke(float(dice(150, 1)), float(dice(120, 2)), float(dice(9, 3)) / 9));
      }
    }
    require_same_work(replayed(before, desk.recorder), desk.document);
  }
}

TEST_CASE("what no script can hold is counted") {
  Desk desk;
  desk.start();
  desk.change("Other ground", [](Document& d) { d.terrain = std::make_shared<const Terrain>(*d.terrain); });
  CHECK(desk.recorder.missed() == 1);
}

TEST_CASE("another landscape is part of a recording, and neither undo nor redo reaches over it") {
  Desk desk;
  desk.start();
  desk.change("Seed", [](Document& document) { document.seed = 9; });
  desk.document = valley();
  desk.document.seed = 77;
  desk.history.clear();
  desk.recorder.record_open("sample:valley", {}, desk.document);
  desk.change("Title", [](Document& document) { document.title = "New"; });
  desk.undo();
  const auto& entries = desk.recorder.script().entries;
  REQUIRE(entries.size() == 4);
  CHECK(std::get<OpenEntry>(entries[1].what).sample == "valley");
  CHECK(std::holds_alternative<PartsPatch>(entries[2].what));
  CHECK(std::get<UndoEntry>(entries[3].what).steps == 1);
  CHECK(desk.recorder.missed() == 0);
  CHECK(desk.recorder.unsaved());
}

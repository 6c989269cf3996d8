#include "ui/editor_actions.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "core/exchange/open_input.hpp"
#include "core/exchange/scene_file.hpp"
#include "ui/edit_actions.hpp"
#include "ui/keep_settings.hpp"
#include "ui/landscape_figures.hpp"
#include "ui/layer_actions.hpp"
#include "ui/pictured.hpp"
#include "ui/tool_gestures.hpp"

namespace biotope {
namespace {

/// Marks a document that is not on the disk, whatever its edits.
constexpr std::uint64_t never_saved = std::numeric_limits<std::uint64_t>::max();

/// What a person is told of bookmarks that are not as they were saved; empty when all is well.
std::string views_problem(const SavedViews& views, const std::vector<std::string>& problems, bool damaged) {
  if (problems.empty()) return {};
  const std::string others = problems.size() > 1 ? " (and " + std::to_string(problems.size() - 1) + " more)" : "";
  std::string first = problems.front();
  if (first.ends_with('.')) first.pop_back();
  if (damaged && views.unread.empty()) {
    return first + others + ". All " + std::to_string(views.bookmarks.size()) +
           " bookmarks in it could be read: look whether they are as you know them. The next save puts the file right.";
  }
  return first + others + ". What is in the file stays there until you change a bookmark or the path.";
}

/// Bookmarks and the camera's path of the scene that was opened. Damage to them is told and takes nothing else away.
void load_views(EditorState& state, const std::string& input) {
  state.views = {};
  state.pictures.playing = -1;
  state.pictures.day_passes = false;
  if (std::filesystem::path(input).extension() != ".biotope") return;
  const auto saved = load_scene_views(input);
  if (!saved) return complain(state, "The bookmarks could not be read", saved.error());
  std::vector<std::string> problems;
  if (!saved->damage.empty()) problems.push_back(saved->damage);
  state.views = read_saved_views(saved->text, input + ": views.json", problems);
  const std::string told = views_problem(state.views, problems, !saved->damage.empty());
  if (!told.empty()) complain(state, "Not all bookmarks and views of the path could be read", {told});
  if (!state.views.path.hours) return;
  state.pictures.day_passes = true;
  state.pictures.hours = {float((*state.views.path.hours)[0]), float((*state.views.path.hours)[1])};
}

void finish_loading(EditorState& state) {
  const std::string what = state.loading.what();
  std::optional<Result<Document>> loaded = state.loading.take();
  if (!loaded) return;
  if (!*loaded) {
    // What could not be opened is not rescued yet: it stays on the disk and is offered the next time.
    if (what == state.recovery_file) state.recovery_file.clear();
    if (loaded->error().message == "stopped") return;
    complain(state, "This could not be opened", loaded->error());
    // A terrain may only need to be told its cell size or layout: the import preview asks for them.
    std::error_code error;
    const bool terrain = !what.starts_with("sample:") && std::filesystem::path(what).extension() != ".biotope";
    if (terrain && std::filesystem::is_regular_file(what, error)) {
      state.import_path = what;
      state.dialogs.import_file = true;
    }
    return;
  }
  const bool is_scene = std::filesystem::path(what).extension() == ".biotope" && what != state.recovery_file;
  state.scene_file = is_scene ? std::filesystem::path(what) : std::filesystem::path();
  cancel_playing(state);
  const bool recovered = what == state.recovery_file;
  if (recovered) drop_recording(state);
  replace_document(state, std::move(**loaded));
  state.recorder.record_open(what, state.loading_options, state.document);
  load_views(state, what);
  if (recovered) {
    state.edits = 1;  // rescued work is not saved yet
    state.rescued = true;
  } else {
    remember_recent(state.settings, what);
  }
  keep_settings(state);
}

void finish_saving(EditorState& state) {
  std::optional<Result<bool>> saved = state.saving.take();
  if (!saved) return;
  auto then = std::exchange(state.after_saved, {});
  const bool again = std::exchange(state.save_again, false);
  if (!*saved) {
    state.saved_edits = never_saved;
    complain(state, "The scene was not saved", saved->error());
    std::error_code error;
    if (again || std::filesystem::exists(state.scene_file, error)) return;
    // Nothing is there: the next save asks where to.
    std::erase(state.settings.recent, state.scene_file.string());
    state.scene_file.clear();
    return;
  }
  announce(state, "Saved " + state.scene_file.filename().string());
  keep_settings(state);
  if (again) {
    state.after_saved = std::move(then);
    save(state);
  } else if (then) {
    then(state);
  }
}

/// Takes the worker's newest snapshots, if they are of this landscape.
void take_snapshots(EditorState& state) {
  const auto belongs = [&](const std::shared_ptr<const MapsSnapshot>& snapshot) {
    return snapshot && snapshot->document.terrain == state.document.terrain;
  };
  const auto newest = state.worker->latest();
  if (!belongs(newest) || newest == state.newest) return;
  const bool failed_before = state.newest && !state.newest->status;
  state.newest = newest;
  const auto complete = state.worker->latest_complete();
  state.shown = belongs(complete) ? complete : newest;
  const auto before =
      std::exchange(state.pictured, pictured_maps(newest, belongs(complete) ? complete : nullptr, state.pictured));
  if (state.pictured != before && state.pictured != newest) state.worker->retire(state.pictured);
  if (!newest->status && !failed_before) complain(state, "The landscape could not be computed", newest->status.error());
}

/// The stroke's own picture goes when the worker's map of the same paint is there.
void retire_paint_picture(EditorState& state) {
  if (state.painting.stroking() || !state.painting.shown() || state.painting.awaited() == 0 || !state.newest ||
      !state.newest->web)
    return;
  if (state.newest->document_revision < state.painting.awaited()) return;
  // As long as the map under the paint is the same, the picture is what the worker's map would be.
  if (state.painting.source() == computed_source(*state.newest, state.painting.layer())) return;
  const MapId map = map_of_layer(state.painting.layer(), *state.newest->web);
  const bool animal = map.kind == MapKind::animal_density;
  if (animal && !state.newest->complete) return;
  if (state.maps.request(animal ? state.shown : state.newest, map).current) state.painting.close();
}

}  // namespace

void replace_document(EditorState& state, Document document) {
  state.document = std::move(document);
  state.has_document = true;
  state.history.clear();
  state.edits = state.saved_edits = 0;
  state.painting.close();
  state.maps.clear();
  state.question.reset();
  state.view.framed = false;
  state.view.camera_placed = false;
  state.view.camera_untouched = true;
  state.exploring = {};
  forget_herd(state);
  state.view.visible_species.clear();
  state.selected_species = -1;
  state.last_selected = {-1, -1};
  state.also_selected.clear();
  state.grounds.clear();
  drop_pending_edits(state);
  state.importing.cancel();
  state.gesture.reset();
  state.paint.last_point.reset();
  state.paint.clone_at.reset();
  state.dragged_value.reset();
  state.dragged_climate.reset();
  state.counting.cancel();
  state.figures_of.reset();
  state.figures.clear();
  state.changes.forget();
  state.shortages.clear();
  // The ground is shown at once; what lives on it follows.
  auto bare = std::make_shared<MapsSnapshot>();
  bare->document = state.document;
  state.newest = state.shown = state.pictured = bare;
  state.posted_revision = state.worker->post(state.document);
  state.posted_position = state.history.position();
  state.must_post = false;
}

void open(EditorState& state, const std::string& input, const DemImportOptions& options) {
  state.loading_options = options;
  state.loading.start(input, [input, options](const TaskContext& context) { return open_input(input, options, context); });
}

void unless_unsaved(EditorState& state, std::function<void(EditorState&)> then) {
  if (!state.dirty() && state.saving.running()) {
    // Whether the scene is saved is not known yet.
    state.after_saved = std::move(then);
    return;
  }
  if (!state.dirty()) {
    then(state);
    return;
  }
  state.after_unsaved = std::move(then);
  state.dialogs.unsaved = true;
}

void open_asking(EditorState& state, const std::string& input, const DemImportOptions& options) {
  unless_unsaved(state, [input, options](EditorState& later) { open(later, input, options); });
}

void open_or_import(EditorState& state, const std::string& input) {
  if (input.starts_with("sample:") || std::filesystem::path(input).extension() == ".biotope") {
    open_asking(state, input);
    return;
  }
  state.import_path = input;
  state.dialogs.import_file = true;
}

void save(EditorState& state) {
  if (!state.has_document) return;
  if (state.scene_file.empty()) {
    state.dialogs.save_file = true;
    return;
  }
  save_as(state, state.scene_file);
}

void save_as(EditorState& state, std::filesystem::path file) {
  if (file.extension() != ".biotope") file += ".biotope";
  state.scene_file = file;
  state.settings.last_folder = file.parent_path().string();
  remember_recent(state.settings, file.string());
  if (state.saving.running()) {
    state.save_again = true;
    return;
  }
  state.saved_edits = state.edits;
  const std::string views = saved_views_to_json(state.views);
  state.saving.start("Saving", [file, document = state.document, views](const TaskContext&) -> Result<bool> {
    const Status saved = save_scene(file, document, nullptr, views);
    if (!saved) return tl::unexpected(saved.error());
    return true;
  });
}

void change_document(EditorState& state, const std::string& name, const std::function<void(Document&)>& change) {
  if (!state.has_document) return;
  Document after = state.document;
  change(after);
  state.history.perform(state.document, std::make_unique<DocumentCommand>(name, state.document, std::move(after)));
  ++state.edits;
  state.must_post = true;
  state.painting.follow(state.document);
  recorded(state, PartsEdit{name, change});
}

void undo(EditorState& state) {
  if (tool_active(state) || !state.history.undo(state.document)) return;
  ++state.edits;
  state.recorder.record_undo(state.document, history_step(state));
  state.painting.follow(state.document);
  state.must_post = true;
}

void redo(EditorState& state) {
  if (tool_active(state) || !state.history.redo(state.document)) return;
  ++state.edits;
  state.recorder.record_redo(state.document, history_step(state));
  state.painting.follow(state.document);
  state.must_post = true;
}

void go_to_step(EditorState& state, std::size_t position) {
  while (state.history.position() > position && state.history.can_undo()) undo(state);
  while (state.history.position() < position && state.history.can_redo()) redo(state);
}

void recompute_from_scratch(EditorState& state) {
  if (!state.has_document) return;
  state.posted_revision = state.worker->post_from_scratch(state.document);
  state.must_post = false;
  announce(state, "Computing everything again");
}

void cancel_work(EditorState& state) {
  if (state.loading.running()) {
    state.loading.cancel();
    announce(state, "Opening was stopped");
  } else if (state.worker->progress().busy) {
    state.worker->cancel();
    announce(state, "Stopped; the last maps stay. F5 computes again");
  }
}

std::string document_name(const EditorState& state) {
  if (!state.has_document) return {};
  if (!state.scene_file.empty()) return state.scene_file.stem().string();
  if (!state.document.title.empty()) return state.document.title;
  return state.document.terrain->name.empty() ? "Untitled" : state.document.terrain->name;
}

void announce(EditorState& state, std::string text) {
  state.notice = std::move(text);
  state.notice_until = -1;  // `update` knows the time
}

void complain(EditorState& state, std::string title, const Error& error) {
  state.messages.push_back({std::move(title), error.message});
}

void post_edits(EditorState& state) {
  if (!state.must_post || !state.has_document) return;
  state.posted_revision = state.worker->post(state.document);
  state.changes.note_posted(state.posted_revision,
                            last_edit_words(state.history, state.posted_position, state.painting.stroking()));
  state.posted_position = state.history.position();
  if (state.painting.shown()) state.painting.wait_for(state.posted_revision);
  state.must_post = false;
}

void update(EditorState& state, double now, double frame_seconds) {
  state.frame_seconds = float(frame_seconds);
  const std::size_t undo_memory = std::size_t(state.settings.history_megabytes) << 20;
  if (state.history.budget() != undo_memory) state.history.set_budget(undo_memory);
  state.history.tidy();
  finish_loading(state);
  finish_saving(state);
  post_edits(state);
  take_snapshots(state);
  retire_paint_picture(state);
  advance_playing(state);
  advance_edits(state);
  advance_layer_files(state);
  prepare_painting(state);
  follow_landscape(state);
  select_for_tab(state);
  if (state.clock.playing) {
    state.clock.hour = std::fmod(state.clock.hour + state.clock.speed * std::min(frame_seconds, 0.25), 24.0);
  }
  if (state.notice_until < 0) state.notice_until = now + 5;
  if (now > state.notice_until) state.notice.clear();
  follow_pointer(state, now);
  if (state.question && state.shown && state.question->revision != state.shown->revision) {
    const CellQuestion asked = *state.question;
    ask_why(state, asked.x, asked.y);
  }
}

bool animates(const EditorState& state) {
  const bool works = state.loading.running() || state.saving.running() || state.grounds.busy() ||
                     state.pending.making.running() || state.importing.running() || state.exporting.running() ||
                     state.player.running() || state.player.saving.running();
  return works || state.clock.playing || state.maps.busy() || state.painting.stroking() || state.must_post ||
         (state.worker && state.worker->progress().busy);
}

}  // namespace biotope

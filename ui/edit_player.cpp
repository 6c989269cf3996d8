#include "ui/edit_player.hpp"

#include <algorithm>
#include <utility>

#include "core/exchange/edit_script_files.hpp"
#include "core/exchange/edit_script_play.hpp"
#include "ui/edit_actions.hpp"
#include "ui/editor_actions.hpp"
#include "ui/file_request.hpp"

namespace biotope {
namespace {

std::string edits_text(std::size_t count) { return std::to_string(count) + (count == 1 ? " edit" : " edits"); }

void save_recording(EditorState& state, const std::filesystem::path& file) {
  state.player.saving.start(file.filename().string(),
                            [file, script = state.recorder.script(),
                             attachments = state.recorder.attachments()](const TaskContext&) -> Result<std::size_t> {
                              if (Status saved = save_edit_script(file, script, attachments); !saved)
                                return tl::unexpected(saved.error());
                              return script.entries.size();
                            });
}

void finish_saving_recording(EditorState& state) {
  const std::string file = state.player.saving.what();
  const auto saved = state.player.saving.take();
  if (!saved) return;
  if (!*saved) {
    complain(state, "The edits were not saved", saved->error());
    return;
  }
  if (!state.recorder.recording()) state.recorder.mark_saved();
  announce(state, "Saved " + edits_text(**saved) + " in " + file);
  if (state.recorder.missed() == 0) return;
  complain(state, "Some changes are not in the script",
           Error{edits_text(state.recorder.missed()) + " changed given environment maps, which an edit script cannot hold."});
}

/// The steps that have been made since the last time.
std::deque<EditPlayer::Step> take_steps(EditPlayer& player) {
  const std::lock_guard lock(player.queue->mutex);
  player.count = player.queue->count;
  return std::exchange(player.queue->steps, {});
}

void take_step(EditorState& state, const EditPlayer::Step& step) {
  if (step.opened) {
    replace_document(state, *step.opened);
    // Nothing of it is on the disk as a scene.
    state.edits = 1;
    ++state.player.done;
    return;
  }
  if (step.command) state.history.perform(state.document, shared_command(step.command));
  for (int i = 0; i < step.steps; ++i) state.history.redo(state.document);
  for (int i = 0; i > step.steps; --i) state.history.undo(state.document);
  ++state.edits;
  ++state.player.done;
}

void take_steps_made(EditorState& state) {
  EditPlayer& player = state.player;
  const auto steps = take_steps(player);
  if (steps.empty()) return;
  for (const EditPlayer::Step& step : steps) take_step(state, step);
  player.edits = state.edits;
  state.must_post = true;
  state.painting.follow(state.document);
}

void play_script(EditorState& state, EditScript script) {
  EditPlayer& player = state.player;
  if (player.task.running()) return;
  player.queue = std::make_shared<EditPlayer::Queue>();
  player.queue->count = script.entries.size();
  player.edits = state.edits;
  player.task.start("Playing",
                    [file = player.file, script = std::move(script), document = state.document,
                     queue = player.queue](const TaskContext& context) -> Result<std::size_t> {
                      SolveCache cache;
                      const PlayOptions options{file.filename().string(), file.parent_path()};
                      const auto played = play(document, script, options, cache, context, [&queue](const PlayedEntry& entry) {
                        const std::lock_guard lock(queue->mutex);
                        queue->steps.push_back({entry.command, entry.steps, entry.opened});
                      });
                      if (!played) return tl::unexpected(played.error());
                      return script.entries.size();
                    });
}

/// What was read is played, after asking where it would lose unsaved work.
void finish_reading(EditorState& state) {
  auto read = state.player.reading.take();
  if (!read) return;
  if (!*read) {
    complain(state, "The edits could not be read", read->error());
    return;
  }
  const auto opens = [](const ScriptEntry& entry) { return std::holds_alternative<OpenEntry>(entry.what); };
  if (std::none_of((*read)->entries.begin(), (*read)->entries.end(), opens)) {
    play_script(state, std::move(**read));
    return;
  }
  unless_unsaved(state, [script = std::move(**read)](EditorState& later) { play_script(later, script); });
}

void begin_recording(EditorState& state) {
  state.history.end_merging();
  state.recorder.start(state.document, history_step(state));
  state.edit_listener = [](EditorState& s, const Edit& edit) { s.recorder.record(edit, s.document, history_step(s)); };
  announce(state, "Recording what you do; File > Stop recording and save ends it");
}

}  // namespace

std::size_t history_step(const EditorState& state) { return state.history.dropped() + state.history.position(); }

void unless_recording_unsaved(EditorState& state, std::function<void(EditorState&)> then) {
  if (!state.recorder.unsaved()) {
    then(state);
    return;
  }
  state.player.after_recording = std::move(then);
  state.dialogs.unsaved_recording = true;
}

void start_recording(EditorState& state) {
  if (state.has_document && !state.player.running()) unless_recording_unsaved(state, begin_recording);
}

void drop_recording(EditorState& state) {
  state.recorder = {};
  state.edit_listener = {};
}

void stop_and_save_recording(EditorState& state) {
  state.recorder.stop();
  state.edit_listener = {};
  if (!state.recorder.unsaved()) {
    announce(state, "Recording ended; nothing was done");
    return;
  }
  FileRequest request;
  request.title = "Save " + edits_text(state.recorder.count());
  request.action = "Save";
  request.saving = true;
  request.browser.endings = {".json"};
  request.browser.name = "edits.json";
  request.then = save_recording;
  ask_for_file(state, std::move(request));
}

void ask_to_play(EditorState& state) {
  FileRequest request;
  request.title = "Play edits";
  request.action = "Play";
  request.browser.endings = {".json"};
  request.then = play_edits;
  ask_for_file(state, std::move(request));
}

void play_edits(EditorState& state, const std::filesystem::path& file) {
  if (!state.has_document || state.player.running() || state.recorder.recording()) return;
  if (!pending_edit(state).empty()) {
    announce(state, pending_edit(state) + " is still being done");
    return;
  }
  EditPlayer& player = state.player;
  player.file = file;
  player.name = file.filename().string();
  player.done = player.count = 0;
  player.edits = state.edits;
  player.reading.start("Reading", [file](const TaskContext&) { return load_edit_script(file); });
}

void advance_playing(EditorState& state) {
  EditPlayer& player = state.player;
  finish_saving_recording(state);
  finish_reading(state);
  if (!player.task.running()) return;
  if (state.edits != player.edits) {
    player.task.cancel();
    complain(state, "Playing stopped", Error{"The landscape was changed while " + player.name + " was played."});
    return;
  }
  take_steps_made(state);
  const auto ended = player.task.take();
  if (!ended) return;
  take_steps_made(state);
  if (*ended) {
    announce(state, "Played " + edits_text(**ended) + " of " + player.name);
  } else {
    complain(state, "The edits could not be played to the end", ended->error());
  }
}

void cancel_playing(EditorState& state) {
  if (!state.player.running()) return;
  state.player.reading.cancel();
  state.player.task.cancel();
  if (!state.player.queue) return;
  take_steps_made(state);
  announce(state, "Playing was stopped after " + edits_text(state.player.done));
}

}  // namespace biotope

#pragma once

#include <cstdint>
#include <deque>
#include <filesystem>
#include <functional>
#include <memory>
#include <mutex>
#include <string>

#include "core/document/history.hpp"
#include "core/exchange/edit_script.hpp"
#include "ui/background_task.hpp"

namespace biotope {

struct EditorState;

/// An edit script being played in the background: what it has made waits here for the window's thread.
struct EditPlayer {
  struct Step {
    std::shared_ptr<const Command> command;  ///< null for undo and redo
    int steps = 0;                           ///< of undo (less than 0) and redo
    std::shared_ptr<const Document> opened;  ///< in place of the landscape there was
  };
  struct Queue {
    std::mutex mutex;
    std::deque<Step> steps;
    std::size_t count = 0;
  };

  BackgroundTask<EditScript> reading;
  BackgroundTask<std::size_t> task;
  /// A recording being written.
  BackgroundTask<std::size_t> saving;
  std::shared_ptr<Queue> queue;
  std::string name;
  std::filesystem::path file;
  /// What waits for an answer about an unsaved recording.
  std::function<void(EditorState&)> after_recording;
  /// Entries that are done, of all.
  std::size_t done = 0;
  std::size_t count = 0;
  /// Count of edits the document must have, or somebody else changed it.
  std::uint64_t edits = 0;
  [[nodiscard]] bool running() const { return reading.running() || task.running(); }
};

// Recording.

/// Calls `then` at once, or after asking when that would lose recorded edits that are not saved.
void unless_recording_unsaved(EditorState& state, std::function<void(EditorState&)> then);
/// Begins to record what the person does from now on; asks first when a recording is not saved.
void start_recording(EditorState& state);
/// Ends recording and forgets it.
void drop_recording(EditorState& state);
/// Ends recording, and asks for a file to save it in.
void stop_and_save_recording(EditorState& state);
/// Number of the history's newest step that is done, however many old ones were dropped.
[[nodiscard]] std::size_t history_step(const EditorState& state);

// Playing.

/// Asks for a script and plays it on the document.
void ask_to_play(EditorState& state);
/// Reads a script and plays it in the background: one step of the history for each entry, as soon as it is made. One that opens
/// another landscape asks first where that would lose unsaved work.
void play_edits(EditorState& state, const std::filesystem::path& file);
/// Once a frame: does to the document what has been made, and says when a recording is written.
void advance_playing(EditorState& state);
/// Stops; what is done stays and can be undone.
void cancel_playing(EditorState& state);

}  // namespace biotope

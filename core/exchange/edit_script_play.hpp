#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <memory>
#include <string>

#include "core/base/status.hpp"
#include "core/base/task_context.hpp"
#include "core/document/document.hpp"
#include "core/document/history.hpp"
#include "core/exchange/edit_script.hpp"
#include "core/pipeline/solve.hpp"

namespace biotope {

/// Where a script comes from.
struct PlayOptions {
  /// Begins messages: a file's name.
  std::string label = "edits";
  /// Folder of the files that the script names.
  std::filesystem::path folder;
};

/// What playing one entry did.
struct PlayedEntry {
  std::size_t number = 0;  ///< from 1
  std::size_t count = 0;   ///< of the script
  /// The step it made of the history; null for undo and redo.
  std::shared_ptr<const Command> command;
  /// Steps taken back (less than 0) or done again.
  int steps = 0;
  /// The landscape that was opened, with which the history begins anew; null for all other entries.
  std::shared_ptr<const Document> opened;
  /// After the entry; valid during the call only.
  const Document* document = nullptr;
};
/// Called after every entry, from the computing thread; may be empty.
using OnPlayed = std::function<void(const PlayedEntry&)>;

/// Plays a script on a document and returns what became of it. Every entry becomes one step of a history of its own, also where
/// it changes nothing, so that undo and redo take back what they took back when they were recorded. Before an edit that reads
/// computed maps the document is solved as far as they need, with `cache`; the others wait for nothing. Fails with the entry's
/// number and what is wrong with it, or with "Stopped."; deterministic for any number of threads.
[[nodiscard]] Result<Document> play(Document document, const EditScript& script, const PlayOptions& options, SolveCache& cache,
                                    const TaskContext& context = {}, const OnPlayed& played = {});

/// A command that a history owns together with others.
[[nodiscard]] std::unique_ptr<Command> shared_command(std::shared_ptr<const Command> command);

}  // namespace biotope

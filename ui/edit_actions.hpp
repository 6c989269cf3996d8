#pragma once

#include "core/document/edit.hpp"

namespace biotope {

struct EditorState;

// Every change of the document beside live strokes goes through here.

/// Has an edit done: it becomes one step of the history, is posted to the worker and told to the recorder. On large maps it is
/// made in the background; edits are done in the order they were asked for. A failure is told to the person.
void perform_edit(EditorState& state, Edit edit);
/// Once a frame: takes what was made in the background and starts what waits.
void advance_edits(EditorState& state);
/// What is being made ("Fill moisture ..."); empty when nothing is.
[[nodiscard]] std::string pending_edit(const EditorState& state);
/// Tells the recorder of an edit that is part of the history now.
void recorded(EditorState& state, const Edit& edit);
/// Forgets edits that are still waiting (another landscape was opened).
void drop_pending_edits(EditorState& state);

}  // namespace biotope

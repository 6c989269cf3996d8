#pragma once

#include "ui/editor_state.hpp"

namespace biotope {

// Placing and drawing on the views. Places are in cells; `reach` is how far a pointer takes hold, in cells. Every finished change
// is one step of the history.

void choose_placing(EditorState& state, PlacingTool tool);
/// Presses the left button: takes hold of a handle or a route, places a thing, or adds a point to a line. False when the press is
/// not for placing.
bool press_placing(EditorState& state, PathPoint at, float reach);
void drag_placing(EditorState& state, PathPoint at);
void release_placing(EditorState& state);
/// Ends the line being drawn and places it; too few points are forgotten.
void finish_line(EditorState& state);
/// Gives up, one thing at a time: the line, what is dragged, the tool, the selection. False when there was nothing.
bool cancel_placing(EditorState& state);
/// Takes the last point off the line being drawn.
void shorten_line(EditorState& state);
/// Removes the selected thing.
void remove_selected(EditorState& state);
/// Adds a point to the selected line at a place.
void split_selected(EditorState& state, PathPoint at);
/// Changes the placed things as one step.
void change_placed(EditorState& state, const std::string& name, const std::function<void(PlacedThings&)>& change);
/// What is drawn: the document's things, or what they become when the drag ends.
[[nodiscard]] PlacedThings shown_things(const EditorState& state);
/// Keeps the session fitting to the document (after undo, another scene, another tool). Once a frame.
void follow_document(EditorState& state);

}  // namespace biotope

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
/// Whether Delete means the selected thing, wherever the pointer is: while the select tool is in the hand and no line is drawn.
[[nodiscard]] bool removes_thing(const EditorState& state);
/// The left button, as this frame sees it.
struct PointerButton {
  bool down = false;
  bool released = false;
  bool dragging = false;
};
/// Goes on with what a press took hold of, on the view that was pressed: drags and, when the button is let go, finishes, also
/// where the pointer is over no ground (`at` is nothing). True while the button belongs to placing.
bool follow_press(EditorState& state, PlacingView view, const std::optional<PathPoint>& at, const PointerButton& left);
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

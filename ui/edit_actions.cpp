#include "ui/edit_actions.hpp"

#include <utility>

#include "core/pipeline/edit_grounds.hpp"
#include "ui/editor_actions.hpp"

namespace biotope {
namespace {

/// Cells up to which an edit is made at once: a few milliseconds.
constexpr std::size_t quick_cells = std::size_t(300) * 300;

/// Whether an edit looks at every cell, so that a large map takes long.
bool looks_at_all_cells(const Edit& edit) {
  if (const auto* select = std::get_if<SelectEdit>(&edit)) {
    return select->shape != SelectEdit::Shape::everything && select->shape != SelectEdit::Shape::nothing;
  }
  return !std::holds_alternative<PartsEdit>(edit) && !std::holds_alternative<ClearEdit>(edit) &&
         !std::holds_alternative<LockEdit>(edit);
}

Result<std::unique_ptr<Command>> made(const Document& document, const Edit& edit,
                                      const std::shared_ptr<const MapsSnapshot>& snapshot) {
  if (!snapshot) return make_command(document, edit, EditGrounds{});
  return make_command(document, edit, edit_grounds(snapshot, needs_of(edit).conditions));
}

void take_effect(EditorState& state, const Edit& edit, Result<std::unique_ptr<Command>> command) {
  if (!command) {
    complain(state, edit_name(edit, state.document) + " was not done", command.error());
    return;
  }
  if (!*command) {
    announce(state, edit_name(edit, state.document) + ": nothing changed");
    return;
  }
  state.history.perform(state.document, std::move(*command));
  ++state.edits;
  // What is selected or locked changes no map.
  if (!std::holds_alternative<SelectEdit>(edit) && !std::holds_alternative<LockEdit>(edit)) state.must_post = true;
  state.painting.follow(state.document);
  recorded(state, edit);
}

void start_making(EditorState& state) {
  PendingEdits& pending = state.pending;
  pending.edits_before = state.edits;
  pending.making.start(edit_name(pending.waiting.front(), state.document),
                       [document = state.document, edit = pending.waiting.front(), snapshot = state.shown](const TaskContext&) {
                         return made(document, edit, snapshot);
                       });
}

}  // namespace

void recorded(EditorState& state, const Edit& edit) {
  if (state.edit_listener) state.edit_listener(state, edit);
}

void perform_edit(EditorState& state, Edit edit) {
  if (!state.has_document) return;
  const bool quick = state.document.terrain->height.size() <= quick_cells || !looks_at_all_cells(edit);
  if (quick && state.pending.waiting.empty()) {
    take_effect(state, edit, made(state.document, edit, state.shown));
    return;
  }
  state.pending.waiting.push_back(std::move(edit));
  if (!state.pending.making.running()) start_making(state);
}

void advance_edits(EditorState& state) {
  PendingEdits& pending = state.pending;
  if (state.painting.stroking()) return;
  if (auto command = pending.making.take()) {
    // What was made of another document is made again of this one.
    if (pending.edits_before == state.edits) {
      const Edit edit = std::move(pending.waiting.front());
      pending.waiting.pop_front();
      take_effect(state, edit, std::move(*command));
    }
  }
  if (!pending.waiting.empty() && !pending.making.running()) start_making(state);
}

std::string pending_edit(const EditorState& state) {
  return state.pending.making.running() ? state.pending.making.what() : std::string();
}

void drop_pending_edits(EditorState& state) {
  state.pending.making.cancel();
  state.pending.waiting.clear();
}

}  // namespace biotope

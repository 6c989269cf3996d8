#include "ui/locking_commands.hpp"

#include "ui/edit_actions.hpp"
#include "ui/icons.hpp"

namespace biotope {
namespace {

struct LockRow {
  const char* id;
  const char* name;
  const char* keys;
  const char* tooltip;
  const char* icon;
  LockEdit::How how;
};

constexpr LockRow rows[] = {
    {"lock.add", "Lock the selection", "Ctrl+L", "No edit changes paint in what is selected, on any layer, until it is unlocked",
     icons::lock, LockEdit::How::add},
    {"lock.only", "Lock only the selection", "", "What is selected is locked, everything else is free", icons::lock,
     LockEdit::How::replace},
    {"lock.subtract", "Unlock the selection", "Ctrl+Shift+L", "Edits act again in what is selected", icons::unlock,
     LockEdit::How::subtract},
    {"lock.nothing", "Unlock everything", "", "Edits act everywhere again", icons::unlock, LockEdit::How::nothing}};

bool can(const EditorState& state, LockEdit::How how) {
  const bool locked = state.document.locked_area != nullptr;
  const bool selected = state.document.selection != nullptr;
  switch (how) {
    case LockEdit::How::replace:
    case LockEdit::How::add:
      return state.has_document && selected;
    case LockEdit::How::subtract:
      return locked && selected;
    case LockEdit::How::nothing:
      break;
  }
  return locked;
}

}  // namespace

void add_locking_commands(std::vector<EditorCommand>& list) {
  for (const LockRow& row : rows) {
    EditorCommand command = editor_command(row.id, "Edit", row.name, row.keys, row.tooltip, row.icon,
                                           [how = row.how](EditorState& state) { perform_edit(state, LockEdit{how}); });
    command.enabled = [how = row.how](const EditorState& state) { return can(state, how); };
    command.line_before = row.how == LockEdit::How::add;
    list.push_back(std::move(command));
  }
}

}  // namespace biotope

#pragma once

#include <functional>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "ui/editor_state.hpp"
#include "ui/shortcut.hpp"

namespace biotope {

/// Something a person can ask the editor to do. Menus, the toolbar, the palette, the shortcuts and Help are all made from these.
struct EditorCommand {
  std::string id;       ///< "file.open": stable, used in settings
  std::string menu;     ///< "File"; empty: only in the palette
  std::string name;     ///< "Open ..."
  std::string keys;     ///< its own shortcut; may be empty
  std::string tooltip;  ///< one sentence
  const char* icon = "";
  std::function<void(EditorState&)> run;
  /// Empty: always.
  std::function<bool(const EditorState&)> enabled = {};
  /// For commands that switch something; empty: not a switch.
  std::function<bool(const EditorState&)> checked = {};
  /// Runs again while the key is held.
  bool repeats = false;
  bool line_before = false;  ///< a line above it in its menu
};

/// The one list of commands, with the person's own shortcuts.
class CommandTable {
 public:
  /// Shortcuts by id replace commands' own; one that does not parse or names no command is skipped and told in `problems`.
  explicit CommandTable(std::vector<EditorCommand> commands, const std::map<std::string, std::string>& shortcuts = {});

  [[nodiscard]] const std::vector<EditorCommand>& all() const { return commands_; }
  [[nodiscard]] const EditorCommand* find(std::string_view id) const;
  [[nodiscard]] Shortcut shortcut(std::string_view id) const;
  /// Text of the shortcut; empty when there is none.
  [[nodiscard]] std::string keys(std::string_view id) const;
  /// The command of a key press; null when there is none.
  [[nodiscard]] const EditorCommand* of_keys(const Shortcut& pressed) const;
  /// Commands whose names hold the letters of `text` in order; whole words and beginnings first.
  [[nodiscard]] std::vector<const EditorCommand*> search(std::string_view text) const;
  /// Menus in the order of their first command.
  [[nodiscard]] std::vector<std::string> menus() const;
  [[nodiscard]] const std::vector<std::string>& problems() const { return problems_; }

 private:
  std::vector<EditorCommand> commands_;
  std::vector<Shortcut> shortcuts_;
  std::vector<std::string> problems_;
};

[[nodiscard]] bool enabled(const EditorCommand& command, const EditorState& state);
[[nodiscard]] bool checked(const EditorCommand& command, const EditorState& state);
/// Runs an enabled command; nothing otherwise.
void run(const EditorCommand& command, EditorState& state);

/// A command that is always there; what else it has is set on what is returned.
[[nodiscard]] EditorCommand editor_command(std::string id, std::string menu, std::string name, std::string keys,
                                           std::string tooltip, const char* icon, std::function<void(EditorState&)> action);
/// One that waits for a landscape.
[[nodiscard]] EditorCommand landscape_command(std::string id, std::string menu, std::string name, std::string keys,
                                              std::string tooltip, const char* icon, std::function<void(EditorState&)> action);
[[nodiscard]] bool has_document(const EditorState& state);

/// Every command of the editor.
[[nodiscard]] std::vector<EditorCommand> editor_commands();

}  // namespace biotope

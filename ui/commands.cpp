#include "ui/commands.hpp"

#include <algorithm>
#include <cctype>

namespace biotope {
namespace {

std::string lower(std::string_view text) {
  std::string result(text);
  std::transform(result.begin(), result.end(), result.begin(), [](unsigned char c) { return char(std::tolower(c)); });
  return result;
}

/// How well `wanted` fits `name` (both lower case): less is better, negative is not at all.
int rank(const std::string& name, const std::string& wanted) {
  if (wanted.empty()) return 0;
  const std::size_t at = name.find(wanted);
  if (at == 0) return 0;
  if (at != std::string::npos) return name[at - 1] == ' ' ? 1 : 2;
  std::size_t next = 0;
  for (const char c : name) {
    if (next < wanted.size() && c == wanted[next]) ++next;
  }
  return next == wanted.size() ? 3 : -1;
}

}  // namespace

CommandTable::CommandTable(std::vector<EditorCommand> commands, const std::map<std::string, std::string>& shortcuts)
    : commands_(std::move(commands)) {
  for (const EditorCommand& command : commands_) shortcuts_.push_back(parse_shortcut(command.keys).value_or(Shortcut{}));
  for (const auto& [id, keys] : shortcuts) {
    const auto found = std::find_if(commands_.begin(), commands_.end(), [&](const EditorCommand& c) { return c.id == id; });
    const auto parsed = parse_shortcut(keys);
    if (found == commands_.end()) {
      problems_.push_back("Shortcut for '" + id + "': there is no such command");
    } else if (!parsed) {
      problems_.push_back("Shortcut for '" + id + "': '" + keys + "' is not a key such as Ctrl+Shift+S");
    } else {
      shortcuts_[std::size_t(found - commands_.begin())] = *parsed;
    }
  }
}

const EditorCommand* CommandTable::find(std::string_view id) const {
  const auto found = std::find_if(commands_.begin(), commands_.end(), [&](const EditorCommand& c) { return c.id == id; });
  return found == commands_.end() ? nullptr : &*found;
}

Shortcut CommandTable::shortcut(std::string_view id) const {
  const EditorCommand* command = find(id);
  return command == nullptr ? Shortcut{} : shortcuts_[std::size_t(command - commands_.data())];
}

std::string CommandTable::keys(std::string_view id) const { return to_text(shortcut(id)); }

const EditorCommand* CommandTable::of_keys(const Shortcut& pressed) const {
  if (pressed.key == 0) return nullptr;
  const auto found = std::find(shortcuts_.begin(), shortcuts_.end(), pressed);
  return found == shortcuts_.end() ? nullptr : &commands_[std::size_t(found - shortcuts_.begin())];
}

std::vector<const EditorCommand*> CommandTable::search(std::string_view text) const {
  const std::string wanted = lower(text);
  std::vector<std::pair<int, const EditorCommand*>> ranked;
  for (const EditorCommand& command : commands_) {
    int best = rank(lower(command.name), wanted);
    const int with_menu = rank(lower(command.menu + " " + command.name), wanted);
    if (best < 0 || (with_menu >= 0 && with_menu < best)) best = with_menu;
    if (best >= 0) ranked.emplace_back(best, &command);
  }
  std::stable_sort(ranked.begin(), ranked.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
  std::vector<const EditorCommand*> result;
  for (const auto& entry : ranked) result.push_back(entry.second);
  return result;
}

std::vector<std::string> CommandTable::menus() const {
  std::vector<std::string> menus;
  for (const EditorCommand& command : commands_) {
    if (!command.menu.empty() && std::find(menus.begin(), menus.end(), command.menu) == menus.end())
      menus.push_back(command.menu);
  }
  return menus;
}

bool enabled(const EditorCommand& command, const EditorState& state) { return !command.enabled || command.enabled(state); }
bool checked(const EditorCommand& command, const EditorState& state) { return command.checked && command.checked(state); }

void run(const EditorCommand& command, EditorState& state) {
  if (enabled(command, state)) command.run(state);
}

EditorCommand editor_command(std::string id, std::string menu, std::string name, std::string keys, std::string tooltip,
                             const char* icon, std::function<void(EditorState&)> action) {
  EditorCommand command;
  command.id = std::move(id);
  command.menu = std::move(menu);
  command.name = std::move(name);
  command.keys = std::move(keys);
  command.tooltip = std::move(tooltip);
  command.icon = icon;
  command.run = std::move(action);
  return command;
}

EditorCommand landscape_command(std::string id, std::string menu, std::string name, std::string keys, std::string tooltip,
                                const char* icon, std::function<void(EditorState&)> action) {
  EditorCommand command = editor_command(std::move(id), std::move(menu), std::move(name), std::move(keys), std::move(tooltip),
                                         icon, std::move(action));
  command.enabled = has_document;
  return command;
}

bool has_document(const EditorState& state) { return state.has_document; }

}  // namespace biotope

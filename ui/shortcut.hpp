#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace biotope {

/// A key with modifiers. Keys are numbered as GLFW does: printable keys by their US-layout character in upper case.
struct Shortcut {
  int key = 0;  ///< 0: none
  bool control = false;
  bool shift = false;
  bool alt = false;
  bool operator==(const Shortcut&) const = default;
};

/// "Ctrl+Shift+S", "F5", "[", "Tab", "Space"; upper or lower case. Nothing for a key that has no name; an empty text is no
/// shortcut.
[[nodiscard]] std::optional<Shortcut> parse_shortcut(std::string_view text);
/// The text that parse_shortcut reads back; empty for no key.
[[nodiscard]] std::string to_text(const Shortcut& shortcut);

}  // namespace biotope

#include "ui/shortcut.hpp"

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <utility>

namespace biotope {
namespace {

constexpr std::array<std::pair<std::string_view, int>, 15> named_keys{{{"Space", GLFW_KEY_SPACE},
                                                                       {"Tab", GLFW_KEY_TAB},
                                                                       {"Enter", GLFW_KEY_ENTER},
                                                                       {"Esc", GLFW_KEY_ESCAPE},
                                                                       {"Backspace", GLFW_KEY_BACKSPACE},
                                                                       {"Delete", GLFW_KEY_DELETE},
                                                                       {"Left", GLFW_KEY_LEFT},
                                                                       {"Right", GLFW_KEY_RIGHT},
                                                                       {"Up", GLFW_KEY_UP},
                                                                       {"Down", GLFW_KEY_DOWN},
                                                                       {"Home", GLFW_KEY_HOME},
                                                                       {"End", GLFW_KEY_END},
                                                                       {"PageUp", GLFW_KEY_PAGE_UP},
                                                                       {"PageDown", GLFW_KEY_PAGE_DOWN},
                                                                       {"Insert", GLFW_KEY_INSERT}}};
constexpr std::string_view printable = "ABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789[],.;'/\\-=`";

bool same_text(std::string_view a, std::string_view b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(),
                    [](unsigned char x, unsigned char y) { return std::tolower(x) == std::tolower(y); });
}

int key_of(std::string_view name) {
  if (name.size() == 1) {
    const char upper = char(std::toupper(static_cast<unsigned char>(name[0])));
    return printable.find(upper) == std::string_view::npos ? 0 : int(upper);
  }
  for (const auto& [known, key] : named_keys) {
    if (same_text(known, name)) return key;
  }
  if (name.size() <= 3 && (name[0] == 'F' || name[0] == 'f')) {
    int number = 0;
    for (const char c : name.substr(1)) {
      if (c < '0' || c > '9') return 0;
      number = number * 10 + (c - '0');
    }
    if (number >= 1 && number <= 25) return GLFW_KEY_F1 + number - 1;
  }
  return 0;
}

std::string name_of(int key) {
  for (const auto& [known, code] : named_keys) {
    if (code == key) return std::string(known);
  }
  if (key >= GLFW_KEY_F1 && key <= GLFW_KEY_F25) return "F" + std::to_string(key - GLFW_KEY_F1 + 1);
  if (key > 0 && key < 128 && printable.find(char(key)) != std::string_view::npos) return std::string(1, char(key));
  return {};
}

}  // namespace

std::optional<Shortcut> parse_shortcut(std::string_view text) {
  Shortcut shortcut;
  if (text.empty()) return shortcut;
  while (true) {
    const std::size_t plus = text.find('+');
    if (plus == std::string_view::npos || plus + 1 >= text.size()) break;
    const std::string_view modifier = text.substr(0, plus);
    if (same_text(modifier, "Ctrl")) {
      shortcut.control = true;
    } else if (same_text(modifier, "Shift")) {
      shortcut.shift = true;
    } else if (same_text(modifier, "Alt")) {
      shortcut.alt = true;
    } else {
      return std::nullopt;
    }
    text.remove_prefix(plus + 1);
  }
  shortcut.key = key_of(text);
  if (shortcut.key == 0) return std::nullopt;
  return shortcut;
}

std::string to_text(const Shortcut& shortcut) {
  const std::string key = name_of(shortcut.key);
  if (key.empty()) return {};
  std::string text;
  if (shortcut.control) text += "Ctrl+";
  if (shortcut.shift) text += "Shift+";
  if (shortcut.alt) text += "Alt+";
  return text + key;
}

}  // namespace biotope

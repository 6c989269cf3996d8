#pragma once

#include <string>
#include <string_view>

#include "ui/commands.hpp"
#include "ui/editor_state.hpp"
#include "ui/theme.hpp"

namespace biotope {

/// What every part of the window is drawn with.
struct UiContext {
  EditorState& state;
  const Theme& theme;
  const CommandTable& commands;
};

/// Keys that windows over the editor listen to; GLFW's numbers.
enum class DialogKey : int { escape = 256, enter = 257, down = 264, up = 265 };
/// True when the key was pressed since the last frame; it is then taken, so that nothing else acts on it.
[[nodiscard]] bool take_key(EditorState& state, DialogKey key);

/// A tooltip after a short rest of the pointer over the last item: what it does and, in grey, its keys.
void tooltip(const Theme& theme, std::string_view text, std::string_view keys = {});
/// A square button with the command's icon, lit while it is on, with name, keys and sentence as a tooltip.
void command_button(const UiContext& ui, std::string_view id, float side);
/// A menu entry of a command.
void command_menu_item(const UiContext& ui, std::string_view id);

/// A quiet title over a group of controls.
void heading(const Theme& theme, std::string_view text);
/// Text for wrapped lines: a number stays on the line of its unit and of its groups of digits.
[[nodiscard]] std::string unbroken(std::string_view text);
/// Text that wraps at the window's edge, in a colour.
void wrapped(const ImVec4& colour, std::string_view text);
/// Grey text that wraps.
void hint(const Theme& theme, std::string_view text);
/// A name on the left in grey and a value at the right edge; on a line of its own where both do not fit.
void readout(const Theme& theme, std::string_view name, std::string_view value);
/// A slider as a bar that is filled up to the value, with its name and what the value says in it; true while it changes.
/// Ctrl+click lets one type the number.
bool labelled_slider(const Theme& theme, const char* name, float& value, float least, float most, const std::string& shown,
                     bool logarithmic = false);
/// A row of exclusive choices; true when `chosen` changed.
bool segmented(const Theme& theme, const char* id, std::initializer_list<const char*> names, int& chosen, float width);
/// An icon without a frame; lit on hover. True when clicked.
bool icon_button(const Theme& theme, const char* id, const char* icon, const ImVec4& colour, std::string_view tip);
/// A button in the accent colour, for the one thing a dialog is about.
bool primary_button(const Theme& theme, const char* name, float width = 0);
/// Text cut with "..." to fit a width.
[[nodiscard]] std::string fitted_text(std::string_view text, float width);
/// Text drawn at a place with a soft shadow, readable on any picture: white on dark, or `dark_ink` on light.
void shadowed_text(ImDrawList& list, ImFont* font, ImVec2 at, bool dark_ink, std::string_view text);

}  // namespace biotope

#pragma once

#include <vector>

#include "ui/commands.hpp"

namespace biotope {

/// Tools that draw and place things, copying and pasting paint, and brushes to start from: for the palette and the keys.
void add_placing_commands(std::vector<EditorCommand>& list);
void add_paint_copy_commands(std::vector<EditorCommand>& list);
void add_preset_commands(std::vector<EditorCommand>& list);

}  // namespace biotope

#pragma once

#include <vector>

#include "ui/commands.hpp"

namespace biotope {

/// Walking, herds, places, weather: what is done in the 3D view.
void add_exploring_commands(std::vector<EditorCommand>& list);
/// Pictures of it, for the File menu.
void add_picture_commands(std::vector<EditorCommand>& list);

}  // namespace biotope

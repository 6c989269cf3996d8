#pragma once

#include <vector>

#include "ui/commands.hpp"

namespace biotope {

/// Locks and unlocks the ground that is selected: no edit changes paint where it is locked.
void add_locking_commands(std::vector<EditorCommand>& list);

}  // namespace biotope

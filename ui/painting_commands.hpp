#pragma once

#include <vector>

#include "ui/commands.hpp"

namespace biotope {

/// Tools, selection and filling.
void add_painting_commands(std::vector<EditorCommand>& list);

}  // namespace biotope

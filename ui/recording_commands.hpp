#pragma once

#include <vector>

#include "ui/commands.hpp"

namespace biotope {

/// File > Record edits, Stop recording and save ..., Play edits ...
void add_recording_commands(std::vector<EditorCommand>& list);

}  // namespace biotope

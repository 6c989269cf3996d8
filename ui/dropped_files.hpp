#pragma once

#include <string>
#include <vector>

namespace biotope {

struct EditorState;

/// What files dropped on the window mean: one is opened or imported; of several the first that is a scene, else the first, and
/// the others are named.
void drop_files(EditorState& state, const std::vector<std::string>& files);

}  // namespace biotope

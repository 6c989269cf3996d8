#pragma once

#include "ui/editor_state.hpp"

namespace biotope {

/// Once a frame: has the figures that panels show (species, heights, water, trails, activity) counted in the background for the
/// newest landscape, takes what is ready, and tells what an edit changed once all of it is answered.
void follow_landscape(EditorState& state);

}  // namespace biotope

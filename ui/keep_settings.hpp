#pragma once

namespace biotope {

struct EditorState;

/// Writes what the editor remembers, the brush in the hand included, beside what was there and renames it. Whenever a scene was
/// opened or saved, and at the end: an editor that is killed forgets no recent file. Told once when it cannot be written.
void keep_settings(EditorState& state);

/// Takes the brush of the last session into the hand: all of its shape, its filter and its stamp. The tool stays.
void take_up_brush(EditorState& state);

}  // namespace biotope

#pragma once

#include "ui/widgets.hpp"

namespace biotope {

// Windows over the editor, one file each where they are more than a few lines.

void draw_palette(const UiContext& ui);
void draw_file_dialogs(const UiContext& ui);
void draw_shortcut_list(const UiContext& ui);
void draw_settings_dialog(const UiContext& ui);
void draw_sample_list(const UiContext& ui);
void draw_first_steps(const UiContext& ui);
void draw_file_request(const UiContext& ui);
void draw_playing(const UiContext& ui);
void draw_unsaved_recording(const UiContext& ui);
void draw_select_range(const UiContext& ui);
void draw_image_import(const UiContext& ui);

/// Opens (once) and begins a centred modal; end with ImGui::EndPopup. `open` is the flag in OpenDialogs, cleared when the modal
/// closes.
bool begin_modal(const UiContext& ui, const char* title, bool& open, float width, float height = 0);
/// The field for a file's name; it has the keyboard when the dialog opens. True when Enter accepts the dialog: pressed in the
/// field, or anywhere but in another field (`typing`: one had the keyboard before this frame's fields were drawn).
bool draw_file_name(const UiContext& ui, std::string& name, bool typing);
/// Buttons at the right edge: the caller draws `count` buttons of this width after it.
void align_buttons(const Theme& theme, int count, float width);

}  // namespace biotope

#pragma once

#include "ui/widgets.hpp"

namespace biotope {

/// The window with bookmarks and the camera's path.
void draw_views_window(const UiContext& ui);
/// What is being drawn into files, with its progress and a way to stop it.
void draw_export_card(const UiContext& ui);
/// Size of a picture, before its file is asked for.
void draw_picture_dialog(const UiContext& ui);

}  // namespace biotope

#include "ui/panels/picture_size.hpp"

#include <algorithm>
#include <array>

#include "ui/dialogs.hpp"
#include "ui/panels/views_window.hpp"
#include "ui/picture_export.hpp"

namespace biotope {
namespace {

struct NamedSize {
  const char* name;
  int width;
  int height;
};
constexpr std::array<NamedSize, 5> sizes{{{"HD, 1280 x 720", 1280, 720},
                                          {"Full HD, 1920 x 1080", 1920, 1080},
                                          {"4K, 3840 x 2160", 3840, 2160},
                                          {"8K, 7680 x 4320", 7680, 4320},
                                          {"Square, 4096 x 4096", 4096, 4096}}};
constexpr float button_width = 110;

}  // namespace

void draw_picture_size(const UiContext& ui) {
  PictureSession& pictures = ui.state.pictures;
  const auto known = std::find_if(sizes.begin(), sizes.end(), [&](const NamedSize& size) {
    return size.width == pictures.width && size.height == pictures.height;
  });
  ImGui::SetNextItemWidth(-1);
  if (ImGui::BeginCombo("##size", known != sizes.end() ? known->name : "Own size")) {
    for (const NamedSize& size : sizes) {
      if (!ImGui::Selectable(size.name, known != sizes.end() && &size == &*known)) continue;
      pictures.width = size.width;
      pictures.height = size.height;
    }
    ImGui::EndCombo();
  }
  tooltip(ui.theme, "Size of the pictures, pixels");
  std::array<int, 2> own{pictures.width, pictures.height};
  ImGui::SetNextItemWidth(-1);
  if (ImGui::InputInt2("##own", own.data())) {
    pictures.width = std::clamp(own[0], 16, largest_picture_side);
    pictures.height = std::clamp(own[1], 16, largest_picture_side);
  }
  tooltip(ui.theme, "Width and height, pixels");
}

void draw_picture_dialog(const UiContext& ui) {
  EditorState& state = ui.state;
  if (!begin_modal(ui, "Save the picture", state.dialogs.picture, 360)) return;
  ImGui::TextWrapped("The 3D view as it is now, drawn anew at this size and in high quality.");
  // Enter in a field ends that field only.
  const bool typing = ImGui::IsAnyItemActive();
  draw_picture_size(ui);
  ImGui::Dummy(ImVec2(0, ui.theme.px(6)));
  align_buttons(ui.theme, 2, button_width);
  const bool cancelled = ImGui::Button("Cancel", ImVec2(ui.theme.px(button_width), 0));
  ImGui::SameLine();
  const bool entered = !typing && take_key(state, DialogKey::enter);
  const bool accepted = primary_button(ui.theme, "Where ...", ui.theme.px(button_width)) || entered;
  if (cancelled || accepted) {
    state.dialogs.picture = false;
    ImGui::CloseCurrentPopup();
  }
  ImGui::EndPopup();
  if (accepted) ask_to_save_picture(state);
}

}  // namespace biotope

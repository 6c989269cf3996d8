#pragma once

#include <imgui.h>

#include <array>

namespace biotope {

/// Colours, sizes and fonts of the editor.
struct Theme {
  bool dark = true;
  /// Multiplies every size; 1 is a screen of about 96 dots an inch.
  float scale = 1;
  bool has_icons = false;

  ImVec4 window{}, panel{}, raised{}, line{};
  ImVec4 text{}, muted{};
  ImVec4 accent{};     ///< what is active
  ImVec4 attention{};  ///< what needs the person
  ImVec4 loss{};       ///< what would be lost, what failed

  ImFont* regular = nullptr;
  ImFont* bold = nullptr;
  ImFont* title = nullptr;
  ImFont* small = nullptr;

  /// A length at scale 1, in pixels of this screen.
  [[nodiscard]] float px(float length) const { return length * scale; }
};

[[nodiscard]] Theme make_theme(bool dark, float scale);

/// Makes the fonts and sets Dear ImGui's colours and sizes. Before the first frame, and again when theme or scale change (the
/// renderer's font texture must then be made again).
void apply_theme(Theme& theme);

[[nodiscard]] inline ImU32 colour_u32(const ImVec4& colour) { return ImGui::ColorConvertFloat4ToU32(colour); }
[[nodiscard]] inline ImVec4 with_alpha(ImVec4 colour, float alpha) {
  colour.w = alpha;
  return colour;
}
[[nodiscard]] inline ImVec4 to_imgui(const std::array<float, 3>& colour, float alpha = 1) {
  return {colour[0], colour[1], colour[2], alpha};
}

}  // namespace biotope

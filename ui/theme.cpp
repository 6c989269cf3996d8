#include "ui/theme.hpp"

#include <imgui_internal.h>

#include <algorithm>
#include <filesystem>
#include <string>

#include "ui/icons.hpp"

namespace biotope {
namespace {

constexpr float text_size = 15;

ImVec4 rgb(unsigned hex, float alpha = 1) {
  return {float((hex >> 16) & 255) / 255, float((hex >> 8) & 255) / 255, float(hex & 255) / 255, alpha};
}

std::string inter(const char* weight) { return std::string("/usr/share/fonts/opentype/inter/Inter-") + weight + ".otf"; }

/// Figures of one width, so that readouts do not tremble while they change.
void make_figures_tabular(ImFont& font) {
  float widest = 0;
  for (char figure = '0'; figure <= '9'; ++figure) {
    const ImFontGlyph* glyph = font.FindGlyphNoFallback(ImWchar(figure));
    if (glyph != nullptr) widest = std::max(widest, glyph->AdvanceX);
  }
  for (ImFontGlyph& glyph : font.Glyphs) {
    if (glyph.Codepoint < '0' || glyph.Codepoint > '9') continue;
    const float shift = float(int((widest - glyph.AdvanceX) / 2 + 0.5F));
    glyph.X0 += shift;
    glyph.X1 += shift;
    glyph.AdvanceX = widest;
    font.IndexAdvanceX[int(glyph.Codepoint)] = widest;
  }
}

ImFont* add_font(const Theme& theme, const char* weight, float size) {
  static constexpr ImWchar ranges[] = {0x0020, 0x00ff, 0x0100, 0x017f, 0x2010, 0x2026, 0x00b2, 0x00b3, 0x2190, 0x2193, 0};
  ImFontAtlas& fonts = *ImGui::GetIO().Fonts;
  ImFontConfig config;
  config.OversampleH = theme.scale >= 1.5F ? 1 : 2;
  config.PixelSnapH = true;
  const std::string file = inter(weight);
  const float pixels = float(int(size * theme.scale + 0.5F));
  if (std::filesystem::exists(file)) return fonts.AddFontFromFileTTF(file.c_str(), pixels, &config, ranges);
  config.SizePixels = float(int(13 * theme.scale));
  return fonts.AddFontDefault(&config);
}

bool merge_icons(const Theme& theme, float size) {
  static constexpr ImWchar ranges[] = {icons::first, icons::last, 0};
  const char* file = "/usr/share/fonts/opentype/font-awesome/FontAwesome.otf";
  if (!std::filesystem::exists(file)) return false;
  ImFontConfig config;
  config.MergeMode = true;
  config.PixelSnapH = true;
  config.GlyphMinAdvanceX = size * theme.scale;
  config.GlyphOffset.y = float(int(theme.scale + 0.5F));
  return ImGui::GetIO().Fonts->AddFontFromFileTTF(file, float(int(size * theme.scale + 0.5F)), &config, ranges) != nullptr;
}

void make_fonts(Theme& theme) {
  ImFontAtlas& fonts = *ImGui::GetIO().Fonts;
  fonts.Clear();
  theme.regular = add_font(theme, "Regular", text_size);
  theme.has_icons = merge_icons(theme, text_size - 1);
  theme.bold = add_font(theme, "SemiBold", text_size);
  theme.title = add_font(theme, "SemiBold", text_size + 4);
  theme.small = add_font(theme, "Regular", text_size - 2);
  merge_icons(theme, text_size - 3);
  fonts.Build();
  for (ImFont* font : {theme.regular, theme.bold, theme.title, theme.small}) make_figures_tabular(*font);
}

void set_metrics(const Theme& theme, ImGuiStyle& style) {
  style = ImGuiStyle();
  style.WindowPadding = {12, 8};
  style.FramePadding = {8, 4};
  style.ItemSpacing = {8, 6};
  style.ItemInnerSpacing = {6, 4};
  style.CellPadding = {4, 3};
  style.IndentSpacing = 16;
  style.ScrollbarSize = 11;
  style.GrabMinSize = 10;
  style.WindowRounding = style.ChildRounding = style.PopupRounding = 4;
  style.FrameRounding = style.GrabRounding = style.TabRounding = 4;
  style.ScrollbarRounding = 6;
  style.WindowBorderSize = style.ChildBorderSize = style.FrameBorderSize = 0;
  style.PopupBorderSize = 1;
  style.ScaleAllSizes(theme.scale);
  style.PopupBorderSize = 1;
}

void set_surface_colours(const Theme& t, ImVec4* c) {
  c[ImGuiCol_Text] = t.text;
  c[ImGuiCol_TextDisabled] = t.muted;
  c[ImGuiCol_WindowBg] = t.window;
  c[ImGuiCol_ChildBg] = ImVec4(0, 0, 0, 0);
  c[ImGuiCol_PopupBg] = t.dark ? rgb(0x2b2f33, 0.99F) : rgb(0xfbfbf9, 0.99F);
  c[ImGuiCol_Border] = t.line;
  c[ImGuiCol_MenuBarBg] = t.window;
  c[ImGuiCol_TitleBg] = t.panel;
  c[ImGuiCol_TitleBgActive] = t.raised;
  c[ImGuiCol_Separator] = t.line;
  c[ImGuiCol_SeparatorHovered] = c[ImGuiCol_SeparatorActive] = t.accent;
  c[ImGuiCol_ScrollbarBg] = ImVec4(0, 0, 0, 0);
  c[ImGuiCol_ScrollbarGrab] = with_alpha(t.muted, 0.30F);
  c[ImGuiCol_ScrollbarGrabHovered] = with_alpha(t.muted, 0.50F);
  c[ImGuiCol_ScrollbarGrabActive] = with_alpha(t.muted, 0.70F);
  c[ImGuiCol_ModalWindowDimBg] = ImVec4(0, 0, 0, t.dark ? 0.45F : 0.30F);
  c[ImGuiCol_TableHeaderBg] = t.raised;
  c[ImGuiCol_TableBorderLight] = c[ImGuiCol_TableBorderStrong] = t.line;
  c[ImGuiCol_TableRowBgAlt] = with_alpha(t.text, 0.025F);
}

void set_control_colours(const Theme& t, ImVec4* c) {
  c[ImGuiCol_FrameBg] = t.raised;
  c[ImGuiCol_FrameBgHovered] = t.dark ? rgb(0x3c4147) : rgb(0xcdd1ca);
  c[ImGuiCol_FrameBgActive] = t.dark ? rgb(0x444a50) : rgb(0xc2c7bf);
  c[ImGuiCol_Button] = t.raised;
  c[ImGuiCol_ButtonHovered] = c[ImGuiCol_FrameBgHovered];
  c[ImGuiCol_ButtonActive] = c[ImGuiCol_FrameBgActive];
  c[ImGuiCol_CheckMark] = t.accent;
  c[ImGuiCol_SliderGrab] = with_alpha(t.accent, 0.90F);
  c[ImGuiCol_SliderGrabActive] = t.accent;
  c[ImGuiCol_Header] = with_alpha(t.accent, 0.22F);
  c[ImGuiCol_HeaderHovered] = with_alpha(t.text, 0.08F);
  c[ImGuiCol_HeaderActive] = with_alpha(t.accent, 0.35F);
  c[ImGuiCol_TextSelectedBg] = with_alpha(t.accent, 0.40F);
  c[ImGuiCol_NavHighlight] = t.accent;
  c[ImGuiCol_PlotHistogram] = t.accent;
  c[ImGuiCol_DragDropTarget] = t.accent;
}

}  // namespace

Theme make_theme(bool dark, float scale) {
  Theme theme;
  theme.dark = dark;
  theme.scale = scale;
  if (dark) {
    theme.window = rgb(0x1e2124);
    theme.panel = rgb(0x26292d);
    theme.raised = rgb(0x34383d);
    theme.line = rgb(0x34383d);
    theme.text = rgb(0xdfe2e0);
    theme.muted = rgb(0x949a9e);
    theme.accent = rgb(0x7fb069);
    theme.attention = rgb(0xe0a83e);
    theme.loss = rgb(0xe0645a);
  } else {
    theme.window = rgb(0xe6e8e4);
    theme.panel = rgb(0xf4f5f2);
    theme.raised = rgb(0xd7dad4);
    theme.line = rgb(0xcdd0ca);
    theme.text = rgb(0x23282a);
    theme.muted = rgb(0x646c6e);
    theme.accent = rgb(0x4f8a3a);
    theme.attention = rgb(0xa86c08);
    theme.loss = rgb(0xb83a30);
  }
  return theme;
}

void apply_theme(Theme& theme) {
  make_fonts(theme);
  ImGuiStyle& style = ImGui::GetStyle();
  set_metrics(theme, style);
  set_surface_colours(theme, style.Colors);
  set_control_colours(theme, style.Colors);
}

}  // namespace biotope

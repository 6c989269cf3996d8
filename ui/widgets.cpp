#include "ui/widgets.hpp"

#include <imgui_internal.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <set>

namespace biotope {
namespace {

void text(std::string_view value) { ImGui::TextUnformatted(value.data(), value.data() + value.size()); }

}  // namespace

bool take_key(EditorState& state, DialogKey key) {
  const auto pressed = [&](const KeyPress& press) { return press.keys.key == int(key); };
  return std::erase_if(state.key_presses, pressed) > 0;
}

void tooltip(const Theme& theme, std::string_view words, std::string_view keys) {
  const bool rests = GImGui->HoveredIdTimer >= 0.35F && !ImGui::IsMouseDown(ImGuiMouseButton_Left);
  if (!rests || !ImGui::IsItemHovered(ImGuiHoveredFlags_AllowWhenDisabled)) return;
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, ImVec2(theme.px(8), theme.px(6)));
  ImGui::BeginTooltip();
  ImGui::PushTextWrapPos(theme.px(300));
  text(unbroken(words));
  ImGui::PopTextWrapPos();
  if (!keys.empty()) {
    ImGui::PushStyleColor(ImGuiCol_Text, theme.muted);
    text(keys);
    ImGui::PopStyleColor();
  }
  ImGui::EndTooltip();
  ImGui::PopStyleVar();
}

void command_button(const UiContext& ui, std::string_view id, float side) {
  const EditorCommand* command = ui.commands.find(id);
  if (command == nullptr) return;
  const bool lit = checked(*command, ui.state);
  const bool usable = enabled(*command, ui.state);
  const Theme& theme = ui.theme;
  ImGui::PushStyleColor(ImGuiCol_Button, lit ? with_alpha(theme.accent, 0.28F) : ImVec4(0, 0, 0, 0));
  ImGui::PushStyleColor(ImGuiCol_Text, lit ? theme.accent : theme.text);
  ImGui::PushStyleVar(ImGuiStyleVar_FramePadding, ImVec2(0, 0));
  ImGui::BeginDisabled(!usable);
  const std::string label = (theme.has_icons ? std::string(command->icon) : command->name.substr(0, 1)) + "##" + command->id;
  if (ImGui::Button(label.c_str(), ImVec2(side, side))) run(*command, ui.state);
  ImGui::EndDisabled();
  ImGui::PopStyleVar();
  ImGui::PopStyleColor(2);
  const std::string words = command->name == command->tooltip ? command->name : command->name + "\n" + command->tooltip;
  tooltip(theme, words, ui.commands.keys(id));
}

void command_menu_item(const UiContext& ui, std::string_view id) {
  const EditorCommand* command = ui.commands.find(id);
  if (command == nullptr) return;
  if (command->line_before) ImGui::Separator();
  const std::string keys = ui.commands.keys(id);
  if (ImGui::MenuItem(command->name.c_str(), keys.c_str(), checked(*command, ui.state), enabled(*command, ui.state))) {
    run(*command, ui.state);
  }
  tooltip(ui.theme, command->tooltip);
}

void heading(const Theme& theme, std::string_view words) {
  ImGui::Dummy(ImVec2(0, theme.px(4)));
  ImGui::PushFont(theme.bold);
  text(words);
  ImGui::PopFont();
}

std::string unbroken(std::string_view words) {
  static constexpr std::string_view hard_space = "\xc2\xa0";
  const auto digit = [&](std::size_t at) { return at < words.size() && words[at] >= '0' && words[at] <= '9'; };
  const auto goes_on = [&](std::size_t at) {
    // Digits, a percent sign, or a unit: one to four letters such as "m", "km", "kg/yr".
    if (digit(at) || (at < words.size() && words[at] == '%')) return true;
    std::size_t letters = 0;
    while (at + letters < words.size() && std::isalpha(static_cast<unsigned char>(words[at + letters])) != 0) ++letters;
    const char after = at + letters < words.size() ? words[at + letters] : ' ';
    static const std::set<std::string_view> units{"m", "km", "mm",  "ha", "kg",  "t",   "h",
                                                  "s", "ms", "fps", "B",  "KiB", "MiB", "GiB"};
    return after == '/' || units.contains(words.substr(at, letters));
  };
  std::string result;
  for (std::size_t i = 0; i < words.size(); ++i) {
    const bool between = words[i] == ' ' && i > 0 && digit(i - 1) && goes_on(i + 1);
    if (between) {
      result += hard_space;
    } else {
      result += words[i];
    }
  }
  return result;
}

void wrapped(const ImVec4& colour, std::string_view words) {
  ImGui::PushStyleColor(ImGuiCol_Text, colour);
  ImGui::PushTextWrapPos(0);
  text(unbroken(words));
  ImGui::PopTextWrapPos();
  ImGui::PopStyleColor();
}

void hint(const Theme& theme, std::string_view words) { wrapped(theme.muted, words); }

void readout(const Theme& theme, std::string_view name, std::string_view value) {
  const float room = ImGui::GetContentRegionAvail().x;
  const float wanted = ImGui::CalcTextSize(value.data(), value.data() + value.size()).x;
  const float named = ImGui::CalcTextSize(name.data(), name.data() + name.size()).x;
  ImGui::PushStyleColor(ImGuiCol_Text, theme.muted);
  text(fitted_text(name, room));
  ImGui::PopStyleColor();
  const std::string shown = fitted_text(value, room);
  const float right = ImGui::GetContentRegionMax().x - ImGui::CalcTextSize(shown.c_str()).x;
  if (named + theme.px(10) + wanted <= room) {
    ImGui::SameLine(right);
  } else {
    ImGui::SetCursorPosX(right);
  }
  text(shown);
}

namespace {

/// Where a value lies between the ends of its slider, 0..1.
float share_of(float value, float least, float most, bool logarithmic) {
  const bool by_ratio = logarithmic && least > 0 && value > 0;
  const float share = by_ratio ? std::log(value / least) / std::log(most / least) : (value - least) / (most - least);
  return std::isfinite(share) ? std::clamp(share, 0.0F, 1.0F) : 0;
}

}  // namespace

bool labelled_slider(const Theme& theme, const char* name, float& value, float least, float most, const std::string& shown,
                     bool logarithmic) {
  ImGui::PushID(name);
  ImGui::SetNextItemWidth(-1);
  for (const ImGuiCol part : {ImGuiCol_SliderGrab, ImGuiCol_SliderGrabActive}) ImGui::PushStyleColor(part, ImVec4(0, 0, 0, 0));
  const bool changed = ImGui::SliderFloat("##slider", &value, least, most, "", logarithmic ? ImGuiSliderFlags_Logarithmic : 0);
  ImGui::PopStyleColor(2);
  const ImVec2 low = ImGui::GetItemRectMin();
  const ImVec2 high = ImGui::GetItemRectMax();
  // While a number is typed the field shows it.
  const bool typing = ImGui::TempInputIsActive(ImGui::GetItemID());
  ImGui::PopID();
  if (typing) return changed;
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const bool lit = ImGui::IsItemHovered() || ImGui::IsItemActive();
  const float end = low.x + (high.x - low.x) * share_of(value, least, most, logarithmic);
  const float alpha = ImGui::GetStyle().Alpha;
  list.PushClipRect(low, ImVec2(end, high.y), true);
  list.AddRectFilled(low, high, colour_u32(with_alpha(theme.accent, (lit ? 0.55F : 0.42F) * alpha)), theme.px(4));
  list.PopClipRect();
  const float inset = theme.px(8);
  const float top = low.y + (high.y - low.y - ImGui::GetFontSize()) / 2;
  const float room = high.x - low.x - 2 * inset;
  const std::string words = fitted_text(shown, room);
  const float width = ImGui::CalcTextSize(words.c_str()).x;
  list.AddText(ImVec2(low.x + inset, top), colour_u32(with_alpha(theme.text, 0.86F * alpha)),
               fitted_text(name, room - width - theme.px(10)).c_str());
  list.AddText(ImVec2(high.x - inset - width, top), colour_u32(with_alpha(theme.text, alpha)), words.c_str());
  return changed;
}

bool segmented(const Theme& theme, const char* id, std::initializer_list<const char*> names, int& chosen, float width) {
  ImGui::PushID(id);
  ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, ImVec2(theme.px(2), 0));
  bool changed = false;
  int index = 0;
  const float each = (width - theme.px(2) * float(names.size() - 1)) / float(names.size());
  for (const char* name : names) {
    if (index > 0) ImGui::SameLine();
    const bool lit = index == chosen;
    ImGui::PushStyleColor(ImGuiCol_Button, lit ? with_alpha(theme.accent, 0.30F) : theme.raised);
    if (ImGui::Button(name, ImVec2(each, 0)) && !lit) {
      chosen = index;
      changed = true;
    }
    ImGui::PopStyleColor();
    ++index;
  }
  ImGui::PopStyleVar();
  ImGui::PopID();
  return changed;
}

bool icon_button(const Theme& theme, const char* id, const char* icon, const ImVec4& colour, std::string_view tip) {
  const float side = ImGui::GetFontSize() + theme.px(6);
  ImGui::PushID(id);
  ImGui::PushStyleColor(ImGuiCol_Button, ImVec4(0, 0, 0, 0));
  ImGui::PushStyleColor(ImGuiCol_Text, colour);
  ImGui::PushStyleVar(ImGuiStyleVar_FramePadding, ImVec2(0, 0));
  const bool clicked = ImGui::Button(icon, ImVec2(side, side));
  ImGui::PopStyleVar();
  ImGui::PopStyleColor(2);
  ImGui::PopID();
  tooltip(theme, tip);
  return clicked;
}

bool primary_button(const Theme& theme, const char* name, float width) {
  ImGui::PushStyleColor(ImGuiCol_Button, with_alpha(theme.accent, theme.dark ? 0.75F : 0.95F));
  ImGui::PushStyleColor(ImGuiCol_ButtonHovered, theme.accent);
  ImGui::PushStyleColor(ImGuiCol_ButtonActive, with_alpha(theme.accent, 0.85F));
  ImGui::PushStyleColor(ImGuiCol_Text, theme.dark ? ImVec4(0.06F, 0.08F, 0.05F, 1) : ImVec4(1, 1, 1, 1));
  const bool clicked = ImGui::Button(name, ImVec2(width, 0));
  ImGui::PopStyleColor(4);
  return clicked;
}

std::string fitted_text(std::string_view words, float width) {
  if (ImGui::CalcTextSize(words.data(), words.data() + words.size()).x <= width) return std::string(words);
  std::string cut(words);
  while (!cut.empty()) {
    // Whole UTF-8 characters only.
    do {
      cut.pop_back();
    } while (!cut.empty() && (static_cast<unsigned char>(cut.back()) & 0xc0U) == 0x80U);
    if (!cut.empty() && static_cast<unsigned char>(cut.back()) >= 0xc0U) cut.pop_back();
    const std::string shown = cut + "...";
    if (ImGui::CalcTextSize(shown.c_str()).x <= width) return shown;
  }
  return "...";
}

void shadowed_text(ImDrawList& list, ImFont* font, ImVec2 at, bool dark_ink, std::string_view words) {
  const float size = font->FontSize;
  const float offset = std::max(1.0F, size / 15);
  const char* end = words.data() + words.size();
  const ImU32 halo = dark_ink ? IM_COL32(255, 255, 255, 170) : IM_COL32(0, 0, 0, 170);
  const ImU32 ink = dark_ink ? IM_COL32(24, 28, 30, 255) : IM_COL32(255, 255, 255, 255);
  list.AddText(font, size, ImVec2(at.x + offset, at.y + offset), halo, words.data(), end);
  list.AddText(font, size, at, ink, words.data(), end);
}

}  // namespace biotope

#include <algorithm>
#include <array>
#include <cmath>

#include "core/terrain/sun.hpp"
#include "ui/format.hpp"
#include "ui/icons.hpp"
#include "ui/parts.hpp"
#include "ui/weather_control.hpp"

namespace biotope {
namespace {

/// Colour of the sky at a height of the sun, degrees: night, dusk, day.
ImU32 sky_colour(double degrees, bool dark) {
  const float day = float(std::clamp((degrees + 6) / 18, 0.0, 1.0));
  const float dusk = float(std::exp(-degrees * degrees / 60));
  const float base = dark ? 0.13F : 0.62F;
  const float lift = dark ? 0.20F : 0.26F;
  return colour_u32(
      {base + lift * 0.55F * day + 0.26F * dusk, base + lift * 0.80F * day + 0.12F * dusk, base + 0.05F + lift * day, 1});
}

/// The day from 0 to 24 h: sky behind, the sun's height as a curve, how many herds are up as bars.
void draw_day(const UiContext& ui, ImVec2 at, ImVec2 size) {
  const EditorState& state = ui.state;
  const Theme& theme = ui.theme;
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const double latitude = state.document.terrain ? state.document.terrain->latitude : 43;
  const double day = middle_day(state.clock.month);
  const auto sun = [&](double hour) { return sun_position(latitude, day, hour).elevation * 57.29577951; };
  constexpr int steps = 96;
  for (int i = 0; i < steps; ++i) {
    const float x0 = at.x + size.x * float(i) / steps;
    const float x1 = at.x + size.x * float(i + 1) / steps;
    const ImU32 a = sky_colour(sun(24.0 * i / steps), theme.dark);
    const ImU32 b = sky_colour(sun(24.0 * (i + 1) / steps), theme.dark);
    list.AddRectFilledMultiColor(ImVec2(x0, at.y), ImVec2(x1, at.y + size.y), a, b, b, a);
  }
  const std::vector<float>& awake = state.activity;
  for (std::size_t i = 0; i < awake.size(); ++i) {
    const float x0 = at.x + size.x * float(i) / float(awake.size());
    const float x1 = at.x + size.x * float(i + 1) / float(awake.size()) - 1;
    list.AddRectFilled(ImVec2(x0, at.y + size.y * (1 - 0.8F * awake[i])), ImVec2(x1, at.y + size.y),
                       colour_u32(with_alpha(theme.accent, 0.38F)));
  }
  const auto curve_y = [&](double degrees) { return at.y + size.y * float(0.92 - 0.86 * std::clamp(degrees, 0.0, 90.0) / 90); };
  std::array<ImVec2, steps + 1> curve;
  for (int i = 0; i <= steps; ++i)
    curve[std::size_t(i)] = ImVec2(at.x + size.x * float(i) / steps, curve_y(sun(24.0 * i / steps)));
  list.AddPolyline(curve.data(), int(curve.size()), IM_COL32(255, 222, 140, theme.dark ? 170 : 255), 0, theme.px(1.5F));
  for (int hour = 0; hour <= 24; hour += 6) {
    const float x = at.x + size.x * float(hour) / 24;
    if (hour > 0 && hour < 24) list.AddLine(ImVec2(x, at.y), ImVec2(x, at.y + size.y), IM_COL32(255, 255, 255, 28));
  }
  const float now = at.x + size.x * float(state.clock.hour / 24);
  list.AddLine(ImVec2(now, at.y), ImVec2(now, at.y + size.y), IM_COL32(255, 255, 255, 230), theme.px(2));
  list.AddCircleFilled(ImVec2(now, curve_y(sun(state.clock.hour))), theme.px(4.5F), IM_COL32(255, 224, 130, 255), 20);
}

void draw_hours(const Theme& theme, ImVec2 at, float width) {
  ImDrawList& list = *ImGui::GetWindowDrawList();
  ImGui::PushFont(theme.small);
  const int step = width > theme.px(420) ? 3 : width > theme.px(170) ? 6 : 12;
  for (int hour = 0; hour <= 24; hour += step) {
    const std::string words = std::to_string(hour) + (hour == 24 ? " h" : "");
    const float half = ImGui::CalcTextSize(words.c_str()).x / 2;
    const float x = std::clamp(at.x + width * float(hour) / 24 - half, at.x, at.x + width - 2 * half);
    list.AddText(ImVec2(x, at.y), colour_u32(theme.muted), words.c_str());
  }
  ImGui::PopFont();
}

void draw_play(const UiContext& ui) {
  EditorState& state = ui.state;
  const float side = ui.theme.px(34);
  const char* icon = ui.theme.has_icons ? (state.clock.playing ? icons::pause : icons::play) : (state.clock.playing ? "||" : ">");
  ImGui::PushStyleVar(ImGuiStyleVar_FramePadding, ImVec2(0, 0));
  ImGui::PushStyleVar(ImGuiStyleVar_FrameRounding, side / 2);
  if (ImGui::Button((std::string(icon) + "##play").c_str(), ImVec2(side, side))) state.clock.playing = !state.clock.playing;
  ImGui::PopStyleVar(2);
  tooltip(ui.theme, state.clock.playing ? "Pause the day" : "Play the day: herds walk, light moves", "Space over the clock");
}

/// The twelve months as letters; the chosen one is lit, a drag runs through the year.
void draw_months(const UiContext& ui, float width) {
  EditorState& state = ui.state;
  const Theme& theme = ui.theme;
  const float height = ImGui::GetFrameHeight();
  const ImVec2 at = ImGui::GetCursorScreenPos();
  ImGui::InvisibleButton("months", ImVec2(width, height));
  const float each = width / float(months);
  const int under = std::clamp(int((ImGui::GetIO().MousePos.x - at.x) / each), 0, months - 1);
  if (ImGui::IsItemActive()) state.clock.month = under;
  const bool hovered = ImGui::IsItemHovered();
  tooltip(theme, std::string(month_name(hovered ? under : state.clock.month)) +
                     "\nThe month sets the sun, the season of the plants in 3D and the monthly maps");
  ImDrawList& list = *ImGui::GetWindowDrawList();
  list.AddRectFilled(at, ImVec2(at.x + width, at.y + height), colour_u32(theme.raised), theme.px(4));
  ImGui::PushFont(theme.small);
  for (int month = 0; month < months; ++month) {
    const bool chosen = month == state.clock.month;
    const float left = at.x + each * float(month);
    if (chosen) list.AddRectFilled(ImVec2(left, at.y), ImVec2(left + each, at.y + height), colour_u32(theme.accent), theme.px(3));
    const std::string letter(month_name(month).substr(0, 1));
    const ImVec2 size = ImGui::CalcTextSize(letter.c_str());
    const ImVec4 ink = chosen                      ? (theme.dark ? ImVec4(0.06F, 0.08F, 0.05F, 1) : ImVec4(1, 1, 1, 1))
                       : hovered && month == under ? theme.text
                                                   : theme.muted;
    list.AddText(ImVec2(left + (each - size.x) / 2, at.y + (height - size.y) / 2), colour_u32(ink), letter.c_str());
  }
  ImGui::PopFont();
}

void draw_speed_and_month(const UiContext& ui, float width) {
  EditorState& state = ui.state;
  struct Speed {
    const char* name;
    double hours_a_second;
  };
  static constexpr std::array<Speed, 4> speeds{{{"1 min/s", 1.0 / 60}, {"5 min/s", 5.0 / 60}, {"15 min/s", 0.25}, {"1 h/s", 1}}};
  const auto current = std::min_element(speeds.begin(), speeds.end(), [&](const Speed& a, const Speed& b) {
    return std::abs(a.hours_a_second - state.clock.speed) < std::abs(b.hours_a_second - state.clock.speed);
  });
  ImGui::BeginGroup();
  ImGui::SetNextItemWidth(width);
  if (ImGui::BeginCombo("##speed", current->name)) {
    for (const Speed& speed : speeds) {
      if (ImGui::Selectable(speed.name, &speed == &*current)) state.clock.speed = speed.hours_a_second;
    }
    ImGui::EndCombo();
  }
  tooltip(ui.theme, "How fast the day plays");
  draw_months(ui, width);
  ImGui::EndGroup();
}

}  // namespace

void draw_clock_bar(const UiContext& ui, ImVec2 size) {
  EditorState& state = ui.state;
  const Theme& theme = ui.theme;
  const float right_width = theme.px(168);
  const ImVec2 start = ImGui::GetCursorPos();
  ImGui::SetCursorPosY(start.y + theme.px(2));
  draw_play(ui);
  ImGui::SetCursorPos(ImVec2(start.x - theme.px(3), start.y + theme.px(40)));
  ImGui::TextUnformatted(format_clock(state.clock.hour).c_str());
  const float left = start.x + theme.px(52);
  const float weather_width = theme.px(126);
  const float width = std::max(size.x - left - right_width - weather_width - theme.px(38), theme.px(60));
  const float height = theme.px(44);
  ImGui::SetCursorPos(ImVec2(left, start.y));
  const ImVec2 at = ImGui::GetCursorScreenPos();
  ImGui::InvisibleButton("day", ImVec2(width, height + theme.px(16)));
  if (ImGui::IsItemActive()) {
    state.clock.hour = std::clamp(double((ImGui::GetIO().MousePos.x - at.x) / width) * 24, 0.0, 23.999);
  }
  tooltip(theme, "Drag to any hour. The curve is the sun's height, the bars show how many herds are up");
  draw_day(ui, at, ImVec2(width, height));
  draw_hours(theme, ImVec2(at.x, at.y + height + theme.px(1)), width);
  ImGui::SetCursorPos(ImVec2(left + width + theme.px(14), start.y));
  draw_weather_control(ui, weather_width);
  ImGui::SetCursorPos(ImVec2(left + width + weather_width + theme.px(28), start.y));
  draw_speed_and_month(ui, right_width);
  const bool over = ImGui::IsWindowHovered(ImGuiHoveredFlags_AllowWhenBlockedByActiveItem);
  const auto is_space = [](const KeyPress& press) { return press.keys == Shortcut{' ', false, false, false} && !press.repeat; };
  if (over && !ImGui::GetIO().WantTextInput && std::erase_if(state.key_presses, is_space) > 0)
    state.clock.playing = !state.clock.playing;
}

}  // namespace biotope

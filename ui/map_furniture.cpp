#include "ui/map_furniture.hpp"

#include <algorithm>
#include <cmath>

#include "render/map_colours.hpp"
#include "ui/format.hpp"
#include "ui/view_transform.hpp"

namespace biotope {
namespace {

ImU32 plate_colour(const Theme& theme) { return theme.dark ? IM_COL32(24, 26, 29, 215) : IM_COL32(250, 250, 248, 225); }

std::string tick_text(double value, const std::string& unit) {
  return unit == "%" ? format_round_number(value * 100) + " %" : format_round_number(value);
}

ImVec2 draw_class_legend(const Theme& theme, ImVec2 corner, const MapEntry& map) {
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const float row = ImGui::GetFontSize() + theme.px(3);
  const float width = theme.px(150);
  const float height = row * float(map.classes.size() + 1) + theme.px(14);
  const ImVec2 top(corner.x, corner.y - height);
  list.AddRectFilled(top, ImVec2(top.x + width, corner.y), plate_colour(theme), theme.px(4));
  float y = top.y + theme.px(7);
  list.AddText(ImVec2(top.x + theme.px(10), y), colour_u32(theme.text), map.title.c_str());
  for (std::size_t i = 0; i < map.classes.size(); ++i) {
    y += row;
    const ImVec2 chip(top.x + theme.px(10), y + theme.px(3));
    list.AddRectFilled(chip, ImVec2(chip.x + theme.px(14), chip.y + row - theme.px(6)),
                       colour_u32(to_imgui(category_colour(int(i)))), theme.px(2));
    list.AddText(ImVec2(top.x + theme.px(32), y), colour_u32(theme.text), map.classes[i].c_str());
  }
  return {width + theme.px(12), height + theme.px(12)};
}

}  // namespace

float round_up(float value) {
  if (!(value > 0) || !std::isfinite(value)) return value;
  const double decade = std::pow(10, std::floor(std::log10(double(value))));
  for (const double step : {1.0, 2.0, 5.0}) {
    // A hair above a round number is that number.
    if (double(value) <= step * decade * 1.0001) return float(step * decade);
  }
  return float(10 * decade);
}

float line_step(const ScaleRange& range) {
  const std::vector<double> ticks = round_ticks(range.low, range.high, 6);
  return ticks.size() < 2 ? 0 : float(ticks[1] - ticks[0]);
}

ScaleRange scale_range(const MapEntry& map, float least, float greatest) {
  if (map.colours == ColourMap::diverging && !map.low && !map.high) {
    // More and less are read against the neutral middle.
    const float most = round_up(std::max({std::abs(least), std::abs(greatest), 1.0F}));
    return {-most, most};
  }
  float low = map.low.value_or(least);
  float high = map.high.value_or(greatest);
  // A map that is nearly empty or flat still gets a scale one can read.
  const float smallest = map.unit == "%" ? 0.05F : 1.0F;
  if (!map.high && map.unit == "%") high = std::max(high, smallest);
  // Amounts end at a round number, so that the scale stays where it is while values change a little.
  if (!map.high && map.low == 0.0F) high = round_up(high);
  if (!(high > low)) high = low + std::max(std::abs(low) * 0.01F, smallest);
  return {low, high};
}

namespace {

/// The colours from one end of a scale to the other.
void draw_colours(ColourMap colours, ImVec2 from, ImVec2 size) {
  ImDrawList& list = *ImGui::GetWindowDrawList();
  constexpr int steps = 48;
  for (int i = 0; i < steps; ++i) {
    const ImU32 a = colour_u32(to_imgui(colour_of(colours, float(i) / steps)));
    const ImU32 b = colour_u32(to_imgui(colour_of(colours, float(i + 1) / steps)));
    list.AddRectFilledMultiColor(ImVec2(from.x + size.x * float(i) / steps, from.y),
                                 ImVec2(from.x + size.x * float(i + 1) / steps, from.y + size.y), a, b, b, a);
  }
}

/// Round values under a scale; texts keep between `least` and `most`, and one that would touch the one before is left out.
void draw_ticks(const Theme& theme, ImVec2 from, float width, const ScaleRange& range, const std::string& unit, float least,
                float most) {
  ImDrawList& list = *ImGui::GetWindowDrawList();
  float taken = least;
  for (const double tick : round_ticks(range.low, range.high, 5)) {
    const float x = from.x + width * float((tick - double(range.low)) / double(range.high - range.low));
    list.AddLine(ImVec2(x, from.y), ImVec2(x, from.y + theme.px(3)), colour_u32(theme.text), theme.px(1));
    const std::string words = tick_text(tick, unit);
    const float half = ImGui::CalcTextSize(words.c_str()).x / 2;
    const float at = std::clamp(x - half, least, most - 2 * half);
    if (at < taken) continue;
    list.AddText(ImVec2(at, from.y + theme.px(3)), colour_u32(theme.muted), words.c_str());
    taken = at + 2 * half + theme.px(4);
  }
}

}  // namespace

ImVec2 draw_legend(const Theme& theme, ImVec2 origin, ImVec2 size, const MapEntry& map, float low, float high, bool updating) {
  if (map.id.kind == MapKind::none) return {};
  const float margin = theme.px(12);
  const ImVec2 corner(origin.x + margin, origin.y + size.y - margin);
  ImGui::PushFont(theme.small);
  if (!map.classes.empty()) {
    const ImVec2 taken = draw_class_legend(theme, corner, map);
    ImGui::PopFont();
    return taken;
  }
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const bool classes = map.colours == ColourMap::categorical;
  const float line = ImGui::GetFontSize();
  std::string title = map.title;
  if (!map.unit.empty() && map.unit != "%") title += " (" + map.unit + ")";
  if (updating) title += "  ...";
  const float bar = std::min(theme.px(168), std::max(size.x - 2 * margin - theme.px(28), theme.px(60)));
  title = fitted_text(title, std::max(bar, size.x - 2 * margin - theme.px(28)));
  const float width = std::max(bar, ImGui::CalcTextSize(title.c_str()).x) + theme.px(28);
  const float height = line + theme.px(14) + (classes ? 0 : line + theme.px(18));
  const ImVec2 top(corner.x, corner.y - height);
  list.AddRectFilled(top, ImVec2(top.x + width, corner.y), plate_colour(theme), theme.px(4));
  list.AddText(ImVec2(top.x + theme.px(12), top.y + theme.px(7)), colour_u32(theme.text), title.c_str());
  if (!classes) {
    const ImVec2 from(top.x + theme.px(14), top.y + line + theme.px(12));
    const float thick = theme.px(10);
    draw_colours(map.colours, from, ImVec2(bar, thick));
    draw_ticks(theme, ImVec2(from.x, from.y + thick), bar, {low, high}, map.unit, top.x + theme.px(4),
               top.x + width - theme.px(4));
  }
  ImGui::PopFont();
  return {width + margin, height + margin};
}

void draw_scale_bar(const Theme& theme, ImVec2 origin, ImVec2 size, double metres_per_pixel, ImVec2 legend) {
  const ScaleBar bar = scale_bar(metres_per_pixel, theme.px(120));
  if (bar.metres <= 0) return;
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const float right = origin.x + size.x - theme.px(14);
  const float left = right - float(bar.pixels);
  const bool beside = left > origin.x + legend.x + theme.px(8);
  const float bottom = origin.y + size.y - (beside ? theme.px(14) : legend.y + theme.px(10));
  const float thick = theme.px(4);
  list.AddRectFilled(ImVec2(left - 1, bottom - thick - 1), ImVec2(right + 1, bottom + 1), IM_COL32(0, 0, 0, 200));
  list.AddRectFilled(ImVec2(left, bottom - thick), ImVec2(right, bottom), IM_COL32(250, 250, 250, 255));
  list.AddRectFilled(ImVec2((left + right) / 2, bottom - thick), ImVec2(right, bottom), IM_COL32(40, 42, 44, 255));
  const std::string words = format_round_length(bar.metres);
  ImGui::PushFont(theme.small);
  const ImVec2 text = ImGui::CalcTextSize(words.c_str());
  ImGui::PopFont();
  shadowed_text(list, theme.small, ImVec2(right - text.x, bottom - thick - text.y - theme.px(3)), !theme.dark, words);
}

void draw_north_arrow(const Theme& theme, ImVec2 origin, ImVec2 size, float heading) {
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const float radius = theme.px(21);
  const ImVec2 middle(origin.x + size.x - radius - theme.px(10), origin.y + radius + theme.px(10));
  const float angle = -heading * 0.01745329F;
  const auto turned = [&](float x, float y) {
    return ImVec2(middle.x + theme.px(x * std::cos(angle) - y * std::sin(angle)),
                  middle.y + theme.px(x * std::sin(angle) + y * std::cos(angle)));
  };
  list.AddCircleFilled(middle, radius, IM_COL32(20, 22, 24, 150), 36);
  list.AddTriangleFilled(turned(0, -7), turned(-5, 12), turned(0, 9), IM_COL32(250, 250, 250, 255));
  list.AddTriangleFilled(turned(0, -7), turned(5, 12), turned(0, 9), IM_COL32(150, 154, 158, 255));
  ImGui::PushFont(theme.small);
  const ImVec2 half = ImGui::CalcTextSize("N");
  ImGui::PopFont();
  const ImVec2 letter = turned(0, -13);
  list.AddText(theme.small, theme.small->FontSize, ImVec2(letter.x - half.x / 2, letter.y - half.y / 2), IM_COL32_WHITE, "N");
}

}  // namespace biotope

#include "ui/panels/climate_chart.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "ui/editor_actions.hpp"
#include "ui/format.hpp"

namespace biotope {
namespace {

/// Place and scale of a chart.
struct Chart {
  ImVec2 at;
  float width = 0;
  float height = 0;
  double low = 0;
  double high = 1;
  [[nodiscard]] float month_width() const { return width / float(months); }
  [[nodiscard]] float x_of(int month) const { return at.x + month_width() * (float(month) + 0.5F); }
  [[nodiscard]] float y_of(double value) const { return at.y + height * float(1 - (value - low) / (high - low)); }
  [[nodiscard]] double value_at(float y) const { return low + (high - low) * (1 - double(y - at.y) / double(height)); }
};

/// The scale is the undragged climate's, so that it does not run away under the pointer.
Chart temperature_chart(const Climate& climate) {
  Chart chart;
  chart.low = std::floor((std::min(*std::ranges::min_element(climate.temperature_min), 0.0) - 3) / 5) * 5;
  chart.high = std::ceil((std::max(*std::ranges::max_element(climate.temperature_max), 10.0) + 3) / 5) * 5;
  return chart;
}

Chart rain_chart(const Climate& climate) {
  Chart chart;
  chart.high = std::ceil(std::max(*std::ranges::max_element(climate.precipitation) * 1.25, 60.0) / 20) * 20;
  return chart;
}

void place(const Theme& theme, Chart& chart, const char* title, const std::string& unit, float height) {
  ImGui::PushFont(theme.small);
  ImGui::TextColored(theme.muted, "%s", title);
  ImGui::PopFont();
  chart.at = ImGui::GetCursorScreenPos();
  chart.width = ImGui::GetContentRegionAvail().x;
  chart.height = theme.px(height);
  ImDrawList& list = *ImGui::GetWindowDrawList();
  list.AddRectFilled(chart.at, ImVec2(chart.at.x + chart.width, chart.at.y + chart.height),
                     colour_u32(with_alpha(theme.text, 0.04F)), theme.px(4));
  ImGui::PushFont(theme.small);
  for (const double value : {chart.low, chart.high}) {
    const float y = value == chart.low ? chart.at.y + chart.height - ImGui::GetFontSize() : chart.at.y;
    list.AddText(ImVec2(chart.at.x + theme.px(3), y), colour_u32(with_alpha(theme.muted, 0.7F)), format_value(value, unit).c_str());
  }
  ImGui::PopFont();
}

void draw_months(const Theme& theme, const Chart& chart, int now) {
  ImDrawList& list = *ImGui::GetWindowDrawList();
  ImGui::PushFont(theme.small);
  for (int month = 0; month < months; ++month) {
    const std::string letter(month_name(month).substr(0, 1));
    list.AddText(ImVec2(chart.x_of(month) - ImGui::CalcTextSize(letter.c_str()).x / 2, chart.at.y + chart.height + theme.px(1)),
                 colour_u32(month == now ? theme.accent : theme.muted), letter.c_str());
  }
  ImGui::PopFont();
}

void draw_temperature(const Theme& theme, const Chart& chart, const Climate& climate) {
  ImDrawList& list = *ImGui::GetWindowDrawList();
  if (chart.low < 0)
    list.AddLine(ImVec2(chart.at.x, chart.y_of(0)), ImVec2(chart.at.x + chart.width, chart.y_of(0)),
                 colour_u32(with_alpha(theme.text, 0.20F)));
  std::array<ImVec2, months> mean;
  for (int month = 0; month < months; ++month) {
    const auto m = std::size_t(month);
    const float x = chart.x_of(month);
    list.AddLine(ImVec2(x, chart.y_of(climate.temperature_min[m])), ImVec2(x, chart.y_of(climate.temperature_max[m])),
                 colour_u32(with_alpha(theme.loss, 0.35F)), theme.px(4));
    mean[m] = ImVec2(x, chart.y_of(climate.temperature_mean[m]));
  }
  list.AddPolyline(mean.data(), months, colour_u32(theme.loss), 0, theme.px(2));
  for (const ImVec2& point : mean) list.AddCircleFilled(point, theme.px(3), colour_u32(theme.loss), 12);
}

void draw_rain(const Theme& theme, const Chart& chart, const Climate& climate) {
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const ImU32 blue = colour_u32(theme.dark ? ImVec4(0.36F, 0.58F, 0.74F, 0.75F) : ImVec4(0.30F, 0.52F, 0.70F, 0.70F));
  for (int month = 0; month < months; ++month) {
    const float half = chart.month_width() * 0.34F;
    const float top = chart.y_of(std::clamp(climate.precipitation[std::size_t(month)], 0.0, chart.high));
    list.AddRectFilled(ImVec2(chart.x_of(month) - half, top), ImVec2(chart.x_of(month) + half, chart.at.y + chart.height), blue,
                       theme.px(2));
  }
}

std::string month_text(const Climate& climate, int month) {
  const auto m = std::size_t(month);
  return std::string(month_name(month)) + "\n" + format_value(climate.temperature_mean[m], "°C") + " (" +
         format_number(climate.temperature_min[m]) + " to " + format_number(climate.temperature_max[m]) + ")\n" +
         format_value(climate.precipitation[m], "mm") + " of rain and snow\nDrag to change it";
}

/// The invisible surface over a chart: drags a month's value.
void handle_drag(const UiContext& ui, const Chart& chart, const char* id, ClimateQuantity quantity) {
  EditorState& state = ui.state;
  ImGui::SetCursorScreenPos(chart.at);
  ImGui::InvisibleButton(id, ImVec2(chart.width, chart.height));
  const ImVec2 mouse = ImGui::GetIO().MousePos;
  const int under = std::clamp(int((mouse.x - chart.at.x) / chart.month_width()), 0, months - 1);
  if (ImGui::IsItemActivated()) state.clock.month = under;
  const int month = state.clock.month;
  if (ImGui::IsItemActive() && ImGui::IsMouseDragging(ImGuiMouseButton_Left, ui.theme.px(3))) {
    const float y = std::clamp(mouse.y, chart.at.y, chart.at.y + chart.height);
    const double step = quantity == ClimateQuantity::temperature ? 0.1 : 1.0;
    const double value = std::round(chart.value_at(y) / step) * step;
    state.dragged_climate = with_month(state.document.climate, quantity, month, value);
  }
  if (ImGui::IsItemDeactivated() && state.dragged_climate) {
    const Climate edited = *state.dragged_climate;
    state.dragged_climate.reset();
    const std::string what = quantity == ClimateQuantity::temperature ? "Temperature of " : "Precipitation of ";
    if (!(edited == state.document.climate)) {
      change_document(state, what + std::string(month_name(month)), [&](Document& document) { document.climate = edited; });
    }
  }
  if (ImGui::IsItemActive()) {
    ImGui::SetTooltip("%s", month_text(state.dragged_climate.value_or(state.document.climate), month).c_str());
  } else if (ImGui::IsItemHovered()) {
    ImGui::SetTooltip("%s", month_text(state.document.climate, under).c_str());
  }
}

}  // namespace

Climate with_month(Climate climate, ClimateQuantity quantity, int month, double value) {
  const auto m = std::size_t(month);
  if (quantity == ClimateQuantity::precipitation) {
    climate.precipitation[m] = std::max(value, 0.0);
    return climate;
  }
  const double moved = std::clamp(value, -80.0, 60.0) - climate.temperature_mean[m];
  climate.temperature_mean[m] += moved;
  climate.temperature_min[m] += moved;
  climate.temperature_max[m] += moved;
  return climate;
}

void draw_climate_charts(const UiContext& ui) {
  EditorState& state = ui.state;
  const Climate shown = state.dragged_climate.value_or(state.document.climate);
  Chart warmth = temperature_chart(state.document.climate);
  place(ui.theme, warmth, "Temperature: mean, and from minimum to maximum", "°C", 84);
  draw_temperature(ui.theme, warmth, shown);
  handle_drag(ui, warmth, "temperature chart", ClimateQuantity::temperature);
  Chart rain = rain_chart(state.document.climate);
  place(ui.theme, rain, "Precipitation of the month", "mm", 62);
  draw_rain(ui.theme, rain, shown);
  handle_drag(ui, rain, "precipitation chart", ClimateQuantity::precipitation);
  draw_months(ui.theme, rain, state.clock.month);
  ImGui::Dummy(ImVec2(0, ui.theme.px(12)));
}

}  // namespace biotope

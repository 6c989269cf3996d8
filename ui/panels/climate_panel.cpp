#include <algorithm>
#include <array>
#include <cmath>

#include "ui/editor_actions.hpp"
#include "ui/format.hpp"
#include "ui/panels/panels.hpp"

namespace biotope {
namespace {

struct Row {
  const char* name;
  MonthlyValues Climate::*values;
  const char* format;
  const char* tip;
};
constexpr std::array<Row, 5> rows{{{"Mean", &Climate::temperature_mean, "%.1f", "Mean temperature at the reference height, °C"},
                                   {"Min", &Climate::temperature_min, "%.1f", "Mean of the daily minimum, °C"},
                                   {"Max", &Climate::temperature_max, "%.1f", "Mean of the daily maximum, °C"},
                                   {"Rain", &Climate::precipitation, "%.0f", "Precipitation, mm in the month"},
                                   {"Cloud", &Climate::cloud, "%.2f", "Cloud cover, 0 to 1"}}};

/// Climate diagram: precipitation as bars, mean temperature as a line within the band from minimum to maximum.
void draw_chart(const UiContext& ui, const Climate& climate) {
  const Theme& theme = ui.theme;
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const float width = ImGui::GetContentRegionAvail().x;
  const float height = theme.px(118);
  ImGui::InvisibleButton("climate chart", ImVec2(width, height + theme.px(16)));
  const bool hovered = ImGui::IsItemHovered();
  ImDrawList& list = *ImGui::GetWindowDrawList();
  list.AddRectFilled(at, ImVec2(at.x + width, at.y + height), colour_u32(with_alpha(theme.text, 0.04F)), theme.px(4));
  const double rain = std::max(*std::max_element(climate.precipitation.begin(), climate.precipitation.end()), 50.0);
  const double cold = std::min(*std::min_element(climate.temperature_min.begin(), climate.temperature_min.end()), 0.0) - 2;
  const double warm = std::max(*std::max_element(climate.temperature_max.begin(), climate.temperature_max.end()), 10.0) + 2;
  const float month_width = width / float(months);
  const auto y_of = [&](double degrees) { return at.y + height * float(1 - (degrees - cold) / (warm - cold)); };
  const ImU32 blue = colour_u32(theme.dark ? ImVec4(0.36F, 0.58F, 0.74F, 0.65F) : ImVec4(0.30F, 0.52F, 0.70F, 0.60F));
  std::array<ImVec2, months> mean;
  for (int month = 0; month < months; ++month) {
    const auto m = std::size_t(month);
    const float x = at.x + month_width * (float(month) + 0.5F);
    const float bar = height * 0.9F * float(std::max(climate.precipitation[m], 0.0) / rain);
    const bool now = month == ui.state.clock.month;
    list.AddRectFilled(ImVec2(x - month_width * 0.34F, at.y + height - bar), ImVec2(x + month_width * 0.34F, at.y + height), blue,
                       theme.px(2));
    list.AddLine(ImVec2(x, y_of(climate.temperature_min[m])), ImVec2(x, y_of(climate.temperature_max[m])),
                 colour_u32(with_alpha(theme.loss, 0.35F)), theme.px(4));
    mean[m] = ImVec2(x, y_of(climate.temperature_mean[m]));
    ImGui::PushFont(theme.small);
    const std::string letter(month_name(month).substr(0, 1));
    list.AddText(ImVec2(x - ImGui::CalcTextSize(letter.c_str()).x / 2, at.y + height + theme.px(1)),
                 colour_u32(now ? theme.accent : theme.muted), letter.c_str());
    ImGui::PopFont();
  }
  if (cold < 0 && warm > 0)
    list.AddLine(ImVec2(at.x, y_of(0)), ImVec2(at.x + width, y_of(0)), colour_u32(with_alpha(theme.text, 0.20F)));
  list.AddPolyline(mean.data(), months, colour_u32(theme.loss), 0, theme.px(2));
  for (const ImVec2& point : mean) list.AddCircleFilled(point, theme.px(2.5F), colour_u32(theme.loss), 12);
  if (!hovered) return;
  const int month = std::clamp(int((ImGui::GetIO().MousePos.x - at.x) / month_width), 0, months - 1);
  const auto m = std::size_t(month);
  ImGui::SetTooltip("%s\n%s (%s to %s)\n%s of rain and snow", month_name(month).data(),
                    format_value(climate.temperature_mean[m], "°C").c_str(), format_number(climate.temperature_min[m]).c_str(),
                    format_number(climate.temperature_max[m]).c_str(), format_value(climate.precipitation[m], "mm").c_str());
  if (ImGui::IsMouseClicked(ImGuiMouseButton_Left)) ui.state.clock.month = month;
}

/// Moves the months' values of a copy of the climate with the number that is being typed.
void draw_cell(const UiContext& ui, const Row& row, int month) {
  const auto m = std::size_t(month);
  double value = (ui.state.document.climate.*row.values)[m];
  ImGui::PushID(row.name);
  ImGui::PushID(month);
  ImGui::SetNextItemWidth(-1);
  if (ImGui::InputDouble("##value", &value, 0, 0, row.format,
                         ImGuiInputTextFlags_EnterReturnsTrue | ImGuiInputTextFlags_AutoSelectAll) &&
      std::isfinite(value)) {
    change_document(ui.state, std::string(row.name) + " of " + std::string(month_name(month)), [&](Document& document) {
      const bool rain = row.values == &Climate::precipitation;
      const bool cloud = row.values == &Climate::cloud;
      (document.climate.*row.values)[m] = cloud  ? std::clamp(value, 0.0, 1.0)
                                          : rain ? std::max(value, 0.0)
                                                 : std::clamp(value, -80.0, 60.0);
    });
  }
  ImGui::PopID();
  ImGui::PopID();
}

void draw_table(const UiContext& ui) {
  ImGui::PushFont(ui.theme.small);
  ImGui::PushStyleVar(ImGuiStyleVar_FramePadding, ImVec2(ui.theme.px(3), ui.theme.px(2)));
  ImGui::PushStyleVar(ImGuiStyleVar_CellPadding, ImVec2(ui.theme.px(1), ui.theme.px(1)));
  if (ImGui::BeginTable("months", int(rows.size()) + 1, ImGuiTableFlags_SizingStretchSame)) {
    ImGui::TableSetupColumn("month", ImGuiTableColumnFlags_WidthFixed, ui.theme.px(32));
    ImGui::TableNextRow();
    ImGui::TableNextColumn();
    for (const Row& row : rows) {
      ImGui::TableNextColumn();
      ImGui::TextDisabled("%s", row.name);
      tooltip(ui.theme, row.tip);
    }
    for (int month = 0; month < months; ++month) {
      ImGui::TableNextRow();
      ImGui::TableNextColumn();
      ImGui::AlignTextToFramePadding();
      const bool now = month == ui.state.clock.month;
      ImGui::TextColored(now ? ui.theme.accent : ui.theme.muted, "%s", std::string(short_month_name(month)).c_str());
      for (const Row& row : rows) {
        ImGui::TableNextColumn();
        draw_cell(ui, row, month);
      }
    }
    ImGui::EndTable();
  }
  ImGui::PopStyleVar(2);
  ImGui::PopFont();
}

void draw_choice(const UiContext& ui) {
  EditorState& state = ui.state;
  const Climate& climate = state.document.climate;
  ImGui::SetNextItemWidth(-1);
  const std::string title = climate.title.empty() ? climate.name : climate.title;
  if (ImGui::BeginCombo("##climate", title.c_str(), ImGuiComboFlags_HeightLarge)) {
    for (const Climate& each : state.climates) {
      const std::string name = each.title.empty() ? each.name : each.title;
      if (ImGui::Selectable(name.c_str(), each.name == climate.name) && !(each == climate)) {
        change_document(state, "Climate: " + name, [&](Document& document) { document.climate = each; });
      }
      tooltip(ui.theme, each.description);
    }
    ImGui::EndCombo();
  }
  tooltip(ui.theme, "The weather of twelve months; everything that lives here follows");
}

}  // namespace

void draw_climate_panel(const UiContext& ui) {
  const Climate& climate = ui.state.document.climate;
  heading(ui.theme, "Climate");
  draw_choice(ui);
  if (!climate.description.empty()) hint(ui.theme, climate.description);
  double mean = 0;
  double rain = 0;
  for (std::size_t m = 0; m < months; ++m) {
    mean += climate.temperature_mean[m] / months;
    rain += climate.precipitation[m];
  }
  readout(ui.theme, "Mean of the year at " + format_length(climate.reference_height), format_value(mean, "°C"));
  readout(ui.theme, "Rain and snow in a year", format_value(rain, "mm"));
  draw_chart(ui, climate);
  draw_table(ui);
  readout(ui.theme, "Cooling with height", format_value(climate.lapse_rate, "°C/km"));
  if (!climate.source.empty()) hint(ui.theme, "Source: " + climate.source);
}

}  // namespace biotope

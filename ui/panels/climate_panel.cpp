#include <algorithm>
#include <array>
#include <cmath>

#include "ui/editor_actions.hpp"
#include "ui/format.hpp"
#include "ui/panels/climate_chart.hpp"
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

/// One number of a month; Enter makes it a step of the history.
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
  draw_climate_charts(ui);
  draw_table(ui);
  readout(ui.theme, "Cooling with height", format_value(climate.lapse_rate, "°C/km"));
  if (!climate.source.empty()) hint(ui.theme, "Source: " + climate.source);
}

}  // namespace biotope

#include "ui/quality.hpp"

#include <algorithm>
#include <array>
#include <string>
#include <vector>

#include "ui/format.hpp"

namespace biotope {
namespace {

struct LevelCost {
  QualityLevel level;
  double times_low;  ///< what a picture costs
};
// Plants' count and reach grow with the level, and so do triangles and the ground's detail; our choice, on the safe side.
constexpr std::array<LevelCost, 3> costs{{{QualityLevel::ultra, 9}, {QualityLevel::high, 4.5}, {QualityLevel::medium, 2.2}}};

}  // namespace

QualityLevel measured_level(std::span<const double> seconds_at_low, bool software) {
  if (seconds_at_low.empty()) return QualityLevel::low;
  const double quickest = *std::min_element(seconds_at_low.begin(), seconds_at_low.end());
  for (const LevelCost& cost : costs) {
    if (quickest * cost.times_low * wanted_frames(software) <= 1) return cost.level;
  }
  return QualityLevel::low;
}

void draw_quality_setting(const UiContext& ui) {
  EditorState& state = ui.state;
  ImGui::TextDisabled("Quality of the 3D view");
  int chosen = int(state.settings.quality_level);
  if (segmented(ui.theme, "quality", {"Automatic", "Low", "Medium", "High", "Ultra"}, chosen, ImGui::GetContentRegionAvail().x)) {
    state.settings.quality_level = QualityLevel(chosen);
  }
  std::string now = "low";
  for (const QualityLevel level : {QualityLevel::medium, QualityLevel::high, QualityLevel::ultra}) {
    if (state.view.quality >= quality_factor(level)) now = quality_name(level);
  }
  const std::string frames = std::to_string(int(wanted_frames(state.view.software)));
  hint(ui.theme, "Now: " + now + ". Automatic: the highest that keeps " + frames + " pictures a second" +
                     (state.view.software ? " drawn by the processor" : "") + ", measured at start.");
}

void draw_figures(const UiContext& ui, ImVec2 corner, const DrawnFigures& figures) {
  const Theme& theme = ui.theme;
  std::vector<std::string> lines{
      format_count(double(figures.plants)) + " plants, " + format_count(double(figures.animals)) + " animals",
      format_count(double(figures.triangles)) + " triangles in " + format_count(double(figures.draw_calls)) + " draw calls",
      "plants and herds in memory: " + format_bytes(figures.instance_bytes) + " of " + format_bytes(figures.most_instance_bytes),
      std::to_string(figures.width) + " x " + std::to_string(figures.height) + " pixels, quality " +
          format_round_number(double(ui.state.view.quality))};
  if (figures.seconds > 0) {
    lines.push_back(format_value(figures.seconds * 1000, "ms") + " a picture, " + format_value(1 / figures.seconds, "a second"));
  }
  float width = 0;
  ImGui::PushFont(theme.small);
  for (const std::string& line : lines) width = std::max(width, ImGui::CalcTextSize(line.c_str()).x);
  const float row = ImGui::GetFontSize() + theme.px(3);
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const ImVec2 low(corner.x + width + theme.px(16), corner.y + row * float(lines.size()) + theme.px(12));
  list.AddRectFilled(corner, low, IM_COL32(16, 18, 20, 190), theme.px(4));
  float y = corner.y + theme.px(6);
  for (const std::string& line : lines) {
    list.AddText(ImVec2(corner.x + theme.px(8), y), IM_COL32(235, 238, 240, 255), line.c_str());
    y += row;
  }
  ImGui::PopFont();
}

}  // namespace biotope

#include "ui/mode_badge.hpp"

#include <string>

#include "ui/format.hpp"
#include "ui/icons.hpp"

namespace biotope {
namespace {

struct Badge {
  const char* icon = "";
  std::string text;
  std::string keys;
};

Badge badge_of(const UiContext& ui) {
  const EditorState& state = ui.state;
  if (state.pictures.playing >= 0) {
    return {icons::film, "On the path, " + format_value(state.pictures.playing, "s"), ui.commands.keys("explore.play_path")};
  }
  if (state.exploring.walking) return {icons::walk, "On foot", ui.commands.keys("explore.walk")};
  if (!state.exploring.following) return {};
  const DailyPlan* plan = chosen_plan(state);
  if (plan == nullptr || !state.shown->web) return {};
  const std::string name = display_name(state.shown->web->species[std::size_t(plan->species)]);
  return {icons::follow, "Following " + name, ui.commands.keys("explore.follow")};
}

}  // namespace

void draw_mode_badge(const UiContext& ui, ImVec2 origin, ImVec2 size) {
  const Badge badge = badge_of(ui);
  if (badge.text.empty()) return;
  const Theme& theme = ui.theme;
  const std::string icon = theme.has_icons ? std::string(badge.icon) + "  " : std::string();
  const std::string words = icon + badge.text;
  const std::string keys = badge.keys.empty() ? std::string() : "   " + badge.keys + " ends";
  const ImVec2 words_size = ImGui::CalcTextSize(words.c_str());
  const ImVec2 keys_size = ImGui::CalcTextSize(keys.c_str());
  const float margin = theme.px(10);
  const ImVec2 low(origin.x + margin, origin.y + size.y - margin - words_size.y - theme.px(10));
  const ImVec2 high(low.x + words_size.x + keys_size.x + theme.px(20), origin.y + size.y - margin);
  ImDrawList& list = *ImGui::GetWindowDrawList();
  list.AddRectFilled(low, high, IM_COL32(16, 18, 20, 190), theme.px(4));
  const float y = low.y + theme.px(5);
  list.AddText(ImVec2(low.x + theme.px(10), y), IM_COL32(235, 238, 240, 255), words.c_str());
  list.AddText(ImVec2(low.x + theme.px(10) + words_size.x, y), IM_COL32(160, 166, 170, 255), keys.c_str());
}

}  // namespace biotope

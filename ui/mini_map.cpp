#include "ui/mini_map.hpp"

#include <algorithm>
#include <cmath>

#include "ui/camera_mark.hpp"
#include "ui/exploring.hpp"
#include "ui/relief_picture.hpp"

namespace biotope {
namespace {

constexpr int picture_side = 256;
constexpr double remake_seconds = 0.7;

void draw_herds(const UiContext& ui, ImDrawList& list, ImVec2 low, ImVec2 size) {
  const EditorState& state = ui.state;
  if (!state.view.herds || !state.shown || !state.shown->plans || !state.shown->graph || !state.shown->web) return;
  const MapsSnapshot& maps = *state.shown;
  const Terrain& terrain = maps.terrain();
  const DailyPlan* chosen = chosen_plan(state);
  const auto draw_herd = [&](const DailyPlan& plan, float radius, ImU32 edge) {
    if (std::size_t(plan.level) >= maps.graph->levels.size()) return;
    const auto species = std::size_t(plan.species);
    if (species < state.view.visible_species.size() && !state.view.visible_species[species]) return;
    const HerdState now = herd_state(plan, maps.graph->levels[std::size_t(plan.level)], state.clock.hour, terrain.cell_size);
    const ImVec2 at(low.x + size.x * (now.at.x + 0.5F) / float(terrain.height.width()),
                    low.y + size.y * (now.at.y + 0.5F) / float(terrain.height.height()));
    list.AddCircleFilled(at, radius + ui.theme.px(0.8F), edge, 12);
    list.AddCircleFilled(at, radius, colour_u32(to_imgui(maps.web->species[species].colour)), 12);
  };
  for (const DailyPlan& plan : *maps.plans) draw_herd(plan, ui.theme.px(1.7F), IM_COL32(0, 0, 0, 130));
  if (chosen != nullptr) draw_herd(*chosen, ui.theme.px(3.5F), IM_COL32(255, 255, 255, 255));
}

}  // namespace

void MiniMap::follow(const EditorState& state) {
  const MapsSnapshot& maps = *state.shown;
  const bool other_land = !terrain_ || terrain_->height.width() != maps.terrain().height.width();
  if (terrain_ == maps.surface() && hydrology_ == maps.hydrology && trees_ == maps.tree_cover) return;
  if (!other_land && ImGui::GetTime() - made_at_ < remake_seconds) return;
  made_at_ = ImGui::GetTime();
  terrain_ = maps.surface();
  hydrology_ = maps.hydrology;
  trees_ = maps.tree_cover;
  const ReliefPicture relief = make_relief_picture(maps, picture_side);
  picture_ = make_texture_2d(GL_RGBA8, relief.width, relief.height, 1, {});
  glPixelStorei(GL_UNPACK_ALIGNMENT, 4);
  glTextureSubImage2D(picture_.name(), 0, 0, 0, relief.width, relief.height, GL_RGBA, GL_UNSIGNED_BYTE, relief.rgba.data());
}

void MiniMap::handle(const UiContext& ui, ImVec2 origin, ImVec2 size) {
  EditorState& state = ui.state;
  visible_ =
      state.settings.mini_map && state.shown && state.document.terrain && size.x > ui.theme.px(300) && size.y > ui.theme.px(220);
  if (!visible_) return;
  follow(state);
  const Terrain& terrain = ground_of(state);
  const double longer = std::max(terrain.width_metres(), terrain.height_metres());
  const float side = std::min(ui.theme.px(168), 0.36F * std::min(size.x, size.y));
  frame_.size = ImVec2(side * float(terrain.width_metres() / longer), side * float(terrain.height_metres() / longer));
  const float margin = ui.theme.px(10);
  frame_.low = ImVec2(origin.x + size.x - frame_.size.x - margin, origin.y + size.y - frame_.size.y - margin);
  const ImVec2 cursor = ImGui::GetCursorScreenPos();
  ImGui::SetCursorScreenPos(frame_.low);
  ImGui::InvisibleButton("mini-map", frame_.size);
  hovered_ = ImGui::IsItemHovered();
  if (ImGui::IsItemActive()) {
    const ImVec2 mouse = ImGui::GetIO().MousePos;
    const float x = std::clamp((mouse.x - frame_.low.x) / frame_.size.x, 0.0F, 1.0F);
    const float y = std::clamp((mouse.y - frame_.low.y) / frame_.size.y, 0.0F, 1.0F);
    move_camera_to(state, {x * float(terrain.height.width()) - 0.5F, y * float(terrain.height.height()) - 0.5F});
  }
  tooltip(ui.theme, "Click or drag: the camera goes there", ui.commands.keys("explore.mini_map"));
  ImGui::SetCursorScreenPos(cursor);
}

void MiniMap::draw(const UiContext& ui) {
  if (!visible_ || !picture_) return;
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const ImVec2 high(frame_.low.x + frame_.size.x, frame_.low.y + frame_.size.y);
  const float edge = ui.theme.px(2);
  list.AddRectFilled(ImVec2(frame_.low.x - edge, frame_.low.y - edge), ImVec2(high.x + edge, high.y + edge),
                     IM_COL32(16, 18, 20, 200), ui.theme.px(4));
  const auto texture = reinterpret_cast<ImTextureID>(std::uintptr_t(picture_.name()));
  list.AddImageRounded(texture, frame_.low, high, ImVec2(0, 0), ImVec2(1, 1), IM_COL32(255, 255, 255, hovered_ ? 255 : 225),
                       ui.theme.px(3));
  list.PushClipRect(frame_.low, high, true);
  draw_herds(ui, list, frame_.low, frame_.size);
  const Terrain& terrain = ground_of(ui.state);
  const PathPoint cell = camera_cell(ui.state);
  // From outside the land the camera still shows at the edge.
  const float x = std::clamp((cell.x + 0.5F) / float(terrain.height.width()), 0.02F, 0.98F);
  const float y = std::clamp((cell.y + 0.5F) / float(terrain.height.height()), 0.02F, 0.98F);
  draw_camera_mark(ui, list, ImVec2(frame_.low.x + frame_.size.x * x, frame_.low.y + frame_.size.y * y), ui.theme.px(30));
  list.PopClipRect();
}

}  // namespace biotope

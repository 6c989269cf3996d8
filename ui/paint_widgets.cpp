#include "ui/paint_widgets.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/document/brush_shape.hpp"
#include "ui/map_catalogue.hpp"

namespace biotope {
namespace {

constexpr int stamp_dots = 22;

/// The end of a range slider that is nearest to a place, 0 or 1.
int nearest_end(float at, float low, float high) {
  if (low == high) return at < low ? 0 : 1;
  return std::abs(at - low) < std::abs(at - high) ? 0 : 1;
}

void level_menu(const EditorState& state, const FoodWeb& web, bool plants, std::optional<LayerId>& chosen) {
  if (!ImGui::BeginMenu(plants ? "Plants" : "Animals")) return;
  for (const Species& species : web.species) {
    if (species.is_plant() != plants) continue;
    const LayerId layer{plants ? LayerKind::plant_density : LayerKind::animal_density, species.name};
    if (ImGui::MenuItem(layer_title(layer, state.web()).c_str())) chosen = layer;
  }
  ImGui::EndMenu();
}

}  // namespace

bool section(const Theme& theme, const char* title, const std::string& note, bool open_at_first) {
  ImGui::PushStyleColor(ImGuiCol_Header, ImVec4(0, 0, 0, 0));
  ImGui::SetNextItemOpen(open_at_first, ImGuiCond_Once);
  const bool open = ImGui::TreeNodeEx(title, ImGuiTreeNodeFlags_SpanAvailWidth | ImGuiTreeNodeFlags_NoTreePushOnOpen);
  ImGui::PopStyleColor();
  if (!note.empty()) {
    const float left = ImGui::CalcTextSize(title).x + theme.px(34);
    const std::string text = fitted_text(note, ImGui::GetContentRegionMax().x - left);
    ImGui::SameLine(std::max(ImGui::GetContentRegionMax().x - ImGui::CalcTextSize(text.c_str()).x, left));
    ImGui::TextColored(theme.muted, "%s", text.c_str());
  }
  return open;
}

bool range_slider(const Theme& theme, const char* id, float& low, float& high, float least, float most, float softness,
                  bool wraps) {
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const float width = std::max(ImGui::GetContentRegionAvail().x, theme.px(40));
  const float height = theme.px(18);
  ImGui::InvisibleButton(id, ImVec2(width, height));
  const ImGuiID key = ImGui::GetID(id);
  ImGuiStorage& storage = *ImGui::GetStateStorage();
  const float grab = theme.px(5);
  const auto place = [&](float value) {
    const float t = std::clamp((value - least) / std::max(most - least, 1e-6F), 0.0F, 1.0F);
    return at.x + grab + t * (width - 2 * grab);
  };
  bool changed = false;
  if (ImGui::IsItemActive()) {
    const float t = std::clamp((ImGui::GetIO().MousePos.x - at.x - grab) / (width - 2 * grab), 0.0F, 1.0F);
    const float value = least + t * (most - least);
    if (ImGui::IsItemActivated()) storage.SetInt(key, nearest_end(value, low, high));
    float& moved = storage.GetInt(key) == 0 ? low : high;
    const float before = moved;
    moved = value;
    if (!wraps && storage.GetInt(key) == 0) low = std::min(low, high);
    if (!wraps && storage.GetInt(key) == 1) high = std::max(low, high);
    changed = moved != before;
  }
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const float middle = at.y + height / 2;
  const float half = theme.px(3);
  const auto bar = [&](float from, float to, ImU32 colour) {
    if (to > from) list.AddRectFilled(ImVec2(from, middle - half), ImVec2(to, middle + half), colour, theme.px(2));
  };
  bar(place(least), place(most), colour_u32(theme.raised));
  const ImU32 full = colour_u32(with_alpha(theme.accent, 0.8F));
  const ImU32 soft = colour_u32(with_alpha(theme.accent, 0.3F));
  if (low <= high) {
    bar(place(low - softness), place(high + softness), soft);
    bar(place(low), place(high), full);
  } else {
    bar(place(least), place(high), full);
    bar(place(low), place(most), full);
  }
  const bool lit = ImGui::IsItemHovered() || ImGui::IsItemActive();
  for (const float end : {low, high}) {
    list.AddCircleFilled(ImVec2(place(end), middle), grab, colour_u32(lit ? theme.text : theme.accent), 20);
  }
  return changed;
}

void draw_falloff(const Theme& theme, const Brush& brush, ImVec2 size) {
  const ImVec2 at = ImGui::GetCursorScreenPos();
  ImGui::Dummy(size);
  ImDrawList& list = *ImGui::GetWindowDrawList();
  list.AddRectFilled(at, ImVec2(at.x + size.x, at.y + size.y), colour_u32(with_alpha(theme.text, 0.05F)), theme.px(3));
  Brush disk = brush;
  disk.stamp = nullptr;
  disk.radius = 100;
  const DabShape shape(disk, {0, 0, 1});
  const float inset = theme.px(4);
  constexpr int half = 40;
  std::array<ImVec2, 2 * half + 1> line;
  for (int i = -half; i <= half; ++i) {
    const float t = float(i) / float(half);
    const float weight = shape(int(std::lround(t * 100)), 0);
    line[std::size_t(i + half)] = {at.x + size.x * (0.5F + 0.5F * t), at.y + size.y - inset - weight * (size.y - 2 * inset)};
  }
  const float floor = at.y + size.y - inset;
  // Without soft edges, which would show as stripes where two pieces meet.
  const ImDrawListFlags flags = list.Flags;
  list.Flags &= ~ImDrawListFlags_AntiAliasedFill;
  for (std::size_t i = 0; i + 1 < line.size(); ++i) {
    const ImVec2 quad[4] = {line[i], line[i + 1], ImVec2(line[i + 1].x, floor), ImVec2(line[i].x, floor)};
    list.AddConvexPolyFilled(quad, 4, colour_u32(with_alpha(theme.accent, 0.18F)));
  }
  list.Flags = flags;
  list.AddPolyline(line.data(), int(line.size()), colour_u32(theme.accent), 0, theme.px(1.5F));
}

void draw_stamp(ImDrawList& list, ImVec2 at, float side, const Grid<float>* stamp, ImU32 colour) {
  if (stamp == nullptr) {
    list.AddCircleFilled(ImVec2(at.x + side / 2, at.y + side / 2), side * 0.45F, colour, 32);
    return;
  }
  const float dot = side / stamp_dots;
  const int alpha = int(colour >> IM_COL32_A_SHIFT) & 255;
  for (int y = 0; y < stamp_dots; ++y) {
    for (int x = 0; x < stamp_dots; ++x) {
      const float weight =
          sample_bilinear(*stamp, (x + 0.5) / stamp_dots * stamp->width() - 0.5, (y + 0.5) / stamp_dots * stamp->height() - 0.5);
      const int dot_alpha = int(float(alpha) * std::clamp(weight, 0.0F, 1.0F));
      if (dot_alpha < 8) continue;
      const ImVec2 low(at.x + float(x) * dot, at.y + float(y) * dot);
      list.AddRectFilled(low, ImVec2(low.x + dot, low.y + dot),
                         (colour & ~IM_COL32_A_MASK) | (ImU32(dot_alpha) << IM_COL32_A_SHIFT));
    }
  }
}

std::optional<LayerId> layer_menu(const EditorState& state) {
  std::optional<LayerId> chosen;
  for (const char* name : {"illumination", "temperature", "moisture", "texture"}) {
    const LayerId layer{LayerKind::resource, name};
    if (ImGui::MenuItem(layer_title(layer, state.web()).c_str())) chosen = layer;
  }
  if (ImGui::MenuItem("Geology")) chosen = LayerId{LayerKind::geology, "class"};
  if (ImGui::MenuItem("Ground")) chosen = LayerId{LayerKind::ground, "height"};
  if (ImGui::MenuItem("Obstacles, passages")) chosen = LayerId{LayerKind::passage, "all"};
  if (const FoodWeb* web = state.web()) {
    level_menu(state, *web, true, chosen);
    level_menu(state, *web, false, chosen);
  }
  return chosen;
}

}  // namespace biotope

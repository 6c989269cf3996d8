#include <array>
#include <cctype>
#include <cmath>

#include "ui/editor_actions.hpp"
#include "ui/format.hpp"
#include "ui/icons.hpp"
#include "ui/parts.hpp"

namespace biotope {
namespace {

/// Metres of a cell's centre in the file's reference system, or from the south-west corner where there is none.
std::array<double, 2> ground_coordinates(const Terrain& terrain, int x, int y) {
  const auto& t = terrain.georeference.transform;
  if (terrain.georeference.wkt.empty())
    return {(x + 0.5) * terrain.cell_size, terrain.height_metres() - (y + 0.5) * terrain.cell_size};
  return {t[0] + (x + 0.5) * t[1] + (y + 0.5) * t[2], t[3] + (x + 0.5) * t[4] + (y + 0.5) * t[5]};
}

/// Place, height and the shown map's value under the pointer.
std::string pointer_text(const EditorState& state) {
  if (!state.pointer.over_map || !state.document.terrain) return "Move over the map for coordinates and values";
  const Terrain& terrain = *state.document.terrain;
  const int x = int(std::lround(state.pointer.x));
  const int y = int(std::lround(state.pointer.y));
  const auto [east, north] = ground_coordinates(terrain, x, y);
  std::string text = "x " + format_count(east) + " m   y " + format_count(north) + " m   height " +
                     format_value(terrain.height.contains(x, y) ? terrain.height(x, y) : NAN, "m");
  return text;
}

std::string value_text(const EditorState& state) {
  if (!state.pointer.over_map || !state.newest) return {};
  const MapId map = visible_map(state);
  if (map.kind == MapKind::none || map.kind == MapKind::height) return {};
  const int x = int(std::lround(state.pointer.x));
  const int y = int(std::lround(state.pointer.y));
  const FoodWeb* web = state.web();
  const MapEntry entry = describe_map(map, web);
  const bool live = web != nullptr && state.painting.shown() && map_of_layer(state.painting.layer(), *web) == map;
  float value = NAN;
  if (live && state.painting.shown()->contains(x, y)) {
    value = (*state.painting.shown())(x, y);
  } else {
    value = state.maps.value(map, x, y).value_or(value_at(*state.newest, map, x, y));
  }
  if (!entry.classes.empty() && value >= 0 && std::size_t(value) < entry.classes.size()) {
    return entry.title + ": " + entry.classes[std::size_t(value)];
  }
  if (map.kind == MapKind::passage && value < 0) return entry.title + ": neither";
  if (map.kind == MapKind::ground_change && std::isnan(value)) return entry.title + ": as it was";
  if (map.kind == MapKind::animal_regions) {
    return std::isfinite(value)
               ? entry.title + ": " + (value < 0 ? std::string("cannot be here") : "region " + format_count(value + 1))
               : entry.title + ": unknown";
  }
  return entry.title + ": " + format_value(value, entry.unit);
}

/// Says what cannot be seen: a brush that reaches beyond the 3D picture on all sides.
std::string ring_text(const EditorState& state) {
  if (!state.exploring.ring_out_of_sight || !state.document.terrain) return {};
  return "the brush reaches " + format_length(double(state.brush.radius) * state.document.terrain->cell_size) +
         " around, wider than this view";
}

std::string work_text(const EditorState& state) {
  if (state.loading.running()) return "Opening: " + state.loading.stage();
  if (!state.worker) return {};
  const WorkerProgress progress = state.worker->progress();
  if (!progress.busy) return {};
  if (progress.stage.empty()) return "Computing";
  std::string text = progress.stage + " " + format_percent(progress.fraction);
  text[0] = char(std::toupper(static_cast<unsigned char>(text[0])));
  return text;
}

/// Texts from the right edge leftward.
struct RightAligned {
  float right;
  void add(const Theme& theme, const std::string& text, const ImVec4& colour) {
    if (text.empty()) return;
    right -= ImGui::CalcTextSize(text.c_str()).x;
    ImGui::SameLine(right);
    ImGui::TextColored(colour, "%s", text.c_str());
    right -= theme.px(18);
  }
};

void draw_cancel(const UiContext& ui, RightAligned& place) {
  const float side = ImGui::GetFontSize() + ui.theme.px(6);
  place.right -= side;
  ImGui::SameLine(place.right);
  if (icon_button(ui.theme, "stop", ui.theme.has_icons ? icons::close : "x", ui.theme.muted, "Stop computing (Esc)"))
    cancel_work(ui.state);
  place.right -= ui.theme.px(2);
}

}  // namespace

void draw_status_bar(const UiContext& ui, ImVec2 size) {
  const EditorState& state = ui.state;
  const Theme& theme = ui.theme;
  const bool over = state.pointer.over_map;
  ImGui::TextColored(over ? theme.text : theme.muted, "%s", pointer_text(state).c_str());
  const std::string value = value_text(state);
  if (!value.empty()) {
    ImGui::SameLine(0, theme.px(18));
    ImGui::TextColored(theme.accent, "%s", value.c_str());
  }
  const std::string ring = ring_text(state);
  if (!ring.empty()) {
    ImGui::SameLine(0, theme.px(18));
    ImGui::TextColored(theme.attention, "%s", ring.c_str());
  }
  RightAligned place{size.x - theme.px(10)};
  if (state.frame_seconds > 0 && (state.clock.playing || state.painting.stroking())) {
    place.add(theme, std::to_string(int(std::lround(1 / state.frame_seconds))) + " fps", theme.muted);
  }
  if (state.history.bytes() > 1'000'000) place.add(theme, "undo " + format_bytes(state.history.bytes()), theme.muted);
  if (state.recorder.recording()) place.add(theme, "recording: " + std::to_string(state.recorder.count()), theme.loss);
  const std::string work = work_text(state);
  if (!work.empty()) {
    draw_cancel(ui, place);
    place.add(theme, work, theme.text);
  } else if (state.newest && !state.newest->status) {
    place.add(theme, "computing failed", theme.loss);
  }
  if (!state.notice.empty()) place.add(theme, state.notice, theme.attention);
}

}  // namespace biotope

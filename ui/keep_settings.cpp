#include "ui/keep_settings.hpp"

#include "ui/brush_presets.hpp"
#include "ui/brush_stamps.hpp"
#include "ui/editor_actions.hpp"

namespace biotope {
namespace {

/// Beside the settings, as text like the person's own brushes.
std::filesystem::path brush_file(const EditorState& state) { return state.settings_file.parent_path() / "brush-in-hand.json"; }

BrushPreset brush_in_hand(const EditorState& state) {
  BrushPreset hand;
  hand.name = state.paint.preset.empty() ? "In the hand" : state.paint.preset;
  hand.tool = is_brush(state.tool) ? state.tool : Tool::add;
  hand.size = state.brush.radius * float(state.document.terrain ? state.document.terrain->cell_size : 1);
  hand.brush = state.brush;
  hand.brush.stamp = nullptr;
  hand.stamp = state.paint.stamp;
  return hand;
}

}  // namespace

void keep_settings(EditorState& state) {
  if (state.settings_file.empty()) return;
  state.settings.brush = state.brush;
  state.settings.brush.stamp = nullptr;
  state.settings.contours = state.view.contours;
  state.settings.overlay_opacity = state.view.opacity;
  Status kept = save_settings(state.settings_file, state.settings);
  if (kept) kept = save_presets(brush_file(state), {brush_in_hand(state)});
  if (!kept && !state.settings_complained) complain(state, "Settings", kept.error());
  state.settings_complained = !kept;
}

void take_up_brush(EditorState& state) {
  if (state.settings_file.empty()) return;
  const std::vector<BrushPreset> kept = load_presets(brush_file(state));
  if (kept.empty()) return;
  const BrushPreset& hand = kept.front();
  const float radius = state.brush.radius;
  state.brush = hand.brush;
  // Cells, as in the settings: which landscape comes is not known yet.
  state.brush.radius = radius;
  if (hand.name != "In the hand") state.paint.preset = hand.name;
  if (hand.stamp.empty()) return;
  if (auto stamp = load_stamp(hand.stamp)) {
    state.brush.stamp = stamp->weights;
    state.paint.stamp = hand.stamp;
  }
}

}  // namespace biotope

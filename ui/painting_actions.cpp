#include <utility>

#include "core/pipeline/edit_grounds.hpp"
#include "ui/edit_actions.hpp"
#include "ui/editor_actions.hpp"
#include "ui/paint_targets.hpp"

namespace biotope {
namespace {

/// Where a clone takes its values from: the chosen layer, else the painted one.
std::optional<LayerId> clone_layer(const EditorState& state) {
  if (state.tool != Tool::clone) return std::nullopt;
  return state.paint.clone_from ? state.paint.clone_from : paint_target(state);
}

float height_at(EditorState& state, float x, float y) {
  const LayerId ground{LayerKind::ground, "height"};
  const auto map = state.grounds.final_of(*state.shown, state.document, ground);
  return map ? sample_bilinear(*map, x, y) : 0;
}

StrokePlan stroke_plan(EditorState& state, float x, float y) {
  const MapsSnapshot& snapshot = *state.shown;
  StrokePlan plan;
  plan.brush = brush_of_tool(state);
  if (state.tool == Tool::flatten) plan.brush.value = height_at(state, x, y);
  if (state.tool == Tool::clone && state.paint.clone_at) {
    state.paint.clone_offset = {state.paint.clone_at->x - x, state.paint.clone_at->y - y};
    state.paint.clone_at.reset();
    plan.brush.clone_offset = state.paint.clone_offset;
  }
  for (EditTarget& target : edit_targets(state, plan.brush)) {
    auto computed = state.grounds.computed(snapshot, target.layer);
    // A species that is not computed yet is left out; the one that is looked at is known (paint_hindrance).
    if (!computed && !plan.targets.empty()) continue;
    plan.targets.push_back(std::move(target));
    plan.computed.push_back(std::move(computed));
  }
  plan.source = computed_map_source(snapshot, plan.targets.front().layer);
  if (!state.painting.shows(plan.targets.front().layer, plan.source)) {
    plan.picture = state.grounds.take_picture(snapshot, plan.targets.front().layer);
  }
  plan.clone_from = clone_layer(state);
  if (plan.clone_from) plan.clone_source = state.grounds.final_of(snapshot, state.document, *plan.clone_from);
  plan.filters = state.grounds.filters(snapshot, state.document, plan.brush.filter);
  return plan;
}

}  // namespace

void prepare_painting(EditorState& state) {
  if (state.painting.stroking() || !state.shown) return;
  const bool needs_maps = is_painting(state.tool) || state.paint.show_filter;
  PaintNeeds needs = needs_maps ? needs_of_brush(painted_layers(state), state.brush, clone_layer(state)) : PaintNeeds{};
  const std::optional<LayerId> target = is_brush(state.tool) ? paint_target(state) : std::nullopt;
  if (target && !state.painting.shows(*target, computed_map_source(*state.shown, *target))) needs.picture = target;
  state.grounds.prepare(state.shown, state.document, needs);
}

void begin_stroke(EditorState& state, float x, float y, float pressure) {
  if (!is_brush(state.tool)) return;
  const std::string waiting = pending_edit(state);
  const std::string hindrance = waiting.empty() ? paint_hindrance(state) : waiting + " is still being done";
  if (!hindrance.empty()) {
    announce(state, hindrance);
    return;
  }
  StrokePlan plan = stroke_plan(state, x, y);
  const LayerId layer = plan.targets.front().layer;
  if (!state.painting.begin(state.document, std::move(plan))) return;
  ++state.paint.strokes;
  // One sees what one paints.
  show_layer(state, layer);
  continue_stroke(state, x, y, pressure);
}

void continue_stroke(EditorState& state, float x, float y, float pressure) {
  if (!state.painting.stroking()) return;
  if (!state.painting.move_to(state.document, x, y, pressure).empty()) state.must_post = true;
  state.paint.last_point = PathPoint{x, y};
}

void end_stroke(EditorState& state) {
  if (!state.painting.stroking()) return;
  FinishedStroke stroke = state.painting.finish(state.document);
  if (!stroke.command) return;
  state.history.record(std::move(stroke.command));
  ++state.edits;
  state.must_post = true;
  recorded(state, stroke.edit);
}

void clear_paint(EditorState& state, const LayerId& layer) { perform_edit(state, ClearEdit{layer}); }

}  // namespace biotope

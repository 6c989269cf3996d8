#include "ui/placing_actions.hpp"

#include <algorithm>
#include <cmath>

#include "ui/editor_actions.hpp"

namespace biotope {
namespace {

std::optional<PlacedKind> kind_of(PlacingTool tool) {
  switch (tool) {
    case PlacingTool::inflow:
      return PlacedKind::inflow;
    case PlacingTool::river:
      return PlacedKind::river;
    case PlacingTool::lake:
      return PlacedKind::lake;
    case PlacingTool::ford:
      return PlacedKind::ford;
    case PlacingTool::exit:
      return PlacedKind::exit;
    case PlacingTool::waypoint:
      return PlacedKind::waypoint;
    case PlacingTool::pin_trail:
      return PlacedKind::pinned_trail;
    case PlacingTool::forbid_trail:
      return PlacedKind::forbidden_trail;
    case PlacingTool::none:
    case PlacingTool::bend_trail:
      return std::nullopt;
  }
  return std::nullopt;
}

bool on_terrain(const EditorState& state, PathPoint at) {
  const Grid<float>& height = state.document.terrain->height;
  return at.x >= -0.5F && at.y >= -0.5F && at.x <= float(height.width()) - 0.5F && at.y <= float(height.height()) - 0.5F;
}

/// A pinned trail is as worn as a good one of the landscape's own.
void suit_weight(const EditorState& state, PinnedTrail& trail) {
  trail.weight = std::max(trail.weight, 0.1F * state.trail_figures.busiest);
}

/// A ford reaches across the river it is placed in.
void suit_radius(const EditorState& state, PlacedFord& ford) {
  if (!state.shown || !state.shown->hydrology) return;
  const Grid<float>& discharge = state.shown->hydrology->discharge;
  float greatest = 0;
  for (int dy = -3; dy <= 3; ++dy) {
    for (int dx = -3; dx <= 3; ++dx) {
      const int x = int(std::lround(ford.at.x)) + dx;
      const int y = int(std::lround(ford.at.y)) + dy;
      if (discharge.contains(x, y)) greatest = std::max(greatest, discharge(x, y));
    }
  }
  ford.radius = std::max(ford.radius, 1.2F * river_width(greatest));
}

void place(EditorState& state, PlacedKind kind, std::vector<PathPoint> points) {
  PlacedItem item{kind, 0};
  change_placed(state, std::string("Place ") + placed_name(kind), [&](PlacedThings& things) {
    item = add_thing(things, kind, std::move(points), *state.document.terrain);
    if (kind == PlacedKind::ford) suit_radius(state, things.placements.places.fords.back());
    if (kind == PlacedKind::pinned_trail) suit_weight(state, things.placements.places.pinned_trails.back());
  });
  state.placing.selected = item;
}

bool take_route(EditorState& state, PathPoint at, float reach) {
  if (!state.shown || !state.shown->trails) return false;
  const auto hit = route_near(*state.shown->trails, at, reach * 1.5F);
  if (!hit) return false;
  state.placing.stretch =
      stretch_around(*state.shown->trails, *hit, state.document.terrain->cell_size, double(state.placing.bend_reach));
  state.placing.bend = TrailBend{};
  return true;
}

bool take_handle(EditorState& state, PathPoint at, float reach) {
  PlacingSession& placing = state.placing;
  const PlacedThings things = placed_things(state.document);
  if (const auto handle = handle_near(things, at, reach, placing.selected)) {
    // A point of another thing's line is only taken once that thing is chosen: its handles are not shown before.
    if (!is_line(handle->item.kind) || placing.selected == handle->item) {
      placing.held = handle;
      placing.selected = handle->item;
      return true;
    }
  }
  const auto item = item_near(things, at, reach);
  if (!item) {
    placing.selected.reset();
    return false;
  }
  placing.selected = item;
  return true;
}

bool press_with_tool(EditorState& state, PathPoint at, float reach) {
  PlacingSession& placing = state.placing;
  if (placing.tool == PlacingTool::bend_trail) {
    if (!take_route(state, at, reach)) announce(state, "No trail here: press on one and pull it");
    return true;
  }
  if (!on_terrain(state, at)) return true;
  const PlacedKind kind = *kind_of(placing.tool);
  if (!is_line(kind)) {
    place(state, kind, {at});
    return true;
  }
  // A click on the first point closes a lake, one on the last ends a line.
  const auto near = [&](PathPoint point) { return std::hypot(point.x - at.x, point.y - at.y) < reach; };
  const bool closes = placing.line.size() >= least_points(kind) &&
                      (near(placing.line.back()) || (kind == PlacedKind::lake && near(placing.line.front())));
  if (closes) {
    finish_line(state);
  } else {
    placing.line.push_back(at);
  }
  return true;
}

}  // namespace

void choose_placing(EditorState& state, PlacingTool tool) {
  PlacingSession& placing = state.placing;
  placing.line.clear();
  placing.held.reset();
  placing.preview.reset();
  placing.bend.reset();
  placing.tool = placing.tool == tool ? PlacingTool::none : tool;
  state.tool = Tool::select;
}

bool press_placing(EditorState& state, PathPoint at, float reach) {
  if (!state.has_document || state.tool != Tool::select) return false;
  if (state.placing.tool != PlacingTool::none) return press_with_tool(state, at, reach);
  return take_handle(state, at, reach);
}

void drag_placing(EditorState& state, PathPoint at) {
  PlacingSession& placing = state.placing;
  const Terrain& terrain = *state.document.terrain;
  if (placing.bend) {
    placing.bend = bent(placing.stretch, at, terrain.cell_size, double(placing.bend_reach));
  } else if (placing.held) {
    PlacedThings things = placed_things(state.document);
    move_point(things, *placing.held, at, terrain);
    placing.preview = std::move(things);
  }
}

void release_placing(EditorState& state) {
  PlacingSession& placing = state.placing;
  if (placing.bend) {
    const TrailBend bend = std::move(*placing.bend);
    placing.bend.reset();
    if (bend.after.size() < 2) return;
    change_placed(state, "Bend a trail",
                  [&](PlacedThings& things) { place_bend(things, bend, state.document.terrain->cell_size); });
    placing.selected = PlacedItem{PlacedKind::pinned_trail, state.document.placements.places.pinned_trails.size() - 1};
    placing.tool = PlacingTool::none;
  } else if (placing.held) {
    const std::string name = std::string("Move ") + placed_name(placing.held->item.kind);
    placing.held.reset();
    if (!placing.preview) return;
    const PlacedThings moved = std::move(*placing.preview);
    placing.preview.reset();
    change_placed(state, name, [&](PlacedThings& things) { things = moved; });
  }
}

void finish_line(EditorState& state) {
  PlacingSession& placing = state.placing;
  const auto kind = kind_of(placing.tool);
  std::vector<PathPoint> line = std::move(placing.line);
  placing.line.clear();
  if (!kind || line.size() < least_points(*kind)) {
    if (kind && !line.empty()) announce(state, std::string(placed_name(*kind)) + " needs more points");
    return;
  }
  place(state, *kind, std::move(line));
  placing.tool = PlacingTool::none;
}

bool cancel_placing(EditorState& state) {
  PlacingSession& placing = state.placing;
  if (placing.bend || placing.held) {
    placing.bend.reset();
    placing.held.reset();
    placing.preview.reset();
    return true;
  }
  if (!placing.line.empty()) {
    placing.line.clear();
    return true;
  }
  if (placing.tool != PlacingTool::none) {
    placing.tool = PlacingTool::none;
    return true;
  }
  if (!placing.selected) return false;
  placing.selected.reset();
  return true;
}

void shorten_line(EditorState& state) {
  if (!state.placing.line.empty()) state.placing.line.pop_back();
}

void remove_selected(EditorState& state) {
  if (!state.placing.selected) return;
  const PlacedItem item = *state.placing.selected;
  state.placing.selected.reset();
  change_placed(state, std::string("Remove ") + placed_name(item.kind),
                [&](PlacedThings& things) { remove_thing(things, item); });
}

void split_selected(EditorState& state, PathPoint at) {
  if (!state.placing.selected || !is_line(state.placing.selected->kind)) return;
  const PlacedItem item = *state.placing.selected;
  change_placed(state, std::string("Add a point to ") + placed_name(item.kind),
                [&](PlacedThings& things) { insert_point(things, item, at); });
}

void change_placed(EditorState& state, const std::string& name, const std::function<void(PlacedThings&)>& change) {
  change_document(state, name, [&](Document& document) {
    PlacedThings things = placed_things(document);
    change(things);
    set_placed(document, things);
  });
}

PlacedThings shown_things(const EditorState& state) {
  return state.placing.preview ? *state.placing.preview : placed_things(state.document);
}

bool removes_thing(const EditorState& state) {
  return state.tool == Tool::select && state.placing.selected && state.placing.line.empty();
}

bool follow_press(EditorState& state, PlacingView view, const std::optional<PathPoint>& at, const PointerButton& left) {
  PlacingSession& placing = state.placing;
  const bool holds_stop = state.herd_day.held_stop >= 0 && state.herd_day.grip == DayGrip::none;
  const bool holds_thing = placing.held || placing.bend;
  if (!holds_stop && !holds_thing && !placing.took_press) return false;
  // Where the view of the press is gone, the other one lets go.
  const bool forgotten = !left.down && !left.released;
  if (placing.pressed_on != view && !forgotten) return true;
  if (left.dragging && at && placing.pressed_on == view) {
    if (holds_stop) drag_day(state, *at);
    if (holds_thing) drag_placing(state, *at);
  }
  if (left.down) return holds_stop || holds_thing;
  if (holds_stop) release_day(state);
  if (holds_thing) release_placing(state);
  placing.took_press = false;
  return true;
}

void follow_document(EditorState& state) {
  PlacingSession& placing = state.placing;
  if (state.tool != Tool::select) {
    placing.tool = PlacingTool::none;
    placing.line.clear();
    placing.selected.reset();
  }
  if (!placing.selected) return;
  const PlacedThings things = placed_things(state.document);
  if (placing.selected->index >= count_of(things, placing.selected->kind)) {
    placing.selected.reset();
    placing.held.reset();
    placing.preview.reset();
  }
}

}  // namespace biotope

#include "ui/landscape_figures.hpp"

#include <algorithm>

#include "core/base/parallel.hpp"
#include "ui/activity_curve.hpp"
#include "ui/editor_actions.hpp"

namespace biotope {
namespace {

constexpr std::size_t most_named_routes = 12;

GroundFigures measure_ground(const Terrain& terrain) {
  GroundFigures figures;
  const auto heights = terrain.height.cells();
  const auto [low, high] = std::minmax_element(heights.begin(), heights.end());
  if (!heights.empty()) figures.height_range = {*low, *high};
  const auto filled = std::count(terrain.voids.cells().begin(), terrain.voids.cells().end(), std::uint8_t(1));
  if (!terrain.voids.empty()) figures.void_share = double(filled) / double(terrain.voids.size());
  return figures;
}

WaterFigures measure_water(const Hydrology& hydrology, double cell_area) {
  std::size_t lake = 0;
  std::size_t sea = 0;
  for (const WaterKind kind : hydrology.water.cells()) {
    lake += kind == WaterKind::lake ? 1 : 0;
    sea += kind == WaterKind::sea ? 1 : 0;
  }
  WaterFigures figures{double(lake) * cell_area, double(sea) * cell_area, 0};
  for (const RiverReach& reach : hydrology.reaches) figures.discharge = std::max(figures.discharge, reach.discharge);
  return figures;
}

/// What has to be counted of a landscape; what did not change keeps its figures.
struct Wanted {
  std::shared_ptr<const MapsSnapshot> maps;
  bool ground = false;
  bool water = false;
  bool trails = false;
  bool activity = false;
};

EditorState::LandscapeCount count(const Wanted& wanted) {
  const MapsSnapshot& maps = *wanted.maps;
  EditorState::LandscapeCount result;
  if (wanted.ground) result.ground = measure_ground(maps.terrain());
  if (wanted.water) result.water = maps.hydrology ? measure_water(*maps.hydrology, maps.terrain().cell_area()) : WaterFigures{};
  if (wanted.trails)
    result.trails = maps.trails ? trail_figures(*maps.trails, maps.terrain().cell_size, most_named_routes) : TrailFigures{};
  if (wanted.activity) result.activity = activity_curve(maps);
  result.species = species_figures(maps);
  result.shortages = shortage_maps(maps);
  return result;
}

/// Tells what an edit changed once all of it is answered.
void tell_changes(EditorState& state) {
  const MapsSnapshot& maps = *state.figures_of;
  if (!maps.complete || !maps.web) return;
  const bool whole =
      state.changes.follow(state.figures, maps.document_revision, state.posted_revision, state.painting.stroking());
  if (whole && state.history.position() > 0 && !state.changes.changes().empty()) {
    announce(state, changes_text(*maps.web, state.changes.changes(), 4));
  }
}

void take_figures(EditorState& state) {
  auto counted = state.counting.take();
  if (!counted || !*counted) return;
  EditorState::LandscapeCount& figures = **counted;
  state.figures = std::move(figures.species);
  state.shortages = std::move(figures.shortages);
  if (figures.ground) state.ground = *figures.ground;
  if (figures.water) state.water = *figures.water;
  if (figures.trails) state.trail_figures = std::move(*figures.trails);
  if (figures.activity) state.activity = std::move(*figures.activity);
  tell_changes(state);
}

}  // namespace

void follow_landscape(EditorState& state) {
  take_figures(state);
  if (state.counting.running() || !state.shown || !state.shown->document.terrain || state.shown == state.figures_of) return;
  const MapsSnapshot* before = state.figures_of.get();
  const Wanted wanted{state.shown, before == nullptr || before->surface() != state.shown->surface(),
                      before == nullptr || before->hydrology != state.shown->hydrology,
                      before == nullptr || before->trails != state.shown->trails,
                      before == nullptr || before->plans != state.shown->plans};
  state.figures_of = state.shown;
  state.counting.start("Counting", [wanted](const TaskContext&) -> Result<EditorState::LandscapeCount> { return count(wanted); });
}

}  // namespace biotope

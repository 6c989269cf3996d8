#include "ui/exploring.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "render/animal_pick.hpp"
#include "render/landscape_renderer.hpp"
#include "ui/camera_motion.hpp"
#include "ui/editor_actions.hpp"
#include "ui/plant_pick.hpp"
#include "ui/walking.hpp"

namespace biotope {
namespace {

constexpr double herd_distance = 38;  // m from which a herd is looked at

WalkingGround walking_ground(const EditorState& state) { return {ground_of(state), water_of(state)}; }

bool visible(const EditorState& state, int species) {
  const auto index = std::size_t(species);
  return index >= state.view.visible_species.size() || state.view.visible_species[index];
}

/// Where the herd of a plan is now, m.
std::optional<glm::dvec3> plan_place(const EditorState& state, const DailyPlan& plan) {
  const auto place = herd_place(*state.shown, int(&plan - state.shown->plans->data()), state.clock.hour);
  return place ? std::optional(place->centre) : std::nullopt;
}

/// A view of a place that trees leave free: from farther away where that can be, from higher up where it must be.
Camera clear_view(const EditorState& state, const glm::dvec3& place, double distance) {
  constexpr double clear_enough = 0.75;
  const PlantsAround plants(state.view.plants ? state.exploring.plants : PlantPlacement(), place, distance + 12,
                            state.view.visible_species);
  const auto clearness = [&](const glm::dvec3& eye) {
    int free = 0;
    int looks = 0;
    for (const glm::dvec2 beside : {glm::dvec2(0, 0), glm::dvec2(6, 0), glm::dvec2(-6, 0), glm::dvec2(0, 6), glm::dvec2(0, -6)}) {
      ++looks;
      free += plants.free(eye, place + glm::dvec3(beside.x, beside.y, 0)) ? 1 : 0;
    }
    return double(free) / looks;
  };
  Camera best = state.view.camera;
  double clearest = -1;
  for (const double slant : {18.0, 40.0, 65.0}) {
    for (const double share : {1.0, 0.6, 0.35}) {
      const Camera camera = view_of_place(ground_of(state), place, distance * share, state.view.camera, clearness, slant);
      const double clear = clearness(camera.position);
      if (clear <= clearest + 0.1) continue;
      clearest = clear;
      best = camera;
    }
    if (clearest >= clear_enough) break;
  }
  return best;
}

/// Flies to where one can stand at or near a place, eyes at their height.
void land(EditorState& state, glm::dvec2 place) {
  const WalkingGround ground = walking_ground(state);
  Camera camera = state.view.camera;
  const glm::dvec2 at = standing_place(ground, place);
  camera.position = {at.x, at.y, eye_level(ground, at)};
  camera.pitch = std::clamp(camera.pitch, -12.0F, 12.0F);
  fly_to(state, camera);
  announce(state, "On foot: W A S D walk, Shift runs, drag to look around");
}

}  // namespace

const Terrain& ground_of(const EditorState& state) {
  const bool known = state.shown && state.shown->document.terrain == state.document.terrain;
  return known ? state.shown->terrain() : *state.document.terrain;
}

const Hydrology* water_of(const EditorState& state) {
  const bool known = state.shown && state.shown->document.terrain == state.document.terrain;
  return known ? state.shown->hydrology.get() : nullptr;
}

void fly_to(EditorState& state, const Camera& camera) {
  state.view.camera_untouched = false;
  state.view.camera_placed = true;
  state.exploring.flight = CameraFlight{state.view.camera, camera, 0};
  if (state.view.mode == ViewMode::map) state.view.mode = ViewMode::split;
}

void show_place(EditorState& state, PathPoint cell, double distance) {
  if (!state.document.terrain) return;
  state.view.map.centre_x = double(cell.x);
  state.view.map.centre_y = double(cell.y);
  state.exploring.following = false;
  const Terrain& terrain = ground_of(state);
  const glm::dvec3 place = place_of(terrain, cell) + glm::dvec3(0, 0, 1);
  fly_to(state, clear_view(state, place, distance));
}

void set_walking(EditorState& state, bool walking) {
  if (!state.document.terrain || state.exploring.walking == walking) return;
  state.exploring.walking = walking;
  state.exploring.following = false;
  if (!walking) {
    announce(state, "Flying again");
    return;
  }
  const Camera& camera = state.view.camera;
  const Terrain& terrain = ground_of(state);
  glm::dvec3 place = camera.position;
  // From high up one lands where one looks.
  if (place.z - double(ground_height(terrain, place.x, place.y)) > 60) {
    if (const auto seen = pick_ground(terrain, place, camera.forward())) place = *seen;
  }
  land(state, {place.x, place.y});
}

void walk_at(EditorState& state, PathPoint cell) {
  if (!state.document.terrain) return;
  state.exploring.walking = true;
  set_following(state, false);
  const glm::dvec3 place = place_of(ground_of(state), cell);
  land(state, {place.x, place.y});
}

bool choose_plan(EditorState& state, int plan) {
  if (!state.shown || !state.shown->plans || !state.shown->web) return false;
  // A number may be of plans that were replaced meanwhile.
  if (plan < 0 || std::size_t(plan) >= state.shown->plans->size()) return false;
  const DailyPlan& chosen = (*state.shown->plans)[std::size_t(plan)];
  auto edit = edit_of_plan(chosen, *state.shown->web, state.shown->animals);
  if (!edit) return false;
  state.herd_day = {};
  state.herd_day.herd = std::move(edit);
  state.exploring.arm.reset();
  state.exploring.member = -1;
  return true;
}

namespace {

/// The species chosen in a list, when one of its herds has a plan; -1: none.
int species_with_plan(const EditorState& state) {
  const auto of_species = [&](const DailyPlan& plan) { return plan.species == state.selected_species; };
  return std::ranges::any_of(*state.shown->plans, of_species) ? state.selected_species : -1;
}

}  // namespace

int neighbouring_plan(const EditorState& state, int step) {
  if (!state.shown || !state.shown->plans || state.shown->plans->empty()) return -1;
  const auto& plans = *state.shown->plans;
  const int count = int(plans.size());
  const DailyPlan* chosen = chosen_plan(state);
  const int from = chosen != nullptr ? int(chosen - plans.data()) : step > 0 ? count - 1 : 0;
  const int species = chosen != nullptr ? chosen->species : species_with_plan(state);
  for (int i = 1; i <= count; ++i) {
    const int index = ((from + step * i) % count + count) % count;
    const DailyPlan& plan = plans[std::size_t(index)];
    if (species >= 0 ? plan.species == species : visible(state, plan.species)) return index;
  }
  return -1;
}

bool choose_nearest_herd(EditorState& state, int species) {
  if (!state.shown || !state.shown->plans) return false;
  if (species < 0) species = species_with_plan(state);
  int nearest = -1;
  double least = std::numeric_limits<double>::max();
  for (std::size_t i = 0; i < state.shown->plans->size(); ++i) {
    const DailyPlan& plan = (*state.shown->plans)[i];
    if (species >= 0 ? plan.species != species : !visible(state, plan.species)) continue;
    const auto place = plan_place(state, plan);
    const double away = place ? glm::length(*place - state.view.camera.position) : least;
    if (away >= least) continue;
    least = away;
    nearest = int(i);
  }
  return choose_plan(state, nearest);
}

std::optional<glm::dvec3> chosen_herd_place(const EditorState& state) {
  const DailyPlan* plan = chosen_plan(state);
  return plan != nullptr ? plan_place(state, *plan) : std::nullopt;
}

void go_to_herd(EditorState& state) {
  const auto place = chosen_herd_place(state);
  if (!place) return;
  const Terrain& terrain = ground_of(state);
  const PathPoint cell = cell_of(terrain, *place);
  state.view.map.centre_x = double(cell.x);
  state.view.map.centre_y = double(cell.y);
  state.exploring.walking = false;
  state.exploring.arm.reset();
  fly_to(state, clear_view(state, *place + glm::dvec3(0, 0, 1), herd_distance));
}

void set_following(EditorState& state, bool following) {
  if (!following) {
    state.exploring.following = false;
    state.exploring.arm.reset();
    return;
  }
  if (!chosen_herd_place(state)) return;
  go_to_herd(state);
  state.exploring.following = true;
  state.exploring.followed = chosen_herd_place(state);
}

bool advance_exploring(EditorState& state, double seconds) {
  if (!state.document.terrain) return false;
  Exploring& exploring = state.exploring;
  const std::optional<glm::dvec3> herd = exploring.following ? exploring.followed : std::nullopt;
  if (exploring.following && !herd) exploring.following = false;
  if (exploring.flight) {
    // A slow machine still shows the way, not only its end.
    exploring.flight->elapsed += std::min(seconds, 0.12);
    state.view.camera = camera_on_flight(*exploring.flight);
    if (!landed(*exploring.flight)) return true;
    exploring.flight.reset();
    if (herd) keep_arm(state);
    return true;
  }
  if (!herd) return false;
  if (!exploring.arm) keep_arm(state);
  if (!exploring.arm) return false;
  const glm::dvec3 before = state.view.camera.position;
  state.view.camera.position = *herd + exploring.arm->offset;
  if (exploring.member >= 0 && state.view.plants) {
    const glm::dvec3 breast = *herd + glm::dvec3(0, 0, 1);
    const double left_out = 1 - exploring.sight.share(exploring.plants, breast, state.view.camera.position, seconds);
    state.view.camera.position += left_out * (breast - state.view.camera.position);
  }
  state.view.camera.pitch = exploring.arm->pitch;
  const Camera kept = kept_over_ground(state.view.camera, ground_of(state), 1.5, water_of(state));
  if (kept.position.z > state.view.camera.position.z + 0.01) {
    // The ground lifts the camera over a hill: it still looks where the herd is.
    const glm::dvec3 arm = *herd + glm::dvec3(0, 0, 1) - kept.position;
    state.view.camera.pitch = std::max(float(std::atan2(arm.z, std::hypot(arm.x, arm.y)) * 57.29577951), -80.0F);
  }
  state.view.camera.position = kept.position;
  return state.view.camera.position != before;
}

void keep_arm(EditorState& state) {
  if (!state.exploring.following || state.exploring.flight) return;
  const Camera& camera = state.view.camera;
  state.exploring.sight.reset();
  if (const auto& herd = state.exploring.followed) state.exploring.arm = {camera.position - *herd, camera.pitch};
}

void take_camera(EditorState& state) {
  state.exploring.flight.reset();
  state.pictures.playing = -1;
  if (!state.exploring.following) return;
  set_following(state, false);
  announce(state, "Not following any more");
}

}  // namespace biotope

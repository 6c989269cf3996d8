#include "ui/landscape_click.hpp"

#include <algorithm>
#include <cmath>

#include "ui/camera_motion.hpp"
#include "ui/editor_actions.hpp"
#include "ui/plant_pick.hpp"

namespace biotope {
namespace {

constexpr double beyond_ground = 3;   // m an animal may lie behind the ground the ray meets: its legs are in the grass
constexpr double animals_told = 250;  // m at which one can hit an animal
constexpr double herbs_told = 14;     // m at which one tells one herb from another

/// From where one stands, along with the herd from now on; a walker stays where he is.
void follow_from_here(EditorState& state) {
  if (state.exploring.walking) return;
  state.exploring.flight.reset();
  state.exploring.arm.reset();
  state.exploring.following = true;
}

/// Plants as they are drawn; before there are any of what is shown, where they will be.
PlantPlacement plants_of(const EditorState& state, const LandscapeClick& click) {
  const MapsSnapshot* drawn = click.plants != nullptr ? click.plants->snapshot() : nullptr;
  return drawn != nullptr && drawn->web == state.shown->web ? *click.plants : PlantPlacement(state.shown);
}

void choose_plant(EditorState& state, const PickedPlant& plant) {
  if (plant.species != state.selected_species) select_species(state, plant.species);
  const PathPoint cell = cell_of(ground_of(state), plant.foot);
  ask_why(state, int(std::lround(cell.x)), int(std::lround(cell.y)));
}

}  // namespace

void click_landscape(EditorState& state, const LandscapeClick& click) {
  if (!state.shown || !state.document.terrain) return;
  const glm::dvec3& eye = state.view.camera.position;
  const double to_ground = click.ground ? glm::length(*click.ground - eye) : 1e5;
  if (state.view.herds) {
    const auto animal = pick_animal(click.drawn, eye, click.ray, to_ground + beyond_ground);
    if (animal && choose_plan(state, animal->plan)) {
      state.exploring.member = animal->member;
      follow_from_here(state);
      return;
    }
  }
  if (state.view.plants) {
    const auto plant = pick_plant(plants_of(state, click), eye, click.ray, to_ground, state.view.visible_species);
    if (plant) {
      choose_plant(state, *plant);
      return;
    }
  }
  if (!click.ground) return;
  const PathPoint cell = cell_of(ground_of(state), *click.ground);
  // From afar animals are too small to be hit: their place is meant.
  if (state.view.herds && to_ground > animals_told && choose_herd(state, cell, click.herd_reach)) {
    state.exploring.member = -1;
    follow_from_here(state);
    return;
  }
  const bool tells_herbs = state.view.plants && to_ground < herbs_told;
  const auto herb = tells_herbs ? herb_at(plants_of(state, click), *click.ground, state.view.visible_species) : std::nullopt;
  if (herb) {
    choose_plant(state, *herb);
    return;
  }
  ask_why(state, int(std::lround(cell.x)), int(std::lround(cell.y)));
}

}  // namespace biotope

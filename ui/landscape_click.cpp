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

/// The number that a species of the drawn plants has in what is shown; -1: it is not there any more.
int shown_species(const EditorState& state, const PlantPlacement& plants, int species) {
  const FoodWeb& drawn = *plants.snapshot()->web;
  return state.shown->web ? state.shown->web->find(drawn.species[std::size_t(species)].name) : -1;
}

void choose_plant(EditorState& state, const PlantPlacement& plants, const PickedPlant& plant) {
  const int species = shown_species(state, plants, plant.species);
  if (species >= 0 && species != state.selected_species) select_species(state, species);
  const PathPoint cell = cell_of(ground_of(state), plant.foot);
  ask_why(state, int(std::lround(cell.x)), int(std::lround(cell.y)));
}

}  // namespace

void click_landscape(EditorState& state, const LandscapeClick& click) {
  if (!state.shown || !state.document.terrain) return;
  const double to_ground = click.ground ? glm::length(*click.ground - click.eye) : 1e5;
  if (state.view.herds) {
    const auto animal = pick_animal(click.drawn, click.eye, click.ray, to_ground + beyond_ground);
    if (animal && choose_plan(state, animal->plan)) {
      state.exploring.member = animal->member;
      follow_from_here(state);
      return;
    }
  }
  const bool plants = state.view.plants && click.plants != nullptr && click.plants->snapshot() != nullptr;
  if (plants) {
    const auto plant = pick_plant(*click.plants, click.eye, click.ray, to_ground, state.view.visible_species);
    if (plant) {
      choose_plant(state, *click.plants, *plant);
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
  const auto herb =
      plants && to_ground < herbs_told ? herb_at(*click.plants, *click.ground, state.view.visible_species) : std::nullopt;
  if (herb) {
    choose_plant(state, *click.plants, *herb);
    return;
  }
  ask_why(state, int(std::lround(cell.x)), int(std::lround(cell.y)));
}

}  // namespace biotope

#pragma once

#include "ui/widgets.hpp"

namespace biotope {

// The parts of the inspector, one file each. They draw into the current Dear ImGui window.

void draw_terrain_panel(const UiContext& ui);
void draw_climate_panel(const UiContext& ui);
/// The species of a food-chain level; 0 are the plants.
void draw_species_list(const UiContext& ui, int level);
/// Switch of a level and, for the selected species of it, its desired share.
void draw_desired_shares(const UiContext& ui, const FoodWeb& web, int level);
void draw_plants_panel(const UiContext& ui);
void draw_animals_panel(const UiContext& ui);
void draw_trails_panel(const UiContext& ui);
/// Title, seed, paint, history, warnings and timings.
void draw_project_panel(const UiContext& ui);
void draw_history_panel(const UiContext& ui);
void draw_warnings_panel(const UiContext& ui);
void draw_brush_panel(const UiContext& ui);
void draw_why_panel(const UiContext& ui);

}  // namespace biotope

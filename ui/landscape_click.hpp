#pragma once

#include <glm/glm.hpp>
#include <optional>
#include <span>

#include "render/animal_pick.hpp"
#include "render/plant_placement.hpp"
#include "ui/editor_state.hpp"

namespace biotope {

/// A click into the 3D view with nothing in the hand.
struct LandscapeClick {
  glm::dvec3 eye{0};                 ///< of the picture that was clicked, m
  glm::vec3 ray{0};                  ///< from the eye
  std::optional<glm::dvec3> ground;  ///< that the ray meets, m
  float herd_reach = 0;              ///< cells around that place in which a herd counts as meant
  std::span<const AnimalAt> drawn;   ///< animals in the picture, of the plans that are shown
  /// Plants in the picture, as they are drawn. They may be of an older food web than what is shown: species then go by name.
  const PlantPlacement* plants = nullptr;
};

/// An animal: its herd is chosen and followed. A plant: its species is chosen, and why it stands there is asked. The ground: why
/// the chosen species is, or is not, here.
void click_landscape(EditorState& state, const LandscapeClick& click);

}  // namespace biotope

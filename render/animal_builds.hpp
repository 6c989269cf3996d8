#pragma once

#include "render/animal_proportions.hpp"

namespace biotope::animal_builds {

// One build an animal: our drawing's choices, from field guides' silhouettes.

[[nodiscard]] AnimalBuild red_deer();
[[nodiscard]] AnimalBuild fallow_deer();
[[nodiscard]] AnimalBuild reindeer();
[[nodiscard]] AnimalBuild moose();
[[nodiscard]] AnimalBuild mule_deer();
[[nodiscard]] AnimalBuild bison();
[[nodiscard]] AnimalBuild horse();
[[nodiscard]] AnimalBuild goat();
[[nodiscard]] AnimalBuild tahr();
[[nodiscard]] AnimalBuild pronghorn();
[[nodiscard]] AnimalBuild chamois();
[[nodiscard]] AnimalBuild sheep();
[[nodiscard]] AnimalBuild wolf();
[[nodiscard]] AnimalBuild fox();
[[nodiscard]] AnimalBuild cat();
[[nodiscard]] AnimalBuild lynx();
[[nodiscard]] AnimalBuild bear();
[[nodiscard]] AnimalBuild boar();
[[nodiscard]] AnimalBuild rhino();

}  // namespace biotope::animal_builds

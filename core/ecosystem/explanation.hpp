#pragma once

#include <memory>
#include <span>
#include <string>
#include <vector>

#include "core/ecosystem/animal_level.hpp"
#include "core/ecosystem/plant_competition.hpp"

namespace biotope {

/// Answer to 'why is this species here, or not?'.
struct Explanation {
  /// One line for a headline: "Absent: too dry from May to September".
  std::string headline;
  /// Sentences with numbers and units, most telling first.
  std::vector<std::string> details;
  /// Before competition, 0..1; -1 for animals.
  float fitness = -1;
  LimitingFactor limiting = LimitingFactor::none;
};

/// A plant at a cell: fitness, limiting resource with the months it fails and by how much, and who out-competed it; with `loss`
/// (paint of the plant's losses, may be null) what an external event takes of its growth.
[[nodiscard]] Explanation explain_plant(const FoodWeb& web, const PlantEnvironment& environment, int plant,
                                        std::span<const std::shared_ptr<const CoverMap>> covers, int x, int y,
                                        const PaintLayer* loss = nullptr);

/// An animal at a cell: blocked (by what), region and its population, which need limits it, who competes; what cuts an empty
/// place off from where the species lives, what paint asks too much of, and what external events take.
[[nodiscard]] Explanation explain_animal(const FoodWeb& web, const AnimalLevel& level, int species, const Ground& ground, int x,
                                         int y);

}  // namespace biotope

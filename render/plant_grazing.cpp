#include "render/plant_grazing.hpp"

#include <algorithm>
#include <cmath>

#include "core/ecosystem/eaten_zones.hpp"
#include "core/ecosystem/losses.hpp"

namespace biotope {

namespace {

/// Steps between nothing and all that is left: so that plants do not change by a hair where animals elsewhere eat a little more.
constexpr double steps = 64;

}  // namespace

Grazing::Grazing(const MapsSnapshot& snapshot) {
  if (!snapshot.web || snapshot.web->levels.empty()) return;
  for (const int species : snapshot.web->levels[0]) {
    Plant& plant = plants_.emplace_back();
    plant.loss = snapshot.loss(species);
    for (const auto& level : snapshot.animals) {
      if (!level || !level->partition || std::size_t(species) >= level->eaten.size()) continue;
      const std::vector<double> share = eaten_share(*level, species);
      if (share.empty()) continue;
      Eater& eater = plant.eaters.emplace_back(Eater{level->partition, {}});
      for (const double eaten : share) eater.left.push_back(float(std::round((1 - eaten) * steps) / steps));
    }
  }
}

float Grazing::left(int plant, int x, int y) const {
  if (std::size_t(plant) >= plants_.size()) return 1;
  const Plant& own = plants_[std::size_t(plant)];
  float left = own.loss ? share_kept(loss_steps((*own.loss)(x, y))) : 1.0F;
  for (const Eater& eater : own.eaters) {
    const std::int32_t piece = eater.partition->label(x, y);
    if (piece >= 0) left *= eater.left[std::size_t(piece)];
  }
  return left;
}

bool Grazing::same_as(const Grazing& other) const {
  return std::equal(
      plants_.begin(), plants_.end(), other.plants_.begin(), other.plants_.end(), [](const Plant& a, const Plant& b) {
        return a.loss == b.loss &&
               std::equal(a.eaters.begin(), a.eaters.end(), b.eaters.begin(), b.eaters.end(),
                          [](const Eater& c, const Eater& d) { return c.partition == d.partition && c.left == d.left; });
      });
}

}  // namespace biotope

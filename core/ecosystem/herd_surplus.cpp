#include "core/ecosystem/herd_surplus.hpp"

#include <algorithm>
#include <cassert>

#include "core/ecosystem/losses.hpp"

namespace biotope {
namespace {

std::size_t index_of(const AnimalLevel& level, int species) {
  const auto found = std::find(level.species.begin(), level.species.end(), species);
  assert(found != level.species.end());
  return std::size_t(found - level.species.begin());
}

/// Share of a species' yearly growth in a region that is lost, painted over the mean of the region.
double lost_share(const AnimalLevel& level, std::size_t index, const Herd& herd) {
  const PaintLayer* loss = loss_of(level.basis.losses, herd.species);
  return loss ? mean_losses(*level.regions[index], loss)[std::size_t(herd.region)] : 0;
}

/// kg a year that the levels take of a species in a region.
double taken(std::span<const std::shared_ptr<const AnimalLevel>> levels, const Herd& herd) {
  const auto resource = std::size_t(herd.species);
  double sum = 0;
  for (const auto& level : levels) {
    if (resource >= level->eaten.size() || level->eaten[resource].empty()) continue;
    for (const AnimalLevel::PreyShare& prey : level->prey) {
      if (prey.species != herd.species || prey.region != herd.region) continue;
      const double available = level->available[resource][std::size_t(prey.piece)];
      if (available > 0) sum += prey.available * std::min(1.0, level->eaten[resource][std::size_t(prey.piece)] / available);
    }
  }
  return sum;
}

/// Share of its food that the herd's own level left in the region.
double food_left(const FoodWeb& web, const AnimalLevel& level, std::size_t index, const Herd& herd) {
  if (!level.partition) return 1;
  double available = 0;
  double eaten = 0;
  for (std::size_t piece = 0; piece < level.partition->pieces.size(); ++piece) {
    if (level.partition->pieces[piece].region[index] != herd.region) continue;
    for (const FoodWeb::ResolvedNeed& need : web.diets[std::size_t(herd.species)]) {
      for (const int food : need.foods) {
        const auto resource = std::size_t(food);
        if (resource >= level.available.size() || level.available[resource].empty()) continue;
        available += level.available[resource][piece];
        eaten += std::min(level.eaten[resource][piece], level.available[resource][piece]);
      }
    }
  }
  return available > 0 ? 1 - eaten / available : 1;
}

}  // namespace

HerdSurplus herd_surplus(const FoodWeb& web, std::span<const std::shared_ptr<const AnimalLevel>> levels, const AnimalLevel& level,
                         const Herd& herd) {
  const std::size_t index = index_of(level, herd.species);
  const AnimalTraits& animal = web.species[std::size_t(herd.species)].animal();
  const double grown =
      level.population[index][std::size_t(herd.region)] * double(animal.growth_rate) * double(animal.mean_mass());
  HerdSurplus surplus;
  if (grown > 0) surplus.own = std::clamp(1 - lost_share(level, index, herd) - taken(levels, herd) / grown, 0.0, 1.0);
  surplus.food = food_left(web, level, index, herd);
  return surplus;
}

double young_share(const AnimalTraits& animal, const HerdSurplus& surplus) {
  constexpr double share_before_taken = 1.0 / 3;
  const double alive = share_before_taken + (1 - share_before_taken) * surplus.own;
  const double reared = 0.5 + 0.5 * std::min(1.0, 2 * surplus.food);
  const double born = std::max(0.0, double(animal.growth_rate)) * alive * reared;
  return std::min(0.35, born / (1 + born));
}

}  // namespace biotope

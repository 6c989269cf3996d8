#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstdio>

#include "core/ecosystem/animal_needs.hpp"
#include "core/ecosystem/explanation.hpp"
#include "core/ecosystem/explanation_obstacles.hpp"
#include "core/ecosystem/losses.hpp"

namespace biotope {
namespace {

std::string decimals(double value, int digits) {
  char text[64];
  std::snprintf(text, sizeof text, "%.*f", digits, value);
  return text;
}

Explanation explain_obstacle(const Ground& ground, const AnimalTraits& animal, Obstacle obstacle, int x, int y) {
  Explanation result;
  switch (obstacle) {
    case Obstacle::slope: {
      const double slope = double(ground.derivatives->slope(x, y));
      const auto degrees = [](double rise) { return number_text(std::atan(rise) * 180 / 3.14159265358979323846); };
      result.headline = "Blocked: too steep";
      result.details.push_back("The ground rises " + decimals(slope, 2) + " m per m (" + degrees(slope) +
                               " degrees); it walks up to " + decimals(double(animal.max_slope), 2) + " (" +
                               degrees(double(animal.max_slope)) + " degrees).");
      break;
    }
    case Obstacle::deep_water:
      result.headline = "Blocked: water too deep";
      result.details.push_back("The water is " + decimals(double(ground.hydrology->water_depth(x, y)), 2) +
                               " m deep and no ford is near; it wades " + decimals(double(animal.wade_depth), 2) + " m.");
      break;
    case Obstacle::trees:
      result.headline = "Blocked: trees too dense";
      result.details.push_back("Trees cover " + number_text(100.0 * (*ground.tree_cover)(x, y) / full_cover) +
                               " % of the ground; it pushes through " + number_text(100.0 * double(animal.max_tree_cover)) +
                               " %.");
      break;
    case Obstacle::painted:
      result.headline = "Blocked: a painted obstacle";
      result.details.push_back("Somebody painted an obstacle for every animal here.");
      break;
    case Obstacle::none:
      break;
  }
  return result;
}

std::string need_text(const NeedBalance& balance, int herd) {
  const double asked = balance.need.kilograms * herd;
  std::string text = "Of " + number_text(balance.offered) + " kg of " + balance.need.name + " that grow in reach each year " +
                     number_text(balance.left) + " are left; another herd of " + std::to_string(herd) + " needs " +
                     number_text(asked);
  if (asked > balance.left) text += ", " + number_text(asked - balance.left) + " kg are short";
  return text + ".";
}

/// kg a year that one animal needs of what is in some list of foods.
double shared_need(const FoodWeb& web, int species, const std::vector<int>& foods) {
  double kilograms = 0;
  for (const YearlyNeed& need : yearly_needs(web, species)) {
    const bool shared = std::any_of(need.foods.begin(), need.foods.end(),
                                    [&](int food) { return std::find(foods.begin(), foods.end(), food) != foods.end(); });
    if (shared) kilograms += need.kilograms;
  }
  return kilograms;
}

/// Other species of the level that live in the region's pieces and eat what this one eats, with their numbers there and their
/// shares of what all need of it.
std::vector<std::string> competitors(const FoodWeb& web, const AnimalLevel& level, std::size_t index, int region,
                                     const std::vector<int>& foods) {
  struct Rival {
    int species = 0;
    double animals = 0;
    double kilograms = 0;
  };
  std::vector<Rival> found;
  double all = level.population[index][std::size_t(region)] * shared_need(web, level.species[index], foods);
  for (std::size_t other = 0; other < level.species.size(); ++other) {
    if (other == index) continue;
    const double need = shared_need(web, level.species[other], foods);
    if (need <= 0) continue;
    std::vector<int> their_regions;
    for (const auto& piece : level.partition->pieces) {
      if (piece.region[index] == region && piece.region[other] >= 0) their_regions.push_back(piece.region[other]);
    }
    std::sort(their_regions.begin(), their_regions.end());
    their_regions.erase(std::unique(their_regions.begin(), their_regions.end()), their_regions.end());
    double animals = 0;
    for (const int own : their_regions) animals += level.population[other][std::size_t(own)];
    all += animals * need;
    if (animals >= 0.5) found.push_back({level.species[other], animals, animals * need});
  }
  std::stable_sort(found.begin(), found.end(), [](const Rival& a, const Rival& b) { return a.kilograms > b.kilograms; });
  std::vector<std::string> texts;
  for (const Rival& rival : found) {
    texts.push_back(number_text(rival.animals) + " " + display_name(web, rival.species) + " (" +
                    number_text(100 * rival.kilograms / all) + " % of what is needed)");
  }
  return texts;
}

std::string joined(const std::vector<std::string>& parts) {
  std::string text;
  for (const std::string& part : parts) text += (text.empty() ? "" : ", ") + part;
  return text;
}

/// What external events take of its foods in the region, and of its own growth.
void add_losses(const FoodWeb& web, const AnimalLevel& level, std::size_t index, int region, std::vector<int> foods,
                Explanation& result) {
  const auto lost_of = [&](int species) {
    return mean_losses(*level.regions[index], loss_of(level.basis.losses, species))[std::size_t(region)];
  };
  std::sort(foods.begin(), foods.end());
  foods.erase(std::unique(foods.begin(), foods.end()), foods.end());
  std::vector<std::string> texts;
  for (const int food : foods) {
    const double lost = lost_of(food);
    if (lost >= 0.0005) texts.push_back(number_text(100 * lost) + " % of the " + display_name(web, food));
  }
  if (!texts.empty())
    result.details.push_back("Lost to an external event here: " + joined(texts) + " that would grow in a year.");
  const double own = lost_of(level.species[index]);
  if (own >= 0.0005)
    result.details.push_back("Of its own yearly growth " + number_text(100 * own) + " % is lost to an external event.");
}

/// What keeps the species of the nearest region where it lives from coming here.
void add_barrier(const AnimalLevel& level, std::size_t index, const Ground& ground, const Mobility& mobility, int x, int y,
                 Explanation& result) {
  const auto nearest = nearest_region_cell(level.regions[index]->label, level.population[index], x, y);
  if (!nearest) return;
  const auto barrier = barrier_between(ground, mobility, x, y, nearest->x, nearest->y);
  if (!barrier) return;
  result.details.push_back("Cut off from the " + number_text(level.population[index][std::size_t(nearest->region)]) +
                           " in region " + std::to_string(nearest->region) + " by " + barrier_text(ground, *barrier, x, y) + ".");
}

/// The settled case and the empty one: population, limiting need, rivals.
void explain_region(const FoodWeb& web, const AnimalLevel& level, std::size_t index, int region, Explanation& result) {
  const AnimalTraits& animal = web.species[std::size_t(level.species[index])].animal();
  const double individuals = level.population[index][std::size_t(region)];
  const auto& own = level.regions[index]->regions[std::size_t(region)];
  const std::string place = "region " + std::to_string(region) + " (" + decimals(own.area / 1e6, 2) + " km2)";
  const std::vector<NeedBalance> balance = need_balance(web, level, index, region);
  const int scarcest = scarcest_need(balance, &NeedBalance::left);
  // Banks are nodes only where something grows to eat.
  const bool nothing_grows = scarcest >= 0 && balance[std::size_t(scarcest)].offered <= 0;
  const bool thirsty = animal.water_visits > 0 && !nothing_grows && !region_has_water(level, index, region);
  if (individuals > 0) {
    std::size_t herds = 0;
    for (const Herd& herd : level.herds) herds += herd.species == level.species[index] && herd.region == region;
    result.headline = "Present: " + number_text(individuals) + " in " + place;
    result.details.push_back(std::to_string(herds) + (herds == 1 ? " herd; " : " herds; ") +
                             number_text(individuals / (own.area / 1e6)) + " per km2.");
  } else if (thirsty) {
    result.headline = "Absent: no water to drink in " + place;
  } else if (scarcest >= 0) {
    const NeedBalance& scarce = balance[std::size_t(scarcest)];
    const bool grows = scarce.offered >= scarce.need.kilograms * animal.herd_min;
    result.headline = (grows ? "Absent: others leave too little " : "Absent: too little ") + scarce.need.name + " in " + place;
  } else {
    result.headline = "Absent from " + place;
  }
  if (thirsty) result.details.push_back("No river, lake or brook can be reached to drink.");
  if (scarcest >= 0) result.details.push_back(need_text(balance[std::size_t(scarcest)], animal.herd_min));
  std::vector<int> foods;
  for (const NeedBalance& need : balance) foods.insert(foods.end(), need.need.foods.begin(), need.need.foods.end());
  const std::vector<std::string> rivals = competitors(web, level, index, region, foods);
  if (!rivals.empty()) result.details.push_back("Shares its food with " + joined(rivals) + ".");
  for (const auto& shortage : level.shortages) {
    if (shortage.species != level.species[index] || shortage.region != region || shortage.missing <= 0) continue;
    result.details.push_back("Painted beyond what grows: " + number_text(shortage.missing) + " kg of " + shortage.resource +
                             " a year are missing.");
  }
  add_losses(web, level, index, region, std::move(foods), result);
}

}  // namespace

Explanation explain_animal(const FoodWeb& web, const AnimalLevel& level, int species, const Ground& ground, int x, int y) {
  const auto found = std::find(level.species.begin(), level.species.end(), species);
  assert(found != level.species.end());
  const std::size_t index = std::size_t(found - level.species.begin());
  const AnimalTraits& animal = web.species[std::size_t(species)].animal();
  const Mobility mobility = mobility_of(animal);
  const Obstacle obstacle = obstacle_at(ground, mobility, x, y);
  if (obstacle != Obstacle::none) return explain_obstacle(ground, animal, obstacle, x, y);
  Explanation result;
  const std::int32_t region = level.regions[index]->label(x, y);
  if (region < 0) {
    result.headline = "Absent: cut off";
    result.details.push_back("Less than " + number_text(minimum_region_area / 10000) +
                             " ha of passable ground is enclosed here, too little to live on.");
    const auto around = barrier_around(ground, mobility, x, y, minimum_region_cells(ground.terrain->cell_size));
    if (around) result.details.push_back("It is shut in mostly by " + barrier_text(ground, *around, x, y) + ".");
    add_barrier(level, index, ground, mobility, x, y, result);
    return result;
  }
  explain_region(web, level, index, region, result);
  if (!(level.population[index][std::size_t(region)] > 0)) add_barrier(level, index, ground, mobility, x, y, result);
  return result;
}

}  // namespace biotope

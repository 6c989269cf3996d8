#include "core/ecosystem/animal_needs.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>

namespace biotope {
namespace {

constexpr double days_per_year = 365;

}  // namespace

std::vector<YearlyNeed> yearly_needs(const FoodWeb& web, int species) {
  std::vector<YearlyNeed> needs;
  const auto& diet = web.diets[std::size_t(species)];
  const auto& named = web.species[std::size_t(species)].animal().diet;
  for (std::size_t i = 0; i < diet.size(); ++i) {
    if (diet[i].amount <= 0) continue;
    needs.push_back(
        {i < named.size() ? named[i].name : "food", diet[i].foods, diet[i].preferences, double(diet[i].amount) * days_per_year});
  }
  return needs;
}

std::vector<NeedBalance> need_balance(const FoodWeb& web, const AnimalLevel& level, std::size_t species_index, int region) {
  std::vector<NeedBalance> balance;
  for (YearlyNeed& need : yearly_needs(web, level.species[species_index])) balance.push_back({std::move(need), 0, 0});
  const auto lives_in = [&](std::size_t piece) { return level.partition->pieces[piece].region[species_index] == region; };
  for (NeedBalance& own : balance) {
    for (const int food : own.need.foods) {
      const auto& available = level.available[std::size_t(food)];
      for (std::size_t piece = 0; piece < available.size(); ++piece) {
        if (available[piece] <= 0 || !lives_in(piece)) continue;
        own.offered += available[piece];
        own.left += available[piece] - (level.eaten.empty() ? 0 : level.eaten[std::size_t(food)][piece]);
      }
    }
    own.left = std::max(0.0, own.left);
  }
  return balance;
}

int scarcest_need(const std::vector<NeedBalance>& balance, double NeedBalance::*amount) {
  int scarcest = -1;
  double fewest = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < balance.size(); ++i) {
    const double animals = balance[i].*amount / balance[i].need.kilograms;
    if (animals >= fewest) continue;
    fewest = animals;
    scarcest = int(i);
  }
  return scarcest;
}

bool region_has_water(const AnimalLevel& level, std::size_t species_index, int region) {
  return std::any_of(level.graph->nodes.begin(), level.graph->nodes.end(), [&](const ResourceNode& node) {
    return node.kind == NodeKind::bank && level.partition->pieces[std::size_t(node.piece)].region[species_index] == region;
  });
}

std::string absence_reason(const FoodWeb& web, const AnimalLevel& level, std::size_t species_index) {
  const auto& regions = level.regions[species_index]->regions;
  const AnimalTraits& animal = web.species[std::size_t(level.species[species_index])].animal();
  if (regions.empty()) return "all ground is too steep, too deep under water or too densely wooded for it";
  std::vector<NeedBalance> best;
  int best_need = -1;
  double most = -1;
  bool any_food = false;
  for (std::size_t region = 0; region < regions.size(); ++region) {
    std::vector<NeedBalance> balance = need_balance(web, level, species_index, int(region));
    const int scarcest = scarcest_need(balance, &NeedBalance::offered);
    if (scarcest < 0) return "its diet says nothing that it eats";
    const double animals = balance[std::size_t(scarcest)].offered / balance[std::size_t(scarcest)].need.kilograms;
    any_food = any_food || animals >= animal.herd_min;
    if (animal.water_visits > 0 && !region_has_water(level, species_index, int(region))) continue;
    if (animals <= most) continue;
    most = animals;
    best_need = scarcest;
    best = std::move(balance);
  }
  if (best_need < 0)
    return any_food ? "no region where it finds food has water to drink" : "no region has water to drink, nor food for a herd";
  const NeedBalance& scarce = best[std::size_t(best_need)];
  if (most < animal.herd_min) {
    return "a herd of " + std::to_string(animal.herd_min) + " needs " + number_text(scarce.need.kilograms * animal.herd_min) +
           " kg of " + scarce.need.name + " a year, more than any of its regions offers";
  }
  return level.desired.empty() ? "others leave too little of its food for a herd of " + std::to_string(animal.herd_min)
                               : "others take its food before its share makes a herd of " + std::to_string(animal.herd_min);
}

std::string display_name(const FoodWeb& web, int species) {
  const Species& own = web.species[std::size_t(species)];
  return own.common_name.empty() ? own.name : own.common_name;
}

std::string number_text(double value) {
  char text[64];
  std::snprintf(text, sizeof text, std::abs(value) >= 9.95 || value == 0 ? "%.0f" : "%.1f", value);
  return text;
}

}  // namespace biotope

#include "core/ecosystem/animal_competition.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/ecosystem/animal_needs.hpp"

namespace biotope {
namespace {

/// Steps of a competition that are still quick (our choice).
constexpr double most_steps = 6000;
/// Rounding that does not make a meal incomplete, as a share of the need.
constexpr double rounding = 1e-9;

}  // namespace

AnimalCompetition::AnimalCompetition(const FoodWeb& web, std::span<const int> species, const Partition& partition,
                                     std::span<const std::shared_ptr<const ConfinementRegions>> regions, const GraphLevel& graph) {
  for (const int number : species) {
    const AnimalTraits& animal = web.species[std::size_t(number)].animal();
    needs_.push_back(yearly_needs(web, number));
    herd_min_.push_back(std::max(1, animal.herd_min));
    drinks_.push_back(animal.water_visits > 0);
  }
  offered_.assign(web.species.size(), std::vector<double>(partition.pieces.size()));
  for (const ResourceNode& node : graph.nodes) {
    for (const ResourceQuantity& quantity : node.quantities) {
      offered_[std::size_t(quantity.species)][std::size_t(node.piece)] += quantity.available;
    }
  }
  left_ = offered_;
  find_settlements(partition, regions, graph);

  double herds = 0;
  for (const Settlement& own : settlements_) herds += own.capacity / herd_min(own.species_index);
  herds_at_a_time_ = std::max(1, int(std::lround(herds / double(std::max(std::size_t{1}, species.size())) / most_steps)));
}

void AnimalCompetition::find_settlements(const Partition& partition, std::span<const std::shared_ptr<const ConfinementRegions>> regions,
                                         const GraphLevel& graph) {
  for (std::size_t i = 0; i < regions.size(); ++i) {
    first_settlement_.push_back(settlements_.size());
    for (std::size_t region = 0; region < regions[i]->regions.size(); ++region) {
      Settlement own;
      own.species_index = int(i);
      own.region = int(region);
      own.has_water = !drinks_[i];
      settlements_.push_back(std::move(own));
    }
    std::vector<int> foods;
    for (const YearlyNeed& need : needs_[i]) foods.insert(foods.end(), need.foods.begin(), need.foods.end());
    std::sort(foods.begin(), foods.end());
    foods.erase(std::unique(foods.begin(), foods.end()), foods.end());
    for (std::size_t piece = 0; piece < partition.pieces.size(); ++piece) {
      const int region = partition.pieces[piece].region[i];
      if (region < 0) continue;
      Settlement& own = settlements_[settlement(int(i), region)];
      bool any = false;
      for (const int food : foods) {
        if (offered_[std::size_t(food)][piece] <= 0) continue;
        any = true;
        if (std::find(own.foods.begin(), own.foods.end(), food) == own.foods.end()) own.foods.push_back(food);
      }
      if (any) own.pieces.push_back(int(piece));
    }
  }
  for (const ResourceNode& node : graph.nodes) {
    if (node.kind != NodeKind::bank) continue;
    const auto& region = partition.pieces[std::size_t(node.piece)].region;
    for (std::size_t i = 0; i < region.size(); ++i) {
      if (region[i] >= 0) settlements_[settlement(int(i), region[i])].has_water = true;
    }
  }
  eaters_of_piece_.resize(partition.pieces.size());
  for (std::size_t s = 0; s < settlements_.size(); ++s) {
    Settlement& own = settlements_[s];
    std::sort(own.foods.begin(), own.foods.end());
    own.taken.assign(own.foods.size() * own.pieces.size(), 0);
    refresh(own);
    for (const int piece : own.pieces) eaters_of_piece_[std::size_t(piece)].push_back(s);
    const auto& needs = needs_[std::size_t(own.species_index)];
    if (needs.empty() || own.pieces.empty()) continue;
    own.capacity = std::numeric_limits<double>::infinity();
    for (const YearlyNeed& need : needs) {
      double found = 0;
      for (std::size_t f = 0; f < own.foods.size(); ++f) {
        if (std::find(need.foods.begin(), need.foods.end(), own.foods[f]) != need.foods.end()) found += own.left[f];
      }
      own.capacity = std::min(own.capacity, found / need.kilograms);
    }
  }
}

void AnimalCompetition::refresh(Settlement& settlement) const {
  settlement.left.assign(settlement.foods.size(), 0);
  for (std::size_t f = 0; f < settlement.foods.size(); ++f) {
    const auto& left = left_[std::size_t(settlement.foods[f])];
    for (const int piece : settlement.pieces) settlement.left[f] += left[std::size_t(piece)];
  }
}

void AnimalCompetition::refresh_around(const Settlement& settlement) {
  std::vector<std::size_t> touched;
  for (const int piece : settlement.pieces) {
    const auto& eaters = eaters_of_piece_[std::size_t(piece)];
    touched.insert(touched.end(), eaters.begin(), eaters.end());
  }
  std::sort(touched.begin(), touched.end());
  touched.erase(std::unique(touched.begin(), touched.end()), touched.end());
  for (const std::size_t other : touched) refresh(settlements_[other]);
}

Meal AnimalCompetition::plan_meal(std::size_t settlement, double animals) const {
  const Settlement& own = settlements_[settlement];
  Meal meal;
  meal.amounts.assign(own.foods.size(), 0);
  for (const YearlyNeed& need : needs_[std::size_t(own.species_index)]) {
    const double demand = need.kilograms * animals;
    double missing = demand;
    // Every round either satisfies the need or uses up a food, so there are at most as many rounds as foods.
    for (std::size_t round = 0; round <= need.foods.size() && missing > demand * rounding; ++round) {
      double total = 0;
      std::vector<std::pair<std::size_t, double>> weights;
      for (std::size_t i = 0; i < need.foods.size(); ++i) {
        const auto found = std::lower_bound(own.foods.begin(), own.foods.end(), need.foods[i]);
        if (found == own.foods.end() || *found != need.foods[i]) continue;
        const std::size_t f = std::size_t(found - own.foods.begin());
        const double left = own.left[f] - meal.amounts[f];
        if (left <= 0) continue;
        weights.emplace_back(f, double(need.preferences[i]) * left);
        total += weights.back().second;
      }
      if (total <= 0) break;
      double taken = 0;
      for (const auto& [f, weight] : weights) {
        const double left = own.left[f] - meal.amounts[f];
        const double amount = std::min(left, missing * weight / total);
        meal.amounts[f] = amount == left ? own.left[f] : meal.amounts[f] + amount;
        taken += amount;
      }
      missing -= taken;
    }
    meal.missing.push_back(missing > demand * rounding ? missing : 0);
    meal.complete = meal.complete && meal.missing.back() == 0;
  }
  return meal;
}

void AnimalCompetition::eat(std::size_t settlement, double animals, const Meal& meal) {
  Settlement& own = settlements_[settlement];
  for (std::size_t f = 0; f < own.foods.size(); ++f) {
    if (meal.amounts[f] <= 0) continue;
    const double share = std::min(1.0, meal.amounts[f] / own.left[f]);
    for (std::size_t p = 0; p < own.pieces.size(); ++p) {
      double& left = left_[std::size_t(own.foods[f])][std::size_t(own.pieces[p])];
      const double amount = left * share;
      left -= amount;
      own.taken[f * own.pieces.size() + p] += amount;
    }
  }
  own.population += animals;
  refresh_around(own);
}

void AnimalCompetition::give_back(std::size_t settlement, double share) {
  Settlement& own = settlements_[settlement];
  for (std::size_t f = 0; f < own.foods.size(); ++f) {
    for (std::size_t p = 0; p < own.pieces.size(); ++p) {
      double& taken = own.taken[f * own.pieces.size() + p];
      left_[std::size_t(own.foods[f])][std::size_t(own.pieces[p])] += taken * share;
      taken -= taken * share;
    }
  }
  own.population -= own.population * share;
  refresh_around(own);
}

double AnimalCompetition::fitness(std::size_t settlement) const {
  const Settlement& own = settlements_[settlement];
  if (own.capacity <= 0) return 0;
  double fitness = 1 - own.population / own.capacity;
  for (const YearlyNeed& need : needs_[std::size_t(own.species_index)]) {
    double left = 0;
    for (const int food : need.foods) {
      const auto found = std::lower_bound(own.foods.begin(), own.foods.end(), food);
      if (found != own.foods.end() && *found == food) left += own.left[std::size_t(found - own.foods.begin())];
    }
    const double demand = need.kilograms * herd_min(own.species_index);
    fitness = std::min(fitness, left > 0 ? 1 - demand / left : 0);
  }
  return std::clamp(fitness, 0.0, 1.0);
}

bool AnimalCompetition::can_feed(std::size_t settlement, double animals) const {
  const Settlement& own = settlements_[settlement];
  return own.has_water && own.capacity > 0 && plan_meal(settlement, animals).complete;
}

bool AnimalCompetition::settle(std::size_t settlement, double animals) {
  const Settlement& own = settlements_[settlement];
  if (!own.has_water || own.capacity <= 0) return false;
  const Meal meal = plan_meal(settlement, animals);
  if (!meal.complete) return false;
  eat(settlement, animals, meal);
  return true;
}

std::vector<std::vector<double>> AnimalCompetition::eaten() const {
  std::vector<std::vector<double>> eaten(offered_.size(), std::vector<double>(eaters_of_piece_.size()));
  for (const Settlement& own : settlements_) {
    for (std::size_t f = 0; f < own.foods.size(); ++f) {
      for (std::size_t p = 0; p < own.pieces.size(); ++p) {
        eaten[std::size_t(own.foods[f])][std::size_t(own.pieces[p])] += own.taken[f * own.pieces.size() + p];
      }
    }
  }
  for (std::size_t resource = 0; resource < eaten.size(); ++resource) {
    for (std::size_t piece = 0; piece < eaten[resource].size(); ++piece) {
      eaten[resource][piece] = std::min(eaten[resource][piece], offered_[resource][piece]);
    }
  }
  return eaten;
}

}  // namespace biotope

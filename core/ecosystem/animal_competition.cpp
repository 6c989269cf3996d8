#include "core/ecosystem/animal_competition.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

#include "core/ecosystem/animal_needs.hpp"

namespace biotope {
namespace {

/// Steps of a competition that are still quick (our choice).
constexpr double most_steps = 6000;
/// Rounding that does not make a meal incomplete, as a share of the need.
constexpr double rounding = 1e-9;

}  // namespace

AnimalCompetition::AnimalCompetition(const CompetitionInput& input, std::span<const char> also) : available_(&input.available) {
  find_settlements(input);
  find_capacities(input);
  find_stocks(input, also);
  find_eaters();
  double herds = 0;
  for (const Settlement& own : settlements_) herds += own.habitable ? own.capacity / herd_min(own.species_index) : 0;
  herds_at_a_time_ = std::max(1, int(std::lround(herds / double(std::max(std::size_t{1}, input.species.size())) / most_steps)));
}

void AnimalCompetition::find_settlements(const CompetitionInput& input) {
  for (std::size_t i = 0; i < input.species.size(); ++i) {
    const AnimalTraits& animal = input.web.species[std::size_t(input.species[i])].animal();
    needs_.push_back(yearly_needs(input.web, input.species[i]));
    herd_min_.push_back(std::max(1, animal.herd_min));
    first_settlement_.push_back(settlements_.size());
    for (std::size_t region = 0; region < input.regions[i]->regions.size(); ++region) {
      Settlement& own = settlements_.emplace_back();
      own.species_index = int(i);
      own.region = int(region);
      own.has_water = animal.water_visits <= 0;
    }
  }
  for (const ResourceNode& node : input.graph.nodes) {
    if (node.kind != NodeKind::bank) continue;
    const auto& region = input.partition.pieces[std::size_t(node.piece)].region;
    for (std::size_t i = 0; i < region.size(); ++i) {
      if (region[i] >= 0) settlements_[settlement(int(i), region[i])].has_water = true;
    }
  }
}

void AnimalCompetition::find_capacities(const CompetitionInput& input) {
  // By settlement and need: what its pieces offer, and whether a node offers any.
  std::vector<std::vector<double>> found(settlements_.size());
  std::vector<std::vector<char>> has_node(settlements_.size());
  for (std::size_t s = 0; s < settlements_.size(); ++s) {
    found[s].resize(needs(settlements_[s].species_index).size());
    has_node[s].resize(found[s].size());
  }
  for (std::size_t piece = 0; piece < input.partition.pieces.size(); ++piece) {
    const auto& region = input.partition.pieces[piece].region;
    for (std::size_t i = 0; i < region.size(); ++i) {
      if (region[i] < 0) continue;
      auto& own = found[settlement(int(i), region[i])];
      for (std::size_t need = 0; need < own.size(); ++need) {
        for (const int food : needs_[i][need].foods) own[need] += input.available[std::size_t(food)][piece];
      }
    }
  }
  for (const ResourceNode& node : input.graph.nodes) {
    const auto& region = input.partition.pieces[std::size_t(node.piece)].region;
    for (std::size_t i = 0; i < region.size(); ++i) {
      for (std::size_t need = 0; region[i] >= 0 && need < needs_[i].size(); ++need) {
        const auto& foods = needs_[i][need].foods;
        const bool offers = std::any_of(node.quantities.begin(), node.quantities.end(), [&](const ResourceQuantity& quantity) {
          return std::find(foods.begin(), foods.end(), quantity.species) != foods.end();
        });
        if (offers) has_node[settlement(int(i), region[i])][need] = 1;
      }
    }
  }
  for (std::size_t s = 0; s < settlements_.size(); ++s) {
    Settlement& own = settlements_[s];
    const auto own_needs = needs(own.species_index);
    own.capacity = own_needs.empty() ? 0 : std::numeric_limits<double>::infinity();
    for (std::size_t need = 0; need < own_needs.size(); ++need) {
      own.capacity = std::min(own.capacity, has_node[s][need] ? found[s][need] / own_needs[need].kilograms : 0);
    }
    own.habitable = own.has_water && own.capacity * (1 + rounding) >= herd_min(own.species_index);
  }
}

void AnimalCompetition::find_stocks(const CompetitionInput& input, std::span<const char> also) {
  std::map<std::vector<std::size_t>, std::int32_t> number;
  stock_of_piece_.assign(input.partition.pieces.size(), -1);
  for (std::size_t piece = 0; piece < stock_of_piece_.size(); ++piece) {
    const auto& region = input.partition.pieces[piece].region;
    std::vector<std::size_t> eaters;
    for (std::size_t i = 0; i < region.size(); ++i) {
      if (region[i] < 0) continue;
      const std::size_t s = settlement(int(i), region[i]);
      if (settlements_[s].habitable || (s < also.size() && also[s])) eaters.push_back(s);
    }
    if (eaters.empty()) continue;
    const auto [stock, added] = number.try_emplace(eaters, std::int32_t(eaters_of_stock_.size()));
    if (added) eaters_of_stock_.push_back(eaters);
    stock_of_piece_[piece] = stock->second;
  }
  offered_.assign(input.available.size(), std::vector<double>(eaters_of_stock_.size()));
  for (std::size_t resource = 0; resource < offered_.size(); ++resource) {
    for (std::size_t piece = 0; piece < stock_of_piece_.size(); ++piece) {
      if (stock_of_piece_[piece] >= 0)
        offered_[resource][std::size_t(stock_of_piece_[piece])] += input.available[resource][piece];
    }
  }
  left_ = offered_;
}

void AnimalCompetition::find_eaters() {
  std::vector<std::vector<int>> foods_of_species;
  for (const auto& needs : needs_) {
    std::vector<int>& foods = foods_of_species.emplace_back();
    for (const YearlyNeed& need : needs) foods.insert(foods.end(), need.foods.begin(), need.foods.end());
    std::sort(foods.begin(), foods.end());
    foods.erase(std::unique(foods.begin(), foods.end()), foods.end());
  }
  for (std::size_t stock = 0; stock < eaters_of_stock_.size(); ++stock) {
    for (const std::size_t s : eaters_of_stock_[stock]) {
      Settlement& own = settlements_[s];
      const auto& foods = foods_of_species[std::size_t(own.species_index)];
      const bool any = std::any_of(foods.begin(), foods.end(), [&](int food) { return offered_[std::size_t(food)][stock] > 0; });
      if (!any) continue;
      own.stocks.push_back(int(stock));
      own.touching.insert(own.touching.end(), eaters_of_stock_[stock].begin(), eaters_of_stock_[stock].end());
    }
  }
  for (Settlement& own : settlements_) {
    for (const int food : foods_of_species[std::size_t(own.species_index)]) {
      const auto& offered = offered_[std::size_t(food)];
      if (std::any_of(own.stocks.begin(), own.stocks.end(), [&](int stock) { return offered[std::size_t(stock)] > 0; }))
        own.foods.push_back(food);
    }
    own.taken.assign(own.foods.size() * own.stocks.size(), 0);
    own.left_is_stale = true;
    std::sort(own.touching.begin(), own.touching.end());
    own.touching.erase(std::unique(own.touching.begin(), own.touching.end()), own.touching.end());
  }
}

Settlement& AnimalCompetition::fresh(std::size_t settlement) {
  Settlement& own = settlements_[settlement];
  if (!own.left_is_stale) return own;
  own.left.assign(own.foods.size(), 0);
  for (std::size_t f = 0; f < own.foods.size(); ++f) {
    const auto& left = left_[std::size_t(own.foods[f])];
    for (const int stock : own.stocks) own.left[f] += left[std::size_t(stock)];
  }
  own.left_is_stale = false;
  return own;
}

void AnimalCompetition::touch(const Settlement& settlement) {
  for (const std::size_t other : settlement.touching) settlements_[other].left_is_stale = true;
}

Meal AnimalCompetition::plan_meal(std::size_t settlement, double animals) {
  const Settlement& own = fresh(settlement);
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
  Settlement& own = fresh(settlement);
  for (std::size_t f = 0; f < own.foods.size(); ++f) {
    if (meal.amounts[f] <= 0) continue;
    const double share = std::min(1.0, meal.amounts[f] / own.left[f]);
    for (std::size_t p = 0; p < own.stocks.size(); ++p) {
      double& left = left_[std::size_t(own.foods[f])][std::size_t(own.stocks[p])];
      const double amount = left * share;
      left -= amount;
      own.taken[f * own.stocks.size() + p] += amount;
    }
  }
  own.population += animals;
  touch(own);
}

void AnimalCompetition::give_back(std::size_t settlement, double share) {
  Settlement& own = settlements_[settlement];
  for (std::size_t f = 0; f < own.foods.size(); ++f) {
    for (std::size_t p = 0; p < own.stocks.size(); ++p) {
      double& taken = own.taken[f * own.stocks.size() + p];
      left_[std::size_t(own.foods[f])][std::size_t(own.stocks[p])] += taken * share;
      taken -= taken * share;
    }
  }
  own.population -= own.population * share;
  touch(own);
}

double AnimalCompetition::fitness(std::size_t settlement) {
  const Settlement& own = fresh(settlement);
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

bool AnimalCompetition::can_feed(std::size_t settlement, double animals) {
  return settlements_[settlement].habitable && plan_meal(settlement, animals).complete;
}

bool AnimalCompetition::settle(std::size_t settlement, double animals) {
  if (!settlements_[settlement].habitable) return false;
  const Meal meal = plan_meal(settlement, animals);
  if (!meal.complete) return false;
  eat(settlement, animals, meal);
  return true;
}

void AnimalCompetition::adopt(const AnimalCompetition& coarser) {
  // Every stock of this ledger lies within one of the coarser, whose pieces all fared alike; or in none, where nobody ate.
  std::vector<std::int32_t> coarse_stock(eaters_of_stock_.size(), -1);
  for (std::size_t piece = 0; piece < stock_of_piece_.size(); ++piece) {
    if (stock_of_piece_[piece] >= 0) coarse_stock[std::size_t(stock_of_piece_[piece])] = coarser.stock_of_piece_[piece];
  }
  for (std::size_t s = 0; s < settlements_.size(); ++s) {
    Settlement& own = settlements_[s];
    const Settlement& before = coarser.settlements_[s];
    own.population = before.population;
    own.left_is_stale = true;
    if (before.population <= 0) continue;
    for (std::size_t f = 0; f < own.foods.size(); ++f) {
      const auto food =
          std::size_t(std::lower_bound(before.foods.begin(), before.foods.end(), own.foods[f]) - before.foods.begin());
      const auto resource = std::size_t(own.foods[f]);
      for (std::size_t i = 0; i < own.stocks.size(); ++i) {
        const auto stock = std::size_t(own.stocks[i]);
        const auto found = std::lower_bound(before.stocks.begin(), before.stocks.end(), coarse_stock[stock]);
        const double offered = coarser.offered_[resource][std::size_t(*found)];
        const double share = offered > 0 ? offered_[resource][stock] / offered : 0;
        const double taken = share * before.taken[food * before.stocks.size() + std::size_t(found - before.stocks.begin())];
        own.taken[f * own.stocks.size() + i] = taken;
        left_[resource][stock] = std::max(0.0, left_[resource][stock] - taken);
      }
    }
  }
}

std::vector<std::vector<double>> AnimalCompetition::eaten() const {
  std::vector<std::vector<double>> by_stock(offered_.size(), std::vector<double>(eaters_of_stock_.size()));
  for (const Settlement& own : settlements_) {
    for (std::size_t f = 0; f < own.foods.size(); ++f) {
      for (std::size_t i = 0; i < own.stocks.size(); ++i) {
        by_stock[std::size_t(own.foods[f])][std::size_t(own.stocks[i])] += own.taken[f * own.stocks.size() + i];
      }
    }
  }
  std::vector<std::vector<double>> eaten(offered_.size(), std::vector<double>(stock_of_piece_.size()));
  for (std::size_t resource = 0; resource < eaten.size(); ++resource) {
    for (std::size_t piece = 0; piece < stock_of_piece_.size(); ++piece) {
      if (stock_of_piece_[piece] < 0) continue;
      const auto stock = std::size_t(stock_of_piece_[piece]);
      const double offered = offered_[resource][stock];
      if (offered > 0)
        eaten[resource][piece] = (*available_)[resource][piece] * std::min(1.0, by_stock[resource][stock] / offered);
    }
  }
  return eaten;
}

}  // namespace biotope

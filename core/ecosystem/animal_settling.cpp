#include <limits>

#include "core/ecosystem/animal_competition.hpp"

namespace biotope {
namespace {

/// A place where a herd could settle.
struct Choice {
  std::size_t settlement = 0;
  double fitness = -1;
  [[nodiscard]] bool found() const { return fitness >= 0; }
};

/// The fittest region of a species that can feed so many animals; the first on ties.
Choice fittest_region(AnimalCompetition& competition, std::span<const std::size_t> settlements, double animals) {
  Choice best;
  for (const std::size_t settlement : settlements) {
    const double fitness = competition.fitness(settlement);
    if (fitness > best.fitness && competition.can_feed(settlement, animals)) best = {settlement, fitness};
  }
  return best;
}

/// Settlements of each species where a herd can live.
std::vector<std::vector<std::size_t>> habitable(const AnimalCompetition& competition, std::size_t species) {
  std::vector<std::vector<std::size_t>> result(species);
  const auto all = competition.settlements();
  for (std::size_t i = 0; i < all.size(); ++i) {
    if (all[i].habitable) result[std::size_t(all[i].species_index)].push_back(i);
  }
  return result;
}

/// Squared distance to the target when `added` individuals of one species join.
double distance_to_target(std::span<const double> individuals, std::span<const double> desired, std::size_t species,
                          double added) {
  double total = added;
  for (const double count : individuals) total += count;
  double distance = 0;
  for (std::size_t i = 0; i < desired.size(); ++i) {
    const double share = (individuals[i] + (i == species ? added : 0)) / total;
    distance += (share - desired[i]) * (share - desired[i]);
  }
  return distance;
}

}  // namespace

Status settle_fittest(AnimalCompetition& competition, const TaskContext& context) {
  for (int herds = competition.herds_at_a_time(); herds >= 1; herds /= 2) {
    for (bool settled = true; settled;) {
      settled = false;
      if (context.stopped()) return fail("stopped");
      for (const auto& eaters : competition.eaters_of_stock()) {
        Choice best;
        for (const std::size_t settlement : eaters) {
          const double fitness = competition.fitness(settlement);
          const double animals = herds * competition.herd_min(competition.settlements()[settlement].species_index);
          if (fitness > best.fitness && competition.can_feed(settlement, animals)) best = {settlement, fitness};
        }
        if (!best.found()) continue;
        const int species = competition.settlements()[best.settlement].species_index;
        settled = competition.settle(best.settlement, herds * competition.herd_min(species)) || settled;
      }
    }
  }
  return {};
}

Status settle_in_proportion(AnimalCompetition& competition, std::span<const double> desired, const TaskContext& context) {
  const auto regions = habitable(competition, desired.size());
  std::vector<double> individuals(desired.size());
  /// Herds of each species at a time: fewer once so many no longer find food, 0 when the species dropped out.
  std::vector<int> herds(desired.size());
  for (std::size_t i = 0; i < desired.size(); ++i)
    herds[i] = desired[i] > 0 && !regions[i].empty() ? competition.herds_at_a_time() : 0;
  for (;;) {
    if (context.stopped()) return fail("stopped");
    std::size_t closest = desired.size();
    double least = std::numeric_limits<double>::infinity();
    double fitness_of_closest = -1;
    const auto animals = [&](std::size_t i) { return double(herds[i]) * competition.herd_min(int(i)); };
    for (std::size_t i = 0; i < desired.size(); ++i) {
      if (herds[i] == 0) continue;
      const double distance = distance_to_target(individuals, desired, i, animals(i));
      if (distance > least) continue;
      const double fitness = distance == least ? fittest_region(competition, regions[i], animals(i)).fitness : -1;
      if (distance == least && closest < desired.size() && fitness_of_closest < 0) {
        fitness_of_closest = fittest_region(competition, regions[closest], animals(closest)).fitness;
      }
      if (distance == least && fitness <= fitness_of_closest) continue;
      closest = i;
      least = distance;
      fitness_of_closest = fitness;
    }
    if (closest == desired.size()) return {};
    const Choice place = fittest_region(competition, regions[closest], animals(closest));
    if (place.found() && competition.settle(place.settlement, animals(closest))) {
      individuals[closest] += animals(closest);
    } else {
      herds[closest] /= 2;
    }
  }
}

}  // namespace biotope

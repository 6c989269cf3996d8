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

/// State of a competition with proportions.
class ProportionedGrowth {
 public:
  ProportionedGrowth(AnimalCompetition& competition, std::span<const double> desired)
      : competition_(competition), regions_(habitable(competition, desired.size())), species_(desired.size()) {
    for (std::size_t i = 0; i < species_.size(); ++i) {
      Member& own = species_[i];
      own.unit = competition.herd_min(int(i));
      if (desired[i] <= 0 || regions_[i].empty()) continue;
      own.share = desired[i];
      own.herds = competition.herds_at_a_time();
    }
    normalise();
  }

  /// Settles herds of the species that they bring closest to the target, or learns that they have no place; false when nobody
  /// grows any more.
  bool grow_once() {
    const std::size_t closest = closest_species();
    if (closest == species_.size()) return false;
    Member& own = species_[closest];
    if (own.individuals + own.animals() / 2 > own.share * limit_) {
      own.herds /= 2;
      return true;
    }
    const Choice place = fittest_region(competition_, regions_[closest], own.animals());
    if (place.found() && competition_.settle(place.settlement, own.animals())) {
      own.individuals += own.animals();
      total_ += own.animals();
    } else {
      own.herds /= 2;
      if (own.herds == 0) drop_out(closest);
    }
    return true;
  }

  /// The species that set the limit counts when another could grow by half in one of its regions.
  [[nodiscard]] Proportions result() {
    for (std::size_t i = 0; i < species_.size(); ++i) {
      const Member& own = species_[i];
      if (own.dropped_out || own.individuals <= 0) continue;
      if (fittest_region(competition_, regions_[i], std::max(own.unit, own.individuals / 2)).found()) return {scarcest_};
    }
    return {};
  }

 private:
  struct Member {
    double share = 0;  ///< target, normalised over the species that can be placed
    double unit = 0;   ///< smallest herd
    double individuals = 0;
    int herds = 0;  ///< settle at a time: fewer once so many find no food or exceed the share, 0 when the species is done
    bool dropped_out = false;
    [[nodiscard]] double animals() const { return herds * unit; }
  };

  void normalise() {
    double sum = 0;
    for (const Member& own : species_) sum += own.share;
    for (Member& own : species_) own.share = sum > 0 ? own.share / sum : 0;
    update_limit();
  }

  /// The species has no place for another herd: where it has none at all, it asks for nothing any more.
  void drop_out(std::size_t species) {
    species_[species].dropped_out = true;
    if (species_[species].individuals <= 0) species_[species].share = 0;
    normalise();
  }

  /// Individuals of all species at which the share of one that dropped out would ask for a whole herd more than it has. Others
  /// grow as long as a herd brings them closer to their share of it.
  void update_limit() {
    limit_ = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < species_.size(); ++i) {
      const Member& own = species_[i];
      if (!own.dropped_out || own.share <= 0) continue;
      const double most = (own.individuals + own.unit) / own.share;
      if (most >= limit_) continue;
      limit_ = most;
      scarcest_ = int(i);
    }
  }

  /// Squared distance to the target when one more unit of a species joins.
  [[nodiscard]] double distance_to_target(std::size_t grown) const {
    const double added = species_[grown].animals();
    double distance = 0;
    for (std::size_t i = 0; i < species_.size(); ++i) {
      const Member& own = species_[i];
      const double difference = (own.individuals + (i == grown ? added : 0)) / (total_ + added) - own.share;
      distance += difference * difference;
    }
    return distance;
  }

  /// The species to grow next: the closest to the target, on ties the fittest; species_.size() when all dropped out.
  [[nodiscard]] std::size_t closest_species() {
    std::size_t closest = species_.size();
    double least = std::numeric_limits<double>::infinity();
    double fitness_of_closest = -1;
    for (std::size_t i = 0; i < species_.size(); ++i) {
      if (species_[i].herds == 0) continue;
      const double distance = distance_to_target(i);
      if (distance > least) continue;
      double fitness = -1;
      if (distance == least) {
        fitness = fittest_region(competition_, regions_[i], species_[i].animals()).fitness;
        if (fitness_of_closest < 0)
          fitness_of_closest = fittest_region(competition_, regions_[closest], species_[closest].animals()).fitness;
        if (fitness <= fitness_of_closest) continue;
      }
      closest = i;
      least = distance;
      fitness_of_closest = fitness;
    }
    return closest;
  }

  AnimalCompetition& competition_;
  std::vector<std::vector<std::size_t>> regions_;
  std::vector<Member> species_;
  double total_ = 0;
  double limit_ = std::numeric_limits<double>::infinity();
  int scarcest_ = -1;  ///< the species that sets the limit
};

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

Result<Proportions> settle_in_proportion(AnimalCompetition& competition, std::span<const double> desired,
                                         const TaskContext& context) {
  ProportionedGrowth growth(competition, desired);
  while (growth.grow_once()) {
    if (context.stopped()) return fail("stopped");
  }
  return growth.result();
}

}  // namespace biotope

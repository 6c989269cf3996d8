#pragma once

#include <span>
#include <string>
#include <vector>

#include "core/base/status.hpp"
#include "core/base/task_context.hpp"
#include "core/ecosystem/confinement.hpp"
#include "core/ecosystem/resource_access_graph.hpp"
#include "core/species/species_library.hpp"

namespace biotope {

/// A need of a species over a year.
struct YearlyNeed {
  std::string name;
  std::vector<int> foods;  ///< species numbers
  std::vector<float> preferences;
  double kilograms = 0;  ///< per animal and year, > 0
};

/// What one species finds and takes in one of its confinement regions.
struct Settlement {
  int species_index = 0;  ///< in the level
  int region = 0;
  bool has_water = false;
  /// Animals that the region would feed if nobody else ate; 0 where a need has no node to go to.
  double capacity = 0;
  /// Water, and food for a herd of the smallest size.
  bool habitable = false;
  double population = 0;
  /// Stocks of the region that offer any of its foods (see AnimalCompetition).
  std::vector<int> stocks;
  /// Foods found in the region (species numbers, ascending), and what is left of each, kg per year.
  std::vector<int> foods;
  std::vector<double> left;
  bool left_is_stale = false;
  /// kg per year taken, by food and stock: taken[food * stocks.size() + stock].
  std::vector<double> taken;
  /// Settlements that share a stock, this one included.
  std::vector<std::size_t> touching;
};

/// Food for some animals: kg per year by food of the settlement, and what is missing by need.
struct Meal {
  std::vector<double> amounts;
  std::vector<double> missing;
  bool complete = true;
};

/// What the competition of a level reads.
struct CompetitionInput {
  const FoodWeb& web;
  std::span<const int> species;
  const Partition& partition;
  std::span<const std::shared_ptr<const ConfinementRegions>> regions;
  const GraphLevel& graph;
  /// kg a year by resource species and piece.
  const std::vector<std::vector<double>>& available;
};

/// State of the competition of one animal level: a ledger from which animals take, so that what is left plus what was taken is
/// always what was offered. It is kept by stock: the pieces of the partition that the same settlements reach, leaving out
/// settlements where no herd can live. All that happens to a stock happens to its pieces in proportion to what they offer.
class AnimalCompetition {
 public:
  /// Settlements of `also` (by settlement) get stocks of their own even where no herd could live, for animals that paint puts
  /// there.
  explicit AnimalCompetition(const CompetitionInput& input, std::span<const char> also = {});

  [[nodiscard]] std::span<const Settlement> settlements() const { return settlements_; }
  [[nodiscard]] std::span<const YearlyNeed> needs(int species_index) const { return needs_[std::size_t(species_index)]; }
  [[nodiscard]] int herd_min(int species_index) const { return herd_min_[std::size_t(species_index)]; }
  /// Settlement of a species in a region.
  [[nodiscard]] std::size_t settlement(int species_index, int region) const {
    return first_settlement_[std::size_t(species_index)] + std::size_t(region);
  }
  /// Settlements that eat from each stock.
  [[nodiscard]] std::span<const std::vector<std::size_t>> eaters_of_stock() const { return eaters_of_stock_; }
  /// Herds of the smallest size that settle at a time: 1, or more where a map holds so many that one by one would take long (our
  /// choice).
  [[nodiscard]] int herds_at_a_time() const { return herds_at_a_time_; }

  /// Takes over what happened in a ledger with fewer stocks.
  void adopt(const AnimalCompetition& coarser);
  /// What `animals` more would eat of what is left: within a need foods replace each other and are taken by preference and
  /// quantity; an incomplete meal takes all there is.
  [[nodiscard]] Meal plan_meal(std::size_t settlement, double animals);
  /// Takes a meal, from the region's stocks in proportion to what is left there.
  void eat(std::size_t settlement, double animals, const Meal& meal);
  /// Gives back the share (0..1) of what a settlement took, and of its animals.
  void give_back(std::size_t settlement, double share);

  /// How well one more smallest herd would live there, 0..1: the minimum over its needs of the share of what is left that it
  /// would leave (the part of the available interval above the herd's need: thesis eq. 5.4), and the share of the region's
  /// capacity that its own kind has not taken. The second is ours: a species crowds itself, as a plant does, so that the smallest
  /// eater does not take everything.
  [[nodiscard]] double fitness(std::size_t settlement);
  /// Settles so many animals; false, and nothing happens, when they cannot be fully fed.
  bool settle(std::size_t settlement, double animals);
  [[nodiscard]] bool can_feed(std::size_t settlement, double animals);

  /// kg per year eaten by resource species and piece.
  [[nodiscard]] std::vector<std::vector<double>> eaten() const;

 private:
  void find_settlements(const CompetitionInput& input);
  void find_capacities(const CompetitionInput& input);
  void find_stocks(const CompetitionInput& input, std::span<const char> also);
  void find_eaters();
  /// What is left in a settlement's stocks, brought up to date.
  Settlement& fresh(std::size_t settlement);
  void touch(const Settlement& settlement);

  const std::vector<std::vector<double>>* available_;
  std::vector<std::vector<YearlyNeed>> needs_;
  std::vector<int> herd_min_;
  std::vector<Settlement> settlements_;
  std::vector<std::size_t> first_settlement_;
  std::vector<std::int32_t> stock_of_piece_;
  /// Settlements of each stock's pieces.
  std::vector<std::vector<std::size_t>> eaters_of_stock_;
  /// kg per year by resource species and stock: offered, and left.
  std::vector<std::vector<double>> offered_;
  std::vector<std::vector<double>> left_;
  int herds_at_a_time_ = 1;
};

/// Competition without proportions: in turn, every stock gives a herd to the fittest species that it can still feed, until none
/// can be.
[[nodiscard]] Status settle_fittest(AnimalCompetition& competition, const TaskContext& context);

/// How a competition with proportions ended.
struct Proportions {
  /// The species (index in the level) whose lack of places held others back that could still have grown by half; -1 when none
  /// did.
  int held_back_by = -1;
};

/// Competition that keeps to desired shares of individuals (paper algorithm 1): the species whose herd brings the level closest
/// to the target (squared error over the shares) settles in its fittest region that can feed it. One that has no place for
/// another herd drops out but stays counted with what it has, and the others go on only as far as that is its share: up to the
/// total at which it would ask for a whole herd more. What came beyond would take the shares farther from the target ("only
/// retains the one among these attempts that brings the system the closest to the desired proportions"), so an implausible target
/// leaves a large surplus. A species that has no place at all asks for nothing: the target is that of the others.
[[nodiscard]] Result<Proportions> settle_in_proportion(AnimalCompetition& competition, std::span<const double> desired,
                                                       const TaskContext& context);

}  // namespace biotope

#pragma once

#include <map>
#include <memory>
#include <span>
#include <vector>

#include "core/movement/herd_boids.hpp"

namespace biotope {

/// One animal of a herd, where it is at an hour and what it does.
struct HerdAnimal {
  /// Metres east and north of the terrain's south-west corner.
  Place place;
  float heading = 0;    ///< radians clockwise from north
  float speed = 0;      ///< m/s
  float cycles = 0;     ///< strides, of which only the fraction means something; driven by the distance walked
  float head_down = 0;  ///< 0 up .. 1 mouth at the ground or water
  float lying = 0;      ///< 0 standing .. 1 lying
  float alarm = 0;      ///< 0 calm .. 1 a predator is within fright distance
  float size = 1;       ///< of the species' size; the young are smaller
  bool young = false;
  bool male = false;
};

/// A herd to place, and how much of its members' places comes from the simulation: 0 their guides alone (cheap, for herds far
/// away) .. 1 boids. Between, the places are mixed, so that nobody jumps as the eye comes nearer.
struct HerdRequest {
  int plan = 0;
  float boids = 1;
};

/// Farthest from its plan's place that a member of a herd is, m, about.
[[nodiscard]] double herd_reach(const HerdWorld& world, const DailyPlan& plan);

/// The individuals of herds at any hour of the day. Each herd is simulated from checkpoints a minute apart; what is shown is a
/// cross-fade of the run that began at the last checkpoint and the one before, so that there is no jump at a checkpoint and every
/// hour has one answer, the same to the bit in whichever order hours are asked for and for any number of threads. Keeps recent
/// runs, so that playing costs a step and scrubbing at most three minutes of simulation a herd. Last, animals of all herds are
/// moved apart, and out of trunks (settle): a function of the hour too, since all herds that could be in the way are placed as
/// well.
class HerdSimulation {
 public:
  explicit HerdSimulation(std::shared_ptr<const HerdWorld> world);
  ~HerdSimulation();
  HerdSimulation(HerdSimulation&&) noexcept;
  HerdSimulation& operator=(HerdSimulation&&) noexcept;

  /// Takes another world in place of the one it has. What is known of herds whose plan and surroundings are the same in both is
  /// kept, and no answer differs from that of a new simulation.
  void follow(std::shared_ptr<const HerdWorld> world);

  /// The animals of each requested herd, in order of the requests; a plan may be asked for once. Parallel over herds.
  [[nodiscard]] std::vector<std::vector<HerdAnimal>> animals(std::span<const HerdRequest> herds, double hour);
  [[nodiscard]] std::vector<HerdAnimal> animals(int plan, double hour);

  [[nodiscard]] const HerdWorld& world() const { return *world_; }
  /// Memory of the runs that are kept; never more than most_bytes after a call, except what the call itself needs.
  [[nodiscard]] std::size_t bytes() const;
  static constexpr std::size_t most_bytes = std::size_t(48) << 20;

 private:
  struct Slot;
  [[nodiscard]] std::shared_ptr<HerdCast> cast(int plan);
  void prepare(std::span<const HerdRequest> herds, double seconds);
  [[nodiscard]] std::vector<int> predators_near(int plan, double from, double until) const;
  BoidRun& run(Slot& slot, int checkpoint);
  [[nodiscard]] std::vector<HerdAnimal> by_formula(const Slot& slot, double seconds) const;
  [[nodiscard]] std::vector<HerdAnimal> simulated(Slot& slot, double seconds);
  [[nodiscard]] std::vector<HerdAnimal> placed(const HerdRequest& herd, double seconds);
  [[nodiscard]] std::vector<HerdRequest> with_neighbours(std::span<const HerdRequest> herds, double seconds) const;
  void settle_herds(std::span<const HerdRequest> herds, std::vector<std::vector<HerdAnimal>>& animals) const;
  void forget_old();
  [[nodiscard]] bool same_herd(const HerdCast& cast, const HerdWorld& before) const;
  void keep_runs(Slot& slot, const HerdWorld& before) const;

  std::shared_ptr<const HerdWorld> world_;
  std::vector<std::vector<int>> predators_;
  HerdStays stays_;
  std::vector<std::unique_ptr<Slot>> slots_;
  std::uint64_t uses_ = 0;
};

}  // namespace biotope

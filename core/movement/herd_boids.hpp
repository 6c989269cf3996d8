#pragma once

#include <memory>
#include <vector>

#include "core/movement/herd_guides.hpp"

namespace biotope {

/// Weights of the steering forces (Reynolds 1987; the weights are common choices for herds): what each wishes as a change of
/// velocity is multiplied by its weight, and the sum is limited.
struct BoidWeights {
  double separation = 1.5;
  double alignment = 1;
  double cohesion = 0.8;
  double path = 1.5;
  double obstacle = 3;
};

/// Strongest steering, m/s2; in flight animals do more (our choice).
inline constexpr double most_force = 2;
inline constexpr double most_flight_force = 5;
/// Closest that two members come, in body lengths.
inline constexpr double closest_members = 0.55;

/// Where a member is and how it moves at a moment of a run. Places are relative to the run's origin.
struct BoidState {
  float x = 0;
  float y = 0;
  float east = 0;  ///< heading, unit vector
  float north = 1;
  float angle = 0;   ///< of the heading, radians clockwise from north, going on beyond a full turn so that it never jumps
  float speed = 0;   ///< m/s along the heading
  float cycles = 0;  ///< strides since the run began
};

/// Seconds from a checkpoint to the next, and how long the run of a checkpoint lasts: it fades in over the first half, and out
/// over the second.
inline constexpr double checkpoint_seconds = 60;
inline constexpr double run_seconds = 2 * checkpoint_seconds;
inline constexpr int checkpoints_per_day = int(day_seconds / checkpoint_seconds);

/// Length of a stride (m) of legs of `hip` metres at a speed: 2.4 hip Fr^0.34 with the Froude number v2 / (g hip) (Alexander
/// 1976, by way of dynamic similarity).
[[nodiscard]] double stride_length(double hip, double speed);
/// Height of the hip joint above the ground of a shoulder height.
[[nodiscard]] constexpr double hip_height(double shoulder) { return 0.78 * shoulder; }

/// The individuals of a herd from a checkpoint on: they begin at their guides and are then simulated step by step. Everything is
/// a pure function of the herd and the checkpoint's number; later states are added when they are asked for.
class BoidRun {
 public:
  /// `predators` and `followed` as in HerdGuides; they are kept alive.
  BoidRun(std::shared_ptr<const HerdCast> cast, std::vector<std::shared_ptr<const HerdCast>> predators,
          std::vector<std::shared_ptr<const HerdCast>> followed, int checkpoint);

  /// States at `since` seconds after the checkpoint (0 .. run_seconds), between the steps by interpolation.
  void at(double since, std::vector<BoidState>& states);
  [[nodiscard]] Place origin() const { return origin_; }
  [[nodiscard]] std::size_t bytes() const {
    const std::size_t a_step = sizeof(std::vector<BoidState>) + sizeof(BoidState) * cast_->members.size();
    return sizeof(BoidRun) + guides_.bytes() + steps_.size() * a_step + 2 * sizeof(HerdGuide) * cast_->members.size();
  }
  [[nodiscard]] HerdGuides& guides() { return guides_; }
  /// Predators that were within sight when it was begun.
  [[nodiscard]] std::vector<int> predators() const;
  [[nodiscard]] double step() const { return step_; }

 private:
  struct Sight;
  /// What the neighbours of each member sum up to.
  struct Around {
    Place push;
    Place velocity;
    Place centre;
    int count = 0;
  };
  void advance();
  void neighbours(const std::vector<BoidState>& states);
  [[nodiscard]] Sight sight(std::size_t member, const BoidState& state) const;
  [[nodiscard]] Place steering(const Sight& sight, const Around& around) const;
  [[nodiscard]] Place avoidance(const Sight& sight) const;
  [[nodiscard]] BoidState moved(const Sight& sight, const Around& around, double size) const;

  std::shared_ptr<const HerdCast> cast_;
  std::vector<std::shared_ptr<const HerdCast>> predators_;
  std::vector<std::shared_ptr<const HerdCast>> followed_;
  double start_;
  HerdGuides guides_;
  double step_;
  Place origin_;
  std::vector<std::vector<BoidState>> steps_;
  std::vector<HerdGuide> guides_now_;
  std::vector<HerdGuide> guides_next_;
  std::vector<Around> around_;
  std::vector<std::uint32_t> order_;
};

/// Pushes members apart that are closer than closest_members, a few times, and keeps them on passable ground. Pure.
void push_apart(const HerdCast& cast, Place origin, std::vector<BoidState>& states, int times);

}  // namespace biotope

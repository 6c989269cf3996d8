#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "core/base/status.hpp"
#include "core/base/task_context.hpp"
#include "core/movement/plan_edits.hpp"
#include "core/movement/trails.hpp"

namespace biotope {

/// A stay at a resource node.
struct PlanStop {
  int node = 0;
  float arrive = 0;  ///< hours, 0..24 (may pass 24 for night-active species; taken modulo 24)
  float leave = 0;
};

/// A stretch of a predator's day in which it follows a herd, within sight (500 m) of it all the time.
struct HerdPursuit {
  float from = 0;  ///< hours; they may pass 24, like those of stops
  float until = 0;
  int plan = -1;  ///< index of the herd's plan among all plans
  bool operator==(const HerdPursuit&) const = default;
};

/// What a herd does in a day; a pure value.
struct DailyPlan {
  int level = 1;
  int herd = 0;     ///< index in the level's herds
  int species = 0;  ///< number in the food web
  int size = 0;     ///< individuals
  /// The herds this predator follows, one after another; empty for all others.
  std::vector<HerdPursuit> pursuits = {};
  std::vector<PlanStop> stops;
  /// Hours the species is active; outside them a herd that stands still rests. May pass 24, like the stops.
  struct Span {
    float from = 0;
    float until = 24;
  };
  std::vector<Span> active;
  /// Way of the whole day as timed points, hours ascending from the first stop, closed over 24 h.
  struct Waypoint {
    float hour = 0;
    PathPoint at;
  };
  std::vector<Waypoint> way;
  /// Whether a person planned it (PlanEdit). Then stops of the edit (by number) that the herd cannot reach, or for which the
  /// walks leave no time in a day, are left out; to others it comes earlier or later than it was asked to, since it walks no
  /// faster than it can.
  bool edited = false;
  std::vector<int> unreachable_stops = {};
  std::vector<int> shifted_stops = {};
};

enum class HerdActivity : std::uint8_t { resting, drinking, feeding, walking, hunting };

/// The stretch of its day in which a predator follows a herd at an hour (any real number; taken modulo 24); null when it follows
/// none then.
[[nodiscard]] const HerdPursuit* pursuit_at(const DailyPlan& plan, double hour);

/// Where a herd is.
struct HerdState {
  PathPoint at;       ///< cell coordinates
  float heading = 0;  ///< radians clockwise from north
  float speed = 0;    ///< m/s
  HerdActivity activity = HerdActivity::resting;
};

/// Herds that get a plan, at most; where a map holds more they are chosen evenly over species, and within a species by chance.
/// Our choice: more can neither be told apart on a map nor kept in little memory.
inline constexpr std::size_t most_plans = 1500;

/// Herds of each level that get a plan, ascending.
[[nodiscard]] std::vector<std::vector<int>> planned_herds(std::span<const std::shared_ptr<const AnimalLevel>> levels,
                                                          std::uint64_t seed, std::size_t most = most_plans);

/// Plans of herds (paper algorithm 3): mandatory resources first, capacities, stays from needs and quantities, active hours;
/// predators follow herds of levels below that they can reach (those that live on plants for more than half plan like grazers):
/// from their resting place they go from herd to herd while they are active, drawn by eq. 2 with the herd's place at that hour,
/// stay within sight (500 m) of each for a while, drink, rest between their active hours where they are, and come back. Who has
/// but one herd in its region keeps to it whenever it is active. One plan a herd, levels in order, for the herds of
/// planned_herds. All of a way lies in its herd's confinement region. A walk never is faster than the species walks on that slope
/// (predators that fell behind trot, half as fast again), and is on the trails (may be null) where one leads along. Deterministic
/// in `seed`; a herd's draws depend on its species, region and number there. Herds that graze call at each waypoint of their
/// region with the probability of its attraction, for a quarter to half an hour. Nobody walks through a forbidden corridor unless
/// there is no way around that is less than about 40 times as long. A herd that an edit names keeps to the edit's stops (it
/// always gets a plan, and follows nobody): it is at each from the asked hour on until it must go to be at the next in time. If a
/// walk takes longer than there is time, it comes late and all that follows is later until there is time again; it is back at its
/// first stop after a day, and what does not fit before is cut short. Of several edits of one herd the last counts.
[[nodiscard]] Result<std::vector<DailyPlan>> compute_daily_plans(const FoodWeb& web,
                                                                 std::span<const std::shared_ptr<const AnimalLevel>> levels,
                                                                 std::span<const LevelMovement> movement, const Ground& ground,
                                                                 std::uint64_t seed, const TaskContext& context = {},
                                                                 const TrailNetwork* trails = nullptr,
                                                                 std::span<const PlanEdit> edits = {});

/// A herd by its level (index) and its number in the level.
struct NamedHerd {
  std::size_t level = 0;
  int herd = 0;
  bool operator==(const NamedHerd&) const = default;
};
/// The herd that an edit names; nothing when there is no such herd (any more).
[[nodiscard]] std::optional<NamedHerd> find_planned_herd(const PlanEdit& edit, const FoodWeb& web,
                                                         std::span<const std::shared_ptr<const AnimalLevel>> levels);
/// The edit that asks for what a plan already does, to be changed by a person. Nothing when the plan belongs to other levels.
[[nodiscard]] std::optional<PlanEdit> edit_of_plan(const DailyPlan& plan, const FoodWeb& web,
                                                   std::span<const std::shared_ptr<const AnimalLevel>> levels);

/// Hours a species is active: diurnal 5-21, crepuscular 4-10 and 16-22, nocturnal 18-6, cathemeral 3-8, 10.5-16 and 18.5-24
/// (our choice).
[[nodiscard]] std::vector<DailyPlan::Span> active_hours(Activity activity);

/// State at an hour (any real number; taken modulo 24): a pure function of (plan, hour).
[[nodiscard]] HerdState herd_state(const DailyPlan& plan, const GraphLevel& graph, double hour, double cell_size);

}  // namespace biotope

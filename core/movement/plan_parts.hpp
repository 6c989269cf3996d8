#pragma once

#include <map>
#include <memory>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "core/movement/daily_plan.hpp"
#include "core/movement/fine_path.hpp"

namespace biotope {

class TravelSearch;

/// A planned stay: how long, and the hour before which the herd does not go on (it rests through the middle of the day).
struct PlannedStay {
  int node = 0;
  float hours = 0;
  float not_before = 0;
};

/// What a herd intends to do: stays from its home in the morning; it walks back there in the evening.
struct DayDraft {
  int species_index = 0;
  int herd = 0;
  std::vector<PlannedStay> stays;
};

/// A way between two nodes with the cost (metres of flat walking) up to each point.
struct NodeWay {
  std::vector<PathPoint> points;
  std::vector<double> cost;
};

/// A walk of a herd from one stop to the next.
struct CourseLeg {
  std::vector<PathPoint> points;
  std::vector<float> hours;
  int from_stop = 0;
  int to_stop = 0;
};

/// The walks of a herd's day, without what it does at its stops.
using HerdCourse = std::vector<CourseLeg>;

/// What planning a level reads.
struct PlanInput {
  const FoodWeb& web;
  const AnimalLevel& level;
  const LevelMovement& movement;
  const Ground& ground;
  /// See herd_keys.
  std::span<const std::uint64_t> keys;
  const PlacedGround& placed;
  const TrailNetwork* trails = nullptr;
};

/// What a herd's draws come from: a number that depends on the seed, its species, its region and how many such herds come before
/// it, so that herds elsewhere do not change its day.
[[nodiscard]] std::vector<std::uint64_t> herd_keys(const AnimalLevel& level, std::uint64_t seed);

/// Cell at or near a node where the mobility of `graph` can stand; nothing when there is none close by.
[[nodiscard]] std::optional<PathCell> standing_cell(const TravelGraph& graph, const ResourceNode& node);

/// Drafts of the days of a level's herds (paper algorithm 3), one after the other since each takes room at the nodes it visits.
/// `wanted` says for every herd whether to plan it. Times between nodes are those of the spatial edges.
[[nodiscard]] std::vector<DayDraft> draft_days(const PlanInput& input, std::span<const std::uint8_t> wanted);

/// The ground under the mobility of one travel graph of the level.
[[nodiscard]] FineGround fine_ground(const PlanInput& input, int graph);

/// Ways between nodes, each found once.
class NodeWays {
 public:
  explicit NodeWays(const PlanInput& input) : input_(input) {}

  /// Notes that a way is needed; all needs come before find().
  void need(int graph, int from, int to);
  /// Finds what is needed, in parallel.
  void find();
  /// Null when there is none.
  [[nodiscard]] const NodeWay* get(int graph, int from, int to) const;

 private:
  void find_from(int from, const FineGround& ground, int graph, TravelSearch& search, std::map<int, NodeWay>& found) const;

  PlanInput input_;
  /// By graph and node of departure: ways by node of arrival.
  std::map<std::pair<int, int>, std::map<int, NodeWay>> ways_;
};

/// Costs of a travel graph of the level by which ways are chosen: on worn ground where there are trails.
[[nodiscard]] std::span<const float> way_costs(const PlanInput& input, int graph);

/// The way over vertices of a travel graph (at least one) that a search by way_costs found, between passable cells of the first
/// and the last; empty when there is none.
[[nodiscard]] NodeWay way_over(const PlanInput& input, int graph, const FineGround& ground,
                               std::span<const std::uint32_t> vertices, PathCell from, PathCell to);

/// Way with costs between two passable cells of a travel graph of the level; empty when there is none.
[[nodiscard]] NodeWay way_between(const PlanInput& input, int graph, const FineGround& ground, PathCell from, PathCell to);

/// Turns a draft into a plan with a timed way, and its course. A draft whose ways do not exist or do not fit into a day stays at
/// home.
[[nodiscard]] std::pair<DailyPlan, HerdCourse> walk_day(const PlanInput& input, const DayDraft& draft, const NodeWays& ways);

/// What a herd does when its stops are known: the way of its day, and its course. Leg i goes from stop i to stop i + 1, the last
/// one back to the first stop, where the herd is at the same hour a day later; no legs for a herd that stays at one stop.
[[nodiscard]] std::pair<DailyPlan, HerdCourse> write_stops(const PlanInput& input, int herd, std::span<const PlanStop> stops,
                                                           std::span<const NodeWay* const> legs);

/// Days of herds that a person planned: herd and edit.
using PlannedEdits = std::vector<std::pair<int, const PlanEdit*>>;
[[nodiscard]] std::vector<std::pair<DailyPlan, HerdCourse>> edited_days(const PlanInput& input, const PlannedEdits& edits);

/// A herd that stands still all day in its region.
[[nodiscard]] DailyPlan stand_still(const PlanInput& input, int herd);

/// A herd to follow and what is needed of it.
struct FollowedHerd {
  int plan = -1;  ///< index among all plans
  const DailyPlan* day = nullptr;
  const HerdCourse* course = nullptr;
  const GraphLevel* graph = nullptr;  ///< nodes its stops name
  int prey_node = -1;                 ///< node of the predator's level that stands for its region
};

/// A predator's day behind one herd (it walks 100 to 300 m after it, nearer at water). Nothing when the herd goes where it cannot
/// follow, or would lose it from sight while it is active.
[[nodiscard]] std::optional<std::pair<DailyPlan, HerdCourse>> follow_herd(const PlanInput& input, int herd,
                                                                          const FollowedHerd& followed, const FineGround& ground);

/// Index of the herd's species in the level.
[[nodiscard]] int species_index_of(const AnimalLevel& level, const Herd& herd);

}  // namespace biotope

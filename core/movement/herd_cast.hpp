#pragma once

#include <memory>
#include <span>
#include <vector>

#include "core/movement/herd_stays.hpp"
#include "core/movement/herd_world.hpp"

namespace biotope {

/// What sets one animal of a herd apart from the others, all day long.
struct HerdMemberTraits {
  float size = 1;  ///< of the species' size
  bool young = false;
  bool male = false;
  /// Share of rest, 0..1, from which it begins to lie down; above 1 it rests standing.
  double lies_from = 2;
  double lead = 0;         ///< s that it walks ahead of the plan's place; negative behind
  double lane = 0;         ///< m to the right of the way while it walks in file
  double hop_period = 60;  ///< s from one spot to the next while it feeds
  double hop_phase = 0;    ///< s
};

/// Where the members of a herd are at one of its stops, absolute places; one entry a member.
struct StopLayout {
  Place centre;
  std::vector<Place> feeding;
  std::vector<Place> resting;
  /// At the water's edge; those that find no room wait behind.
  std::vector<Place> drinking;
  /// Unit vectors toward the water.
  std::vector<Place> toward_water;
  /// Radians from the herd's heading that each looks at rest, and about which each grazes.
  std::vector<double> resting_turn;
  std::vector<double> grazing_turn;
};

/// Cells a member may stand on: those of the herd's confinement region; all of them where regions are not known.
struct HerdRegion {
  std::shared_ptr<const RunMap> labels;
  std::int32_t label = -1;
  [[nodiscard]] bool holds(HerdWorld::Cell cell) const { return !labels || (*labels)(cell.x, cell.y) == label; }
};
[[nodiscard]] HerdRegion herd_region(const HerdWorld& world, const DailyPlan& plan);

/// Share of a herd that is younger than a year, by the surplus where it lives (young_share).
[[nodiscard]] double herd_young_share(const HerdWorld& world, const DailyPlan& plan);

/// Everything about a herd's individuals that does not change during the day. A pure function of (world, plan). Its world may be
/// replaced by one that is the same wherever this herd goes (HerdSimulation::follow).
struct HerdCast {
  std::shared_ptr<const HerdWorld> world;
  int plan_number = 0;
  std::uint64_t seed = 0;
  double body_length = 1.5;  ///< m
  double shoulder = 1;       ///< m
  double walk_speed = 1.4;   ///< m/s on flat ground
  double gallop_speed = 9;   ///< m/s
  double wade_depth = 0.5;   ///< m
  double young_share = 0;    ///< of the herd, on the mean
  HerdRegion region;
  std::vector<HerdMemberTraits> members;
  /// As many as the plan has stops; one at the way's first place when it has none.
  std::vector<StopLayout> stops;
  /// Herds that its stops were laid out beside, a stop after the other.
  std::vector<std::vector<HerdStay>> beside;
  /// Plans of herds that eat this one's species.
  std::vector<int> predators;

  [[nodiscard]] const DailyPlan& plan() const { return (*world->plans)[std::size_t(plan_number)]; }
  /// Whether a member may stand there: on the map and in the herd's region; where that is not known, in water no deeper than it
  /// wades.
  [[nodiscard]] bool passable(Place place) const;
  /// The place itself, or the last passable one on the straight way to it from `from`.
  [[nodiscard]] Place nearest_passable(Place from, Place place) const;
};

/// `stays`: those of all herds; null: a herd stands where its plan says, whoever else is there.
[[nodiscard]] HerdCast cast_herd(std::shared_ptr<const HerdWorld> world, int plan_number, std::vector<int> predators,
                                 const HerdStays* stays = nullptr);

/// Places of the members at a stop of their plan around `centre`, beside those herds that come there before them and clear of
/// trunks; at water they line up along it.
[[nodiscard]] StopLayout lay_out_stop(const HerdCast& cast, std::size_t stop, Place centre, bool at_water,
                                      std::span<const HerdStay> before);

}  // namespace biotope

#pragma once

#include <optional>
#include <span>
#include <utility>

#include "core/movement/plan_parts.hpp"
#include "core/movement/travel_search.hpp"

namespace biotope {

/// A herd that a pack may hunt.
struct PreyHerd {
  FollowedHerd herd;
  /// P_s(v) of the region the herd lives in (paper eq. 1: surplus there and share in the diet), by its share of the animals
  /// there.
  double probability = 0;
};

/// A pack with herds to choose from.
struct HuntingPack {
  int herd = 0;  ///< in the level
  std::span<const PreyHerd> prey;
  /// Its number among the packs of its species and region, and how many there are, at most two (our choice): each hunts its own
  /// share of the herds, so that neighbours keep apart.
  int number = 0;
  int neighbours = 1;
};

/// What a pack does next: visit a herd or drink at a bank. Hours may pass 24.
struct HuntStep {
  int prey = -1;         ///< number among the pack's prey herds; -1: it drinks
  int bank = -1;         ///< node where it drinks
  std::size_t span = 0;  ///< of its active hours
  double arrive = 0;     ///< as far as the coarse graph tells
  double leave = 0;
};

/// What choosing and walking a pack's day share.
struct HuntGround {
  HuntGround(const PlanInput& plan_input, const HuntingPack& hunting_pack);

  /// Vertex of the pack's region; -1 elsewhere.
  [[nodiscard]] int vertex_at(PathPoint at) const;
  [[nodiscard]] bool wet(PathPoint at) const;

  const PlanInput& input;
  HuntingPack pack;
  const Herd& herd;
  const AnimalTraits& animal;
  int number = 0;  ///< of the travel graph
  const TravelGraph& graph;
  FineGround ground;
  /// Where it was last looked from, by way_costs.
  TravelSearch search;
  int searched_from = -1;
};

/// Where a herd is at an hour (any; taken modulo 24).
[[nodiscard]] PathPoint place_on_way(const DailyPlan& plan, double hour);

/// The day of a pack that has several herds to choose from (paper algorithm 3, section 6.2): from a resting place to herd after
/// herd by P_s(v' | v) (eq. 2), v' being where the herd is at that hour, none twice before all have been visited. Nothing where
/// it could visit none, or would not be back after a day.
[[nodiscard]] std::optional<std::pair<DailyPlan, HerdCourse>> hunting_day(const PlanInput& input, const HuntingPack& pack);

}  // namespace biotope

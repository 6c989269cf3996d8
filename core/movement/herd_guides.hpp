#pragma once

#include <vector>

#include "core/movement/herd_cast.hpp"
#include "core/movement/herd_track.hpp"

namespace biotope {

/// Where one member of a herd would be if nobody was in its way, and what it does there: a moving goal in the frame of its herd
/// (thesis section 4.3.2), which the member then steers to.
struct HerdGuide {
  Place at;
  Place facing{0, 1};    ///< unit vector, where it looks while it stands
  double march = 0;      ///< 0 standing about .. 1 walking in file
  double head_down = 0;  ///< 0 up .. 1 mouth at the ground or water
  double lying = 0;      ///< 0 standing .. 1 lying
  /// 0 calm; 1 a predator is within fright distance; and how fast it has to go for it, 0 walk .. 1 gallop.
  double alarm = 0;
  double haste = 0;
};

/// Distances (m) within which a predator makes a herd flee, and look up. Our choice; flight distances of hoofed game from wolves
/// lie between some ten and a hundred metres.
inline constexpr double fright_distance = 55;
inline constexpr double alert_distance = 110;

/// How far a herd of predators has come from its plan's place toward the herd it follows then, 0..1: now and then, while it
/// hunts, it stalks up to the herd, chases it for some seconds and falls back.
[[nodiscard]] double rush_share(const HerdCast& predators, const HerdMoment& moment, double seconds);

/// Plans of the herds that a predator follows at any time of a stretch (seconds; a plan goes on from day to day), ascending.
[[nodiscard]] std::vector<int> followed_between(const DailyPlan& plan, double from, double until);

/// A predator pack that a herd can notice.
struct HerdThreat {
  Place at;
  double rush = 0;
};

/// Resting members stay where they are; walking ones graze, drink or walk; running ones flee or chase.
enum class HerdPace : std::uint8_t { resting, walking, running };

/// What the guides of a herd are computed from, over a stretch of time. Keep `cast` alive.
class HerdGuides {
 public:
  /// `predators`: those within sight at any time of the stretch; `followed`: the herds that this one follows in it
  /// (followed_between); none null.
  HerdGuides(const HerdCast& cast, std::vector<const HerdCast*> predators, std::vector<const HerdCast*> followed, double from,
             double until, double step);

  /// One guide a member.
  void at(double seconds, std::vector<HerdGuide>& guides);
  [[nodiscard]] HerdMoment moment(double seconds) const { return track_.at(seconds); }
  /// The fastest that anybody of the herd goes in a stretch of time.
  [[nodiscard]] HerdPace pace(double from, double until) const;
  /// Memory it holds besides itself.
  [[nodiscard]] std::size_t bytes() const;

 private:
  struct Situation;
  /// What is drawn by chance for a member's steps between two bites.
  struct Hop {
    std::int64_t number = -1;
    Place here;
    Place there;
    bool looks_up = false;
    double turn = 0;
    double next_turn = 0;
  };
  [[nodiscard]] const Hop& hop(std::size_t member, std::int64_t number);
  [[nodiscard]] HerdGuide guide(std::size_t member, double seconds, const Situation& situation);
  [[nodiscard]] Place offset(std::size_t member, const HerdMoment& moment, Place nibble) const;
  [[nodiscard]] Place facing(std::size_t member, const HerdMoment& moment, double turned, Place at,
                             const Situation& situation) const;
  void flee(const Situation& situation, Place path, HerdGuide& guide) const;

  const HerdCast& cast_;
  HerdTrack track_;
  std::vector<const HerdCast*> predators_;
  std::vector<HerdTrack> predator_tracks_;
  std::vector<const HerdCast*> followed_;
  std::vector<HerdTrack> followed_tracks_;
  /// The last hop of each member, to be drawn but once.
  std::vector<Hop> hops_;
};

}  // namespace biotope

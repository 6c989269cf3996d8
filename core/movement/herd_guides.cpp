#include "core/movement/herd_guides.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/base/random.hpp"

namespace biotope {

namespace {

/// A pack that hunts rushes at its herd at most every so many seconds (a day is 12 times that), by chance only in some; it stalks
/// up, keeps up the chase, and falls back for so long. Our choices.
constexpr double rush_period = 7200;
constexpr double rush_likely = 0.6;
constexpr double stalk_seconds = 60;
constexpr double stalk_share = 0.35;
constexpr double sprint_seconds = 9;
constexpr double chase_seconds = 9;
constexpr double return_seconds = 150;
/// How near the middle of a pack comes to the edge of the herd, m.
constexpr double nearest_rush = 14;

double turns(double value) { return value * 2 * std::numbers::pi; }

std::vector<HerdTrack> tracks_of(const std::vector<const HerdCast*>& casts, double from, double until, double step) {
  std::vector<HerdTrack> tracks;
  for (const HerdCast* cast : casts) tracks.emplace_back(*cast, from, until, step);
  return tracks;
}

/// A pack turns to a herd, and from it, within so many seconds. Our choice.
constexpr double turning_seconds = 120;

/// How much a pack has turned to the herd it follows: 0 when it comes to it or goes on, so that it may then turn to another.
double attention(const DailyPlan& plan, double seconds) {
  const HerdPursuit* pursuit = pursuit_at(plan, seconds / 3600);
  if (pursuit == nullptr) return 0;
  const double length = (double(pursuit->until) - double(pursuit->from)) * 3600;
  const double since = seconds - double(pursuit->from) * 3600;
  const double in_stretch = since - day_seconds * std::floor(since / day_seconds);
  return smooth_step(0, turning_seconds, in_stretch) * smooth_step(0, turning_seconds, length - in_stretch);
}

int followed_at(const DailyPlan& plan, double seconds) {
  const HerdPursuit* pursuit = pursuit_at(plan, seconds / 3600);
  return pursuit == nullptr ? -1 : pursuit->plan;
}

/// Metres ahead along the straight line to the followed herd that a rush at its height comes.
Place rush_way(const HerdCast& predators, const HerdCast& followed, Place from, Place herd) {
  const Place way = herd - from;
  const double reach =
      std::max(0.0, length(way) - herd_radius(followed.body_length, int(followed.members.size())) - nearest_rush);
  const Place goal = from + unit_of(way) * reach;
  return predators.nearest_passable(from, goal) - from;
}

/// Longest stretch by which members walk ahead of or behind the plan's place, s.
double longest_lead(const HerdCast& cast) {
  double longest = 0;
  for (const HerdMemberTraits& member : cast.members) longest = std::max(longest, std::abs(member.lead));
  return longest;
}

}  // namespace

double rush_share(const HerdCast& predators, const HerdMoment& moment, double seconds) {
  if (predators.plan().pursuits.empty()) return 0;
  const double phase = rush_period * random_unit({predators.seed, 0x4a5e});
  const double shifted = seconds + phase - day_seconds * std::floor((seconds + phase) / day_seconds);
  const auto number = std::uint64_t(shifted / rush_period);
  if (random_unit({predators.seed, 0x4a5f, number}) > rush_likely) return 0;
  const double since = shifted - double(number) * rush_period;
  constexpr double caught_up = stalk_seconds + sprint_seconds;
  const double begin =
      stalk_share * smooth_step(0, stalk_seconds, since) + (1 - stalk_share) * smooth_step(stalk_seconds, caught_up, since);
  const double end = smooth_step(caught_up + chase_seconds, caught_up + chase_seconds + return_seconds, since);
  if (begin <= end) return 0;
  return (begin - end) * moment.hunting * (1 - moment.march) * attention(predators.plan(), seconds);
}

std::vector<int> followed_between(const DailyPlan& plan, double from, double until) {
  std::vector<int> plans;
  for (const HerdPursuit& pursuit : plan.pursuits) {
    const double begin = double(pursuit.from) * 3600;
    const double end = double(pursuit.until) * 3600;
    const auto after = [](double seconds) { return seconds - day_seconds * std::floor(seconds / day_seconds); };
    if (after(from - begin) <= end - begin || after(begin - from) <= until - from) plans.push_back(pursuit.plan);
  }
  std::sort(plans.begin(), plans.end());
  plans.erase(std::unique(plans.begin(), plans.end()), plans.end());
  return plans;
}

HerdGuides::HerdGuides(const HerdCast& cast, std::vector<const HerdCast*> predators, std::vector<const HerdCast*> followed,
                       double from, double until, double step)
    : cast_(cast),
      track_(cast, from - longest_lead(cast) - step, until + longest_lead(cast) + step, step),
      predators_(std::move(predators)),
      predator_tracks_(tracks_of(predators_, from, until, step)),
      followed_(std::move(followed)),
      followed_tracks_(tracks_of(followed_, from, until, step)) {
  hops_.resize(cast_.members.size());
}

/// What all members see at a moment.
struct HerdGuides::Situation {
  HerdMoment herd;
  std::vector<HerdThreat> threats;
  double rush = 0;
  Place rush_offset;
  /// Middle of the herd that is followed, and how much the pack has turned to it.
  Place quarry;
  double attention = 0;
};

const HerdGuides::Hop& HerdGuides::hop(std::size_t member, std::int64_t number) {
  Hop& hop = hops_[member];
  if (hop.number == number) return hop;
  const std::int64_t a_day = std::llround(day_seconds / cast_.members[member].hop_period);
  const auto unit = [&](std::int64_t n, std::uint64_t what) {
    return random_unit({cast_.seed, member, std::uint64_t(((n % a_day) + a_day) % a_day), what});
  };
  const auto bite = [&](std::int64_t n) {
    const double angle = turns(unit(n, 21));
    return Place{std::cos(angle), std::sin(angle)} * (cast_.body_length * (0.35 + 0.75 * unit(n, 22)));
  };
  const auto turn = [&](std::int64_t n) { return turns((unit(n, 25) - 0.5) * 0.5); };
  hop = {number, bite(number), bite(number + 1), unit(number, 23) < 0.3, turn(number), turn(number + 1)};
  return hop;
}

void HerdGuides::at(double seconds, std::vector<HerdGuide>& guides) {
  Situation situation;
  situation.herd = track_.at(seconds);
  const int followed = followed_at(cast_.plan(), seconds);
  for (std::size_t i = 0; i < followed_.size(); ++i) {
    if (followed_[i]->plan_number != followed) continue;
    situation.quarry = followed_tracks_[i].at(seconds).at;
    situation.attention = attention(cast_.plan(), seconds);
    situation.rush = rush_share(cast_, situation.herd, seconds);
    if (situation.rush > 0)
      situation.rush_offset = rush_way(cast_, *followed_[i], situation.herd.at, situation.quarry) * situation.rush;
  }
  for (std::size_t i = 0; i < predators_.size(); ++i) {
    const HerdCast& pack = *predators_[i];
    const HerdMoment moment = predator_tracks_[i].at(seconds);
    HerdThreat threat{moment.at, 0};
    if (followed_at(pack.plan(), seconds) == cast_.plan_number) {
      threat.rush = rush_share(pack, moment, seconds);
      if (threat.rush > 0) threat.at = threat.at + rush_way(pack, cast_, moment.at, situation.herd.at) * threat.rush;
    }
    situation.threats.push_back(threat);
  }
  guides.clear();
  for (std::size_t i = 0; i < cast_.members.size(); ++i) guides.push_back(guide(i, seconds, situation));
}

/// Where a member is beside its herd's place while the herd stands.
Place HerdGuides::offset(std::size_t member, const HerdMoment& moment, Place nibble) const {
  const auto spot = [&](std::size_t stop) {
    const StopLayout& layout = cast_.stops[stop];
    const double eats = moment.feeding;
    const double drinks = moment.drinking;
    const double rests = std::max(0.0, 1 - eats - drinks);
    // A herd that grazes moves on with its plan; the water's edge stays where it is.
    return (layout.feeding[member] + nibble - layout.centre) * eats + (layout.drinking[member] - moment.at) * drinks +
           (layout.resting[member] - layout.centre + moment.rests_at - moment.at) * rests;
  };
  const Place here = spot(moment.stop);
  return moment.between > 0 ? here + (spot(moment.next_stop) - here) * moment.between : here;
}

/// Where a member looks that stands at a place; `turned`: from the herd's heading while it grazes, radians.
Place HerdGuides::facing(std::size_t member, const HerdMoment& moment, double turned, Place at,
                         const Situation& situation) const {
  const StopLayout& stop = cast_.stops[moment.stop];
  const double turn = (turned + stop.grazing_turn[member]) * moment.feeding + stop.resting_turn[member] * (1 - moment.feeding);
  Place facing{moment.ahead.x * std::cos(turn) + moment.ahead.y * std::sin(turn),
               moment.ahead.y * std::cos(turn) - moment.ahead.x * std::sin(turn)};
  facing = facing * (1 - moment.drinking) + stop.toward_water[member] * (2 * moment.drinking);
  const double hunting = moment.hunting * situation.attention;
  if (hunting > 0) facing = facing * (1 - 0.8 * hunting) + unit_of(situation.quarry - at) * hunting;
  return unit_of(facing * (1 - moment.march) + moment.ahead * moment.march, moment.ahead);
}

HerdGuide HerdGuides::guide(std::size_t member, double seconds, const Situation& situation) {
  const HerdMemberTraits& traits = cast_.members[member];
  const HerdMoment moment = track_.at(seconds + traits.lead);
  HerdGuide guide;
  guide.march = moment.march;

  // Feeding, a member goes from bite to bite around its own spot, a few steps at a time, with the head up now and then.
  const double hops = (seconds + traits.hop_phase) / traits.hop_period;
  const double in_hop = hops - std::floor(hops);
  const Hop& drawn = hop(member, std::int64_t(std::floor(hops)));
  const double steps = smooth_step(0.62, 1.0, in_hop);
  const Place nibble = drawn.here + (drawn.there - drawn.here) * steps;
  const Place aside{moment.ahead.y, -moment.ahead.x};
  guide.at = moment.at + offset(member, moment, nibble) * (1 - moment.march) + aside * (traits.lane * moment.march);

  const double calm = 1 - moment.march;
  const double vigilance = drawn.looks_up ? smooth_step(0.1, 0.16, in_hop) * (1 - smooth_step(0.3, 0.36, in_hop)) : 0.0;
  const double sips = smooth_step(0.12, 0.2, in_hop) * (1 - smooth_step(0.8, 0.88, in_hop));
  guide.head_down = calm * (moment.feeding * (1 - vigilance) + moment.drinking * sips);
  guide.lying = traits.lies_from < 1 ? calm * smooth_step(traits.lies_from, traits.lies_from + 0.2, moment.resting) : 0.0;
  guide.facing = facing(member, moment, drawn.turn + (drawn.next_turn - drawn.turn) * steps, guide.at, situation);

  if (situation.rush > 0) {
    guide.at = guide.at + situation.rush_offset;
    guide.haste = smooth_step(0.3, 0.6, situation.rush);
    guide.facing = unit_of(situation.quarry - guide.at, guide.facing);
    guide.lying *= 1 - smooth_step(0, 0.05, situation.rush);
    guide.head_down *= 1 - situation.rush;
  }
  flee(situation, moment.at, guide);
  guide.at = cast_.nearest_passable(moment.at, guide.at);
  return guide;
}

void HerdGuides::flee(const Situation& situation, Place path, HerdGuide& guide) const {
  for (const HerdThreat& threat : situation.threats) {
    const Place away = guide.at - threat.at;
    const double distance = length(away);
    // One that only lies near is let come closer than one that comes.
    const double coming = 0.45 + 0.55 * threat.rush;
    const double fear = 1 - smooth_step(fright_distance * coming, alert_distance * coming, distance);
    if (fear <= 0) continue;
    const double rush = 0.25 + 0.75 * threat.rush;
    guide.alarm = std::max(guide.alarm, fear);
    // A predator that only lies near is kept in sight; one that comes is run from.
    const double push = rush * std::max(0.0, fright_distance * coming - distance) * 0.8;
    if (push > 0) {
      guide.at = guide.at + unit_of(away, unit_of(guide.at - path)) * push;
      guide.haste = std::max(guide.haste, smooth_step(0.3, 0.6, threat.rush));
      guide.facing = unit_of(guide.facing * (1 - threat.rush) + unit_of(away) * threat.rush, guide.facing);
    } else {
      guide.facing = unit_of(guide.facing * (1 - 0.9 * fear) - unit_of(away) * (0.9 * fear), guide.facing);
    }
    guide.head_down *= 1 - 0.95 * fear;
    guide.lying *= 1 - smooth_step(0.05, 0.4, fear * rush);
  }
}

HerdPace HerdGuides::pace(double from, double until) const {
  HerdPace pace = HerdPace::resting;
  const double reach = longest_lead(cast_);
  for (double seconds = from; seconds <= until; seconds += 10) {
    for (const double lead : {-reach, 0.0, reach}) {
      const HerdMoment moment = track_.at(seconds + lead);
      if (moment.march > 0.001 || moment.resting < 0.999) pace = HerdPace::walking;
    }
    if (rush_share(cast_, track_.at(seconds), seconds) > 0) return HerdPace::running;
    for (std::size_t i = 0; i < predators_.size(); ++i) {
      const HerdMoment moment = predator_tracks_[i].at(seconds);
      if (followed_at(predators_[i]->plan(), seconds) == cast_.plan_number && rush_share(*predators_[i], moment, seconds) > 0)
        return HerdPace::running;
      if (length(moment.at - track_.at(seconds).at) < 2 * alert_distance) pace = HerdPace::walking;
    }
  }
  return pace;
}

std::size_t HerdGuides::bytes() const {
  std::size_t sum =
      track_.bytes() + hops_.capacity() * sizeof(Hop) + (predators_.capacity() + followed_.capacity()) * sizeof(HerdCast*);
  for (const auto* tracks : {&predator_tracks_, &followed_tracks_}) {
    for (const HerdTrack& track : *tracks) sum += sizeof(HerdTrack) + track.bytes();
  }
  return sum;
}

}  // namespace biotope

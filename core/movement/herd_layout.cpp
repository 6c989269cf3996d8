#include <algorithm>
#include <array>
#include <numbers>

#include "core/base/random.hpp"
#include "core/movement/herd_cast.hpp"

namespace biotope {

namespace {

/// How far from the plan's place members go to drink, m: farther only where they would stand in too many rows, drinking in turns.
/// Our choice; a bank's place may lie that far from the water's edge.
struct BankReach {
  double metres;
  double step;            ///< between the places tried
  std::size_t most_rows;  ///< that may wait
};
constexpr std::array<BankReach, 3> bank_reaches{{{40, 1.5, 4}, {90, 2.5, 8}, {160, 4, 8}}};

/// Farthest that a herd stands from its plan's place because others are there, m. Our choice.
constexpr double most_beside = 45;

/// Turn from one place of a sunflower's head to the next: 137.5 degrees.
constexpr double golden_angle = 2.39996322972865332;

struct Spiral {
  Place centre;
  double reach;    ///< m of the first ring
  double stretch;  ///< along `axis`; shrunk across by as much
  double axis;     ///< radians
  double start;

  /// Places that are about 1.7 times `reach` apart, the n-th farther out than the one before.
  [[nodiscard]] Place at(int n) const {
    const double radius = reach * std::sqrt(double(n) + 0.4);
    const double angle = start + golden_angle * double(n);
    const double along = radius * std::cos(angle) * stretch;
    const double across = radius * std::sin(angle) / stretch;
    return centre + Place{along * std::cos(axis) - across * std::sin(axis), along * std::sin(axis) + across * std::cos(axis)};
  }
};

/// Whether a trunk stands where an animal would, whichever way it turned.
bool among_trunks(const HerdCast& cast, Place place) {
  if (!cast.world->details) return false;
  constexpr double widest_trunk = 1.5;
  const double room = 0.36 * cast.body_length;
  const Place corner{room + widest_trunk, room + widest_trunk};
  std::vector<Stem> stems;
  cast.world->details->stems(place - corner, place + corner, stems);
  return std::any_of(stems.begin(), stems.end(), [&](const Stem& stem) { return length(stem.at - place) < room + stem.radius; });
}

/// One place a member: the next of the spiral that is dry, passable and clear of trunks. Where a herd stands in a narrow place,
/// those that find none stand in the middle and make room themselves.
std::vector<Place> scatter(const HerdCast& cast, const Spiral& spiral, double jitter, std::uint64_t what) {
  std::vector<Place> places;
  const std::size_t count = cast.members.size();
  const int most = int(6 * count) + 12;
  const auto unit = [&](int n, std::uint64_t axis) { return random_unit({cast.seed, what, std::uint64_t(n), axis}) - 0.5; };
  for (int n = 0; n < most && places.size() < count; ++n) {
    const Place place = spiral.at(n) + Place{unit(n, 1), unit(n, 2)} * jitter;
    if (!cast.passable(place) || cast.world->shore_at(place) > -0.3F || among_trunks(cast, place)) continue;
    places.push_back(place);
  }
  while (places.size() < count) places.push_back(cast.nearest_passable(spiral.centre, spiral.at(int(places.size()))));
  return places;
}

/// Direction in which the water is, from the nearest wet place around; nothing without water.
bool water_direction(const HerdWorld& world, Place from, double reach, Place& direction) {
  for (double radius = 0.5; radius <= reach; radius += 0.5) {
    constexpr int rays = 24;
    Place sum{};
    for (int ray = 0; ray < rays; ++ray) {
      const double angle = 2 * std::numbers::pi * ray / rays;
      const Place aim{std::cos(angle), std::sin(angle)};
      if (world.shore_at(from + aim * radius) > 0) sum = sum + aim;
    }
    if (length(sum) > 1e-6) {
      direction = unit_of(sum);
      return true;
    }
  }
  return false;
}

/// Dry passable places whose forefeet are at the water's edge, nearest to the centre first.
struct BankPlace {
  Place place;
  Place toward;
  Place edge;
};
std::vector<BankPlace> bank_places(const HerdCast& cast, Place centre, const BankReach& within) {
  std::vector<std::pair<double, BankPlace>> found;
  const double stand_off = 0.50 * cast.body_length;
  const int reach = int(within.metres / within.step);
  for (int j = -reach; j <= reach; ++j) {
    for (int i = -reach; i <= reach; ++i) {
      const Place edge = centre + Place{i * within.step, j * within.step};
      const double away = length(edge - centre);
      if (away > within.metres || cast.world->shore_at(edge) <= 0) continue;
      // The edge of the water: wet itself, with a dry neighbour to the side of the herd.
      for (int side = 0; side < 4; ++side) {
        const Place out = side == 0 ? Place{1, 0} : side == 1 ? Place{-1, 0} : side == 2 ? Place{0, 1} : Place{0, -1};
        Place dry = edge + out * within.step;
        if (cast.world->shore_at(dry) > 0) continue;
        Place wet = edge;
        for (int k = 0; k < 6; ++k) {
          const Place middle = (dry + wet) * 0.5;
          (cast.world->shore_at(middle) > 0 ? wet : dry) = middle;
        }
        Place toward = out * -1.0;
        water_direction(*cast.world, dry, 2.0, toward);
        const Place stand = dry - toward * stand_off;
        if (cast.passable(stand) && cast.passable(dry) && cast.world->shore_at(stand) < 0)
          found.push_back({length(stand - centre), {stand, toward, dry}});
      }
    }
  }
  std::stable_sort(found.begin(), found.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
  std::vector<BankPlace> places;
  for (const auto& [distance, place] : found) places.push_back(place);
  return places;
}

/// The nearest free places of a herd along one stretch of bank.
std::vector<BankPlace> choose_bank_places(std::span<const BankPlace> candidates, double body_length, int members,
                                          std::span<const std::pair<Place, double>> taken) {
  const double apart = 0.85 * body_length;
  std::vector<BankPlace> chosen;
  for (const BankPlace& candidate : candidates) {
    if (int(chosen.size()) >= members) break;
    // All of a herd drink at one stretch of bank.
    if (!chosen.empty() && length(candidate.place - chosen.front().place) > 0.6 * body_length * double(members) + 10) continue;
    const bool free = std::none_of(chosen.begin(), chosen.end(),
                                   [&](const BankPlace& other) { return length(other.place - candidate.place) < apart; }) &&
                      std::none_of(taken.begin(), taken.end(), [&](const std::pair<Place, double>& other) {
                        return length(other.first - candidate.edge) < 0.5 * (other.second + apart);
                      });
    if (free) chosen.push_back(candidate);
  }
  return chosen;
}

/// Herds that come to the same bank at the same time leave each other room: each takes what those before it left.
std::vector<BankPlace> choose_bank_places(const HerdCast& cast, Place centre, std::span<const HerdStay> before) {
  std::vector<BankPlace> chosen;
  for (const BankReach& reach : bank_reaches) {
    std::vector<BankPlace> candidates = bank_places(cast, centre, reach);
    std::vector<std::pair<Place, double>> taken;
    for (const HerdStay& other : before) {
      for (const BankPlace& place : choose_bank_places(candidates, other.body_length, other.members, taken))
        taken.emplace_back(place.edge, 0.85 * other.body_length);
    }
    std::erase_if(candidates, [&](const BankPlace& place) { return among_trunks(cast, place.place); });
    chosen = choose_bank_places(candidates, cast.body_length, int(cast.members.size()), taken);
    if (reach.most_rows * chosen.size() >= cast.members.size()) break;
  }
  return chosen;
}

void line_up_at_water(const HerdCast& cast, std::span<const HerdStay> before, StopLayout& layout) {
  const std::vector<BankPlace> chosen = choose_bank_places(cast, layout.centre, before);
  for (std::size_t i = 0; i < cast.members.size(); ++i) {
    if (chosen.empty()) {
      layout.drinking.push_back(layout.feeding[i]);
      layout.toward_water.push_back({0, 1});
      continue;
    }
    // Those that find no room wait behind, row after row.
    const BankPlace& place = chosen[i % chosen.size()];
    const double row = double(i / chosen.size());
    const Place shift = Place{random_unit({cast.seed, 0xba11, i, 1}) - 0.5, random_unit({cast.seed, 0xba11, i, 2}) - 0.5} *
                        (row > 0 ? 1.2 * cast.body_length : 0.0);
    layout.drinking.push_back(
        cast.nearest_passable(place.place, place.place - place.toward * (1.5 * cast.body_length * row) + shift));
    layout.toward_water.push_back(place.toward);
  }
}

/// Where a herd stands that finds others at its place: beside them, each by so much as the room is that they take.
Place beside_others(const HerdCast& cast, Place centre, std::span<const HerdStay> before) {
  if (before.empty()) return centre;
  double taken = 0;
  for (const HerdStay& other : before) {
    const double radius = herd_radius(other.body_length, other.members);
    taken += radius * radius;
  }
  const double away = std::min(most_beside, std::sqrt(taken) + herd_radius(cast.body_length, int(cast.members.size())));
  const double angle = golden_angle * double(before.size());
  // The first way on which there is room.
  for (int turn = 0; turn < 6; ++turn) {
    const double toward = angle + turn * std::numbers::pi / 3;
    const Place place = centre + Place{std::cos(toward), std::sin(toward)} * away;
    if (cast.passable(place) && cast.world->shore_at(place) < -0.3F) return place;
  }
  return centre;
}

}  // namespace

StopLayout lay_out_stop(const HerdCast& cast, std::size_t stop, Place centre, bool at_water, std::span<const HerdStay> before) {
  const auto unit = [&](std::uint64_t what) { return random_unit({cast.seed, 0x57a4, stop, what}); };
  StopLayout layout;
  layout.centre = centre;
  const double turn = 2 * std::numbers::pi;
  const Place middle = beside_others(cast, centre, before);
  const Spiral feeding{middle, 1.3 * cast.body_length, 1.15 + 0.25 * unit(1), turn * unit(2), turn * unit(3)};
  layout.feeding = scatter(cast, feeding, 0.8 * cast.body_length, 2 * stop);
  const Spiral resting{middle, 1.05 * cast.body_length, 1.05 + 0.2 * unit(4), turn * unit(5), turn * unit(6)};
  layout.resting = scatter(cast, resting, 0.45 * cast.body_length, 2 * stop + 1);
  for (std::size_t i = 0; i < cast.members.size(); ++i) {
    layout.resting_turn.push_back(turn * 0.8 * (random_unit({cast.seed, 0x57a5, stop, i}) - 0.5));
    layout.grazing_turn.push_back(turn * 0.1 * (random_unit({cast.seed, 0x57a6, stop, i}) - 0.5));
  }
  if (at_water) {
    line_up_at_water(cast, before, layout);
  } else {
    layout.drinking = layout.feeding;
    layout.toward_water.assign(cast.members.size(), Place{0, 1});
  }
  return layout;
}

}  // namespace biotope

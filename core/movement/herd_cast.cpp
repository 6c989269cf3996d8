#include "core/movement/herd_cast.hpp"

#include <algorithm>

#include "core/base/random.hpp"
#include "core/ecosystem/herd_surplus.hpp"

namespace biotope {

namespace {

/// Animals side by side while they walk: one more for so many members. Our choice.
constexpr int members_per_lane = 40;
/// Distance from one to the next in file, in body lengths. Our choice.
constexpr double file_spacing = 1.35;

/// Share of grown animals that are male; one in four in herds, as where stags keep apart most of the year. Our choice.
double male_share(int size) { return size >= 5 ? 0.25 : 0.5; }

HerdMemberTraits member_traits(const HerdCast& cast, int number, int count) {
  const auto unit = [&](std::uint64_t what) { return random_unit({cast.seed, std::uint64_t(number), what}); };
  HerdMemberTraits member;
  // Nobody walks alone that is not grown; the leader is grown too.
  member.young = number > 0 && unit(1) < cast.young_share;
  member.male = !member.young && unit(2) < male_share(count);
  member.size = float((0.92 + 0.1 * unit(3)) * (member.young ? 0.52 + 0.16 * unit(4) : 1.0) * (member.male ? 1.06 : 1.0));
  if (unit(5) < 0.72) member.lies_from = 0.3 + 0.45 * unit(10);
  const int lanes = 1 + count / members_per_lane;
  const int files = (count + lanes - 1) / lanes;
  const double spacing = file_spacing * cast.body_length / cast.walk_speed;
  member.lead = (0.5 * (files - 1) - number / lanes + 0.35 * (unit(6) - 0.5)) * spacing;
  member.lane = (number % lanes - 0.5 * (lanes - 1)) * 0.95 * cast.body_length + (unit(7) - 0.5) * 0.2 * cast.body_length;
  // Whole numbers of hops in a day, so that a day ends as it began.
  member.hop_period = day_seconds / double(1100 + int(900 * unit(8)));
  member.hop_phase = member.hop_period * unit(9);
  return member;
}

}  // namespace

double herd_young_share(const HerdWorld& world, const DailyPlan& plan) {
  HerdSurplus surplus;
  const std::size_t level = std::size_t(plan.level) - 1;
  if (level < world.levels.size() && world.levels[level] && std::size_t(plan.herd) < world.levels[level]->herds.size()) {
    const AnimalLevel& animals = *world.levels[level];
    const Herd& herd = animals.herds[std::size_t(plan.herd)];
    if (herd.species == plan.species) surplus = herd_surplus(*world.web, world.levels, animals, herd);
  }
  return young_share(world.traits(plan), surplus);
}

HerdRegion herd_region(const HerdWorld& world, const DailyPlan& plan) {
  const std::size_t level = std::size_t(plan.level) - 1;
  if (level >= world.levels.size() || !world.levels[level]) return {};
  const AnimalLevel& animals = *world.levels[level];
  const auto found = std::find(animals.species.begin(), animals.species.end(), plan.species);
  if (found == animals.species.end()) return {};
  const std::shared_ptr<const ConfinementRegions>& regions = animals.regions[std::size_t(found - animals.species.begin())];
  if (!regions || regions->label.empty() || plan.way.empty()) return {};
  const HerdWorld::Cell home = world.cell_of(world.place_of(plan.way.front().at));
  const std::int32_t label = regions->label(home.x, home.y);
  if (label < 0) return {};
  return {std::shared_ptr<const RunMap>(regions, &regions->label), label};
}

bool HerdCast::passable(Place place) const {
  const Terrain& terrain = world->terrain();
  constexpr double margin = 0.5;
  if (place.x < margin || place.y < margin || place.x > terrain.width_metres() - margin ||
      place.y > terrain.height_metres() - margin)
    return false;
  // A region says all: it holds fords, passages and exits, however deep the water is there.
  return region.labels ? region.holds(world->cell_of(place)) : double(world->depth_at(place)) <= wade_depth;
}

Place HerdCast::nearest_passable(Place from, Place place) const {
  if (passable(place)) return place;
  double low = 0;
  double high = 1;
  for (int i = 0; i < 6; ++i) {
    const double middle = 0.5 * (low + high);
    (passable(from + (place - from) * middle) ? low : high) = middle;
  }
  return from + (place - from) * low;
}

HerdCast cast_herd(std::shared_ptr<const HerdWorld> world, int plan_number, std::vector<int> predators, const HerdStays* stays) {
  HerdCast cast;
  cast.world = std::move(world);
  cast.plan_number = plan_number;
  cast.predators = std::move(predators);
  const DailyPlan& plan = cast.plan();
  const AnimalTraits& traits = cast.world->traits(plan);
  cast.seed =
      random_bits({cast.world->seed, 0xbea57, std::uint64_t(plan.species), std::uint64_t(plan.level), std::uint64_t(plan.herd)});
  cast.body_length = std::max(0.2, double(traits.shape.body_length));
  cast.shoulder = std::max(0.1, double(traits.shape.shoulder_height));
  cast.walk_speed = std::max(0.2, double(traits.speed));
  // Six and a half times the walk, within what animals of that kind run: 7 m/s to 16 m/s. Our choice.
  cast.gallop_speed = std::clamp(6.5 * cast.walk_speed, 7.0, 16.0);
  cast.wade_depth = double(traits.wade_depth);
  cast.region = herd_region(*cast.world, plan);
  cast.young_share = herd_young_share(*cast.world, plan);
  const int count = std::max(0, plan.size);
  for (int i = 0; i < count; ++i) cast.members.push_back(member_traits(cast, i, count));
  if (plan.way.empty()) return cast;
  const GraphLevel& graph = cast.world->graph_of(plan);
  for (std::size_t stop = 0; stop < plan.stops.size(); ++stop) {
    const double middle = 0.5 * (double(plan.stops[stop].arrive) + double(plan.stops[stop].leave)) * 3600;
    const Place centre = cast.world->place_of(cast.world->state(plan, middle).at);
    const bool bank = graph.nodes[std::size_t(plan.stops[stop].node)].kind == NodeKind::bank;
    cast.beside.push_back(stays ? stays->before(plan_number, stop) : std::vector<HerdStay>{});
    cast.stops.push_back(lay_out_stop(cast, stop, centre, bank, cast.beside.back()));
  }
  if (cast.stops.empty()) cast.stops.push_back(lay_out_stop(cast, 0, cast.world->place_of(plan.way.front().at), false, {}));
  return cast;
}

}  // namespace biotope

#include "core/movement/daily_plan.hpp"

#include <algorithm>
#include <cmath>

#include "core/base/parallel.hpp"
#include "core/base/random.hpp"
#include "core/movement/plan_hunt.hpp"

namespace biotope {
namespace {

using PlannedDay = std::pair<DailyPlan, HerdCourse>;

/// Whether a species lives on plants for more than half of what it eats: it looks for places, not for herds.
bool lives_on_plants(const FoodWeb& web, int species) {
  double plants = 0;
  double all = 0;
  for (const auto& need : web.diets[std::size_t(species)]) {
    const auto is_plant = [&](int food) { return web.level[std::size_t(food)] == 0; };
    const auto count = std::count_if(need.foods.begin(), need.foods.end(), is_plant);
    all += double(need.amount);
    if (!need.foods.empty()) plants += double(need.amount) * double(count) / double(need.foods.size());
  }
  return plants * 2 > all;
}

/// Plans all levels, from the lowest up.
class Planner {
 public:
  Planner(const FoodWeb& web, std::span<const std::shared_ptr<const AnimalLevel>> levels, std::span<const LevelMovement> movement,
          const Ground& ground, const TrailNetwork* trails, std::uint64_t seed, std::span<const PlanEdit> edits)
      : web_(web),
        levels_(levels),
        movement_(movement),
        ground_(ground),
        placed_(ground),
        trails_(trails),
        seed_(seed),
        herds_(planned_herds(levels, seed)),
        edits_(levels.size()) {
    for (const PlanEdit& edit : edits) {
      if (const auto named = find_planned_herd(edit, web, levels)) edits_[named->level][named->herd] = &edit;
    }
  }

  void plan_level(std::size_t number) {
    const AnimalLevel& level = *levels_[number];
    const std::vector<std::uint64_t> keys = herd_keys(level, seed_);
    const PlanInput input{web_, level, movement_[number], ground_, keys, placed_, trails_};
    std::vector<std::optional<PlannedDay>> days(level.herds.size());
    keep_edits(input, edits_[number], days);
    if (number > 0) follow(input, herds_[number], days);
    graze(input, herds_[number], days);
    for (std::size_t herd = 0; herd < days.size(); ++herd) {
      auto& day = days[herd];
      if (!day) continue;
      const Herd& animals = level.herds[herd];
      if (!day->first.stops.empty()) plans_of_[{animals.species, animals.region}].push_back(int(plans_.size()));
      plans_.push_back(std::move(day->first));
      courses_.push_back(std::move(day->second));
      level_of_plan_.push_back(number);
    }
  }

  std::vector<DailyPlan> take() { return std::move(plans_); }

 private:
  static void keep_edits(const PlanInput& input, const std::map<int, const PlanEdit*>& edits,
                         std::vector<std::optional<PlannedDay>>& days) {
    const PlannedEdits named(edits.begin(), edits.end());
    std::vector<PlannedDay> edited = edited_days(input, named);
    for (std::size_t i = 0; i < named.size(); ++i) days[std::size_t(named[i].first)] = std::move(edited[i]);
  }

  static void graze(const PlanInput& input, std::span<const int> herds, std::vector<std::optional<PlannedDay>>& days) {
    std::vector<std::uint8_t> wanted(days.size(), 0);
    for (const int herd : herds) {
      const auto& day = days[std::size_t(herd)];
      // A herd whose day a person planned still takes the room it took, so that the others' days stay as they are.
      wanted[std::size_t(herd)] = !day || (day->first.edited && lives_on_plants(input.web, day->first.species));
    }
    std::vector<DayDraft> drafts = draft_days(input, wanted);
    std::erase_if(drafts, [&](const DayDraft& draft) { return days[std::size_t(draft.herd)].has_value(); });
    NodeWays ways(input);
    for (const DayDraft& draft : drafts) {
      const int graph = input.movement.travel->graph_of_species[std::size_t(draft.species_index)];
      for (std::size_t i = 0; i < draft.stays.size() && draft.stays.size() > 1; ++i) {
        ways.need(graph, draft.stays[i].node, draft.stays[(i + 1) % draft.stays.size()].node);
      }
    }
    ways.find();
    parallel_each(drafts.size(), [&](std::size_t i) { days[std::size_t(drafts[i].herd)] = walk_day(input, drafts[i], ways); });
  }

  /// Predators: from herd to herd, or behind the only one they can find.
  void follow(const PlanInput& input, std::span<const int> packs, std::vector<std::optional<PlannedDay>>& days) const {
    std::vector<std::vector<PreyHerd>> prey(packs.size());
    parallel_each(packs.size(), [&](std::size_t i) {
      const auto herd = std::size_t(packs[i]);
      if (!days[herd] && !lives_on_plants(web_, input.level.herds[herd].species)) prey[i] = prey_of(input, packs[i]);
    });
    hunt(input, packs, prey, days);
    keep_to_one(input, packs, prey, days);
  }

  /// Packs with several herds to choose from.
  static void hunt(const PlanInput& input, std::span<const int> packs, std::span<const std::vector<PreyHerd>> prey,
                   std::vector<std::optional<PlannedDay>>& days) {
    constexpr int most_neighbours = 2;
    std::vector<HuntingPack> hunting;
    std::map<std::pair<int, int>, int> neighbours;
    const auto group = [&](int pack) -> int& {
      const Herd& herd = input.level.herds[std::size_t(pack)];
      return neighbours[{herd.species, herd.region}];
    };
    for (std::size_t i = 0; i < packs.size(); ++i) {
      if (prey[i].size() > 1) hunting.push_back({packs[i], prey[i], group(packs[i])++, 1});
    }
    for (HuntingPack& pack : hunting) pack.neighbours = std::min(most_neighbours, group(pack.herd));
    parallel_each(hunting.size(), [&](std::size_t i) { days[std::size_t(hunting[i].herd)] = hunting_day(input, hunting[i]); });
  }

  /// In rounds: every pack without a herd draws one (herds that are already followed draw fewer others), then all try to follow.
  static void keep_to_one(const PlanInput& input, std::span<const int> packs, std::vector<std::vector<PreyHerd>>& prey,
                          std::vector<std::optional<PlannedDay>>& days) {
    std::map<int, int> followers;
    constexpr std::uint64_t rounds = 6;
    for (std::uint64_t round = 0; round < rounds; ++round) {
      std::vector<std::pair<std::size_t, PreyHerd>> chosen;
      for (std::size_t i = 0; i < packs.size(); ++i) {
        const auto herd = std::size_t(packs[i]);
        if (days[herd] || prey[i].empty()) continue;
        const std::size_t drawn = draw(prey[i], followers, random_unit({input.keys[herd], round, 41}));
        chosen.emplace_back(herd, prey[i][drawn]);
        ++followers[prey[i][drawn].herd.plan];
        prey[i].erase(prey[i].begin() + std::ptrdiff_t(drawn));
      }
      parallel_each(chosen.size(), [&](std::size_t i) {
        const auto& [herd, one] = chosen[i];
        days[herd] = follow_herd(input, int(herd), one.herd, ground_of(input, int(herd)));
      });
      for (const auto& [herd, one] : chosen) {
        if (!days[herd]) --followers[one.herd.plan];
      }
    }
  }

  [[nodiscard]] static FineGround ground_of(const PlanInput& input, int herd) {
    const int species = species_index_of(input.level, input.level.herds[std::size_t(herd)]);
    return fine_ground(input, input.movement.travel->graph_of_species[std::size_t(species)]);
  }

  /// Herds whose region is a resource of the pack, with P_s(v) of that region by their share of the animals there; of a region
  /// with many herds some.
  [[nodiscard]] std::vector<PreyHerd> prey_of(const PlanInput& input, int herd) const {
    constexpr std::size_t most_a_region = 24;
    const Herd& pack = input.level.herds[std::size_t(herd)];
    const int species = species_index_of(input.level, pack);
    const auto& presence = input.movement.travel->presence[std::size_t(species)][std::size_t(pack.region)];
    const auto& label = input.level.regions[std::size_t(species)]->label;
    std::vector<PreyHerd> prey;
    for (const auto& [node, probability] : presence) {
      const ResourceNode& place = input.level.graph->nodes[std::size_t(node)];
      if (place.kind != NodeKind::prey) continue;
      const auto there = plans_of_.find({place.group, place.prey_region});
      if (there == plans_of_.end()) continue;
      const std::vector<int>& plans = there->second;
      const std::uint64_t start = random_bits({input.keys[std::size_t(herd)], std::uint64_t(node), 43}) % plans.size();
      const std::size_t first = prey.size();
      double animals = 0;
      for (std::size_t i = 0; i < std::min(plans.size(), most_a_region); ++i) {
        const auto plan = std::size_t(plans[(start + i) % plans.size()]);
        const PathCell home = cell_at(plans_[plan].way.front().at);
        if (label(home.x, home.y) != pack.region) continue;
        animals += plans_[plan].size;
        prey.push_back(
            {{int(plan), &plans_[plan], &courses_[plan], levels_[level_of_plan_[plan]]->graph.get(), node}, double(probability)});
      }
      for (std::size_t i = first; i < prey.size(); ++i) prey[i].probability *= prey[i].herd.day->size / animals;
    }
    return prey;
  }

  static std::size_t draw(const std::vector<PreyHerd>& prey, std::map<int, int>& followers, double unit) {
    const auto weight = [&](const PreyHerd& one) { return one.probability / (1 + followers[one.herd.plan]); };
    double total = 0;
    for (const PreyHerd& one : prey) total += weight(one);
    double left = unit * total;
    for (std::size_t i = 0; i < prey.size(); ++i) {
      if ((left -= weight(prey[i])) < 0) return i;
    }
    return prey.size() - 1;
  }

  const FoodWeb& web_;
  std::span<const std::shared_ptr<const AnimalLevel>> levels_;
  std::span<const LevelMovement> movement_;
  const Ground& ground_;
  PlacedGround placed_;
  const TrailNetwork* trails_;
  std::uint64_t seed_;
  std::vector<std::vector<int>> herds_;
  /// By level and herd.
  std::vector<std::map<int, const PlanEdit*>> edits_;
  std::vector<DailyPlan> plans_;
  std::vector<HerdCourse> courses_;
  std::vector<std::size_t> level_of_plan_;
  /// Plans of herds that go somewhere, by species and region.
  std::map<std::pair<int, int>, std::vector<int>> plans_of_;
};

}  // namespace

DailyPlan stand_still(const PlanInput& input, int herd) {
  const Herd& animals = input.level.herds[std::size_t(herd)];
  const AnimalTraits& animal = input.web.species[std::size_t(animals.species)].animal();
  DailyPlan plan{input.level.level, herd, animals.species, animals.size, {}, {}, active_hours(animal.activity), {}};
  const ConfinementRegions& regions = *input.level.regions[std::size_t(species_index_of(input.level, animals))];
  const Rect bounds = regions.regions[std::size_t(animals.region)].bounds;
  // Any cell of the region: the first drawn ones, or else the first in order.
  PathPoint at{float(bounds.x0), float(bounds.y0)};
  bool found = false;
  for (std::uint64_t i = 0; i < 64 && !found; ++i) {
    const int x = random_int(bounds.x0, bounds.x1 - 1, {input.keys[std::size_t(herd)], i, 51});
    const int y = random_int(bounds.y0, bounds.y1 - 1, {input.keys[std::size_t(herd)], i, 52});
    found = regions.label(x, y) == animals.region;
    if (found) at = {float(x), float(y)};
  }
  for (int y = bounds.y0; y < bounds.y1 && !found; ++y) {
    for (int x = bounds.x0; x < bounds.x1 && !found; ++x) {
      found = regions.label(x, y) == animals.region;
      if (found) at = {float(x), float(y)};
    }
  }
  plan.way = {{0, at}, {24, at}};
  return plan;
}

Result<std::vector<DailyPlan>> compute_daily_plans(const FoodWeb& web, std::span<const std::shared_ptr<const AnimalLevel>> levels,
                                                   std::span<const LevelMovement> movement, const Ground& ground,
                                                   std::uint64_t seed, const TaskContext& context, const TrailNetwork* trails,
                                                   std::span<const PlanEdit> edits) {
  assert(levels.size() == movement.size());
  Planner planner(web, levels, movement, ground, trails, seed, edits);
  for (std::size_t i = 0; i < levels.size(); ++i) {
    if (context.stopped()) return fail("stopped");
    planner.plan_level(i);
    context.report("daily plans", double(i + 1) / double(levels.size()));
  }
  return planner.take();
}

}  // namespace biotope

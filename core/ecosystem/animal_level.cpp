#include "core/ecosystem/animal_level.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "core/base/parallel.hpp"
#include "core/ecosystem/animal_competition.hpp"
#include "core/ecosystem/animal_paint.hpp"
#include "core/ecosystem/animal_warnings.hpp"
#include "core/ecosystem/herds.hpp"
#include "core/ecosystem/resource_nodes.hpp"

namespace biotope {
namespace {

const AnimalTraits& traits(const FoodWeb& web, int species) { return web.species[std::size_t(species)].animal(); }

/// The regions of animals with these limits in a level, or null.
std::shared_ptr<const ConfinementRegions> regions_in(const AnimalLevel& level, const Mobility& mobility) {
  for (std::size_t i = 0; i < level.species.size(); ++i) {
    if (same_obstacles(mobility, level.basis.mobility[i])) return level.regions[i];
  }
  return nullptr;
}

/// Regions of animals with these limits; what was found before is taken over but for some rows.
std::shared_ptr<const ConfinementRegions> regions_for(const AnimalLevelInput& input, const Mobility& mobility,
                                                      std::span<const char> other_rows) {
  for (const auto& below : input.below) {
    if (auto regions = regions_in(*below, mobility)) return regions;
  }
  const auto before = input.previous ? regions_in(*input.previous, mobility) : nullptr;
  if (!before) return std::make_shared<const ConfinementRegions>(confinement_regions(input.ground, mobility));
  if (same_blocked_cells(input.ground, input.previous->basis.ground, mobility)) return before;
  return confinement_regions(input.ground, mobility, other_rows, before);
}

/// One map of regions for every kind of obstacles, shared by the species that meet the same.
void find_regions(const AnimalLevelInput& input, AnimalLevel& level) {
  std::vector<Mobility> kinds;
  std::vector<std::size_t> kind_of_species;
  for (const Mobility& mobility : level.basis.mobility) {
    const auto found =
        std::find_if(kinds.begin(), kinds.end(), [&](const Mobility& kind) { return same_obstacles(kind, mobility); });
    kind_of_species.push_back(std::size_t(found - kinds.begin()));
    if (found == kinds.end()) kinds.push_back(mobility);
  }
  const std::vector<char> other_rows =
      input.previous ? rows_of_other_obstacles(input.ground, input.previous->basis.ground) : std::vector<char>{};
  std::vector<std::shared_ptr<const ConfinementRegions>> maps(kinds.size());
  parallel_each(kinds.size(), [&](std::size_t i) { maps[i] = regions_for(input, kinds[i], other_rows); });
  for (const std::size_t kind : kind_of_species) level.regions.push_back(maps[kind]);
}

/// The partition of the level's regions and the banks in it.
void find_partition(const AnimalLevelInput& input, AnimalLevel& level) {
  const AnimalLevel* previous = input.previous.get();
  if (previous != nullptr && previous->regions == level.regions) {
    level.partition = previous->partition;
  } else {
    level.partition = std::make_shared<const Partition>(finest_partition(level.regions, input.ground.terrain->cell_size));
  }
  const auto same_water = [&](const Ground& before) {
    return before.terrain == input.ground.terrain && before.derivatives == input.ground.derivatives &&
           before.hydrology == input.ground.hydrology;
  };
  const bool known_shore = previous != nullptr && same_water(previous->basis.ground);
  if (known_shore && previous->partition == level.partition) {
    level.basis.banks = previous->basis.banks;
    return;
  }
  std::shared_ptr<const RunTable> shore = known_shore ? previous->basis.banks->shore : nullptr;
  for (const auto& below : input.below) {
    if (!shore && below->basis.banks && same_water(below->basis.ground)) shore = below->basis.banks->shore;
  }
  level.basis.banks = find_banks(input.ground, *piece_runs(level), shore);
}

/// Whether the level's foods lose the same of their growth, by the same paint.
bool same_losses(const AnimalLevelInput& input, std::span<const std::shared_ptr<const PaintLayer>> before) {
  const std::vector<char> edible = edible_to_level(input.web, input.level);
  for (int species = 0; species < int(edible.size()); ++species) {
    if (edible[std::size_t(species)] && loss_of(before, species) != loss_of(input.losses, species)) return false;
  }
  return true;
}

/// Whether herds come by the same places.
bool same_waypoints(const Ground& a, const Ground& b) {
  if (a.places == b.places) return true;
  const Places none;
  const Places& one = a.places ? *a.places : none;
  const Places& other = b.places ? *b.places : none;
  return one.waypoints == other.waypoints && one.exits == other.exits;
}

/// Marks the tiles where two layers (null: blank) are not the same.
template <class T>
void mark_differing(const TiledMap<T>* before, const TiledMap<T>* after, std::vector<char>& changed) {
  if (before == after) return;
  const T background = before ? before->background() : T{};
  const bool same_background = background == (after ? after->background() : T{});
  for (std::size_t i = 0; i < changed.size(); ++i) {
    const auto* a = before ? before->tile(i).get() : nullptr;
    const auto* b = after ? after->tile(i).get() : nullptr;
    if (a != b || (a == nullptr && !same_background)) changed[i] = 1;
  }
}

/// By tile: whether the plants that the level eats, or what is lost of them, differ from those of the previous computation. Empty
/// when that had other kinds of maps, so that nothing of it can be taken over.
std::vector<char> changed_tiles(const AnimalLevelInput& input) {
  if (!input.previous || !input.previous->basis.supply) return {};
  const AnimalLevelBasis& before = input.previous->basis;
  if (before.plants.size() != input.plants.size()) return {};
  const std::vector<char> edible = edible_to_level(input.web, input.level);
  std::vector<char> changed;
  for (std::size_t i = 0; i < input.plants.size(); ++i) {
    const int species = input.web.levels[0][i];
    if (!edible[std::size_t(species)]) continue;
    const CoverMap* one = before.plants[i].get();
    const CoverMap* other = input.plants[i].get();
    if (one == nullptr || other == nullptr || one->rect() != other->rect()) return {};
    changed.resize(other->tile_count());
    mark_differing(one, other, changed);
    mark_differing(loss_of(before.losses, species), loss_of(input.losses, species), changed);
  }
  return changed;
}

/// Nodes, and what the levels below left.
void find_resources(const AnimalLevelInput& input, AnimalLevel& level, const TaskContext& context) {
  const AnimalLevel* previous = input.previous.get();
  if (previous != nullptr && previous->basis.banks == level.basis.banks && previous->partition == level.partition &&
      previous->basis.plants == level.basis.plants && previous->basis.below == level.basis.below &&
      same_losses(input, previous->basis.losses) && same_waypoints(input.ground, previous->basis.ground)) {
    level.prey = previous->prey;
    level.available = previous->available;
    level.graph = previous->graph;
    level.basis.supply = previous->basis.supply;
    return;
  }
  const PresentTiles tiles(input.plants, plant_losses(input.web, input.losses));
  const std::vector<char> changed = changed_tiles(input);
  const std::shared_ptr<const RunTable> pieces = piece_runs(level);
  auto found = std::make_shared<SupplyTiles>();
  const ResourceSources sources{.web = input.web,
                                .level = input.level,
                                .ground = input.ground,
                                .partition = *level.partition,
                                .plants = input.plants,
                                .below = input.below,
                                .tiles = tiles,
                                .banks = *level.basis.banks,
                                .losses = input.losses,
                                .pieces = *pieces,
                                .reuse = {changed.empty() ? nullptr : previous->basis.supply.get(), changed, found.get()}};
  const std::vector<PreySupply> prey = find_prey(sources);
  for (const PreySupply& supply : prey) level.prey.push_back({supply.species, supply.region, supply.piece, supply.available});
  level.available = available_supply(sources, prey);
  level.graph = std::make_shared<const GraphLevel>(build_resource_nodes(sources, prey, context));
  level.basis.supply = std::move(found);
}

std::vector<std::vector<double>> populations(const AnimalCompetition& competition, const AnimalLevel& level) {
  std::vector<std::vector<double>> result;
  for (const auto& regions : level.regions) result.emplace_back(regions->regions.size());
  for (const Settlement& own : competition.settlements())
    result[std::size_t(own.species_index)][std::size_t(own.region)] = own.population;
  return result;
}

/// Lets the settlements eat for the populations that paint made: fewer animals give back their share, more eat of what is left;
/// what is missing is recorded, the paint stays.
void eat_as_painted(AnimalCompetition& competition, AnimalLevel& level, const FoodWeb& web,
                    std::span<const PaintedPopulation> paint) {
  const std::size_t count = competition.settlements().size();
  std::vector<double> wanted(count);
  for (std::size_t i = 0; i < count; ++i) {
    const Settlement& own = competition.settlements()[i];
    wanted[i] = level.population[std::size_t(own.species_index)][std::size_t(own.region)];
    if (wanted[i] < own.population) competition.give_back(i, 1 - wanted[i] / own.population);
  }
  for (std::size_t i = 0; i < count; ++i) {
    const Settlement& own = competition.settlements()[i];
    const double more = wanted[i] - own.population;
    if (more <= 1e-9 * wanted[i]) continue;
    const Meal meal = competition.plan_meal(i, more);
    competition.eat(i, more, meal);
    record_shortages(web, own, competition.needs(own.species_index), meal, paint[std::size_t(own.species_index)], level);
  }
}

/// Populations with paint on them; returns what is then eaten.
std::vector<std::vector<double>> apply_paint(const AnimalLevelInput& input, const CompetitionInput& rules,
                                             const AnimalCompetition& competition, AnimalLevel& level) {
  level.population = level.computed_population;
  std::vector<PaintedPopulation> painted_populations(level.species.size());
  level.attraction.assign(level.species.size(), {});
  std::vector<char> inhabited(competition.settlements().size());
  bool any = false;
  for (std::size_t i = 0; i < level.species.size(); ++i) {
    if (i >= input.paint.size() || !input.paint[i]) continue;
    any = true;
    painted_populations[i] =
        painted_population(*level.regions[i], level.computed_population[i], *input.paint[i], input.ground.terrain->cell_size);
    level.population[i] = painted_populations[i].population;
    level.attraction[i] =
        node_attraction(*level.graph, *level.regions[i], level.computed_population[i], level.population[i], *input.paint[i]);
    warn_of_uninhabitable_paint(input.web, level.species[i], painted_populations[i], level);
    for (std::size_t region = 0; region < level.population[i].size(); ++region) {
      inhabited[competition.settlement(int(i), int(region))] = level.population[i][region] > 0;
    }
  }
  if (!any) return competition.eaten();
  AnimalCompetition with_paint(rules, inhabited);
  with_paint.adopt(competition);
  eat_as_painted(with_paint, level, input.web, painted_populations);
  return with_paint.eaten();
}

void form_herds(const AnimalLevelInput& input, AnimalLevel& level) {
  for (std::size_t i = 0; i < level.species.size(); ++i) {
    const AnimalTraits& animal = traits(input.web, level.species[i]);
    for (std::size_t region = 0; region < level.population[i].size(); ++region) {
      const std::uint64_t place = (std::uint64_t(level.species[i]) << 32) | region;
      const int individuals = int(std::lround(level.population[i][region]));
      for (const int size : herd_sizes(individuals, animal.herd_min, animal.herd_max, input.seed, place)) {
        level.herds.push_back({level.species[i], int(region), size});
      }
    }
  }
}

std::vector<double> shares(const std::vector<std::vector<double>>& population) {
  std::vector<double> result;
  for (const auto& regions : population) result.push_back(std::accumulate(regions.begin(), regions.end(), 0.0));
  const double total = std::accumulate(result.begin(), result.end(), 0.0);
  for (double& share : result) share = total > 0 ? share / total : 0;
  return result;
}

/// Desired shares of the level, normalised; empty when none is asked.
std::vector<double> normalised(std::vector<double> desired) {
  const double total = std::accumulate(desired.begin(), desired.end(), 0.0);
  if (total <= 0) return {};
  for (double& share : desired) share /= total;
  return desired;
}

}  // namespace

Result<AnimalLevel> compute_animal_level(const AnimalLevelInput& input, const TaskContext& context) {
  assert(input.level >= 1 && input.level < input.web.level_count());
  AnimalLevel level;
  level.level = input.level;
  level.species = input.web.levels[std::size_t(input.level)];
  assert(input.desired.empty() || input.desired.size() == level.species.size());
  level.desired = normalised(input.desired);

  context.report("confinement regions", 0);
  level.basis = {
      input.ground, {},     {input.plants.begin(), input.plants.end()}, {input.below.begin(), input.below.end()}, input.losses,
      nullptr,      nullptr};
  for (const int species : level.species) level.basis.mobility.push_back(mobility_of(traits(input.web, species)));
  find_regions(input, level);
  if (context.stopped()) return fail("stopped");
  find_partition(input, level);

  context.report("resource nodes", 0);
  if (context.stopped()) return fail("stopped");
  find_resources(input, level, context);
  if (context.stopped()) return fail("stopped");

  context.report("animal competition", 0);
  const CompetitionInput rules{input.web, level.species, *level.partition, level.regions, *level.graph, level.available};
  AnimalCompetition competition(rules);
  Proportions proportions;
  if (level.desired.empty()) {
    if (const Status settled = settle_fittest(competition, context); !settled) return fail(settled.error().message);
  } else {
    const auto settled = settle_in_proportion(competition, level.desired, context);
    if (!settled) return fail(settled.error().message);
    proportions = *settled;
  }
  level.computed_population = populations(competition, level);
  warn_of_absent_species(input.web, level);
  warn_of_scarce_species(input.web, proportions.held_back_by, level);
  level.eaten = apply_paint(input, rules, competition, level);
  level.achieved = shares(level.population);
  form_herds(input, level);
  context.report("animal competition", 1);
  return level;
}

Grid<float> animal_density(const AnimalLevel& level, int species_index, const PaintLayer* paint) {
  const ConfinementRegions& regions = *level.regions[std::size_t(species_index)];
  const auto& individuals = level.computed_population[std::size_t(species_index)];
  std::vector<float> uniform;
  for (std::size_t i = 0; i < individuals.size(); ++i)
    uniform.push_back(float(uniform_density(regions.regions[i], individuals[i])));
  Grid<float> density(regions.label.width(), regions.label.height());
  parallel_rows(0, density.height(), [&](int y) {
    const auto row = density.row(y);
    std::vector<Paint> cells(paint != nullptr ? row.size() : 0);
    if (paint != nullptr) paint->read_row(y, 0, cells);
    for (const CellRun& run : regions.label.runs().row(y)) {
      for (auto x = std::size_t(run.x0); x < std::size_t(run.x1); ++x) {
        row[x] = uniform[std::size_t(run.value)];
        if (paint != nullptr && cells[x].coverage > 0) row[x] = std::max(0.0F, painted(row[x], cells[x]));
      }
    }
  });
  return density;
}

}  // namespace biotope

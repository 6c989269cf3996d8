#include "core/pipeline/solve.hpp"

#include <algorithm>
#include <numeric>

#include "core/pipeline/solve_parts.hpp"
#include "core/pipeline/solve_run.hpp"
#include "core/terrain/shaping.hpp"

namespace biotope {

SolveCache::SolveCache() : stages_(std::make_unique<Stages>()) {}
SolveCache::~SolveCache() = default;
SolveCache::SolveCache(SolveCache&&) noexcept = default;
SolveCache& SolveCache::operator=(SolveCache&&) noexcept = default;

namespace {

void release_memory(SolveCache::Stages& stages) {
  stages.land.painted.release_unused();
  stages.slopes.derivatives.release_unused();
  stages.water.release_unused();
  stages.environment.light.release_unused();
  stages.environment.warmth.release_unused();
  stages.environment.soil.release_unused();
}

template <class T>
Status keep(std::shared_ptr<const T>& slot, Result<std::shared_ptr<const T>> made) {
  if (!made) return tl::unexpected<Error>(made.error());
  slot = *made;
  return {};
}

}  // namespace

Result<std::shared_ptr<const MapsSnapshot>> SolveRun::all() {
  const std::uint64_t land_before = stages_.land.changes.version();
  for (const Step part : {&SolveRun::land, &SolveRun::life_as_before, &SolveRun::life}) {
    if (Status done = (this->*part)(); !done) return tl::unexpected<Error>(done.error());
  }
  // Once something else is edited, the ground may stay as it is for long.
  if (stages_.land.changes.version() == land_before) release_memory(stages_);
  return whole_snapshot();
}

Status SolveRun::land() {
  return perform({{"species", &SolveRun::species},
                  {"ground", &SolveRun::ground},
                  {"slopes", &SolveRun::slopes},
                  {nearby_stage, &SolveRun::nearby},
                  {"water", &SolveRun::water},
                  {"environment", &SolveRun::environment_as_before}});
}

Status SolveRun::life() {
  if (!maps_->shaded) {
    if (Status done = perform({{"far shade", &SolveRun::environment}}); !done) return done;
  }
  const Status done = perform({{"plants", &SolveRun::plants}});
  return done ? life_on_plants() : done;
}

Status SolveRun::life_on_plants() {
  return perform({{"animals", &SolveRun::animals},
                  {"travel", &SolveRun::travel},
                  {"trails", &SolveRun::trails},
                  {"daily plans", &SolveRun::daily_plans},
                  {"warnings", &SolveRun::overpainted}});
}

Status SolveRun::perform(const Steps& steps) {
  for (const auto& [name, step] : steps) {
    if (context_.stopped()) return fail(stopped_message);
    clock_.begin(shown_as_before_ ? "exact " + name : name);
    context_.report(name, 0);
    const Status done = (this->*step)();
    if (context_.stopped()) return fail(stopped_message);
    if (!done) return fail("While computing " + name + ": " + done.error().message);
    publish_partial();
  }
  clock_.end();
  return {};
}

std::shared_ptr<const MapsSnapshot> SolveRun::whole_snapshot() const {
  auto whole = std::make_shared<MapsSnapshot>(*maps_);
  whole->timings = clock_.timings();
  whole->complete = true;
  return whole;
}

void SolveRun::publish_partial() {
  // What was shown near the brush, or with what is global as before, stays until the same maps are known exactly.
  if (!publish_ || !maps_->hydrology || (shown_nearby_ && maps_->cover.empty()) || shown_as_before_) return;
  publish_(std::make_shared<MapsSnapshot>(*maps_));
}

EnvironmentInput SolveRun::environment_input() const {
  return {stages_.land, stages_.slopes, stages_.water, document_.climate, document_.given_environment};
}

std::vector<double> SolveRun::desired(int level) const {
  const auto use = document_.use_proportions.find(level);
  if (use != document_.use_proportions.end() && !use->second) return {};
  return desired_proportions(*maps_->web, level, document_.climate.name);
}

InputPointers SolveRun::ground_pointers() const {
  return {biology_, maps_->land, maps_->derivatives, maps_->hydrology, maps_->tree_cover, maps_->passage, stages_.opened};
}

InputPointers SolveRun::level_pointers() const {
  InputPointers inputs = ground_pointers();
  inputs.insert(inputs.end(), maps_->animals.begin(), maps_->animals.end());
  return inputs;
}

Status SolveRun::species() {
  // The same species are the same web, so that who draws them need not look whether they changed.
  if (!stages_.web || stages_.web_of != document_.species) {
    auto web = build_food_web(*document_.species);
    if (!web) return tl::unexpected<Error>(web.error());
    stages_.web = std::make_shared<const FoodWeb>(std::move(*web));
    stages_.web_of = document_.species;
  }
  maps_->web = stages_.web;
  FoodWeb biology = *maps_->web;
  biology.species = without_shares(std::move(biology.species));
  if (!stages_.biology || stages_.biology->species != biology.species) {
    stages_.biology = std::make_shared<const FoodWeb>(std::move(biology));
    stages_.plants = {};
    stages_.covers.clear();
    stages_.levels.clear();
  }
  biology_ = stages_.biology;
  return {};
}

Status SolveRun::ground() {
  keep_equal(stages_.places, document_.placements.places);
  Places opened = document_.placements.places;
  opened.pinned_trails.clear();
  opened.forbidden_trails.clear();
  keep_equal(stages_.opened, opened);
  maps_->places = stages_.places;
  maps_->passage = maps_->paint({LayerKind::passage, "all"});
  update_land(stages_.land, document_.terrain, maps_->paint({LayerKind::ground, "height"}), document_.placements.water);
  maps_->land = stages_.land.land;
  return {};
}

Status SolveRun::slopes() {
  update_slopes(stages_.slopes, stages_.land);
  maps_->derivatives = stages_.slopes.derivatives.newest();
  return {};
}

Status SolveRun::water() {
  // The weather is that of the file's terrain: a hill that is raised somewhere must not change the water everywhere.
  const auto mean =
      stages_.mean_height.get({document_.terrain}, [&]() -> Result<double> { return mean_height(*document_.terrain); });
  HydrologyOptions options;
  options.inflows = document_.inflows;
  options.runoff = yearly_runoff(document_.climate, maps_->land->latitude, **mean);
  const std::vector<Inflow> drawn = inflows_of(document_.placements.water, *maps_->land, options.runoff);
  options.inflows.insert(options.inflows.end(), drawn.begin(), drawn.end());
  options.lake_cells = stages_.land.lake_cells;
  const TileSet changed = stages_.land.changes.since(stages_.water_seen_land);
  if (Status done = stages_.water.update(maps_->land, changed, options, context_); !done) return done;
  stages_.water_seen_land = stages_.land.changes.version();
  maps_->hydrology = stages_.water.newest();
  return {};
}

Status SolveRun::environment_with(FarShade far_shade) {
  if (Status done = update_environment(stages_.environment, environment_input(), far_shade, context_); !done) return done;
  if (!lasts_) stages_.environment.soil.forget_passes();
  maps_->environment = stages_.environment.maps;
  maps_->shaded = !stages_.environment.light.stale().any();
  return {};
}

Status SolveRun::plants() {
  const Status done = update_plants(stages_.plants, *biology_, maps_->plant_environment(), stages_.environment.changes,
                                    maps_->plant_desired, nullptr, context_);
  if (!done) return done;
  painted_plants(stages_, *maps_);
  return {};
}

Status SolveRun::animal_level(std::size_t index) {
  const int number = int(index) + 1;
  AnimalLevelInput input{*maps_->web,
                         number,
                         maps_->ground(),
                         maps_->cover,
                         maps_->animals,
                         desired(number),
                         {},
                         {},
                         document_.seed,
                         stages_.levels[index].value};
  InputPointers inputs = level_pointers();
  inputs.insert(inputs.end(), maps_->cover.begin(), maps_->cover.end());
  for (const int s : maps_->web->levels[index + 1]) {
    input.paint.push_back(maps_->paint({LayerKind::animal_density, maps_->web->species[std::size_t(s)].name}));
    inputs.push_back(input.paint.back());
  }
  for (const Species& species : maps_->web->species) {
    input.losses.push_back(maps_->paint({LayerKind::loss, species.name}));
    inputs.push_back(input.losses.back());
  }
  auto level =
      stages_.levels[index].get({inputs, input.desired, input.seed}, [&] { return compute_animal_level(input, context_); });
  if (!level) return tl::unexpected<Error>(level.error());
  maps_->animals.push_back(*level);
  maps_->warnings.insert(maps_->warnings.end(), (*level)->warnings.begin(), (*level)->warnings.end());
  publish_partial();
  return {};
}

Status SolveRun::animals() {
  const std::size_t count = maps_->web->levels.size() - 1;
  stages_.levels.resize(count);
  stages_.movement.resize(count);
  for (std::size_t i = 0; i < count; ++i) {
    context_.report("animals", double(i) / double(count));
    if (Status done = animal_level(i); !done) return done;
    if (context_.stopped()) return fail(stopped_message);
  }
  return {};
}

Status SolveRun::travel() {
  InputPointers all;
  for (std::size_t i = 0; i < maps_->animals.size(); ++i) {
    context_.report("travel", double(i) / double(maps_->animals.size()));
    InputPointers inputs = ground_pointers();
    inputs.push_back(maps_->animals[i]);
    inputs.push_back(maps_->places);
    auto movement = stages_.movement[i].get(inputs, [&] {
      return compute_level_movement(*maps_->web, *maps_->animals[i], maps_->ground(), context_, &stages_.travelled);
    });
    if (!movement) return tl::unexpected<Error>(movement.error());
    maps_->movement.push_back(**movement);
    all.push_back(*movement);
    if (context_.stopped()) return fail(stopped_message);
  }
  return keep(maps_->graph, stages_.graph.get(all, [&]() -> Result<ResourceAccessGraph> { return assembled_graph(*maps_); }));
}

Status SolveRun::trails() {
  InputPointers inputs = level_pointers();
  inputs.push_back(maps_->graph);
  inputs.push_back(maps_->places);
  return keep(maps_->trails, stages_.trails.get(inputs, [&] {
    return compute_trails(*maps_->web, maps_->animals, maps_->movement, maps_->ground(), context_, &stages_.travelled);
  }));
}

Status SolveRun::daily_plans() {
  InputPointers inputs = level_pointers();
  inputs.push_back(maps_->graph);
  inputs.push_back(maps_->trails);
  const std::vector<PlanEdit>& edits = document_.placements.plans;
  const Status planned = keep(maps_->plans, stages_.plans.get({inputs, document_.seed, edits}, [&] {
    return compute_daily_plans(*maps_->web, maps_->animals, maps_->movement, maps_->ground(), document_.seed, context_,
                               maps_->trails.get(), edits);
  }));
  if (!planned) return planned;
  std::size_t herds = 0;
  for (const auto& level : maps_->animals) herds += level->herds.size();
  if (maps_->plans->size() < herds) {
    maps_->warnings.push_back({"Of " + std::to_string(herds) + " herds " + std::to_string(maps_->plans->size()) +
                               ", chosen evenly over the species, have a daily plan."});
  }
  return {};
}

Status SolveRun::overpainted() {
  InputPointers inputs{biology_, maps_->environment};
  std::vector<std::shared_ptr<const PaintLayer>> paint;
  for (const int plant : maps_->web->levels.front()) {
    paint.push_back(maps_->paint({LayerKind::plant_density, maps_->web->species[std::size_t(plant)].name}));
  }
  const PlantEnvironment environment = maps_->plant_environment();
  inputs.insert(inputs.end(), paint.begin(), paint.end());
  inputs.insert(inputs.end(), maps_->cover.begin(), maps_->cover.end());
  inputs.insert(inputs.end(), environment.paint.begin(), environment.paint.end());
  inputs.push_back(environment.soil.texture);
  inputs.push_back(environment.soil.geology);
  const auto find = [&]() -> Result<std::vector<PlantShortage>> {
    return plant_shortages(*maps_->web, environment, maps_->cover, paint, maps_->land->cell_size);
  };
  const Status found = keep(maps_->plant_shortages, stages_.plant_shortages.get(inputs, find));
  if (!found) return found;
  for (const PlantShortage& shortage : *maps_->plant_shortages)
    maps_->warnings.push_back(shortage_warning(*maps_->web, *maps_->land, shortage));
  return {};
}

void SolveCache::release_unused() { release_memory(*stages_); }

Result<std::shared_ptr<const MapsSnapshot>> solve(const Document& document, SolveCache* cache, const TaskContext& context,
                                                  const PublishPartial& publish) {
  if (const Status usable = check_inputs(document); !usable) return tl::unexpected<Error>(usable.error());
  SolveCache own;
  return SolveRun(document, (cache ? *cache : own).stages(), cache != nullptr, context, publish).all();
}

}  // namespace biotope

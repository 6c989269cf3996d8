#include "core/pipeline/solve.hpp"

#include <algorithm>
#include <numeric>

#include "core/pipeline/solve_parts.hpp"
#include "core/pipeline/solve_stages.hpp"
#include "core/pipeline/stage_clock.hpp"
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

/// One run over the operators, in topological order.
class Run {
 public:
  /// `lasts`: whether the stages are for further runs.
  Run(const Document& document, SolveCache::Stages& stages, bool lasts, const TaskContext& context, const PublishPartial& publish)
      : document_(document),
        stages_(stages),
        lasts_(lasts),
        context_(context),
        publish_(publish),
        maps_(std::make_shared<MapsSnapshot>()) {
    maps_->document = document;
  }

  Result<std::shared_ptr<const MapsSnapshot>> all() {
    const std::uint64_t land_before = stages_.land.changes.version();
    for (const auto& todo : {&Run::land, &Run::life_as_before, &Run::life}) {
      if (Status done = (this->*todo)(); !done) return tl::unexpected<Error>(done.error());
    }
    // Once something else is edited, the ground may stay as it is for long.
    if (stages_.land.changes.version() == land_before) release_memory(stages_);
    return whole_snapshot();
  }

 private:
  using Step = Status (Run::*)();
  using Steps = std::vector<std::pair<std::string, Step>>;

  Status land() {
    return perform({{"species", &Run::species},
                    {"ground", &Run::ground},
                    {"slopes", &Run::slopes},
                    {nearby_stage, &Run::nearby},
                    {"water", &Run::water},
                    {"environment", &Run::environment}});
  }
  Status life() {
    if (Status done = perform({{"plants", &Run::plants}}); !done) return done;
    return life_on_plants();
  }
  Status life_on_plants() {
    return perform({{"animals", &Run::animals},
                    {"travel", &Run::travel},
                    {"trails", &Run::trails},
                    {"daily plans", &Run::daily_plans},
                    {"warnings", &Run::overpainted}});
  }
  Status life_as_before();
  Status plants_as_before();

  Status perform(const Steps& steps) {
    for (const auto& [name, step] : steps) {
      if (context_.stopped()) return fail(stopped_message);
      clock_.begin(balancing_ ? "balanced " + name : name);
      context_.report(name, 0);
      const Status done = (this->*step)();
      if (context_.stopped()) return fail(stopped_message);
      if (!done) return fail("While computing " + name + ": " + done.error().message);
      publish_partial();
    }
    clock_.end();
    return {};
  }

  [[nodiscard]] std::shared_ptr<const MapsSnapshot> whole_snapshot() const {
    auto whole = std::make_shared<MapsSnapshot>(*maps_);
    whole->timings = clock_.timings();
    whole->complete = true;
    return whole;
  }

  void publish_partial() {
    // What was shown near the brush, or by the schedule of before, stays until the same maps are known exactly.
    if (!publish_ || !maps_->hydrology || (shown_nearby_ && maps_->cover.empty()) || balancing_) return;
    publish_(std::make_shared<MapsSnapshot>(*maps_));
  }

  template <class T>
  static Status keep(std::shared_ptr<const T>& slot, Result<std::shared_ptr<const T>> made) {
    if (!made) return tl::unexpected<Error>(made.error());
    slot = *made;
    return {};
  }

  Status species();
  Status ground();
  Status slopes();
  Status nearby();
  Status water();
  Status environment();
  Status plants();
  Status animals();
  Status animal_level(std::size_t index);
  Status travel();
  Status trails();
  Status daily_plans();
  Status overpainted();

  [[nodiscard]] EnvironmentInput environment_input() const {
    return {stages_.land, stages_.slopes, stages_.water, document_.climate, document_.given_environment};
  }
  [[nodiscard]] std::vector<double> desired(int level) const {
    const auto use = document_.use_proportions.find(level);
    if (use != document_.use_proportions.end() && !use->second) return {};
    return desired_proportions(*maps_->web, level, document_.climate.name);
  }
  /// What every animal reads of the ground: where it can be.
  [[nodiscard]] InputPointers ground_pointers() const {
    return {biology_, maps_->land, maps_->derivatives, maps_->hydrology, maps_->tree_cover, maps_->passage, stages_.opened};
  }
  [[nodiscard]] InputPointers level_pointers() const {
    InputPointers inputs = ground_pointers();
    inputs.insert(inputs.end(), maps_->animals.begin(), maps_->animals.end());
    return inputs;
  }

  const Document& document_;
  SolveCache::Stages& stages_;
  bool lasts_;
  const TaskContext& context_;
  const PublishPartial& publish_;
  std::shared_ptr<MapsSnapshot> maps_;
  std::shared_ptr<const FoodWeb> biology_;
  bool shown_nearby_ = false;
  /// Whether all that lives was shown by the schedule of before.
  bool balancing_ = false;
  StageClock clock_;
};

Status Run::species() {
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

Status Run::ground() {
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

Status Run::slopes() {
  update_slopes(stages_.slopes, stages_.land);
  maps_->derivatives = stages_.slopes.derivatives.newest();
  return {};
}

/// A small change of the ground is answered around it with the water of before, so that slopes, light, temperature and plants
/// keep up with the brush. Only shown: what it made is stale wherever the exact maps turn out to be others.
Status Run::nearby() {
  maps_->plant_desired = desired(0);
  const EnvironmentInput input = environment_input();
  const PlantStage& plants = stages_.plants;
  if (!publish_ || !can_answer_nearby(stages_.environment, input)) return {};
  if (!can_answer_plants_near(plants, *biology_, *stages_.environment.maps, maps_->plant_desired)) return {};
  const TileSet near = update_environment_nearby(stages_.environment, input);
  MapsSnapshot shown = *maps_;
  shown.hydrology = stages_.water.newest();
  shown.environment = stages_.environment.maps;
  const Status done = update_plants(stages_.plants, *biology_, shown.plant_environment(), stages_.environment.changes,
                                    maps_->plant_desired, &near, context_);
  if (!done) return done;
  painted_plants(stages_, shown);
  if (context_.stopped()) return fail(stopped_message);
  shown_nearby_ = true;
  publish_(std::make_shared<MapsSnapshot>(std::move(shown)));
  return {};
}

Status Run::water() {
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

Status Run::environment() {
  if (Status done = update_environment(stages_.environment, environment_input(), context_); !done) return done;
  if (!lasts_) stages_.environment.soil.forget_passes();
  maps_->environment = stages_.environment.maps;
  return {};
}

/// Shares are of the whole land: an edit anywhere may move every plant a little. So plants compete by the schedule of before
/// first, where their cells changed, and animals, trails and plans follow from that; the schedule is found anew afterwards.
Status Run::life_as_before() {
  const EnvironmentMaps& maps = *maps_->environment;
  if (!publish_ || maps_->plant_desired.empty()) return {};
  if (!can_answer_plants_near(stages_.plants, *biology_, maps, maps_->plant_desired)) return {};
  const auto as_it_was = std::make_shared<MapsSnapshot>(*maps_);
  if (Status done = perform({{"plants", &Run::plants_as_before}}); !done) return done;
  if (!maps_->balanced) {
    if (Status done = life_on_plants(); !done) return done;
    publish_(whole_snapshot());
    balancing_ = true;
  }
  maps_ = as_it_was;
  return {};
}

Status Run::plants_as_before() {
  TileSet everywhere(maps_->environment->geology->width(), maps_->environment->geology->height());
  everywhere.insert(maps_->environment->geology->rect());
  const Status done = update_plants(stages_.plants, *biology_, maps_->plant_environment(), stages_.environment.changes,
                                    maps_->plant_desired, &everywhere, context_);
  if (!done) return done;
  maps_->balanced = !stages_.plants.schedule_stale;
  painted_plants(stages_, *maps_);
  return {};
}

Status Run::plants() {
  const Status done = update_plants(stages_.plants, *biology_, maps_->plant_environment(), stages_.environment.changes,
                                    maps_->plant_desired, nullptr, context_);
  if (!done) return done;
  painted_plants(stages_, *maps_);
  return {};
}

Status Run::animal_level(std::size_t index) {
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

Status Run::animals() {
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

Status Run::travel() {
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

Status Run::trails() {
  InputPointers inputs = level_pointers();
  inputs.push_back(maps_->graph);
  inputs.push_back(maps_->places);
  return keep(maps_->trails, stages_.trails.get(inputs, [&] {
    return compute_trails(*maps_->web, maps_->animals, maps_->movement, maps_->ground(), context_, &stages_.travelled);
  }));
}

Status Run::daily_plans() {
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

Status Run::overpainted() {
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

}  // namespace

void SolveCache::release_unused() { release_memory(*stages_); }

Result<std::shared_ptr<const MapsSnapshot>> solve(const Document& document, SolveCache* cache, const TaskContext& context,
                                                  const PublishPartial& publish) {
  if (const Status usable = check_inputs(document); !usable) return tl::unexpected<Error>(usable.error());
  SolveCache own;
  return Run(document, (cache ? *cache : own).stages(), cache != nullptr, context, publish).all();
}

}  // namespace biotope

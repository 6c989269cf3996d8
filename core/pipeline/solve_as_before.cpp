#include "core/pipeline/solve_run.hpp"

namespace biotope {

/// A small change of the ground is answered around it with the water of before, so that slopes, light, temperature and plants
/// keep up with the brush. Only shown: what it made is stale wherever the exact maps turn out to be others.
Status SolveRun::nearby() {
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

/// Shade reaches far beyond a changed ground. Where much of it does, it follows after everything else has: animals, trails and
/// plans are answered with the shade of before.
Status SolveRun::environment_as_before() { return environment_with(publish_ ? FarShade::may_wait : FarShade::exact); }

/// Shares are of the whole land: an edit anywhere may move every plant a little. So plants compete by the schedule of before
/// first, where their cells changed, and animals, trails and plans follow from that; the schedule is found anew afterwards. So it
/// is where shade waits.
Status SolveRun::life_as_before() {
  const EnvironmentMaps& maps = *maps_->environment;
  if (!publish_ || (maps_->shaded && maps_->plant_desired.empty())) return {};
  if (!can_answer_plants_near(stages_.plants, *biology_, maps, maps_->plant_desired)) return {};
  const auto as_it_was = std::make_shared<MapsSnapshot>(*maps_);
  if (Status done = perform({{"plants", &SolveRun::plants_as_before}}); !done) return done;
  if (!maps_->exact()) {
    if (Status done = life_on_plants(); !done) return done;
    publish_(whole_snapshot());
    shown_as_before_ = true;
  }
  maps_ = as_it_was;
  return {};
}

Status SolveRun::plants_as_before() {
  TileSet everywhere(maps_->environment->geology->width(), maps_->environment->geology->height());
  everywhere.insert(maps_->environment->geology->rect());
  const Status done = update_plants(stages_.plants, *biology_, maps_->plant_environment(), stages_.environment.changes,
                                    maps_->plant_desired, &everywhere, context_);
  if (!done) return done;
  maps_->balanced = !stages_.plants.schedule_stale;
  painted_plants(stages_, *maps_);
  return {};
}

}  // namespace biotope

#include <chrono>
#include <cmath>
#include <utility>

#include "render/animal_renderer.hpp"
#include "render/animal_world.hpp"

namespace biotope {

/// Whether the world has become another.
bool AnimalRenderer::moves_on(const MapsSnapshot& maps, bool same_details) const {
  const bool same = world_ && same_details && world_->plans == maps.plans && world_->graph == maps.graph &&
                    world_->web == maps.web && world_->ground.terrain == maps.surface() &&
                    world_->ground.hydrology == maps.hydrology && world_->ground.derivatives == maps.derivatives &&
                    world_->levels == maps.animals && world_->seed == maps.document.seed;
  return !same;
}

void AnimalRenderer::retire_world() {
  wading_ = {};
  if (simulation_) thread_.retire(std::shared_ptr<const HerdSimulation>(std::move(simulation_)));
  thread_.retire(std::exchange(world_, nullptr));
  thread_.retire(std::exchange(shore_, nullptr));
  thread_.retire(std::exchange(surroundings_, nullptr));
}

bool AnimalRenderer::finish_change(bool wait) {
  if (!change_) return true;
  if (!wait && change_->done.wait_for(std::chrono::seconds(0)) != std::future_status::ready) return false;
  change_->done.get();
  if (change_->placed) {
    placed_ = std::move(*change_->placed);
    change_.reset();
    return true;
  }
  auto simulation = change_->simulation ? std::move(change_->simulation) : std::move(simulation_);
  retire_world();
  shore_ = std::move(change_->shore);
  surroundings_ = std::move(change_->surroundings);
  world_ = std::move(change_->world);
  wading_ = AnimalWading(world_);
  if (world_) simulation_ = std::move(simulation);
  // Herds of the world before are none of this one.
  placed_ = std::move(change_->arrived);
  change_.reset();
  return true;
}

void AnimalRenderer::change_world(const MapsSnapshot& maps, std::shared_ptr<const ShoreMap> shore, const PlantPlacement& trees,
                                  bool same_details) {
  change_ = std::make_unique<Change>();
  change_->shore = std::move(shore);
  const auto follow = [change = change_.get(), maps, trees, same_details, before = surroundings_, look = looked_,
                       followed = simulation_.get()] {
    change->surroundings =
        same_details ? before
                     : std::make_shared<const AnimalSurroundings>(change->shore, maps.terrain().cell_size, trees, before);
    change->world = herd_world(maps, change->surroundings);
    if (!change->world) return;
    if (followed != nullptr) {
      followed->follow(change->world);
    } else {
      change->simulation = std::make_unique<HerdSimulation>(change->world);
    }
    if (!look || !look->options.animals) return;
    // What the next picture needs is found here too.
    HerdSimulation& simulation = followed != nullptr ? *followed : *change->simulation;
    Placed& arrived = change->arrived;
    arrived.requests = herds_near(*change->world, *look);
    arrived.hour = look->options.hour;
    arrived.herds = simulation.animals(arrived.requests, arrived.hour);
  };
  change_->done = thread_.start(follow);
}

void AnimalRenderer::set_world(const MapsSnapshot& maps, std::shared_ptr<const ShoreMap> shore, const PlantPlacement& trees,
                               bool at_once) {
  const bool changing = change_ != nullptr && !change_->placed;
  may_lag_ = !at_once;
  if (!finish_change(at_once)) return;
  if (!maps.plans || !maps.graph || !maps.web) {
    retire_world();
    behind_ = false;
    return;
  }
  const bool same_details = surroundings_ && shore_ == shore && surroundings_->trees_of() == trees.snapshot();
  behind_ = moves_on(maps, same_details);
  // What a change has found is shown before the next: the herds that are placed belong to one world.
  if (!behind_ || (changing && !at_once)) return;
  behind_ = false;
  // Where the animals that are shown mean nothing in the new world there are none until it is known.
  const bool goes_on = world_ && simulation_ && same_extent(world_->terrain(), maps.terrain());
  if (!goes_on) retire_world();
  change_world(maps, std::move(shore), trees, same_details && goes_on);
  static_cast<void>(finish_change(at_once));
}

bool AnimalRenderer::jumps_to(double hour) const {
  if (!may_lag_ || change_ || behind_ || placed_.herds.empty()) return false;
  constexpr double most_seconds = 30;
  const double apart = std::abs(std::remainder(hour - placed_.hour, 24.0));
  return apart * 3600 > most_seconds;
}

void AnimalRenderer::jump(const Look& look) {
  change_ = std::make_unique<Change>();
  change_->placed.emplace();
  change_->done = thread_.start([change = change_.get(), world = world_, look, simulation = simulation_.get()] {
    Placed& placed = *change->placed;
    placed.requests = herds_near(*world, look);
    placed.hour = look.options.hour;
    placed.herds = simulation->animals(placed.requests, placed.hour);
  });
}

}  // namespace biotope

#include <chrono>
#include <cmath>
#include <numeric>
#include <utility>

#include "render/animal_renderer.hpp"
#include "render/animal_world.hpp"

namespace biotope {

namespace {

/// Animals that are placed in a frame of a window: more take longer than 4 ms.
constexpr std::size_t most_at_once = 800;

}  // namespace

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
    bytes_ = simulation_->bytes();
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
    change->arrived = placed_herds(simulation, *change->world, *look);
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

AnimalRenderer::Placed AnimalRenderer::placed_herds(HerdSimulation& simulation, const HerdWorld& world, const Look& look) {
  Placed placed;
  placed.requests = herds_near(world, look);
  placed.herds = simulation.animals(placed.requests, look.options.hour);
  placed.look = look;
  return placed;
}

bool AnimalRenderer::leaps_to(const Look& look) const {
  constexpr double most_seconds = 30;
  if (!placed_.look) return true;
  const double apart = std::abs(std::remainder(look.options.hour - placed_.look->options.hour, 24.0));
  return apart * 3600 > most_seconds;
}

std::size_t AnimalRenderer::Placed::animals() const {
  return std::accumulate(herds.begin(), herds.end(), std::size_t(0),
                         [](std::size_t sum, const auto& herd) { return sum + herd.size(); });
}

void AnimalRenderer::place_herds(const Look& look) {
  if (change_) return;
  const bool same = placed_.look && placed_.look->eye == look.eye && placed_.look->options.hour == look.options.hour &&
                    placed_.look->options.quality == look.options.quality &&
                    placed_.look->options.visible_species == look.options.visible_species;
  if (same) return;
  if (may_lag_ && !behind_ && (leaps_to(look) || placed_.animals() > most_at_once)) return place_elsewhere(look);
  placed_ = placed_herds(*simulation_, *world_, look);
  bytes_ = simulation_->bytes();
}

void AnimalRenderer::place_elsewhere(const Look& look) {
  change_ = std::make_unique<Change>();
  change_->placed.emplace();
  change_->done = thread_.start([change = change_.get(), world = world_, look, simulation = simulation_.get()] {
    change->placed = placed_herds(*simulation, *world, look);
  });
}

}  // namespace biotope

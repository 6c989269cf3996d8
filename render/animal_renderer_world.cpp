#include <chrono>
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

bool AnimalRenderer::finish_change(bool wait) {
  if (!change_) return true;
  if (!wait && change_->done.wait_for(std::chrono::seconds(0)) != std::future_status::ready) return false;
  change_->done.get();
  shore_ = std::move(change_->shore);
  surroundings_ = std::move(change_->surroundings);
  world_ = std::move(change_->world);
  wading_ = AnimalWading(world_);
  if (!world_) simulation_.reset();
  change_.reset();
  return true;
}

void AnimalRenderer::change_world(const MapsSnapshot& maps, std::shared_ptr<const ShoreMap> shore, const PlantPlacement& trees,
                                  bool same_details) {
  change_ = std::make_unique<Change>();
  change_->shore = std::move(shore);
  const auto follow = [change = change_.get(), maps, trees, same_details, before = surroundings_, placed = placed_,
                       simulation = simulation_.get()] {
    change->surroundings =
        same_details ? before
                     : std::make_shared<const AnimalSurroundings>(change->shore, maps.terrain().cell_size, trees, before);
    change->world = herd_world(maps, change->surroundings);
    if (!change->world) return;
    if (simulation != nullptr) simulation->follow(change->world);
    // What the next picture needs is found here too.
    if (simulation != nullptr && change->world->plans->size() > 0) {
      std::vector<HerdRequest> known = placed.requests;
      std::erase_if(known, [&](const HerdRequest& one) { return std::size_t(one.plan) >= change->world->plans->size(); });
      static_cast<void>(simulation->animals(known, placed.hour));
    }
  };
  change_->done = std::async(std::launch::async, follow);
}

void AnimalRenderer::set_world(const MapsSnapshot& maps, std::shared_ptr<const ShoreMap> shore, const PlantPlacement& trees,
                               bool at_once) {
  const bool changing = change_ != nullptr;
  if (!finish_change(at_once)) return;
  const bool same_details = surroundings_ && shore_ == shore && surroundings_->trees_of() == trees.snapshot();
  behind_ = moves_on(maps, same_details);
  // What a change has found is shown before the next: the herds that are placed belong to one world.
  if (!behind_ || (changing && !at_once)) return;
  behind_ = false;
  // Where the animals that are shown mean nothing in the new world there is nothing to wait with.
  const bool goes_on = world_ && simulation_ && world_->web == maps.web && same_extent(world_->terrain(), maps.terrain());
  change_world(maps, std::move(shore), trees, same_details);
  static_cast<void>(finish_change(at_once || !goes_on));
  if (!simulation_ && world_) simulation_ = std::make_unique<HerdSimulation>(world_);
}

}  // namespace biotope

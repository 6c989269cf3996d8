#include "render/animal_surroundings.hpp"

#include <algorithm>
#include <cmath>
#include <mutex>

namespace biotope {

namespace {

/// Radius of a trunk's foot as a share of the tree's height: those of grown trees in plant_models_trees.cpp, with what the roots
/// spread.
constexpr double trunk_share = 0.024;
/// Blocks that are kept: some 40 km2.
constexpr std::size_t most_blocks = 10000;

int block_of(double metres) { return int(std::floor(metres / double(woody_block_side))); }

}  // namespace

AnimalSurroundings::AnimalSurroundings(std::shared_ptr<const ShoreMap> shore, double cell_size, PlantPlacement placement,
                                       std::shared_ptr<const AnimalSurroundings> before)
    : shore_(std::move(shore)), shore_cell_(shore_ ? cell_size / shore_->scale : cell_size), placement_(std::move(placement)) {
  const MapsSnapshot* maps = placement_.snapshot();
  if (!maps || !maps->web || maps->web->levels.empty()) return;
  for (const int species : maps->web->levels[0]) {
    const PlantTraits& traits = maps->web->species[std::size_t(species)].plant();
    heights_.push_back(traits.stratum == Stratum::tree ? traits.shape.height : 0);
  }
  if (!before || before->blocks_.size() > most_blocks || !same_plants(*before)) return;
  const PlantChanges changes(before->placement_.ground(), placement_.ground());
  constexpr auto side = double(woody_block_side);
  for (const auto& [place, trees] : before->blocks_) {
    if (!changes.within(Stratum::tree, place.second * side, place.first * side, side)) blocks_.emplace(place, trees);
  }
}

/// Whether plants of all species grow by the same rules, on maps of the same cells.
bool AnimalSurroundings::same_plants(const AnimalSurroundings& other) const {
  const MapsSnapshot* a = placement_.snapshot();
  const MapsSnapshot* b = other.placement_.snapshot();
  if (!a || !b || a->document.seed != b->document.seed || heights_ != other.heights_) return false;
  if (a->terrain().height.rect() != b->terrain().height.rect() || a->terrain().cell_size != b->terrain().cell_size) return false;
  const auto& plants = a->web->levels[0];
  return a->web == b->web || (plants == b->web->levels[0] && std::all_of(plants.begin(), plants.end(), [&](int i) {
                                return a->web->species[std::size_t(i)].traits == b->web->species[std::size_t(i)].traits;
                              }));
}

std::optional<float> AnimalSurroundings::shore(Place place) const {
  if (!shore_ || shore_->codes.empty()) return std::nullopt;
  const int x = int(std::floor(place.x / shore_cell_));
  const int y = shore_->codes.height() - 1 - int(std::floor(place.y / shore_cell_));
  return shore_distance(shore_->codes.clamped(x, y));
}

std::vector<Stem> AnimalSurroundings::grown(int column, int row) const {
  std::vector<Stem> stems;
  for (const PlantInstance& plant : placement_.block(Stratum::tree, column, row)) {
    const double height = double(heights_[std::size_t(plant.plant)]) * double(plant.scale);
    stems.push_back({{double(plant.x), double(plant.y)}, trunk_share * height});
  }
  std::sort(stems.begin(), stems.end(),
            [](const Stem& a, const Stem& b) { return std::pair(a.at.y, a.at.x) < std::pair(b.at.y, b.at.x); });
  return stems;
}

AnimalSurroundings::Block AnimalSurroundings::block(int column, int row) const {
  {
    const std::shared_lock reading(lock_);
    const auto found = blocks_.find({row, column});
    if (found != blocks_.end()) return found->second;
  }
  auto made = std::make_shared<const std::vector<Stem>>(grown(column, row));
  const std::unique_lock writing(lock_);
  return blocks_.try_emplace({row, column}, std::move(made)).first->second;
}

void AnimalSurroundings::stems(Place low, Place high, std::vector<Stem>& stems) const {
  if (!placement_.snapshot()) return;
  for (int row = block_of(low.y); row <= block_of(high.y); ++row) {
    for (int column = block_of(low.x); column <= block_of(high.x); ++column) {
      const Block trees = block(column, row);
      const auto first =
          std::lower_bound(trees->begin(), trees->end(), low.y, [](const Stem& stem, double y) { return stem.at.y < y; });
      for (auto stem = first; stem != trees->end() && stem->at.y < high.y; ++stem) {
        if (stem->at.x >= low.x && stem->at.x < high.x) stems.push_back(*stem);
      }
    }
  }
}

bool AnimalSurroundings::same_shore(const AnimalSurroundings& other, Place low, Place high) const {
  if (shore_ == other.shore_) return true;
  if (!shore_ || !other.shore_ || shore_->scale != other.shore_->scale || shore_->codes.height() != other.shore_->codes.height())
    return false;
  const int top = shore_->codes.height() - 1 - int(std::floor(high.y / shore_cell_));
  const int bottom = shore_->codes.height() - 1 - int(std::floor(low.y / shore_cell_));
  const int left = int(std::floor(low.x / shore_cell_));
  const int right = int(std::floor(high.x / shore_cell_));
  for (int y = top; y <= bottom; ++y) {
    for (int x = left; x <= right; ++x) {
      if (shore_->codes.clamped(x, y) != other.shore_->codes.clamped(x, y)) return false;
    }
  }
  return true;
}

bool AnimalSurroundings::same_within(const HerdDetails& other, Place low, Place high) const {
  const auto* before = dynamic_cast<const AnimalSurroundings*>(&other);
  if (!before || !same_shore(*before, low, high)) return false;
  for (int row = block_of(low.y); row <= block_of(high.y); ++row) {
    for (int column = block_of(low.x); column <= block_of(high.x); ++column) {
      const auto has = [&](const AnimalSurroundings& all) {
        const auto found = all.blocks_.find({row, column});
        return found == all.blocks_.end() ? nullptr : found->second;
      };
      // Trees that nobody asked for are nothing that anybody's place depends on.
      const Block then = has(*before);
      if (!then) continue;
      const Block now = has(*this);
      if (now != then && (!now || *now != *then)) return false;
    }
  }
  return true;
}

}  // namespace biotope

#include "render/plant_blocks.hpp"

#include <algorithm>
#include <cmath>

#include "core/base/parallel.hpp"
#include "render/changed_tiles.hpp"

namespace biotope {

namespace {

/// Blocks that are built side by side between two looks at the clock.
constexpr std::ptrdiff_t blocks_at_once = 8;

/// True when the plants of two webs stand by the same rules, so that blocks of one are good for the other.
bool same_plants(const MapsSnapshot& a, const MapsSnapshot& b) {
  if (a.web == b.web) return true;
  if (!a.web || !b.web || a.web->levels.empty() || b.web->levels.empty() || a.web->levels[0] != b.web->levels[0]) return false;
  return std::all_of(a.web->levels[0].begin(), a.web->levels[0].end(),
                     [&](int i) { return a.web->species[std::size_t(i)].traits == b.web->species[std::size_t(i)].traits; });
}

}  // namespace

void PlantBlocks::set_snapshot(std::shared_ptr<const MapsSnapshot> snapshot, std::shared_ptr<const GroundLines> lines) {
  const std::shared_ptr<const MapsSnapshot> before = std::move(snapshot_);
  const std::shared_ptr<const GroundLines> lines_before = std::move(lines_);
  snapshot_ = std::move(snapshot);
  lines_ = std::move(lines);
  const bool eaten_otherwise = follow_grazing(before.get());
  placement_ = PlantPlacement(snapshot_, lines_ && snapshot_->hydrology ? lines_->shore : nullptr, grazing_);
  const bool kept = before && same_extent(before->terrain(), snapshot_->terrain()) &&
                    before->document.seed == snapshot_->document.seed && same_plants(*before, *snapshot_) &&
                    before->cover.size() == snapshot_->cover.size();
  if (kept) {
    mark_changed(*before, lines_before.get());
    for (auto& [place, block] : blocks_[std::size_t(Stratum::herb)]) block.stale = block.stale || eaten_otherwise;
  } else {
    blocks_ = {};
  }
}

bool PlantBlocks::follow_grazing(const MapsSnapshot* before) {
  // Until the animals of an edit are known, herbs stay as those before it left them.
  const bool known =
      snapshot_->complete || !before || before->web != snapshot_->web || !same_extent(before->terrain(), snapshot_->terrain());
  if (!known) return false;
  auto now = std::make_shared<const Grazing>(*snapshot_);
  if (grazing_ && now->same_as(*grazing_)) return false;
  grazing_ = std::move(now);
  return true;
}

void PlantBlocks::mark_changed(const MapsSnapshot& before, const GroundLines* lines_before) {
  Grid<std::uint8_t> changed = changed_cover(*snapshot_, before);
  const TiledMap<std::uint8_t>* now = lines_ ? &lines_->trodden : nullptr;
  const TiledMap<std::uint8_t>* then = lines_before != nullptr ? &lines_before->trodden : nullptr;
  const bool comparable = now != nullptr && then != nullptr && now->rect() == then->rect();
  const bool other_ground = before.surface() != snapshot_->surface() || before.hydrology != snapshot_->hydrology;
  if (other_ground || (before.trails != snapshot_->trails && !comparable)) {
    std::fill(changed.cells().begin(), changed.cells().end(), std::uint8_t(1));
  } else if (comparable) {
    for (std::size_t tile = 0; tile < now->tile_count(); ++tile) {
      if (now->tile(tile) != then->tile(tile)) changed[tile] = 1;
    }
  }
  mark(changed);
}

void PlantBlocks::mark(const Grid<std::uint8_t>& tiles) {
  const Terrain& terrain = snapshot_->terrain();
  const double side = tile_side * terrain.cell_size;
  const double north = terrain.height_metres();
  for (int s = 0; s < strata; ++s) {
    const double block = PlantPlacement::block_side(Stratum(s));
    for (auto& [place, plants] : blocks_[std::size_t(s)]) {
      // A block that only touches a tile's border has nothing of it.
      const int x0 = std::max(0, int(std::floor(place.second * block / side)));
      const int x1 = std::min(tiles.width(), int(std::ceil((place.second + 1) * block / side)));
      const int y0 = std::max(0, int(std::floor((north - (place.first + 1) * block) / side)));
      const int y1 = std::min(tiles.height(), int(std::ceil((north - place.first * block) / side)));
      for (int y = y0; y < y1 && !plants.stale; ++y) {
        for (int x = x0; x < x1 && !plants.stale; ++x) plants.stale = tiles(x, y) != 0;
      }
    }
  }
}

std::vector<std::pair<int, int>> PlantBlocks::missing(Stratum stratum, double x, double y, float reach) const {
  const Terrain& terrain = snapshot_->terrain();
  const double side = PlantPlacement::block_side(stratum);
  const Map& have = blocks_[std::size_t(stratum)];
  const auto range = [&](double centre, double extent) {
    return std::pair(std::max(0, int(std::floor((centre - reach) / side))),
                     std::min(int(std::ceil(extent / side)), int(std::floor((centre + reach) / side)) + 1));
  };
  const auto [x0, x1] = range(x, terrain.width_metres());
  const auto [y0, y1] = range(y, terrain.height_metres());
  std::vector<std::pair<int, int>> out;
  const auto distance = [&](const std::pair<int, int>& place) {
    return std::hypot((place.second + 0.5) * side - x, (place.first + 0.5) * side - y);
  };
  for (int row = y0; row < y1; ++row) {
    for (int column = x0; column < x1; ++column) {
      if (distance({row, column}) > double(reach) + side) continue;
      const auto found = have.find({row, column});
      if (found == have.end() || found->second.stale) out.emplace_back(row, column);
    }
  }
  std::sort(out.begin(), out.end(),
            [&](const auto& a, const auto& b) { return std::pair(distance(a), a) < std::pair(distance(b), b); });
  return out;
}

void PlantBlocks::fill(Stratum stratum, std::pair<int, int> place, PlantBlock& block, std::uint32_t version) const {
  block.plants = placement_.block(stratum, place.second, place.first);
  block.stale = false;
  block.version = version;
  if (block.plants.empty()) return;
  const auto [low, high] =
      std::minmax_element(block.plants.begin(), block.plants.end(), [](const auto& a, const auto& b) { return a.z < b.z; });
  block.low = low->z;
  block.high = high->z;
}

bool PlantBlocks::build(Stratum stratum, double x, double y, float reach, std::chrono::steady_clock::time_point until) {
  if (!snapshot_) return true;
  const auto wanted = missing(stratum, x, y, reach);
  float& whole_to = whole_to_[std::size_t(stratum)];
  whole_to = reach;
  if (wanted.empty()) return true;
  drop_far(stratum, x, y, reach);
  Map& blocks = blocks_[std::size_t(stratum)];
  for (auto place = wanted.begin(); place != wanted.end();) {
    if (std::chrono::steady_clock::now() >= until) {
      // Blocks that only changed still have their old plants.
      const auto lacking = std::find_if(place, wanted.end(), [&](const auto& other) { return !blocks.contains(other); });
      if (lacking == wanted.end()) return false;
      const double side = PlantPlacement::block_side(stratum);
      const double away = std::hypot((lacking->second + 0.5) * side - x, (lacking->first + 0.5) * side - y);
      whole_to = float(std::clamp(away - side, 0.0, double(reach)));
      return false;
    }
    const auto end = place + std::min<std::ptrdiff_t>(blocks_at_once, wanted.end() - place);
    fill_all(stratum, {place, end});
    place = end;
  }
  return true;
}

void PlantBlocks::fill_all(Stratum stratum, std::span<const std::pair<int, int>> places) {
  std::vector<PlantBlock*> blocks;
  blocks.reserve(places.size());
  for (const auto& place : places) blocks.push_back(&blocks_[std::size_t(stratum)][place]);
  parallel_each(places.size(), [&](std::size_t i) { fill(stratum, places[i], *blocks[i], versions_ + 1 + std::uint32_t(i)); });
  versions_ += std::uint32_t(places.size());
}

void PlantBlocks::build_all(Stratum stratum, double x, double y, float reach) {
  if (!snapshot_) return;
  const auto wanted = missing(stratum, x, y, reach);
  whole_to_[std::size_t(stratum)] = reach;
  drop_far(stratum, x, y, reach);
  fill_all(stratum, wanted);
}

void PlantBlocks::drop_far(Stratum stratum, double x, double y, float reach) {
  const double side = PlantPlacement::block_side(stratum);
  std::erase_if(blocks_[std::size_t(stratum)], [&](const auto& entry) {
    const auto [row, column] = entry.first;
    return std::hypot((column + 0.5) * side - x, (row + 0.5) * side - y) > 1.6 * double(reach) + 2 * side;
  });
}

std::size_t PlantBlocks::bytes() const {
  std::size_t sum = 0;
  for (const Map& map : blocks_) {
    for (const auto& [place, block] : map) sum += block.plants.capacity() * sizeof(PlantInstance);
  }
  return sum;
}

}  // namespace biotope

#include "render/plant_blocks.hpp"

#include <algorithm>
#include <cmath>

#include "core/base/parallel.hpp"

namespace biotope {

namespace {

/// True when the plants of two webs stand by the same rules, so that blocks of one are good for the other.
bool same_plants(const MapsSnapshot& a, const MapsSnapshot& b) {
  if (a.web == b.web) return true;
  if (!a.web || !b.web || a.web->levels.empty() || b.web->levels.empty() || a.web->levels[0] != b.web->levels[0]) return false;
  return std::all_of(a.web->levels[0].begin(), a.web->levels[0].end(),
                     [&](int i) { return a.web->species[std::size_t(i)].traits == b.web->species[std::size_t(i)].traits; });
}

/// Longest side of the grid on which plants ask for water, cells.
constexpr int longest_shore = 2048;

std::shared_ptr<const ShoreMap> drawn_shore(const Terrain& terrain, const Hydrology& hydrology) {
  const int scale = line_field_scale(terrain.height.width(), terrain.height.height(), longest_shore);
  return std::make_shared<const ShoreMap>(ShoreMap{scale, shore_field(terrain, hydrology, scale)});
}

}  // namespace

void PlantBlocks::set_snapshot(std::shared_ptr<const MapsSnapshot> snapshot) {
  const std::shared_ptr<const MapsSnapshot> before = std::move(snapshot_);
  snapshot_ = std::move(snapshot);
  if (!before || before->hydrology != snapshot_->hydrology || before->document.terrain != snapshot_->document.terrain) {
    shore_ = snapshot_->hydrology ? drawn_shore(snapshot_->terrain(), *snapshot_->hydrology) : nullptr;
  }
  placement_ = PlantPlacement(snapshot_, shore_);
  const bool kept = before && before->document.terrain == snapshot_->document.terrain &&
                    before->document.seed == snapshot_->document.seed && same_plants(*before, *snapshot_) &&
                    before->cover.size() == snapshot_->cover.size();
  if (!kept) {
    blocks_ = {};
    return;
  }
  mark_changed(*before);
}

void PlantBlocks::mark_changed(const MapsSnapshot& before) {
  const Rect all = snapshot_->terrain().height.rect();
  if (before.hydrology != snapshot_->hydrology) mark(all);
  for (std::size_t i = 0; i < snapshot_->cover.size(); ++i) {
    const auto& now = snapshot_->cover[i];
    const auto& then = before.cover[i];
    if (now == then) continue;
    if (!now || !then || now->tile_count() != then->tile_count()) {
      mark(all);
      continue;
    }
    for (std::size_t tile = 0; tile < now->tile_count(); ++tile) {
      if (now->tile(tile) != then->tile(tile)) mark(now->tile_rect(tile));
    }
  }
  if (before.trails == snapshot_->trails) return;
  const bool both = before.trails && snapshot_->trails && before.trails->wear.rect() == snapshot_->trails->wear.rect();
  if (!both) {
    mark(all);
    return;
  }
  for (int y = 0; y < all.y1; y += tile_side) {
    for (int x = 0; x < all.x1; x += tile_side) {
      const Rect part = intersection({x, y, x + tile_side, y + tile_side}, snapshot_->trails->wear.rect());
      bool differs = false;
      for (int row = part.y0; row < part.y1 && !differs; ++row) {
        const auto now = snapshot_->trails->wear.row(row).subspan(std::size_t(part.x0), std::size_t(part.width()));
        const auto then = before.trails->wear.row(row).subspan(std::size_t(part.x0), std::size_t(part.width()));
        differs = !std::equal(now.begin(), now.end(), then.begin());
      }
      if (differs) mark(part);
    }
  }
}

void PlantBlocks::mark(const Rect& cells) {
  const Terrain& terrain = snapshot_->terrain();
  const double west = cells.x0 * terrain.cell_size;
  const double east = cells.x1 * terrain.cell_size;
  const double south = (terrain.height.height() - cells.y1) * terrain.cell_size;
  const double north = (terrain.height.height() - cells.y0) * terrain.cell_size;
  for (int s = 0; s < strata; ++s) {
    const double side = PlantPlacement::block_side(Stratum(s));
    for (auto& [place, block] : blocks_[std::size_t(s)]) {
      const auto [row, column] = place;
      if (column * side < east && (column + 1) * side > west && row * side < north && (row + 1) * side > south)
        block.stale = true;
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

void PlantBlocks::fill(Stratum stratum, std::pair<int, int> place, PlantBlock& block) const {
  block.plants = placement_.block(stratum, place.second, place.first);
  block.stale = false;
  if (block.plants.empty()) return;
  const auto [low, high] =
      std::minmax_element(block.plants.begin(), block.plants.end(), [](const auto& a, const auto& b) { return a.z < b.z; });
  block.low = low->z;
  block.high = high->z;
}

bool PlantBlocks::build(Stratum stratum, double x, double y, float reach, std::chrono::steady_clock::time_point until) {
  if (!snapshot_) return true;
  const auto wanted = missing(stratum, x, y, reach);
  if (wanted.empty()) return true;
  drop_far(stratum, x, y, reach);
  for (const auto& place : wanted) {
    if (std::chrono::steady_clock::now() >= until) return false;
    fill(stratum, place, blocks_[std::size_t(stratum)][place]);
  }
  return true;
}

void PlantBlocks::build_all(Stratum stratum, double x, double y, float reach) {
  if (!snapshot_) return;
  const auto wanted = missing(stratum, x, y, reach);
  drop_far(stratum, x, y, reach);
  std::vector<PlantBlock*> blocks;
  blocks.reserve(wanted.size());
  for (const auto& place : wanted) blocks.push_back(&blocks_[std::size_t(stratum)][place]);
  parallel_each(wanted.size(), [&](std::size_t i) { fill(stratum, wanted[i], *blocks[i]); });
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

#include "render/plant_ground.hpp"

#include <algorithm>
#include <cmath>

#include "render/plant_placement.hpp"

namespace biotope {

namespace {

template <class T>
bool other_cells(const Grid<T>& a, const Grid<T>& b, const Rect& cells) {
  for (int y = cells.y0; y < cells.y1; ++y) {
    const auto mine = a.row(y).subspan(std::size_t(cells.x0), std::size_t(cells.width()));
    const auto its = b.row(y).subspan(std::size_t(cells.x0), std::size_t(cells.width()));
    if (!std::equal(mine.begin(), mine.end(), its.begin())) return true;
  }
  return false;
}

bool other_cells(const CoverMap& a, const CoverMap& b, const Rect& cells) {
  for (int y = cells.y0; y < cells.y1;) {
    const int next_y = std::min(cells.y1, (y / tile_side + 1) * tile_side);
    for (int x = cells.x0; x < cells.x1;) {
      const int next_x = std::min(cells.x1, (x / tile_side + 1) * tile_side);
      const std::size_t tile = a.tile_index(x, y);
      if (a.tile(tile) != b.tile(tile)) {
        for (int row = y; row < next_y; ++row) {
          for (int column = x; column < next_x; ++column) {
            if (a(column, row) != b(column, row)) return true;
          }
        }
      }
      x = next_x;
    }
    y = next_y;
  }
  return false;
}

bool trodden(const MapsSnapshot& maps, int x, int y) {
  return maps.trails && !maps.trails->wear.empty() && maps.trails->wear(x, y) > trodden_wear;
}

}  // namespace

Rect cells_under(const Terrain& terrain, double west, double south, double side) {
  const double cell = terrain.cell_size;
  const int rows = terrain.height.height();
  const Rect all{int(std::floor(west / cell)), rows - 1 - int(std::floor((south + side) / cell)),
                 int(std::floor((west + side) / cell)) + 1, rows - int(std::floor(south / cell))};
  return intersection(all, terrain.height.rect());
}

PlantChanges::PlantChanges(PlantGround before, PlantGround now) : before_(std::move(before)), now_(std::move(now)) {
  const MapsSnapshot& a = *before_.maps;
  const MapsSnapshot& b = *now_.maps;
  heights_ = a.surface() != b.surface();
  water_ = a.hydrology != b.hydrology;
  shore_ = before_.shore != now_.shore;
  trails_ = before_.trails != now_.trails || (!now_.trails && a.trails != b.trails);
  floor_ = a.environment != b.environment || a.derivatives != b.derivatives;
  growth_ = before_.grazing != now_.grazing;
  if (!b.web || b.web->levels.empty()) return;
  for (std::size_t i = 0; i < b.cover.size() && i < a.cover.size(); ++i) {
    const auto stratum = std::size_t(b.web->species[std::size_t(b.web->levels[0][i])].plant().stratum);
    eaten_[stratum].push_back(int(i));
    if (a.cover[i] != b.cover[i]) covers_[stratum].push_back(i);
  }
}

bool PlantChanges::any() const {
  return heights_ || water_ || shore_ || trails_ || floor_ || growth_ ||
         std::any_of(covers_.begin(), covers_.end(), [](const auto& changed) { return !changed.empty(); });
}

bool PlantChanges::other_cover(Stratum stratum, const Rect& cells) const {
  return std::any_of(covers_[std::size_t(stratum)].begin(), covers_[std::size_t(stratum)].end(), [&](std::size_t plant) {
    const auto& a = before_.maps->cover[plant];
    const auto& b = now_.maps->cover[plant];
    return !a || !b || a->rect() != b->rect() || other_cells(*a, *b, cells);
  });
}

bool PlantChanges::other_water(const Rect& cells) const {
  const Hydrology* a = before_.maps->hydrology.get();
  const Hydrology* b = now_.maps->hydrology.get();
  if (a == nullptr || b == nullptr) return a != b;
  return other_cells(a->water, b->water, cells) || other_cells(a->water_depth, b->water_depth, cells);
}

bool PlantChanges::other_shore(const Rect& cells) const {
  const ShoreMap* a = before_.shore.get();
  const ShoreMap* b = now_.shore.get();
  if (a == nullptr || b == nullptr || a->scale != b->scale || a->codes.rect() != b->codes.rect()) return a != b;
  const int s = a->scale;
  const Rect fine{(cells.x0 - 1) * s, (cells.y0 - 1) * s, (cells.x1 + 1) * s, (cells.y1 + 1) * s};
  return other_cells(a->codes, b->codes, intersection(fine, a->codes.rect()));
}

bool PlantChanges::other_trails(const Rect& cells, float west, float south, float side) const {
  if (before_.trails && now_.trails) return !now_.trails->same_within(*before_.trails, west, south, side);
  if (before_.trails || now_.trails) return true;
  for (int y = cells.y0; y < cells.y1; ++y) {
    for (int x = cells.x0; x < cells.x1; ++x) {
      if (trodden(*before_.maps, x, y) != trodden(*now_.maps, x, y)) return true;
    }
  }
  return false;
}

bool PlantChanges::other_floor(const Rect& cells) const {
  const MapsSnapshot& a = *before_.maps;
  const MapsSnapshot& b = *now_.maps;
  if (bool(a.derivatives) != bool(b.derivatives) || bool(a.environment) != bool(b.environment)) return true;
  if (a.derivatives && other_cells(a.derivatives->slope, b.derivatives->slope, cells)) return true;
  if (a.environment == b.environment) return false;
  for (int y = cells.y0; y < cells.y1; ++y) {
    for (int x = cells.x0; x < cells.x1; ++x) {
      if (a.environment->map(Resource::moisture).mean(x, y) != b.environment->map(Resource::moisture).mean(x, y)) return true;
    }
  }
  return false;
}

bool PlantChanges::other_growth(Stratum stratum, const Rect& cells) const {
  if (!before_.grazing || !now_.grazing) return true;
  for (const int plant : eaten_[std::size_t(stratum)]) {
    for (int y = cells.y0; y < cells.y1; ++y) {
      for (int x = cells.x0; x < cells.x1; ++x) {
        if (before_.grazing->left(plant, x, y) != now_.grazing->left(plant, x, y)) return true;
      }
    }
  }
  return false;
}

bool PlantChanges::within(Stratum stratum, double west, double south, double side) const {
  const Terrain& terrain = now_.maps->terrain();
  const Rect cells = cells_under(terrain, west, south, side);
  if (cells.empty()) return false;
  if (other_cover(stratum, cells)) return true;
  if (water_ && other_water(cells)) return true;
  if (shore_ && other_shore(cells)) return true;
  if (trails_ && other_trails(cells, float(west), float(south), float(side))) return true;
  // Heights are read between cells.
  const Rect around = intersection(Rect{cells.x0 - 1, cells.y0 - 1, cells.x1 + 1, cells.y1 + 1}, terrain.height.rect());
  if (heights_ && other_cells(before_.maps->terrain().height, terrain.height, around)) return true;
  if (growth_ && stratum != Stratum::tree && other_growth(stratum, cells)) return true;
  // What grows and lies on the floor of a wood comes with the blocks of herbs.
  return stratum == Stratum::herb && (other_cover(Stratum::tree, cells) || (floor_ && other_floor(cells)));
}

}  // namespace biotope

#include "core/ecosystem/confinement.hpp"

#include <algorithm>
#include <atomic>
#include <cmath>

#include "core/base/parallel.hpp"
#include "core/ecosystem/cell_runs.hpp"
#include "core/ecosystem/ford_discs.hpp"
#include "core/ecosystem/obstacle_rows.hpp"

namespace biotope {
namespace {

/// Cells of `a` and `b` hold the same obstacles and passages; tiles that both share are not looked at.
bool same_passage(const PaintLayer* a, const PaintLayer* b) {
  if (a == b) return true;
  const PaintLayer& one = a != nullptr ? *a : *b;
  const PaintLayer none(one.width(), one.height());
  const PaintLayer& other = a != nullptr && b != nullptr ? *b : none;
  if (one.width() != other.width() || one.height() != other.height()) return false;
  for (std::size_t tile = 0; tile < one.tile_count(); ++tile) {
    const auto& before = one.tile(tile);
    const auto& after = other.tile(tile);
    if (before == after && (before || one.background() == other.background())) continue;
    for (std::size_t i = 0; i < std::size_t(tile_side) * tile_side; ++i) {
      const Paint was = before ? (*before)[i] : one.background();
      const Paint is = after ? (*after)[i] : other.background();
      if (passage_of(was) != passage_of(is)) return false;
    }
  }
  return true;
}

/// The same fords and exits; what else is placed blocks nobody.
bool same_openings(const Places* a, const Places* b) {
  if (a == b) return true;
  const Places none;
  const Places& one = a != nullptr ? *a : none;
  const Places& other = b != nullptr ? *b : none;
  return one.fords == other.fords && one.exits == other.exits;
}

ConfinementRegions regions_of(RunTable passable, double cell_size) {
  const Areas areas = connected_areas(passable);
  const std::size_t minimum = minimum_region_cells(cell_size);
  ConfinementRegions result;
  std::vector<std::int32_t> region_of_area(areas.areas.size(), -1);
  for (std::size_t i = 0; i < areas.areas.size(); ++i) {
    const Area& area = areas.areas[i];
    if (area.cells < minimum) continue;
    region_of_area[i] = std::int32_t(result.regions.size());
    result.regions.push_back({area.cells, double(area.cells) * cell_size * cell_size, area.bounds});
  }
  RunTable runs = collect_rows(passable.width, passable.height, [&](int y, std::vector<CellRun>& out) {
    for (std::size_t i = passable.row_start[std::size_t(y)]; i < passable.row_start[std::size_t(y) + 1]; ++i) {
      const std::int32_t region = region_of_area[std::size_t(areas.area_of_run[i])];
      if (region >= 0) out.push_back({passable.runs[i].x0, passable.runs[i].x1, region});
    }
  });
  result.label = RunMap(std::move(runs));
  result.passable = std::make_shared<const RunTable>(std::move(passable));
  return result;
}

/// Marks the rows in which two rasters (null: none) differ.
template <class T>
void mark_rows(const Grid<T>* a, const Grid<T>* b, std::vector<char>& differ) {
  if (a == b) return;
  parallel_rows(0, int(differ.size()), [&](int y) {
    if (a == nullptr || b == nullptr || !std::ranges::equal(a->row(y), b->row(y))) differ[std::size_t(y)] = 1;
  });
}

/// Marks the rows that discs reach which only one of two lists has.
template <class Disc>
void mark_discs(const std::vector<Disc>& a, const std::vector<Disc>& b, std::vector<char>& differ) {
  const auto mark = [&](const std::vector<Disc>& own, const std::vector<Disc>& other) {
    for (const Disc& disc : own) {
      if (std::find(other.begin(), other.end(), disc) != other.end()) continue;
      const auto row = [&](double y) { return std::size_t(std::clamp(y, 0.0, double(differ.size()))); };
      std::fill(differ.begin() + std::ptrdiff_t(row(std::floor(disc.y - disc.radius))),
                differ.begin() + std::ptrdiff_t(row(std::ceil(disc.y + disc.radius) + 1)), 1);
    }
  };
  mark(a, b);
  mark(b, a);
}

/// Discs that placed exits open.
std::vector<FordDisc> exit_discs(const Ground& ground) {
  std::vector<FordDisc> discs;
  if (!ground.places) return discs;
  for (const PlacedExit& exit : ground.places->exits) {
    discs.push_back({double(exit.at.x), double(exit.at.y), place_radius(exit.radius, ground.terrain->cell_size)});
  }
  return discs;
}

/// Marks the rows of the tiles that two layers of paint do not share.
void mark_passage(const Ground& a, const Ground& b, std::vector<char>& differ) {
  if (a.passage == b.passage) return;
  const PaintLayer& layout = a.passage ? *a.passage : *b.passage;
  const auto background = [](const std::shared_ptr<const PaintLayer>& layer) { return layer ? layer->background() : Paint{}; };
  const bool same_background = background(a.passage) == background(b.passage);
  for (std::size_t i = 0; i < layout.tile_count(); ++i) {
    const auto* one = a.passage ? a.passage->tile(i).get() : nullptr;
    const auto* other = b.passage ? b.passage->tile(i).get() : nullptr;
    if (one == other && (one != nullptr || same_background)) continue;
    const Rect cells = layout.tile_rect(i);
    std::fill(differ.begin() + cells.y0, differ.begin() + cells.y1, 1);
  }
}

}  // namespace

std::size_t minimum_region_cells(double cell_size) {
  return std::size_t(std::max(1.0, std::ceil(minimum_region_area / (cell_size * cell_size) - 1e-9)));
}

Mobility mobility_of(const AnimalTraits& animal) {
  return {animal.max_slope, animal.wade_depth, animal.max_tree_cover, animal.slope_sensitivity};
}

bool same_obstacles(const Mobility& a, const Mobility& b) {
  return a.max_slope == b.max_slope && a.wade_depth == b.wade_depth && a.max_tree_cover == b.max_tree_cover;
}

bool same_blocked_cells(const Ground& a, const Ground& b, const Mobility& mobility) {
  if (a.terrain != b.terrain || a.derivatives != b.derivatives || a.hydrology != b.hydrology) return false;
  if (!same_openings(a.places.get(), b.places.get())) return false;
  if (!same_passage(a.passage.get(), b.passage.get())) return false;
  if (a.tree_cover == b.tree_cover) return true;
  if (!a.tree_cover || !b.tree_cover) return false;
  const int most = most_trees(mobility);
  std::atomic<bool> same = true;
  parallel_rows(0, a.tree_cover->height(), [&](int y) {
    const auto before = a.tree_cover->row(y);
    const auto after = b.tree_cover->row(y);
    int changed = 0;
    for (std::size_t x = 0; x < before.size(); ++x) changed |= int((before[x] > most) != (after[x] > most));
    if (changed != 0) same = false;
  });
  return same;
}

Obstacle obstacle_at(const Ground& ground, const Mobility& mobility, int x, int y) {
  return ObstacleRows(ground, mobility).at(x, y);
}

Grid<std::uint8_t> blocked_cells(const Ground& ground, const Mobility& mobility) {
  const ObstacleRows obstacles(ground, mobility);
  Grid<std::uint8_t> blocked(ground.terrain->height.width(), ground.terrain->height.height());
  parallel_rows(0, blocked.height(), [&](int y) { obstacles.fill_row<std::uint8_t>(y, blocked.row(y), 0, 1); });
  return blocked;
}

ConfinementRegions confinement_regions(const Grid<std::uint8_t>& blocked, double cell_size) {
  return regions_of(collect_runs(blocked.width(), blocked.height(),
                                 [&](int y, std::span<std::int64_t> out) {
                                   const auto row = blocked.row(y);
                                   for (std::size_t x = 0; x < out.size(); ++x) out[x] = row[x] != 0 ? -1 : 0;
                                 }),
                    cell_size);
}

ConfinementRegions confinement_regions(const Ground& ground, const Mobility& mobility) {
  const ObstacleRows obstacles(ground, mobility);
  return regions_of(
      collect_runs<std::int8_t>(ground.terrain->height.width(), ground.terrain->height.height(),
                                [&](int y, std::span<std::int8_t> out) { obstacles.fill_row<std::int8_t>(y, out, 0, -1); }),
      ground.terrain->cell_size);
}

std::vector<char> rows_of_other_obstacles(const Ground& a, const Ground& b) {
  if (a.terrain->height.rect() != b.terrain->height.rect() || a.terrain->cell_size != b.terrain->cell_size) return {};
  std::vector<char> differ(static_cast<std::size_t>(a.terrain->height.height()));
  if (a.derivatives != b.derivatives) mark_rows(&a.derivatives->slope, &b.derivatives->slope, differ);
  if (a.hydrology != b.hydrology) mark_rows(&a.hydrology->water_depth, &b.hydrology->water_depth, differ);
  mark_rows(a.tree_cover.get(), b.tree_cover.get(), differ);
  mark_passage(a, b, differ);
  mark_discs(ford_discs(a), ford_discs(b), differ);
  mark_discs(exit_discs(a), exit_discs(b), differ);
  return differ;
}

std::shared_ptr<const ConfinementRegions> confinement_regions(const Ground& ground, const Mobility& mobility,
                                                              std::span<const char> other_rows,
                                                              const std::shared_ptr<const ConfinementRegions>& earlier) {
  if (!earlier->passable || other_rows.size() != std::size_t(earlier->passable->height)) {
    return std::make_shared<const ConfinementRegions>(confinement_regions(ground, mobility));
  }
  const ObstacleRows obstacles(ground, mobility);
  const RunTable& before = *earlier->passable;
  RunTable passable = collect_rows(before.width, before.height, [&](int y, std::vector<CellRun>& out) {
    if (!other_rows[std::size_t(y)]) {
      const auto row = before.row(y);
      out.insert(out.end(), row.begin(), row.end());
      return;
    }
    std::vector<std::int8_t> cells(static_cast<std::size_t>(before.width));
    obstacles.fill_row<std::int8_t>(y, cells, 0, -1);
    append_runs(std::span<const std::int8_t>(cells), out);
  });
  if (passable == before) return earlier;
  return std::make_shared<const ConfinementRegions>(regions_of(std::move(passable), ground.terrain->cell_size));
}

}  // namespace biotope

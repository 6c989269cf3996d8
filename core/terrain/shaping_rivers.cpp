#include <algorithm>
#include <cmath>
#include <limits>

#include "core/base/tiled_map.hpp"
#include "core/terrain/shaping.hpp"
#include "core/terrain/shaping_outlets.hpp"
#include "core/terrain/shaping_parts.hpp"

namespace biotope {
namespace {

/// Least fall of a bed, rise / run: a lowland river's. Our choice.
constexpr double least_fall = 1e-4;
/// The middle of a bed lies this share of the river's depth below its edges. Our choice.
constexpr float hollow_bed = 0.15F;
/// Behind a lake the bed deepens over this many of its depths. Our choice.
constexpr double deepening_way = 10;
/// Every point of a line has the centre of a cell within so many cells: what is that wide has no gaps.
constexpr double least_half_width = 0.7072;
/// Every cell beside the bed lies so many cells from it at most.
constexpr double bank_cells = 1.5;

/// A point of a river's course on the map.
struct CourseSample {
  PathPoint at;
  float ground = 0;  ///< lowest ground across the river
  float bed = 0;
};

/// Where a cell lies beside a course: its distance (cells), and the place of the nearest point (number of the point before and
/// how far to the next).
struct CourseCell {
  float distance = std::numeric_limits<float>::infinity();
  float place = 0;
  bool operator==(const CourseCell&) const = default;
};

/// A river before it is carved.
struct RiverPlan {
  std::vector<CourseSample> course;
  float depth = 0;
  double half_width = 0;  ///< cells
  /// Cells of the bed and of its banks.
  TiledMap<CourseCell> cells;
};

/// Heights of beds that are carved; a large number elsewhere.
using BedMap = TiledMap<float>;
constexpr float no_bed = std::numeric_limits<float>::infinity();

bool on_map(const Grid<float>& height, PathPoint point) {
  return point.x > -0.5F && point.y > -0.5F && point.x < float(height.width()) - 0.5F && point.y < float(height.height()) - 0.5F;
}

int cell_of(float position) { return int(std::floor(position + 0.5F)); }

/// Finds the cells within `reach` of the course from point i to the next that are nearer to it than to what came before.
void mark_segment(RiverPlan& plan, std::size_t i, double reach) {
  const PathPoint a = plan.course[i].at;
  const PathPoint b = plan.course[i + 1].at;
  const int x0 = std::max(0, int(std::ceil(double(std::min(a.x, b.x)) - reach)));
  const int x1 = std::min(plan.cells.width() - 1, int(std::floor(double(std::max(a.x, b.x)) + reach)));
  const int y0 = std::max(0, int(std::ceil(double(std::min(a.y, b.y)) - reach)));
  const int y1 = std::min(plan.cells.height() - 1, int(std::floor(double(std::max(a.y, b.y)) + reach)));
  const double dx = double(b.x) - double(a.x);
  const double dy = double(b.y) - double(a.y);
  const double square = dx * dx + dy * dy;
  for (int y = y0; y <= y1; ++y) {
    for (int x = x0; x <= x1; ++x) {
      const double along = square > 0 ? ((x - double(a.x)) * dx + (y - double(a.y)) * dy) / square : 0;
      const double t = std::clamp(along, 0.0, 1.0);
      const double distance = std::hypot(x - double(a.x) - dx * t, y - double(a.y) - dy * t);
      if (distance > reach || !(float(distance) < plan.cells(x, y).distance)) continue;
      plan.cells.set(x, y, {float(distance), float(double(i) + t)});
    }
  }
}

/// Calls visit(x, y, cell) for every cell of the plan, by tile.
template <class Visit>
void each_cell(const RiverPlan& plan, const Visit& visit) {
  for (std::size_t tile = 0; tile < plan.cells.tile_count(); ++tile) {
    if (!plan.cells.tile(tile)) continue;
    const Rect rect = plan.cells.tile_rect(tile);
    for (int y = rect.y0; y < rect.y1; ++y) {
      for (int x = rect.x0; x < rect.x1; ++x) {
        const CourseCell cell = plan.cells(x, y);
        if (cell.distance < no_bed) visit(x, y, cell);
      }
    }
  }
}

/// Gives each point of the course the lowest ground beside it, banks included: the bed must lie below both.
void find_ground(const Grid<float>& height, RiverPlan& plan) {
  for (CourseSample& sample : plan.course) sample.ground = sample_bilinear(height, double(sample.at.x), double(sample.at.y));
  const std::size_t last = plan.course.size() - 1;
  each_cell(plan, [&](int x, int y, const CourseCell& cell) {
    const auto before = std::size_t(cell.place);
    // Ground beyond the end is not the bank's.
    if (before >= last) return;
    for (const std::size_t i : {before, before + 1}) plan.course[i].ground = std::min(plan.course[i].ground, height(x, y));
  });
}

RiverPlan plan_river(const Terrain& terrain, const DrawnRiver& river) {
  RiverPlan plan;
  const auto discharge = float(std::max(river.discharge, 0.0));
  plan.depth = river_depth(discharge);
  plan.half_width = std::max(double(river_width(discharge)) / 2 / terrain.cell_size, least_half_width);
  // Points half a cell apart, from the head to the end on the map; wide rivers need fewer.
  std::vector<PathPoint> line = smooth_line(river.course, false);
  std::erase_if(line, [&](PathPoint point) { return !on_map(terrain.height, point); });
  const auto stride = std::max(std::size_t(1), std::size_t(2 * plan.half_width / 3));
  for (std::size_t i = 0; i < line.size(); ++i) {
    if (i % stride == 0 || i + 1 == line.size()) plan.course.push_back({line[i], 0, 0});
  }
  if (plan.course.size() < 2) return plan;
  plan.cells = TiledMap<CourseCell>(terrain.height.width(), terrain.height.height());
  for (std::size_t i = 0; i + 1 < plan.course.size(); ++i) mark_segment(plan, i, plan.half_width + bank_cells);
  find_ground(terrain.height, plan);
  return plan;
}

/// The cells that the plan was made from: those of bed and banks, and the four around each point of the course.
void note_touched(const RiverPlan& plan, TouchedTiles& touched) {
  for (const CourseSample& sample : plan.course) {
    const int x = int(std::floor(sample.at.x));
    const int y = int(std::floor(sample.at.y));
    touched.insert(Rect{x, y, x + 2, y + 2});
  }
  if (plan.course.size() < 2) return;
  each_cell(plan, [&](int x, int y, const CourseCell&) { touched.insert(Rect{x, y, x + 1, y + 1}); });
}

const LakeBasin* lake_at(std::span<const LakeBasin> lakes, PathPoint point) {
  for (const LakeBasin& lake : lakes) {
    if (lake.part(cell_of(point.x), cell_of(point.y)) != LakeBasin::outside) return &lake;
  }
  return nullptr;
}

/// Gives the course its bed: below the ground by the river's depth, never rising; on the water of lakes and on the beds of rivers
/// that it runs into, and from lakes on deepening gradually.
void lay_beds(RiverPlan& plan, double cell_size, std::span<const LakeBasin> lakes, const BedMap& beds) {
  double bed = std::numeric_limits<double>::infinity();
  double behind_lake = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < plan.course.size(); ++i) {
    CourseSample& sample = plan.course[i];
    double way = 0;
    if (i > 0) {
      const PathPoint before = plan.course[i - 1].at;
      way = std::hypot(double(sample.at.x - before.x), double(sample.at.y - before.y)) * cell_size;
    }
    behind_lake += way;
    double wanted = 0;
    if (const LakeBasin* lake = lake_at(lakes, sample.at)) {
      wanted = double(lake->surface);
      behind_lake = 0;
    } else {
      const double deepening = deepening_way * double(plan.depth);
      wanted = double(sample.ground) - double(plan.depth) * std::min(behind_lake / deepening, 1.0);
      const float other = beds(cell_of(sample.at.x), cell_of(sample.at.y));
      if (other < no_bed) wanted = std::max(wanted, double(other));
    }
    bed = i == 0 ? wanted : std::min(bed - least_fall * way, wanted);
    sample.bed = float(bed);
  }
}

/// The bed's cells; in lakes none is lower than the water's surface.
std::vector<CutCell> cut_cells(const RiverPlan& plan, const Grid<float>& height, std::span<const LakeBasin> lakes) {
  std::vector<CutCell> cells;
  each_cell(plan, [&](int x, int y, const CourseCell& cell) {
    if (double(cell.distance) > plan.half_width) return;
    const std::size_t before = std::min(std::size_t(cell.place), plan.course.size() - 2);
    const float t = cell.place - float(before);
    const float edge = cell.distance / float(plan.half_width);
    float level = plan.course[before].bed + (plan.course[before + 1].bed - plan.course[before].bed) * t +
                  hollow_bed * plan.depth * edge * edge;
    for (const LakeBasin& lake : lakes) {
      if (lake.part(x, y) != LakeBasin::outside) level = std::max(level, lake.surface);
    }
    cells.push_back({height.index(x, y), level});
  });
  return cells;
}

}  // namespace

void carve_rivers(Terrain& terrain, std::span<const DrawnRiver* const> rivers, std::span<const LakeBasin> lakes,
                  std::span<TouchedTiles> touched) {
  std::vector<RiverPlan> plans;
  for (const DrawnRiver* river : rivers) {
    plans.push_back(plan_river(terrain, *river));
    note_touched(plans.back(), touched[plans.size() - 1]);
  }
  BedMap beds(terrain.height.width(), terrain.height.height(), no_bed);
  for (std::size_t i = 0; i < plans.size(); ++i) {
    RiverPlan& plan = plans[i];
    if (plan.course.size() < 2) continue;
    lay_beds(plan, terrain.cell_size, lakes, beds);
    const std::vector<CutCell> cells = cut_cells(plan, terrain.height, lakes);
    for (const CutCell& cell : cells) {
      beds.set(int(cell.cell % std::size_t(beds.width())), int(cell.cell / std::size_t(beds.width())), cell.level);
    }
    cut_with_banks(terrain.height, terrain.cell_size, cells, lakes, touched[i]);
    const CourseSample& end = plan.course.back();
    if (lake_at(lakes, end.at) != nullptr) continue;
    const std::vector<CutCell> outlet =
        lead_out(terrain, {cell_of(end.at.x), cell_of(end.at.y), end.bed, end.ground, plan.half_width}, cells, lakes, touched[i]);
    cut_with_banks(terrain.height, terrain.cell_size, outlet, lakes, touched[i]);
  }
}

}  // namespace biotope

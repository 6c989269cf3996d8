#include "core/terrain/synthetic.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/base/parallel.hpp"
#include "core/terrain/dissection.hpp"
#include "core/terrain/noise.hpp"
#include "core/terrain/sample_designs.hpp"

namespace biotope {
namespace {

/// Every landscape is eroded on 1152 cells a side, of which the middle 1024 are kept: the ends of the river's course lie at the square's
/// edges, and no divide or other trace of the edge shall be seen.
constexpr int eroded_cells = 1152;
constexpr int coarsest_cells = 144;
constexpr int kept_cells = 1024;
constexpr int margin = (eroded_cells - kept_cells) / 2;

/// Catchment outside the map of the river that enters in the north: what the authors' public code gives Tautavel, m2.
constexpr double tautavel_catchment = 305e6;

Grid<float> middle_part(const Grid<float>& whole) {
  Grid<float> part(kept_cells, kept_cells);
  for (int y = 0; y < kept_cells; ++y) std::copy_n(whole.row(margin + y).data() + margin, kept_cells, part.row(y).data());
  return part;
}

/// Creep and rain round what the solver leaves sharp: a few passes of diffusion.
void soften(Grid<float>& height, int passes, float share) {
  Grid<float> next = height;
  for (int pass = 0; pass < passes; ++pass) {
    parallel_rows(1, height.height() - 1, [&](int y) {
      const auto north = height.row(y - 1);
      const auto row = height.row(y);
      const auto south = height.row(y + 1);
      const auto out = next.row(y);
      for (std::size_t x = 1; x + 1 < row.size(); ++x) {
        const float mean = 0.25F * (north[x] + south[x] + row[x - 1] + row[x + 1]);
        out[x] = row[x] + share * (mean - row[x]);
      }
    });
    std::swap(height, next);
  }
}

/// Lowers the ground along the course as a glacier's tongue does: a smooth bowl whose threshold downstream holds a lake.
void dig(Grid<float>& height, const LandscapeDesign& design, const Overdeepening& bowl) {
  const double cell = design.side / height.width();
  const CourseDistance course = course_distance(design.course, height.width(), cell);
  parallel_rows(0, height.height(), [&](int y) {
    const double along_bowl = ((y + 0.5) * cell - bowl.from_y) / (bowl.to_y - bowl.from_y);
    if (along_bowl <= 0 || along_bowl >= 1) return;
    for (int x = 0; x < height.width(); ++x) {
      const double across = double(course.distance(x, y)) / bowl.half_width;
      if (across >= 1) continue;
      const double lengthwise = 4 * along_bowl * (1 - along_bowl);
      height(x, y) -= float(bowl.depth * lengthwise * (1 - across * across) * (1 - across * across));
    }
  });
}

/// Where the course comes into the kept part: the lowest cell of the first row near it.
Inflow entry(const LandscapeDesign& design, const Grid<float>& kept, double catchment) {
  const double cell = design.side / eroded_cells;
  const auto first = std::find_if(design.course.begin(), design.course.end(), [&](const CoursePoint& p) { return p.y >= margin * cell; });
  const int middle = int(first->x / cell) - margin;
  Inflow inflow{middle, 0, catchment};
  for (int x = std::max(0, middle - 8); x <= std::min(kept.width() - 1, middle + 8); ++x) {
    if (kept(x, 0) < kept(inflow.x, 0)) inflow.x = x;
  }
  return inflow;
}

/// Catmull-Rom weights of the four cells around a fraction between the middle two.
std::array<float, 4> cubic_weights(float t) {
  return {0.5F * t * (-1 + t * (2 - t)), 0.5F * (2 + t * t * (3 * t - 5)), 0.5F * t * (1 + t * (4 - 3 * t)), 0.5F * t * t * (t - 1)};
}

float cubic_sample(const Grid<float>& height, double x, double y) {
  const int ix = int(std::floor(x));
  const int iy = int(std::floor(y));
  const auto wx = cubic_weights(float(x - ix));
  const auto wy = cubic_weights(float(y - iy));
  float sum = 0;
  for (int dy = -1; dy <= 2; ++dy) {
    float row = 0;
    for (int dx = -1; dx <= 2; ++dx) row += wx[std::size_t(dx + 1)] * height.clamped(ix + dx, iy + dy);
    sum += wy[std::size_t(dy + 1)] * row;
  }
  return sum;
}

/// `factor` times as many cells a side: smooth between the given ones, with roughness that grows with the slope, as rock shows where soil
/// does not stay.
Grid<float> enlarged(const Grid<float>& height, int factor, double cell_size, std::uint64_t seed) {
  const int side = height.width() * factor;
  const LayeredNoise rough(seed, side, 24, 4, 0.55F);
  Grid<float> large(side, side);
  parallel_rows(0, side, [&](int y) {
    for (int x = 0; x < side; ++x) {
      const double cx = (x + 0.5) / factor - 0.5;
      const double cy = (y + 0.5) / factor - 0.5;
      const float east = sample_bilinear(height, cx + 1, cy) - sample_bilinear(height, cx - 1, cy);
      const float south = sample_bilinear(height, cx, cy + 1) - sample_bilinear(height, cx, cy - 1);
      const float slope = std::hypot(east, south) / float(2 * cell_size);
      large(x, y) = cubic_sample(height, cx, cy) + 0.9F * std::min(slope * slope, 1.5F) * rough(x, y);
    }
  });
  return large;
}

Result<SampleLandscape> eroded_sample(const LandscapeDesign& design, int softening, double catchment, const TaskContext& context) {
  Grid<float> whole = dissect(design, coarsest_cells, eroded_cells, context);
  if (whole.empty()) return fail("Stopped.");
  soften(whole, softening, 0.5F);
  SampleLandscape sample;
  sample.terrain.height = middle_part(whole);
  sample.terrain.cell_size = design.side / eroded_cells;
  sample.inflows = {entry(design, sample.terrain.height, catchment)};
  return sample;
}

Result<SampleLandscape> valley(const TaskContext& context) { return eroded_sample(valley_design(), 3, tautavel_catchment, context); }

Result<SampleLandscape> valley_at_one_metre(const TaskContext& context) {
  auto sample = valley(context);
  if (!sample) return sample;
  constexpr int factor = 4;
  sample->terrain.height = enlarged(sample->terrain.height, factor, sample->terrain.cell_size, valley_design().seed + 9);
  sample->terrain.cell_size /= factor;
  Inflow& inflow = sample->inflows.front();
  const int first = inflow.x * factor;
  inflow.x = first;
  for (int x = first; x < first + factor; ++x) {
    if (sample->terrain.height(x, 0) < sample->terrain.height(inflow.x, 0)) inflow.x = x;
  }
  return sample;
}

Result<SampleLandscape> alpine(const TaskContext& context) {
  const LandscapeDesign design = alpine_design();
  Grid<float> whole = dissect(design, coarsest_cells, eroded_cells, context);
  if (whole.empty()) return fail("Stopped.");
  soften(whole, 3, 0.5F);
  dig(whole, design, alpine_lake());
  SampleLandscape sample;
  sample.terrain.height = middle_part(whole);
  sample.terrain.cell_size = design.side / eroded_cells;
  sample.inflows = {entry(design, sample.terrain.height, 40e6)};
  return sample;
}

Result<SampleLandscape> canyon(const TaskContext& context) {
  // A river that comes from far away, as the Colorado does: what it drains is our choice.
  auto sample = eroded_sample(canyon_design(), 2, 5e9, context);
  if (sample) sample->terrain.latitude = 36.1;
  return sample;
}

struct Recipe {
  SampleDescription description;
  Result<SampleLandscape> (*make)(const TaskContext&);
};

const std::array<Recipe, 4>& recipes() {
  static const std::array<Recipe, 4> all{
      {{{"valley", "Valley", "A limestone valley: meadows along a river, cliffs, gullies and a plateau; 4 x 4 km.", kept_cells, 4}, valley},
       {{"valley-1m", "Valley at 1 m", "The same valley at one metre: 4096 x 4096 cells.", 4 * kept_cells, 1}, valley_at_one_metre},
       {{"alpine", "Alpine valley", "Peaks above a glacial valley with a lake; 8 x 8 km.", kept_cells, 8}, alpine},
       {{"canyon", "Canyon", "A dry plateau cut by a canyon of layered cliffs; 8 x 8 km.", kept_cells, 8}, canyon}}};
  return all;
}

}  // namespace

std::vector<SampleDescription> sample_descriptions() {
  std::vector<SampleDescription> descriptions;
  for (const Recipe& recipe : recipes()) descriptions.push_back(recipe.description);
  return descriptions;
}

Result<SampleLandscape> sample_landscape(std::string_view name, const TaskContext& context) {
  for (const Recipe& recipe : recipes()) {
    if (recipe.description.name != name) continue;
    auto sample = recipe.make(context);
    if (sample) sample->terrain.name = name;
    return sample;
  }
  std::string known;
  for (const Recipe& recipe : recipes()) known += (known.empty() ? "" : ", ") + recipe.description.name;
  return fail("There is no sample \"" + std::string(name) + "\". Known samples: " + known + ".");
}

}  // namespace biotope

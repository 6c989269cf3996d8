#include "core/terrain/synthetic.hpp"

#include <algorithm>
#include <cmath>

#include "core/base/parallel.hpp"
#include "core/terrain/dissection.hpp"
#include "core/terrain/sample_designs.hpp"

namespace biotope {
namespace {

/// The northern and southern ends of the course lie at the square's edges; the sample is cut out of its middle so that no divide or
/// other trace of the edge is seen.
Grid<float> middle_part(const Grid<float>& whole, int cells) {
  const int first = (whole.width() - cells) / 2;
  Grid<float> part(cells, cells);
  for (int y = 0; y < cells; ++y) std::copy_n(whole.row(first + y).data() + first, cells, part.row(y).data());
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

}  // namespace

std::vector<SampleDescription> sample_descriptions() {
  return {
      {"valley", "Valley", "A Mediterranean limestone valley: meadows along a river, cliffs, gullies and a plateau.", 1024, 4},
      {"valley-1m", "Valley at 1 m", "The same valley at one metre: 4096 x 4096 cells.", 4096, 1},
      {"alpine", "Alpine valley", "High relief above a valley with a lake.", 1024, 8},
      {"canyon", "Canyon", "A dry plateau cut by a canyon of layered cliffs.", 1024, 8},
  };
}

Result<SampleLandscape> sample_landscape(std::string_view name, const TaskContext& context) {
  SampleLandscape sample;
  if (name == "valley") {
    const LandscapeDesign design = valley_design();
    Grid<float> whole = dissect(design, 144, 1152, context);
    if (whole.empty()) return fail("stopped");
    soften(whole, 3, 0.5F);
    sample.terrain.height = middle_part(whole, 1024);
    sample.terrain.cell_size = 4;
    sample.terrain.latitude = 42.85;
    sample.terrain.name = name;
    return sample;
  }
  return fail("no such sample");
}

}  // namespace biotope

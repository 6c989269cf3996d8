#pragma once

#include <cstdint>
#include <functional>
#include <vector>

#include "core/base/grid.hpp"
#include "core/base/task_context.hpp"
#include "core/terrain/river_course.hpp"

namespace biotope {

/// A function of a place: metres from the north-west corner, y southward.
using Field = std::function<float(double x, double y)>;

/// A layer of rock that stands at its own angle, between two stratigraphic heights.
struct RockBed {
  float from = 0;
  float to = 0;
  float steepest = 1;  ///< rise / run at which a hillslope in it stands
};

/// A country that running water has cut: what the rock is, and the river everything drains to.
struct LandscapeDesign {
  double side = 0;  ///< of the square, m
  std::vector<CoursePoint> course;
  /// 0 soft (marl) .. 1 hard (limestone).
  Field hardness;
  /// Height of the old surface into which the valleys are cut, m: above it slopes are `plateau_slope`.
  Field plateau;
  /// Added to a height to find the bed it lies in, m.
  Field dip;
  /// Height of another valley's floor at the border, m; 0 or less where the border is a divide.
  Field border_floor;
  std::vector<RockBed> beds;
  float hard_slope = 0.8F;   ///< of hard hillslopes outside the beds, rise / run
  float soft_slope = 0.3F;
  float plateau_slope = 0.05F;
  float plateau_edge = 40;   ///< height over which slopes turn from valley side to plateau, m
  float floor_slope = 0.01F; ///< of the valley floor, rise / run
  /// Channel slope = steepness x (area / 1 km2)^-0.45 (Flint's law), rise / run.
  float hard_steepness = 0.12F;
  float soft_steepness = 0.04F;
  std::uint64_t seed = 0;
};

/// Heights on a cells x cells raster, found from coarse to fine. On every level the drainage tree and the heights are solved by turns: each
/// cell drains down the steepest way; heights follow from the river upstream, every step as steep as rock and contributing area make it
/// (the steady state of stream-power erosion with threshold hillslopes; ordering after Braun and Willett 2013).
/// `cells` is `coarsest` times a power of two. Empty when stopped.
[[nodiscard]] Grid<float> dissect(const LandscapeDesign& design, int coarsest, int cells, const TaskContext& context);

}  // namespace biotope

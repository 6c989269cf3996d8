#pragma once

#include <cstdint>
#include <vector>

#include "core/base/grid.hpp"

namespace biotope {

/// A point of a river that a generated landscape is carved around. Positions in metres from the north-west corner, y southward.
struct CoursePoint {
  double x = 0;
  double y = 0;
  /// Height of the bed, m.
  double bed = 0;
  /// Half the width of the valley floor, m.
  double floor = 0;
};

/// How a river winds from the northern edge to the southern one.
struct CourseDesign {
  double side = 0;                ///< of the square it crosses, m
  std::vector<double> line;       ///< x of the valley's middle at equal steps from north to south, m
  double meander_length = 400;    ///< along the river, m
  double meander_angle = 1.0;     ///< greatest angle to the valley, rad (sine-generated curve, Langbein and Leopold 1966)
  std::vector<double> swing;      ///< factor on the angle at equal steps from north to south, 0..1
  std::uint64_t seed = 0;
};

/// Points about `step` metres apart from the northern edge to the southern; beds and floors are left 0.
[[nodiscard]] std::vector<CoursePoint> make_course(const CourseDesign& design, double step);

/// Gives a course its bed and floor: `beds` at equal steps along the river, never rising downstream, `floors` at equal steps from north to
/// south, m.
void lay_bed(std::vector<CoursePoint>& course, double side, const std::vector<double>& beds, const std::vector<double>& floors);

/// Value at fraction 0..1 of values given at equal steps, joined smoothly.
[[nodiscard]] double along(const std::vector<double>& values, double fraction);

/// The course's nearest point to each cell of a side x side raster of square cells, and the distance to it in metres.
struct CourseDistance {
  Grid<std::int32_t> nearest;
  Grid<float> distance;
};
[[nodiscard]] CourseDistance course_distance(const std::vector<CoursePoint>& course, int cells, double cell_size);

}  // namespace biotope

#include <algorithm>
#include <cmath>
#include <memory>

#include "core/terrain/noise.hpp"
#include "core/terrain/sample_designs.hpp"

namespace biotope {
namespace {

constexpr double side = 4608;
constexpr std::uint64_t seed = 66720;

/// Heights of the bed and half widths of the floor along the river.
void shape_course(std::vector<CoursePoint>& course) {
  const std::vector<double> beds{92, 86, 80, 75.5, 71.5, 68, 64.5, 61};
  const std::vector<double> floors{60, 70, 150, 240, 230, 130, 170, 210};
  const SmoothNoise riffles(seed + 5, 2 * side, 210);
  double travelled = 0;
  for (std::size_t i = 0; i < course.size(); ++i) {
    const double fraction = double(i) / double(course.size() - 1);
    if (i > 0) travelled += std::hypot(course[i].x - course[i - 1].x, course[i].y - course[i - 1].y);
    course[i].bed = along(beds, fraction) + 0.6 * double(riffles(travelled, 1));
    course[i].floor = along(floors, course[i].y / side);
    if (i > 0) course[i].bed = std::min(course[i].bed, course[i - 1].bed - 0.001);
  }
}

float smooth_step(double from, double to, double value) {
  const double t = std::clamp((value - from) / (to - from), 0.0, 1.0);
  return float(t * t * (3 - 2 * t));
}

}  // namespace

LandscapeDesign valley_design() {
  LandscapeDesign design;
  design.side = side;
  design.seed = seed;
  CourseDesign course;
  course.side = side;
  course.line = {1750, 1900, 2250, 2350, 2200, 2350, 2650, 2750};
  course.meander_length = 430;
  course.meander_angle = 1.15;
  course.swing = {0.6, 0.6, 0.9, 1.0, 1.0, 0.7, 0.9, 1.0};
  course.seed = seed;
  design.course = make_course(course, 4);
  shape_course(design.course);

  const auto folds = std::make_shared<LayeredNoise>(seed + 1, side, 1100, 3);
  design.hardness = [folds](double x, double y) {
    // Limestone in the north-west and the south-east, marl in the band between them.
    const double across = (x - y) / side + 0.12 + 0.16 * double((*folds)(x, y));
    return std::max(1 - smooth_step(-0.24, -0.12, across), smooth_step(0.20, 0.32, across));
  };
  const auto roll = std::make_shared<LayeredNoise>(seed + 2, side, 900, 3);
  design.plateau = [roll, hardness = design.hardness](double x, double y) {
    const double hard = double(hardness(x, y));
    return float(170 + 230 * hard + 60 * double((*roll)(x, y)) + 50 * (1 - y / side));
  };
  const auto tilt = std::make_shared<LayeredNoise>(seed + 3, side, 700, 2);
  design.dip = [tilt](double x, double y) { return float(0.03 * (x - side / 2) + 0.02 * (y - side / 2) + 18 * double((*tilt)(x, y))); };
  design.border_floor = [](double, double) { return 0.0F; };
  design.beds = {{150, 178, 1.9F}, {205, 260, 2.4F}, {330, 365, 2.0F}};
  design.hard_slope = 0.62F;
  design.soft_slope = 0.32F;
  return design;
}

}  // namespace biotope

#include <algorithm>
#include <cmath>
#include <memory>

#include "core/terrain/noise.hpp"
#include "core/terrain/sample_designs.hpp"

namespace biotope {
namespace {

constexpr double side = 9216;
constexpr std::uint64_t seed = 36100;

}  // namespace

LandscapeDesign canyon_design() {
  LandscapeDesign design;
  design.side = side;
  design.seed = seed;
  CourseDesign course;
  course.side = side;
  course.line = {3000, 3500, 4700, 5600, 5400, 4300, 3800, 4600};
  course.meander_length = 1300;
  course.meander_angle = 0.9;
  course.swing = {0.7, 1.0, 0.9, 1.0, 1.0, 0.8, 1.0, 0.8};
  course.seed = seed;
  design.course = make_course(course, 8);
  lay_bed(design.course, side, {760, 752, 745, 739, 732, 724, 715, 705}, {60, 90, 70, 130, 110, 60, 90, 120});

  const auto rock = std::make_shared<LayeredNoise>(seed + 1, side, 2400, 2);
  design.hardness = [rock](double x, double y) { return std::clamp(0.9F + 0.2F * (*rock)(x, y), 0.0F, 1.0F); };
  const auto roll = std::make_shared<LayeredNoise>(seed + 2, side, 2200, 3);
  design.plateau = [roll](double x, double y) {
    return float(1560 + 120 * double((*roll)(x, y)) + 260 * std::clamp(y / side - 0.35, 0.0, 1.0));
  };
  const auto tilt = std::make_shared<LayeredNoise>(seed + 3, side, 2600, 2);
  design.dip = [tilt](double x, double y) { return float(0.012 * (x - side / 2) - 0.02 * (y - side / 2) + 15 * double((*tilt)(x, y))); };
  design.border_floor = [](double, double) { return 0.0F; };
  design.beds = {{860, 930, 2.2F}, {1040, 1180, 2.8F}, {1270, 1320, 2.0F}, {1390, 1520, 3.0F}};
  design.hard_slope = 0.52F;
  design.soft_slope = 0.4F;
  design.plateau_slope = 0.045F;
  design.plateau_edge = 60;
  design.floor_slope = 0.02F;
  design.hard_steepness = 0.3F;
  design.soft_steepness = 0.18F;
  return design;
}

}  // namespace biotope

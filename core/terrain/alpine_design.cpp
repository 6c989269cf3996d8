#include <algorithm>
#include <cmath>
#include <memory>

#include "core/terrain/noise.hpp"
#include "core/terrain/sample_designs.hpp"

namespace biotope {
namespace {

constexpr double side = 9216;
constexpr std::uint64_t seed = 42850;

}  // namespace

LandscapeDesign alpine_design() {
  LandscapeDesign design;
  design.side = side;
  design.seed = seed;
  CourseDesign course;
  course.side = side;
  course.line = {3600, 3900, 4500, 5000, 5000, 4600, 4300, 4500};
  course.meander_length = 800;
  course.meander_angle = 0.7;
  course.swing = {0.5, 0.6, 0.6, 0.3, 0.3, 0.8, 1.0, 1.0};
  course.seed = seed;
  design.course = make_course(course, 8);
  lay_bed(design.course, side, {1084, 1070, 1059, 1052, 1049, 1038, 1021, 1003}, {90, 150, 260, 380, 380, 220, 200, 260});

  const auto rock = std::make_shared<LayeredNoise>(seed + 1, side, 1500, 5, 0.6F);
  design.hardness = [rock](double x, double y) { return std::clamp(0.55F + 0.8F * (*rock)(x, y), 0.0F, 1.0F); };
  const auto massif = std::make_shared<LayeredNoise>(seed + 2, side, 3200, 3);
  design.plateau = [massif](double x, double y) { return float(2400 + 480 * double((*massif)(x, y))); };
  const auto fold = std::make_shared<LayeredNoise>(seed + 3, side, 1800, 2);
  design.dip = [fold](double x, double y) { return float(0.12 * (x - side / 2) + 90 * double((*fold)(x, y))); };
  design.border_floor = [](double, double) { return 0.0F; };
  design.beds = {{1500, 1590, 1.7F}, {1850, 1960, 1.9F}, {2200, 2330, 1.8F}};
  design.hard_slope = 1.0F;
  design.soft_slope = 0.42F;
  design.plateau_slope = 0.35F;
  design.plateau_edge = 260;
  design.floor_slope = 0.03F;
  design.hard_steepness = 0.22F;
  design.soft_steepness = 0.11F;
  return design;
}

Overdeepening alpine_lake() { return {3300, 5200, 330, 55}; }

}  // namespace biotope

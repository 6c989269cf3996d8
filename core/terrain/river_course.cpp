#include "core/terrain/river_course.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "core/base/random.hpp"

namespace biotope {

void lay_bed(std::vector<CoursePoint>& course, double side, const std::vector<double>& beds, const std::vector<double>& floors) {
  constexpr double least_fall = 0.001;
  for (std::size_t i = 0; i < course.size(); ++i) {
    course[i].bed = along(beds, double(i) / double(course.size() - 1));
    course[i].floor = along(floors, course[i].y / side);
    if (i > 0) course[i].bed = std::min(course[i].bed, course[i - 1].bed - least_fall);
  }
}

double along(const std::vector<double>& values, double fraction) {
  const double place = std::clamp(fraction, 0.0, 1.0) * double(values.size() - 1);
  const auto i = std::min(std::size_t(place), values.size() - 2);
  const auto at = [&](std::ptrdiff_t k) { return values[std::size_t(std::clamp<std::ptrdiff_t>(k, 0, std::ptrdiff_t(values.size()) - 1))]; };
  const auto k = std::ptrdiff_t(i);
  const double f = place - double(i);
  const double a = at(k - 1), b = at(k), c = at(k + 1), d = at(k + 2);
  return b + 0.5 * f * (c - a + f * (2 * a - 5 * b + 4 * c - d + f * (3 * (b - c) + d - a)));
}

std::vector<CoursePoint> make_course(const CourseDesign& design, double step) {
  std::vector<CoursePoint> points;
  double y = 0;
  double offset = 0;
  double phase = 0;
  const double steps = design.side / step;
  for (int i = 0; y < design.side && i < int(40 * steps); ++i) {
    const double fraction = y / design.side;
    const double middle = along(design.line, fraction);
    points.push_back({middle + offset, y, 0, 0});
    // Each bend has its own length, or the river would look drawn with a ruler.
    const auto bend = std::uint64_t(phase / std::numbers::pi);
    const double length = design.meander_length * (0.65 + 0.8 * random_unit({design.seed, 1, bend}));
    phase += 2 * std::numbers::pi * step / length;
    const double swing = along(design.swing, fraction) * (0.75 + 0.4 * random_unit({design.seed, 2, bend}));
    const double back = std::clamp(-offset / design.meander_length, -0.6, 0.6);
    const double angle = design.meander_angle * swing * std::cos(phase) + back;
    y += step * std::cos(angle);
    offset += step * std::sin(angle);
  }
  const double last = design.side;
  points.push_back({along(design.line, 1) + offset, last, 0, 0});
  return points;
}

CourseDistance course_distance(const std::vector<CoursePoint>& course, int cells, double cell_size) {
  CourseDistance result{Grid<std::int32_t>(cells, cells, -1), Grid<float>(cells, cells, std::numeric_limits<float>::max())};
  const auto offer = [&](int x, int y, std::int32_t point) {
    const CoursePoint& p = course[std::size_t(point)];
    const auto distance = float(std::hypot(p.x - (x + 0.5) * cell_size, p.y - (y + 0.5) * cell_size));
    if (distance >= result.distance(x, y)) return;
    result.distance(x, y) = distance;
    result.nearest(x, y) = point;
  };
  for (std::size_t i = 0; i < course.size(); ++i) {
    const int x = std::clamp(int(course[i].x / cell_size), 0, cells - 1);
    const int y = std::clamp(int(course[i].y / cell_size), 0, cells - 1);
    offer(x, y, std::int32_t(i));
  }
  const auto take = [&](int x, int y, int nx, int ny) {
    if (nx >= 0 && ny >= 0 && nx < cells && ny < cells && result.nearest(nx, ny) >= 0) offer(x, y, result.nearest(nx, ny));
  };
  // Two sweeps hand every cell its neighbours' nearest points (dead reckoning): within a fraction of a cell of exact.
  for (int y = 0; y < cells; ++y) {
    for (int x = 0; x < cells; ++x) {
      for (int dx = -1; dx <= 1; ++dx) take(x, y, x + dx, y - 1);
      take(x, y, x - 1, y);
    }
    for (int x = cells - 1; x >= 0; --x) take(x, y, x + 1, y);
  }
  for (int y = cells - 1; y >= 0; --y) {
    for (int x = cells - 1; x >= 0; --x) {
      for (int dx = -1; dx <= 1; ++dx) take(x, y, x + dx, y + 1);
      take(x, y, x + 1, y);
    }
    for (int x = 0; x < cells; ++x) take(x, y, x - 1, y);
  }
  return result;
}

}  // namespace biotope

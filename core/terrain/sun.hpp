#pragma once

#include <array>
#include <vector>

#include "core/base/grid.hpp"
#include "core/base/status.hpp"
#include "core/base/task_context.hpp"
#include "core/terrain/derivatives.hpp"
#include "core/terrain/terrain.hpp"

namespace biotope {

/// A direction toward the sun.
struct SunPosition {
  /// Radians above the horizon, and clockwise from north.
  double elevation = 0;
  double azimuth = 0;
};

/// Declination (radians) on a day of the year (1..365): asin(0.3978 sin(j - 1.4 + 0.0355 sin(j - 0.0489))), j = 2 pi day / 365.25.
[[nodiscard]] double solar_declination(double day_of_year);

/// Sun at a latitude (degrees), day of the year and local solar hour (0..24).
[[nodiscard]] SunPosition sun_position(double latitude, double day_of_year, double hour);

/// Hours of daylight on flat ground.
[[nodiscard]] double day_length(double latitude, double day_of_year);

/// Middle day of month 0..11 (January is 0).
[[nodiscard]] double middle_day(int month);

/// Horizon heights by azimuth sector, on a grid that may be coarser than the terrain.
struct Horizons {
  /// Terrain cells per horizon cell (1, 2, 4, ...).
  int stride = 1;
  /// One grid a sector, sector s at azimuth 2 pi s / sectors.size(); values are tangents of the horizon's elevation, at least 0.
  std::vector<Grid<float>> sectors;
};

/// Horizons in `sectors` azimuths by upper convex hulls along lines; O(cells x sectors).
[[nodiscard]] Horizons compute_horizons(const Terrain& terrain, int sectors = 16, int stride = 0);

/// Mean over the 24 hours of the month's middle day of max(0, n.s) where the sun clears the horizon (soft edge): a ratio 0..1
/// per month, January first. Parallel; empty result when stopped.
[[nodiscard]] Result<std::array<Grid<float>, 12>> compute_monthly_illumination(const Terrain& terrain,
                                                                               const Derivatives& derivatives,
                                                                               const TaskContext& context = {});

}  // namespace biotope

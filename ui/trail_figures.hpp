#pragma once

#include <cstddef>
#include <vector>

#include "core/movement/trails.hpp"

namespace biotope {

/// What the trails panel says about a network.
struct TrailFigures {
  /// Greatest use anywhere, kg x trips / year.
  float busiest = 0;
  /// Metres by use compared with the busiest place: above a tenth, above a hundredth, the rest.
  double heavy_length = 0;
  double middle_length = 0;
  double light_length = 0;
  struct Route {
    std::size_t index = 0;
    float greatest = 0;  ///< kg x trips / year
    double length = 0;   ///< m
    PathPoint middle;
  };
  /// The routes with the greatest use, the busiest first; equal ones in the network's order.
  std::vector<Route> most_used;
};

/// Reads every point once. `cell_size` in metres; at most `count` routes are named.
[[nodiscard]] TrailFigures trail_figures(const TrailNetwork& trails, double cell_size, std::size_t count);

}  // namespace biotope

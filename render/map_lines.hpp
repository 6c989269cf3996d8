#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <span>
#include <vector>

#include "core/pipeline/maps_snapshot.hpp"

namespace biotope {

/// One side of a point of a band along a polyline, as shaders/map/ribbon.vert reads it.
struct RibbonVertex {
  float x = 0;  ///< cells
  float y = 0;
  float normal_x = 0;
  float normal_y = 0;
  float side = 0;      ///< -1 or 1
  float strength = 0;  ///< 0..1
  float metres = 0;    ///< width on the ground
  std::array<std::uint8_t, 4> tone{};
};

/// Bands as indexed triangles.
struct RibbonMesh {
  std::vector<RibbonVertex> vertices;
  std::vector<std::uint32_t> indices;
};

/// A point of a band before it gets its width.
struct RibbonPoint {
  float x = 0;
  float y = 0;
  float strength = 0;
  float metres = 0;
};

/// Appends a band along the points; fewer than two points add nothing.
void add_ribbon(RibbonMesh& mesh, std::span<const RibbonPoint> points, std::array<std::uint8_t, 4> tone);

/// Trails, strength on a logarithmic scale of use between the least and the most used.
[[nodiscard]] RibbonMesh trail_ribbons(const TrailNetwork& trails);
/// Rivers, strength growing with discharge. `columns` is the grid's width.
[[nodiscard]] RibbonMesh river_ribbons(const Hydrology& hydrology, int columns);

/// A herd's mark, as shaders/map/marker.vert reads it.
struct HerdMarker {
  float x = 0;  ///< cells
  float y = 0;
  float heading = 0;  ///< radians clockwise from north
  float pixels = 0;   ///< nose to tail
  std::array<std::uint8_t, 4> tone{};
  int species = 0;
  int animals = 0;
};

/// Marks of one species that would lie over each other become one, as large as all its animals ask for and turned like the largest
/// herd. `pixels_of` gives the length of a mark for a species and a number of animals.
[[nodiscard]] std::vector<HerdMarker> merged_marks(std::vector<HerdMarker> marks, double pixels_per_cell,
                                                   const std::function<float(int species, int animals)>& pixels_of);

/// The herds at an hour and the way each went in the last hour. `visible` by species number; empty shows all; `mark_scale`
/// multiplies the size of marks.
struct HerdPicture {
  std::vector<HerdMarker> markers;
  RibbonMesh tails;
};
[[nodiscard]] HerdPicture herds_at(const MapsSnapshot& snapshot, double hour, const std::vector<bool>& visible, float mark_scale,
                                   double pixels_per_cell);

}  // namespace biotope

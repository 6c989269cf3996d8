#pragma once

#include <array>
#include <cstdint>
#include <string>

#include "core/base/grid.hpp"

namespace biotope {

/// Where a terrain lies on the Earth.
struct Georeference {
  /// Coordinate reference system as WKT; empty when the file had none.
  std::string wkt;
  /// GDAL's affine transform from (column, row) to the units of the CRS (metres or feet; metres without a CRS): x = t0 + c t1 + r t2,
  /// y = t3 + c t4 + r t5. Without a file it puts the south-west corner at (0, 0). The model computes with Terrain::cell_size only.
  std::array<double, 6> transform{0, 1, 0, 0, 0, -1};
};

/// The ground: heights on a square, metric grid. x east, y north, z up; row 0 is the northern edge.
struct Terrain {
  /// Metres above sea level; sea floor is negative. Voids hold a filled height (see `voids`).
  Grid<float> height;
  /// 1 where the source had no data and the height was filled in; empty when there was none.
  Grid<std::uint8_t> voids;
  /// Side of a cell: always metres, whatever the unit of the CRS.
  double cell_size = 1.0;
  /// Degrees north of the centre; drives the sun.
  double latitude = 42.85;
  Georeference georeference;
  /// What a person calls it: a file's stem or a sample's name.
  std::string name;

  [[nodiscard]] double width_metres() const { return height.width() * cell_size; }
  [[nodiscard]] double height_metres() const { return height.height() * cell_size; }
  [[nodiscard]] double cell_area() const { return cell_size * cell_size; }
};

}  // namespace biotope

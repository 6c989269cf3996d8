#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "core/base/grid.hpp"
#include "core/base/status.hpp"
#include "core/exchange/height_source.hpp"
#include "core/terrain/terrain.hpp"

namespace biotope {

/// Heights on a square metric grid whose row 0 is the northern edge; NaN where there is no data.
struct MetricGrid {
  Grid<float> height;
  /// Metres; absent when neither the file nor the options say.
  std::optional<double> cell_size;
  /// Degrees north of the centre, when the georeference tells.
  std::optional<double> latitude;
  /// The transform is in the CRS's own units (metres, or feet).
  Georeference georeference;
  std::string crs_name;
  bool geographic = false;
  std::vector<std::string> notes;
};

/// Puts heights on a square metric grid. Grids that are square and north-up in a CRS true to scale keep their cells to the bit; geographic
/// ones and those whose CRS stretches distances by more than 2 % (Web Mercator) are reprojected to the local UTM zone, the turned and the
/// oblong ones are resampled, all bilinearly; edges without data that this leaves are cut off. `cell_size` overrules the georeference.
/// The heights are moved out of `source`.
[[nodiscard]] Result<MetricGrid> place_on_metric_grid(const std::filesystem::path& file, HeightSource& source,
                                                      std::optional<double> cell_size);

}  // namespace biotope

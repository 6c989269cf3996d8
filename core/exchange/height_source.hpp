#pragma once

#include <array>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "core/base/grid.hpp"
#include "core/base/status.hpp"
#include "core/base/task_context.hpp"
#include "core/exchange/dem_import.hpp"

namespace biotope {

/// Heights beyond this are no ground on Earth and count as missing, m (our choice; Everest is 8849, the deepest sea -10935).
inline constexpr double highest_ground = 12000;
/// Most cells on a side that an import takes.
inline constexpr int largest_side = 16384;

/// Heights as a file has them: metres, NaN where there is no data, on the file's own grid.
struct HeightSource {
  Grid<float> height;
  /// GDAL's affine transform from (column, row) to the CRS, moved to the crop; absent when the file has none.
  std::optional<std::array<double, 6>> transform;
  /// CRS as WKT; empty when the file has none.
  std::string wkt;
  std::string format;
  std::string sample_type;
  /// Size of the whole file, before any crop.
  int file_width = 0;
  int file_height = 0;
  int bands = 1;
  /// Cells whose height was beyond `highest_ground`.
  std::size_t absurd_cells = 0;
  std::vector<std::string> notes;
};

/// Reads a file through GDAL, or as RAW when the options give a layout. Crop, units, scale and offset are applied.
[[nodiscard]] Result<HeightSource> read_heights(const std::filesystem::path& file, const DemImportOptions& options,
                                                const TaskContext& context);

/// The RAW half of read_heights.
[[nodiscard]] Result<HeightSource> read_raw_heights(const std::filesystem::path& file, const DemImportOptions& options,
                                                    const TaskContext& context);

/// How stored numbers become metres.
struct HeightScale {
  double factor = 1;
  double offset = 0;
};

/// Scales one row in place; no-data and absurd heights become NaN. Returns the number of absurd ones.
std::size_t scale_heights(std::span<float> row, const HeightScale& scale, std::optional<float> no_data);

/// The part of a width x height file to read, or an Error when the crop does not lie inside or is thinner than 2 cells.
[[nodiscard]] Result<Rect> crop_of(const std::filesystem::path& file, const DemImportOptions& options, int width,
                                   int height);

/// An Error unless `file` is there, a plain file and not empty.
[[nodiscard]] Status check_readable(const std::filesystem::path& file);

}  // namespace biotope

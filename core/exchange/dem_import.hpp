#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "core/base/rect.hpp"
#include "core/base/status.hpp"
#include "core/base/task_context.hpp"
#include "core/terrain/terrain.hpp"

namespace biotope {

/// Layout of a headerless raster.
struct RawLayout {
  int width = 0;
  int height = 0;
  /// "uint8", "int16", "uint16", "int32", "uint32", "float32", "float64".
  std::string sample_type = "uint16";
  bool big_endian = false;
  std::size_t header_bytes = 0;
};

/// What to do with cells without data.
enum class VoidHandling { fill, keep_as_sea };

/// How a DEM becomes a Terrain.
struct DemImportOptions {
  /// Metres; overrules the file's georeference. Needed when the file has none.
  std::optional<double> cell_size;
  /// Multiplies heights (0.3048 for feet); negative is refused.
  double vertical_scale = 1;
  double vertical_offset = 0;
  /// Longer side after resampling, cells.
  std::optional<int> longer_side;
  /// Part of the file to take, source cells, before resampling.
  std::optional<Rect> crop;
  std::optional<RawLayout> raw;
  VoidHandling voids = VoidHandling::fill;
  /// Degrees; overrules what follows from the georeference.
  std::optional<double> latitude;
};

/// What a person should see before an import replaces anything.
struct DemPreview {
  std::filesystem::path file;
  std::string format;
  std::string sample_type;
  int width = 0;
  int height = 0;
  int bands = 1;
  /// Metres after reprojection; absent when the file has no CRS.
  std::optional<double> cell_size;
  std::string crs_name;
  bool geographic = false;
  float lowest = 0;
  float highest = 0;
  std::size_t void_cells = 0;
  std::size_t total_cells = 0;
  /// What a person should know ("2.7 % voids will be filled", "degrees: reprojected to UTM 10N").
  std::vector<std::string> notes;
  /// At most 512 cells a side, for a shaded picture.
  Terrain thumbnail;
};

[[nodiscard]] Result<DemPreview> preview_dem(const std::filesystem::path& file, const DemImportOptions& options = {});

/// Reads a DEM through GDAL (or RAW): all sample types, nodata and NaN filled smoothly from their surroundings (and marked in
/// `voids`), geographic coordinates reprojected to the local UTM zone. Errors: unreadable or truncated file, no CRS and no cell size,
/// 1 x n grids, all void, several bands (a photo), a grid beyond 16384 cells a side.
[[nodiscard]] Result<Terrain> import_dem(const std::filesystem::path& file, const DemImportOptions& options = {},
                                         const TaskContext& context = {});

/// Bilinear (area-averaging when shrinking) copy of a terrain with its longer side of `longer_side` cells.
[[nodiscard]] Terrain resampled(const Terrain& terrain, int longer_side);

}  // namespace biotope

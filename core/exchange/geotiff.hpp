#pragma once

#include <filesystem>

#include "core/base/grid.hpp"
#include "core/base/status.hpp"
#include "core/terrain/terrain.hpp"

namespace biotope {

/// Writes a float32 GeoTIFF (one band, DEFLATE) with the terrain's georeference; byte-identical for identical input. Atomic: written to
/// a temporary name, then renamed.
[[nodiscard]] Status write_geotiff(const std::filesystem::path& file, const Grid<float>& map, const Terrain& terrain);

/// Reads one band as float; Errors name the file.
[[nodiscard]] Result<Grid<float>> read_raster(const std::filesystem::path& file);

}  // namespace biotope

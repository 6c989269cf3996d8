#include "core/exchange/dem_import.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "core/exchange/height_source.hpp"
#include "core/exchange/metric_grid.hpp"
#include "core/exchange/void_fill.hpp"

namespace biotope {
namespace {

/// Height of voids that become sea, m: deep enough to be no shore, unless the file's own sea is deeper (our choice).
constexpr float sea_of_voids = -10;
constexpr int thumbnail_side = 512;

struct LoadedDem {
  HeightSource source;  ///< without its heights, which have moved to `grid`
  MetricGrid grid;
  Grid<std::uint8_t> voids;
  std::size_t void_cells = 0;
};

Status check_options(const std::filesystem::path& file, const DemImportOptions& options) {
  const auto wrong = [&](const std::string& what) { return fail(file.string() + ": " + what); };
  if (options.cell_size && !(*options.cell_size > 0 && std::isfinite(*options.cell_size))) {
    return wrong("the cell size must be more than 0 m.");
  }
  if (!(options.vertical_scale > 0) || !std::isfinite(options.vertical_scale)) {
    return wrong("the vertical scale must be more than 0.");
  }
  if (!std::isfinite(options.vertical_offset)) return wrong("the vertical offset must be a number.");
  if (options.longer_side && (*options.longer_side < 2 || *options.longer_side > largest_side)) {
    return wrong("the longer side must have 2 to " + std::to_string(largest_side) + " cells.");
  }
  if (options.latitude && !(std::abs(*options.latitude) <= 90)) {
    return wrong("the latitude must lie between -90 and 90 degrees.");
  }
  return {};
}

std::string percent(std::size_t part, std::size_t whole) {
  char text[32];
  std::snprintf(text, sizeof text, "%.3g %%", 100.0 * double(part) / double(whole));
  return text;
}

Status check_not_all_void(const std::filesystem::path& file, const LoadedDem& dem, std::size_t source_cells) {
  if (dem.void_cells < dem.voids.size()) return {};
  if (dem.source.absurd_cells * 2 > source_cells) {
    return fail(file.string() + ": its heights lie beyond 12000 m, so they are not metres. Give a vertical scale "
                "(--vertical-scale).");
  }
  return fail(file.string() + ": has no data at all: every cell is void.");
}

Result<LoadedDem> load(const std::filesystem::path& file, const DemImportOptions& options, const TaskContext& context) {
  if (const Status sound = check_options(file, options); !sound) return tl::unexpected(sound.error());
  auto source = read_heights(file, options, context);
  if (!source) return tl::unexpected(source.error());
  LoadedDem dem;
  dem.source = std::move(*source);
  const std::size_t source_cells = dem.source.height.size();
  auto grid = place_on_metric_grid(file, dem.source, options.cell_size);
  if (!grid) return tl::unexpected(grid.error());
  dem.grid = std::move(*grid);
  dem.voids = missing_cells(dem.grid.height);
  dem.void_cells = std::size_t(std::count(dem.voids.cells().begin(), dem.voids.cells().end(), 1));
  if (const Status some = check_not_all_void(file, dem, source_cells); !some) return tl::unexpected(some.error());
  if (dem.source.absurd_cells > 0) {
    dem.grid.notes.push_back(percent(dem.source.absurd_cells, source_cells) +
                             " of the heights lie beyond 12000 m and count as voids.");
  }
  return dem;
}

/// Lowest and highest height that the file itself gave.
std::pair<float, float> range_of(const LoadedDem& dem) {
  float lowest = std::numeric_limits<float>::infinity();
  float highest = -lowest;
  for (const float height : dem.grid.height.cells()) {
    if (std::isnan(height)) continue;
    lowest = std::min(lowest, height);
    highest = std::max(highest, height);
  }
  return {lowest, highest};
}

Terrain to_terrain(const std::filesystem::path& file, LoadedDem&& dem, const DemImportOptions& options) {
  Terrain terrain;
  const float lowest = dem.void_cells > 0 ? range_of(dem).first : 0;
  terrain.height = std::move(dem.grid.height);
  if (dem.void_cells > 0) {
    if (options.voids == VoidHandling::fill) {
      fill_missing(terrain.height, dem.voids);
    } else {
      for (float& height : terrain.height.cells()) {
        if (std::isnan(height)) height = std::min(sea_of_voids, lowest);
      }
    }
    terrain.voids = std::move(dem.voids);
  }
  terrain.cell_size = dem.grid.cell_size.value_or(1.0);
  terrain.georeference = dem.grid.georeference;
  if (!dem.grid.cell_size) terrain.georeference.transform[3] = terrain.height.height();
  if (options.latitude) {
    terrain.latitude = *options.latitude;
  } else if (dem.grid.latitude) {
    terrain.latitude = *dem.grid.latitude;
  }
  terrain.name = file.stem().string();
  return options.longer_side ? resampled(terrain, *options.longer_side) : terrain;
}

}  // namespace

Result<DemPreview> preview_dem(const std::filesystem::path& file, const DemImportOptions& options) {
  auto dem = load(file, options, {});
  if (!dem) return tl::unexpected(dem.error());
  DemPreview preview;
  preview.file = file;
  preview.format = dem->source.format;
  preview.sample_type = dem->source.sample_type;
  preview.width = dem->source.file_width;
  preview.height = dem->source.file_height;
  preview.bands = dem->source.bands;
  preview.cell_size = dem->grid.cell_size;
  preview.crs_name = dem->grid.crs_name;
  preview.geographic = dem->grid.geographic;
  std::tie(preview.lowest, preview.highest) = range_of(*dem);
  preview.void_cells = dem->void_cells;
  preview.total_cells = dem->voids.size();
  preview.notes = dem->source.notes;
  preview.notes.insert(preview.notes.end(), dem->grid.notes.begin(), dem->grid.notes.end());
  if (dem->void_cells > 0) {
    preview.notes.push_back(percent(dem->void_cells, dem->voids.size()) + " of the cells have no data and will be " +
                            (options.voids == VoidHandling::fill ? "filled from their surroundings."
                                                                 : "kept as sea."));
  }
  DemImportOptions as_it_is = options;
  as_it_is.longer_side.reset();
  preview.thumbnail = to_terrain(file, std::move(*dem), as_it_is);
  const int longer = std::max(preview.thumbnail.height.width(), preview.thumbnail.height.height());
  if (longer > thumbnail_side) preview.thumbnail = resampled(preview.thumbnail, thumbnail_side);
  return preview;
}

Result<Terrain> import_dem(const std::filesystem::path& file, const DemImportOptions& options,
                           const TaskContext& context) {
  auto dem = load(file, options, context);
  if (!dem) return tl::unexpected(dem.error());
  if (!dem->grid.cell_size) {
    return fail(file.string() + ": says nothing about the size of its cells. Give it in metres: --cell-size M.");
  }
  return to_terrain(file, std::move(*dem), options);
}

}  // namespace biotope

#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "core/base/status.hpp"
#include "core/base/task_context.hpp"
#include "core/climate/climate.hpp"
#include "core/document/document.hpp"
#include "core/exchange/dem_import.hpp"

namespace biotope {

/// Folder of species and climates: next to the program when installed, in the source tree when built there, or BIOTOPE_ASSETS.
[[nodiscard]] Result<std::filesystem::path> assets_folder();

/// The species file used when none is asked for.
[[nodiscard]] std::filesystem::path default_species_file(const std::filesystem::path& assets);

/// A climate of the assets folder by its name; an unknown name is an Error that lists the known ones.
[[nodiscard]] Result<Climate> climate_named(std::string_view name);

/// True for a name that ends in ".biotope".
[[nodiscard]] bool is_scene_file(const std::filesystem::path& file);

/// What the command line and File > Open accept: a scene (.biotope), any DEM, or "sample:NAME". A DEM or sample becomes a Document with the default
/// climate (mild-humid) and species.
/// Cell size, longer side and latitude apply to all three; a scene's paint is resampled with its terrain. Options that say how to read a DEM
/// (RAW layout, crop, vertical scale and offset) given with a scene or sample are an Error.
[[nodiscard]] Result<Document> open_input(const std::string& input, const DemImportOptions& options = {},
                                          const TaskContext& context = {});

/// Reads --environment maps: every file of DIR that is named illumination-MM.tif, temperature-MM.tif, moisture-MM.tif (MM = 01..12) or geology.tif. A wrong
/// size or a missing month is an Error naming the file, and so is a value that is not on the scale (1..9, or a geology class 0..4).
[[nodiscard]] Result<GivenEnvironment> load_given_environment(const std::filesystem::path& folder, int width, int height);

}  // namespace biotope

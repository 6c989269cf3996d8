#include "core/exchange/open_input.hpp"

#include <algorithm>
#include <cmath>

#include "core/exchange/document_scale.hpp"
#include "core/exchange/scene_file.hpp"
#include "core/species/species_library.hpp"
#include "core/terrain/synthetic.hpp"

namespace biotope {
namespace {

constexpr std::string_view sample_prefix = "sample:";
constexpr std::string_view default_climate = "mild-humid";

Status use_defaults(Document& document) {
  const auto assets = assets_folder();
  if (!assets) return tl::unexpected(assets.error());
  auto climate = climate_named(default_climate);
  if (!climate) return tl::unexpected(climate.error());
  document.climate = std::move(*climate);
  auto species = load_species(default_species_file(*assets));
  if (!species) return tl::unexpected(species.error());
  document.species = std::make_shared<const std::vector<Species>>(std::move(*species));
  return {};
}

/// A landscape of no place on earth lies in metres from its south-west corner, so that maps written of it have its size.
void place_in_metres(Document& document) {
  const Georeference nowhere;
  const Georeference& reference = document.terrain->georeference;
  if (!reference.wkt.empty() || reference.transform != nowhere.transform) return;
  auto terrain = std::make_shared<Terrain>(*document.terrain);
  const double cell = terrain->cell_size;
  terrain->georeference.transform = {0, cell, 0, terrain->height_metres(), 0, -cell};
  document.terrain = std::move(terrain);
}

Result<Document> open_sample(std::string_view name, const TaskContext& context) {
  auto sample = sample_landscape(name, context);
  if (!sample) return tl::unexpected(sample.error());
  Document document;
  document.terrain = std::make_shared<const Terrain>(std::move(sample->terrain));
  document.inflows = std::move(sample->inflows);
  document.title = std::string(name);
  for (const SampleDescription& description : sample_descriptions()) {
    if (description.name == name) document.title = description.title;
  }
  if (const Status set = use_defaults(document); !set) return tl::unexpected(set.error());
  return document;
}

Result<Document> open_dem(const std::filesystem::path& file, const DemImportOptions& options, const TaskContext& context) {
  auto terrain = import_dem(file, options, context);
  if (!terrain) return tl::unexpected(terrain.error());
  Document document;
  document.title = terrain->name;
  document.terrain = std::make_shared<const Terrain>(std::move(*terrain));
  if (const Status set = use_defaults(document); !set) return tl::unexpected(set.error());
  return document;
}

/// An Error for options that say how to read a DEM, given with something else: ignoring them would be a silent mistake.
Status check_no_dem_options(const std::string& input, const DemImportOptions& options) {
  const char* option = options.raw                    ? "--raw"
                       : options.crop                 ? "--crop"
                       : options.vertical_scale != 1  ? "--vertical-scale"
                       : options.vertical_offset != 0 ? "--vertical-offset"
                                                      : nullptr;
  if (option == nullptr) return {};
  return fail(input + ": is no DEM, so " + option + " does not apply.");
}

/// Cell size, size and latitude for what does not come through the DEM import.
Result<Document> scaled(Document document, const DemImportOptions& options) {
  if (options.latitude) {
    if (!(std::abs(*options.latitude) <= 90)) return fail("The latitude must lie between -90 and 90 degrees.");
    auto terrain = std::make_shared<Terrain>(*document.terrain);
    terrain->latitude = *options.latitude;
    document.terrain = std::move(terrain);
  }
  if (options.cell_size) {
    if (!(*options.cell_size > 0)) return fail("The cell size must be more than 0 m.");
    document = with_cell_size(document, *options.cell_size);
  }
  if (options.longer_side) {
    if (*options.longer_side < 2 || *options.longer_side > 16384) {
      return fail("The longer side must have 2 to 16384 cells.");
    }
    document = resampled_document(document, *options.longer_side);
  }
  return document;
}

}  // namespace

bool is_scene_file(const std::filesystem::path& file) { return file.extension() == ".biotope"; }

Result<Climate> climate_named(std::string_view name) {
  const auto assets = assets_folder();
  if (!assets) return tl::unexpected(assets.error());
  auto climates = load_climates(*assets / "climates");
  if (!climates) return tl::unexpected(climates.error());
  std::string known;
  for (Climate& climate : *climates) {
    if (climate.name == name) return std::move(climate);
    known += (known.empty() ? "" : ", ") + climate.name;
  }
  return fail("There is no climate '" + std::string(name) + "'. Known climates: " + known + ".");
}

Result<Document> open_input(const std::string& input, const DemImportOptions& options, const TaskContext& context) {
  const bool sample = input.starts_with(sample_prefix);
  if (sample || is_scene_file(input)) {
    if (const Status sound = check_no_dem_options(input, options); !sound) return tl::unexpected(sound.error());
  }
  if (sample) {
    auto document = open_sample(std::string_view(input).substr(sample_prefix.size()), context);
    if (document) place_in_metres(*document);
    return document ? scaled(std::move(*document), options) : document;
  }
  if (is_scene_file(input)) {
    auto document = load_scene(input);
    if (document) place_in_metres(*document);
    return document ? scaled(std::move(*document), options) : document;
  }
  return open_dem(input, options, context);
}

}  // namespace biotope

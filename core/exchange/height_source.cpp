#include "core/exchange/height_source.hpp"

#include <algorithm>
#include <cmath>
#include <map>

#include "core/exchange/gdal_support.hpp"
#include "core/pipeline/solve.hpp"

namespace biotope {
namespace {

/// Rows read at a time: enough that each call is cheap, few enough that a stop is answered at once.
constexpr int rows_a_read = 64;
/// Written as 'no data' by many tools that do not say so in the file.
constexpr float customary_no_data = -9999;

Status check_bands(const std::filesystem::path& file, GDALDataset& dataset) {
  const int bands = dataset.GetRasterCount();
  if (bands == 0) {
    return fail(file.string() + ": holds no raster of its own (a collection of several data sets?). Extract the "
                "elevation, for example with gdal_translate.");
  }
  GDALRasterBand& first = *dataset.GetRasterBand(1);
  if (first.GetColorInterpretation() == GCI_PaletteIndex || first.GetColorTable() != nullptr) {
    return fail(file.string() + ": is a picture with a colour palette; a DEM has heights in one band.");
  }
  if (GDALDataTypeIsComplex(first.GetRasterDataType())) {
    return fail(file.string() + ": holds complex numbers; a DEM has heights in one band.");
  }
  const bool with_mask = bands == 2;
  if (bands == 1 || with_mask) return {};
  if (bands <= 4) {
    return fail(file.string() + ": looks like a photo with " + std::to_string(bands) + " bands; a DEM has one.");
  }
  return fail(file.string() + ": has " + std::to_string(bands) + " bands; a DEM has one. Extract the elevation, for "
              "example with gdal_translate -b 1.");
}

/// Metres per unit of a band's heights; absent when the unit is unknown.
std::optional<double> metres_per_unit(std::string unit) {
  std::transform(unit.begin(), unit.end(), unit.begin(), [](unsigned char c) { return char(std::tolower(c)); });
  static const std::map<std::string, double> units{
      {"", 1},          {"m", 1},         {"metre", 1},           {"meter", 1},
      {"metres", 1},    {"meters", 1},    {"ft", 0.3048},         {"foot", 0.3048},
      {"feet", 0.3048}, {"us-ft", 1200.0 / 3937}, {"us survey foot", 1200.0 / 3937}, {"foot_us", 1200.0 / 3937},
      {"ftus", 1200.0 / 3937}, {"km", 1000}, {"dm", 0.1},         {"cm", 0.01},
      {"mm", 0.001}};
  const auto found = units.find(unit);
  if (found == units.end()) return std::nullopt;
  return found->second;
}

HeightScale scale_of(GDALRasterBand& band, const DemImportOptions& options, std::vector<std::string>& notes) {
  const std::string unit = band.GetUnitType();
  const auto metres = metres_per_unit(unit);
  if (!metres) notes.push_back("Unknown unit of height '" + unit + "': read as metres.");
  if (metres && *metres != 1) notes.push_back("Heights in " + unit + ": converted to metres.");
  const double to_metres = metres.value_or(1) * options.vertical_scale;
  return {band.GetScale() * to_metres, band.GetOffset() * to_metres + options.vertical_offset};
}

std::optional<float> no_data_of(GDALRasterBand& band) {
  int has_value = 0;
  const double value = band.GetNoDataValue(&has_value);
  if (!has_value) return std::nullopt;
  return float(value);
}

/// A band that says which cells are valid, or null when the file has none.
GDALRasterBand* mask_of(GDALDataset& dataset) {
  GDALRasterBand& band = *dataset.GetRasterBand(1);
  const int flags = band.GetMaskFlags();
  if ((flags & (GMF_PER_DATASET | GMF_ALPHA)) == 0 || (flags & GMF_ALL_VALID) != 0) return nullptr;
  return band.GetMaskBand();
}

Status read_cells(const std::filesystem::path& file, GDALDataset& dataset, const Rect& crop, const HeightScale& scale,
                  HeightSource& source, const TaskContext& context) {
  GDALRasterBand& band = *dataset.GetRasterBand(1);
  GDALRasterBand* mask = mask_of(dataset);
  const auto no_data = no_data_of(band);
  std::vector<std::uint8_t> valid(mask == nullptr ? 0 : std::size_t(crop.width()) * rows_a_read);
  for (int y = 0; y < crop.height(); y += rows_a_read) {
    if (context.stopped()) return fail(stopped_message);
    context.report("reading heights", double(y) / crop.height());
    const int rows = std::min(rows_a_read, crop.height() - y);
    const GdalErrorScope errors;
    const CPLErr read = band.RasterIO(GF_Read, crop.x0, crop.y0 + y, crop.width(), rows, source.height.row(y).data(),
                                      crop.width(), rows, GDT_Float32, 0, 0, nullptr);
    const CPLErr masked = mask == nullptr ? CE_None
                                          : mask->RasterIO(GF_Read, crop.x0, crop.y0 + y, crop.width(), rows,
                                                           valid.data(), crop.width(), rows, GDT_Byte, 0, 0, nullptr);
    if (read != CE_None || masked != CE_None || errors.failed()) {
      return fail(file.string() + ": is damaged or cut short: rows " + std::to_string(crop.y0 + y) + " to " +
                  std::to_string(crop.y0 + y + rows - 1) + " cannot be read" + because(errors) +
                  ". Copy or download it again.");
    }
    for (int row = 0; row < rows; ++row) {
      const auto cells = source.height.row(y + row);
      source.absurd_cells += scale_heights(cells, scale, no_data);
      if (mask == nullptr) continue;
      for (std::size_t x = 0; x < cells.size(); ++x) {
        if (valid[std::size_t(row) * cells.size() + x] == 0) cells[x] = std::nanf("");
      }
    }
  }
  return {};
}

void read_georeference(GDALDataset& dataset, const Rect& crop, HeightSource& source) {
  std::array<double, 6> t{};
  if (dataset.GetGeoTransform(t.data()) == CE_None) {
    t[0] += crop.x0 * t[1] + crop.y0 * t[2];
    t[3] += crop.x0 * t[4] + crop.y0 * t[5];
    source.transform = t;
  }
  const char* wkt = dataset.GetProjectionRef();
  if (wkt != nullptr) source.wkt = wkt;
}

}  // namespace

Status check_readable(const std::filesystem::path& file) {
  std::error_code error;
  const auto status = std::filesystem::status(file, error);
  if (!std::filesystem::exists(status)) return fail(file.string() + ": no such file.");
  if (std::filesystem::is_directory(status)) {
    return fail(file.string() + ": is a folder; give one of the files in it.");
  }
  if (!std::filesystem::is_regular_file(status)) return fail(file.string() + ": is not a plain file.");
  const auto bytes = std::filesystem::file_size(file, error);
  if (error) return fail(file.string() + ": cannot be read (" + error.message() + ").");
  if (bytes == 0) return fail(file.string() + ": is empty.");
  return {};
}

Result<Rect> crop_of(const std::filesystem::path& file, const DemImportOptions& options, int width, int height) {
  const std::string size = std::to_string(width) + " x " + std::to_string(height);
  if (width < 2 || height < 2) {
    return fail(file.string() + ": is a grid of " + size + " cells; a terrain needs at least 2 x 2.");
  }
  const Rect crop = options.crop.value_or(Rect{0, 0, width, height});
  if (crop.width() < 2 || crop.height() < 2 || intersection(crop, {0, 0, width, height}) != crop) {
    return fail(file.string() + ": the part to take (columns " + std::to_string(crop.x0) + ".." +
                std::to_string(crop.x1) + ", rows " + std::to_string(crop.y0) + ".." + std::to_string(crop.y1) +
                ") must lie within the file's " + size + " cells and be at least 2 x 2.");
  }
  if (std::max(crop.width(), crop.height()) > largest_side) {
    return fail(file.string() + ": " + size + " cells are too many; the longer side may have " +
                std::to_string(largest_side) + ". Take a part of it.");
  }
  return crop;
}

std::size_t scale_heights(std::span<float> row, const HeightScale& scale, std::optional<float> no_data) {
  std::size_t absurd = 0;
  for (float& cell : row) {
    const bool declared_missing = no_data && (cell == *no_data || (std::isnan(*no_data) && std::isnan(cell)));
    if (declared_missing || cell == customary_no_data || std::isnan(cell)) {
      cell = std::nanf("");
      continue;
    }
    const double metres = double(cell) * scale.factor + scale.offset;
    const bool believable = std::abs(metres) <= highest_ground;
    absurd += !believable;
    cell = believable ? float(metres) : std::nanf("");
  }
  return absurd;
}

Result<HeightSource> read_heights(const std::filesystem::path& file, const DemImportOptions& options,
                                  const TaskContext& context) {
  if (const Status readable = check_readable(file); !readable) return tl::unexpected(readable.error());
  if (options.raw) return read_raw_heights(file, options, context);
  GdalErrorScope errors;
  const DatasetPointer dataset = open_raster(file);
  if (!dataset) {
    return fail(file.string() + ": is not a raster that can be read" + because(errors) +
                ". Give a GeoTIFF, ASC, HGT, USGS DEM or 16-bit PNG, or --raw for bare samples.");
  }
  if (const Status bands = check_bands(file, *dataset); !bands) return tl::unexpected(bands.error());
  const auto crop = crop_of(file, options, dataset->GetRasterXSize(), dataset->GetRasterYSize());
  if (!crop) return tl::unexpected(crop.error());

  HeightSource source;
  source.format = dataset->GetDriverName();
  GDALRasterBand& band = *dataset->GetRasterBand(1);
  source.sample_type = GDALGetDataTypeName(band.GetRasterDataType());
  source.file_width = dataset->GetRasterXSize();
  source.file_height = dataset->GetRasterYSize();
  source.bands = dataset->GetRasterCount();
  read_georeference(*dataset, *crop, source);
  if (source.bands == 2 && dataset->GetRasterBand(2)->GetColorInterpretation() != GCI_AlphaBand) {
    source.notes.push_back("The file has 2 bands: the first is read.");
  }
  if (band.GetRasterDataType() == GDT_Byte) source.notes.push_back("8-bit heights: the ground will show steps.");
  const HeightScale scale = scale_of(band, options, source.notes);
  source.height = Grid<float>(crop->width(), crop->height());
  const Status read = read_cells(file, *dataset, *crop, scale, source, context);
  if (!read) return tl::unexpected(read.error());
  return source;
}

}  // namespace biotope

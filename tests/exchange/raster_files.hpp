#pragma once

#include <gdal/cpl_conv.h>
#include <gdal/cpl_string.h>
#include <gdal/gdal.h>
#include <gdal/ogr_srs_api.h>
#include <unistd.h>

#include <array>
#include <atomic>
#include <filesystem>
#include <fstream>
#include <optional>
#include <string>
#include <vector>

#include "core/base/grid.hpp"

namespace biotope_test {

/// A folder of its own for one test, gone with it.
class TemporaryFolder {
 public:
  TemporaryFolder() {
    static std::atomic<int> count{0};
    path_ = std::filesystem::temp_directory_path() /
            ("biotope-test-" + std::to_string(::getpid()) + "-" + std::to_string(count++));
    std::filesystem::create_directories(path_);
  }
  ~TemporaryFolder() {
    std::error_code ignored;
    std::filesystem::remove_all(path_, ignored);
  }
  TemporaryFolder(const TemporaryFolder&) = delete;
  TemporaryFolder& operator=(const TemporaryFolder&) = delete;
  std::filesystem::path operator/(const std::string& name) const { return path_ / name; }
  const std::filesystem::path& path() const { return path_; }
  /// Names of what it holds, hidden files too.
  std::vector<std::string> names() const {
    std::vector<std::string> found;
    for (const auto& entry : std::filesystem::directory_iterator(path_)) found.push_back(entry.path().filename());
    return found;
  }

 private:
  std::filesystem::path path_;
};

/// What a raster made for a test is like.
struct RasterRecipe {
  GDALDataType type = GDT_Float32;
  int epsg = 32631;  ///< 0: no CRS
  std::optional<std::array<double, 6>> transform{{500000, 10, 0, 4700000, 0, -10}};
  std::optional<double> no_data;
  std::optional<double> scale;
  std::optional<double> offset;
  std::string unit;
  int bands = 1;
  std::string driver = "GTiff";
  std::vector<std::string> creation;
};

/// Writes rows of cells (row 0 first) with GDAL; drivers that only copy get a copy.
inline void write_raster(const std::filesystem::path& file, const std::vector<std::vector<double>>& rows,
                         const RasterRecipe& recipe = {}) {
  GDALAllRegister();
  const int width = int(rows.front().size());
  const int height = int(rows.size());
  const bool direct = recipe.driver == "GTiff";
  char** options = nullptr;
  for (const auto& option : recipe.creation) options = CSLAddString(options, option.c_str());
  GDALDatasetH dataset = GDALCreate(GDALGetDriverByName(direct ? "GTiff" : "MEM"), file.c_str(), width, height,
                                    recipe.bands, recipe.type, direct ? options : nullptr);
  if (recipe.transform) {
    auto transform = *recipe.transform;
    GDALSetGeoTransform(dataset, transform.data());
  }
  if (recipe.epsg != 0) {
    OGRSpatialReferenceH reference = OSRNewSpatialReference(nullptr);
    OSRImportFromEPSG(reference, recipe.epsg);
    char* wkt = nullptr;
    OSRExportToWkt(reference, &wkt);
    GDALSetProjection(dataset, wkt);
    CPLFree(wkt);
    OSRDestroySpatialReference(reference);
  }
  for (int band = 1; band <= recipe.bands; ++band) {
    GDALRasterBandH target = GDALGetRasterBand(dataset, band);
    if (recipe.no_data) GDALSetRasterNoDataValue(target, *recipe.no_data);
    if (recipe.scale) GDALSetRasterScale(target, *recipe.scale);
    if (recipe.offset) GDALSetRasterOffset(target, *recipe.offset);
    if (!recipe.unit.empty()) GDALSetRasterUnitType(target, recipe.unit.c_str());
    for (int y = 0; y < height; ++y) {
      auto cells = rows[std::size_t(y)];
      if (GDALRasterIO(target, GF_Write, 0, y, width, 1, cells.data(), width, 1, GDT_Float64, 0, 0) != CE_None) std::abort();
    }
  }
  if (!direct) {
    GDALDatasetH copy = GDALCreateCopy(GDALGetDriverByName(recipe.driver.c_str()), file.c_str(), dataset, 0, options,
                                       nullptr, nullptr);
    if (copy != nullptr) GDALClose(copy);
  }
  GDALClose(dataset);
  CSLDestroy(options);
}

/// A small hill: 100 m + 3 a column + 5 a row.
inline std::vector<std::vector<double>> slope_rows(int width, int height) {
  std::vector<std::vector<double>> rows(std::size_t(height), std::vector<double>(std::size_t(width), 0.0));
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) rows[std::size_t(y)][std::size_t(x)] = 100 + 3 * x + 5 * y;
  }
  return rows;
}

/// Cuts a file to its first `bytes` bytes.
inline void truncate(const std::filesystem::path& file, std::uintmax_t bytes) {
  std::filesystem::resize_file(file, bytes);
}

inline std::string bytes_of(const std::filesystem::path& file) {
  std::ifstream stream(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), {}};
}

}  // namespace biotope_test

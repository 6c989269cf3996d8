#include <catch2/catch.hpp>
#include <cmath>
#include <limits>

#include "core/exchange/dem_import.hpp"
#include "tests/exchange/raster_files.hpp"

using namespace biotope;
using namespace biotope_test;
using Catch::Matchers::Contains;

namespace {

void require_slope(const Terrain& terrain, int width, int height) {
  REQUIRE(terrain.height.width() == width);
  REQUIRE(terrain.height.height() == height);
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) REQUIRE(terrain.height(x, y) == float(100 + 3 * x + 5 * y));
  }
}

std::string import_error(const std::filesystem::path& file, const DemImportOptions& options = {}) {
  const auto terrain = import_dem(file, options);
  REQUIRE_FALSE(terrain);
  return terrain.error().message;
}

}  // namespace

TEST_CASE("every sample type gives the same heights") {
  const TemporaryFolder folder;
  for (const GDALDataType type : {GDT_Byte, GDT_UInt16, GDT_Int16, GDT_UInt32, GDT_Int32, GDT_Float32, GDT_Float64}) {
    RasterRecipe recipe;
    recipe.type = type;
    write_raster(folder / "dem.tif", slope_rows(7, 5), recipe);
    const auto terrain = import_dem(folder / "dem.tif");
    INFO(GDALGetDataTypeName(type));
    REQUIRE(terrain);
    require_slope(*terrain, 7, 5);
    CHECK(terrain->cell_size == 10);
    CHECK(terrain->voids.empty());
    CHECK(terrain->name == "dem");
    CHECK(terrain->georeference.transform == std::array<double, 6>{500000, 10, 0, 4700000, 0, -10});
    CHECK(terrain->latitude == Approx(42.45).margin(0.1));
  }
}

TEST_CASE("an import never writes beside the file") {
  const TemporaryFolder folder;
  write_raster(folder / "dem.tif", slope_rows(6, 6));
  REQUIRE(import_dem(folder / "dem.tif"));
  CHECK(folder.names() == std::vector<std::string>{"dem.tif"});
}

TEST_CASE("cells without data are filled between their surroundings and marked") {
  const TemporaryFolder folder;
  auto rows = slope_rows(9, 9);
  rows[4][4] = -9000;
  RasterRecipe recipe;
  recipe.type = GDT_Int16;
  recipe.no_data = -9000;
  write_raster(folder / "dem.tif", rows, recipe);
  const auto terrain = import_dem(folder / "dem.tif");
  REQUIRE(terrain);
  CHECK(std::count(terrain->voids.cells().begin(), terrain->voids.cells().end(), 1) == 1);
  CHECK(terrain->voids(4, 4) == 1);
  CHECK(terrain->height(4, 4) == Approx(132).margin(0.01));
  CHECK(terrain->height(3, 4) == 129);

  DemImportOptions as_sea;
  as_sea.voids = VoidHandling::keep_as_sea;
  const auto coast = import_dem(folder / "dem.tif", as_sea);
  REQUIRE(coast);
  CHECK(coast->height(4, 4) < 0);
  CHECK(coast->voids(4, 4) == 1);
}

TEST_CASE("NaN, infinity, undeclared -9999 and heights off the Earth are voids") {
  const TemporaryFolder folder;
  auto rows = slope_rows(8, 8);
  rows[1][1] = std::nan("");
  rows[2][5] = std::numeric_limits<double>::infinity();
  rows[5][2] = -9999;
  rows[6][6] = 3.4e38;
  rows[0][7] = -32768;
  write_raster(folder / "dem.tif", rows);
  const auto terrain = import_dem(folder / "dem.tif");
  REQUIRE(terrain);
  CHECK(std::count(terrain->voids.cells().begin(), terrain->voids.cells().end(), 1) == 5);
  for (const float height : terrain->height.cells()) {
    CHECK(height >= 95);
    CHECK(height <= 165);
  }
}

TEST_CASE("the sea floor keeps its negative heights") {
  const TemporaryFolder folder;
  write_raster(folder / "dem.tif", {{-2805.5, -10}, {3, 1520.25}});
  const auto terrain = import_dem(folder / "dem.tif");
  REQUIRE(terrain);
  CHECK(terrain->height(0, 0) == -2805.5F);
  CHECK(terrain->height(1, 0) == -10);
  CHECK(terrain->voids.empty());
}

TEST_CASE("a file's scale, offset and unit and a person's own are applied") {
  const TemporaryFolder folder;
  RasterRecipe recipe;
  recipe.type = GDT_Int16;
  recipe.scale = 0.5;
  recipe.offset = 1000;
  write_raster(folder / "scaled.tif", {{0, 2}, {4, 6}}, recipe);
  const auto scaled = import_dem(folder / "scaled.tif");
  REQUIRE(scaled);
  CHECK(scaled->height(1, 1) == 1003);

  RasterRecipe feet;
  feet.unit = "ft";
  write_raster(folder / "feet.tif", {{1000, 1000}, {1000, 2000}}, feet);
  const auto metres = import_dem(folder / "feet.tif");
  REQUIRE(metres);
  CHECK(metres->height(1, 1) == Approx(609.6));

  DemImportOptions options;
  options.vertical_scale = 2;
  options.vertical_offset = -7;
  write_raster(folder / "plain.tif", {{10, 10}, {10, 20}});
  const auto stretched = import_dem(folder / "plain.tif", options);
  REQUIRE(stretched);
  CHECK(stretched->height(1, 1) == 33);
  options.vertical_scale = -1;
  CHECK_THAT(import_error(folder / "plain.tif", options), Contains("vertical scale"));
}

TEST_CASE("a crop and a resample take what was asked") {
  const TemporaryFolder folder;
  write_raster(folder / "dem.tif", slope_rows(12, 10));
  DemImportOptions options;
  options.crop = Rect{2, 3, 10, 9};
  const auto cropped = import_dem(folder / "dem.tif", options);
  REQUIRE(cropped);
  REQUIRE(cropped->height.width() == 8);
  REQUIRE(cropped->height.height() == 6);
  CHECK(cropped->height(0, 0) == 100 + 3 * 2 + 5 * 3);
  CHECK(cropped->georeference.transform[0] == 500020);
  CHECK(cropped->georeference.transform[3] == 4700000 - 30);

  options.longer_side = 4;
  const auto small = import_dem(folder / "dem.tif", options);
  REQUIRE(small);
  CHECK(small->height.width() == 4);
  CHECK(small->height.height() == 3);
  CHECK(small->cell_size == 20);
  CHECK(small->height(0, 0) == Approx(100 + 3 * 2.5 + 5 * 3.5));

  options.crop = Rect{5, 5, 20, 8};
  CHECK_THAT(import_error(folder / "dem.tif", options), Contains("12 x 10"));
}

TEST_CASE("headerless RAW is read in either byte order") {
  const TemporaryFolder folder;
  const std::vector<unsigned char> big{0x01, 0x00, 0x01, 0x2c, 0x00, 0x64, 0x00, 0x00, 0xff, 0xf6, 0x00, 0x05};
  std::ofstream(folder / "dem.raw", std::ios::binary).write(reinterpret_cast<const char*>(big.data()), std::streamsize(big.size()));
  DemImportOptions options;
  options.raw = RawLayout{3, 2, "int16", true, 0};
  options.cell_size = 5;
  const auto terrain = import_dem(folder / "dem.raw", options);
  REQUIRE(terrain);
  CHECK(terrain->height(0, 0) == 256);
  CHECK(terrain->height(1, 0) == 300);
  CHECK(terrain->height(1, 1) == -10);
  CHECK(terrain->cell_size == 5);
  CHECK(terrain->georeference.transform == std::array<double, 6>{0, 5, 0, 10, 0, -5});

  options.raw->width = 4;
  CHECK_THAT(import_error(folder / "dem.raw", options), Contains("12 bytes") && Contains("16"));
  options.raw = RawLayout{3, 2, "int17", true, 0};
  CHECK_THAT(import_error(folder / "dem.raw", options), Contains("int17") && Contains("float32"));
  options.raw = RawLayout{2, 2, "int16", true, 4};
  const auto after_header = import_dem(folder / "dem.raw", options);
  REQUIRE(after_header);
  CHECK(after_header->height(0, 0) == 100);
}

TEST_CASE("RAW of every sample type") {
  const TemporaryFolder folder;
  const auto check = [&](const std::string& type, auto sample) {
    const std::array<decltype(sample), 4> cells{1, 2, 3, sample};
    std::ofstream(folder / "dem.raw", std::ios::binary).write(reinterpret_cast<const char*>(cells.data()), sizeof cells);
    DemImportOptions options;
    options.raw = RawLayout{2, 2, type, false, 0};
    options.cell_size = 1;
    const auto terrain = import_dem(folder / "dem.raw", options);
    INFO(type);
    REQUIRE(terrain);
    CHECK(terrain->height(1, 1) == float(sample));
    CHECK(terrain->height(1, 0) == 2);
  };
  check("uint8", std::uint8_t(200));
  check("int16", std::int16_t(-3000));
  check("uint16", std::uint16_t(9000));
  check("int32", std::int32_t(-4000));
  check("uint32", std::uint32_t(8000));
  check("float32", 12.75F);
  check("float64", -0.125);
}

TEST_CASE("other formats: ASC, 16-bit PNG, SRTM HGT and USGS DEM") {
  const TemporaryFolder folder;
  std::ofstream(folder / "dem.asc") << "ncols 3\nnrows 2\nxllcorner 1000\nyllcorner 2000\ncellsize 25\n"
                                    << "NODATA_value -9999\n1 2 3\n4.5 -9999 6\n";
  const auto asc = import_dem(folder / "dem.asc");
  REQUIRE(asc);
  CHECK(asc->cell_size == 25);
  CHECK(asc->height(0, 1) == 4.5F);
  CHECK(asc->voids(1, 1) == 1);

  RasterRecipe png;
  png.driver = "PNG";
  png.type = GDT_UInt16;
  png.epsg = 0;
  png.transform.reset();
  write_raster(folder / "dem.png", slope_rows(5, 4), png);
  CHECK_THAT(import_error(folder / "dem.png"), Contains("dem.png") && Contains("--cell-size"));
  DemImportOptions options;
  options.cell_size = 2;
  const auto picture = import_dem(folder / "dem.png", options);
  REQUIRE(picture);
  require_slope(*picture, 5, 4);
  CHECK(picture->cell_size == 2);

  std::vector<char> hgt(1201 * 1201 * 2, 0);
  for (std::size_t i = 0; i < hgt.size(); i += 2) {
    hgt[i] = 0x04;
    hgt[i + 1] = char(i / 2402 % 100);
  }
  std::ofstream(folder / "N42E002.hgt", std::ios::binary).write(hgt.data(), std::streamsize(hgt.size()));
  const auto srtm = import_dem(folder / "N42E002.hgt");
  REQUIRE(srtm);
  CHECK(srtm->cell_size == Approx(80).margin(3));
  CHECK(srtm->latitude == Approx(42.5).margin(0.01));
  CHECK(srtm->voids.empty());
}

TEST_CASE("what is no DEM says so in the person's words") {
  const TemporaryFolder folder;
  CHECK_THAT(import_error(folder / "none.tif"), Contains("none.tif") && Contains("no such file"));
  CHECK_THAT(import_error(folder.path()), Contains("folder"));
  std::ofstream(folder / "empty.tif");
  CHECK_THAT(import_error(folder / "empty.tif"), Contains("empty"));
  std::ofstream(folder / "text.tif") << "this is a letter, not a map\n";
  CHECK_THAT(import_error(folder / "text.tif"), Contains("text.tif") && Contains("not a raster"));

  RasterRecipe photo;
  photo.bands = 3;
  photo.type = GDT_Byte;
  write_raster(folder / "photo.tif", slope_rows(4, 4), photo);
  CHECK_THAT(import_error(folder / "photo.tif"), Contains("looks like a photo with 3 bands; a DEM has one"));
  photo.bands = 4;
  write_raster(folder / "photo4.tif", slope_rows(4, 4), photo);
  CHECK_THAT(import_error(folder / "photo4.tif"), Contains("4 bands"));

  write_raster(folder / "cell.tif", {{5}});
  CHECK_THAT(import_error(folder / "cell.tif"), Contains("1 x 1") && Contains("at least 2 x 2"));
  write_raster(folder / "line.tif", {{5, 6, 7}});
  CHECK_THAT(import_error(folder / "line.tif"), Contains("3 x 1") && Contains("at least 2 x 2"));

  RasterRecipe nothing;
  nothing.no_data = 0;
  write_raster(folder / "void.tif", {{0, 0}, {0, 0}}, nothing);
  CHECK_THAT(import_error(folder / "void.tif"), Contains("every cell is void"));
  write_raster(folder / "units.tif", {{30000, 40000}, {50000, 60000}});
  CHECK_THAT(import_error(folder / "units.tif"), Contains("vertical scale"));
}

TEST_CASE("a damaged or cut file is an error, not a plain of zeros") {
  const TemporaryFolder folder;
  const auto rows = slope_rows(300, 300);
  for (const std::vector<std::string>& creation :
       {std::vector<std::string>{}, {"COMPRESS=DEFLATE"}, {"COMPRESS=LZW", "TILED=YES"}}) {
    RasterRecipe recipe;
    recipe.creation = creation;
    write_raster(folder / "whole.tif", rows, recipe);
    const auto size = std::filesystem::file_size(folder / "whole.tif");
    for (const double part : {0.3, 0.6, 0.9}) {
      std::filesystem::copy_file(folder / "whole.tif", folder / "cut.tif",
                                 std::filesystem::copy_options::overwrite_existing);
      truncate(folder / "cut.tif", std::uintmax_t(double(size) * part));
      INFO((creation.empty() ? "plain" : creation[0]) << " cut at " << part);
      CHECK_THAT(import_error(folder / "cut.tif"), Contains("cut.tif"));
    }
  }
  std::ofstream(folder / "cut.asc") << "ncols 3\nnrows 3\nxllcorner 0\nyllcorner 0\ncellsize 10\n1 2 3\n4 5\n";
  CHECK_THAT(import_error(folder / "cut.asc"), Contains("cut.asc"));
  RasterRecipe png;
  png.driver = "PNG";
  png.type = GDT_UInt16;
  write_raster(folder / "cut.png", rows, png);
  truncate(folder / "cut.png", std::filesystem::file_size(folder / "cut.png") / 2);
  DemImportOptions options;
  options.cell_size = 1;
  CHECK_THAT(import_error(folder / "cut.png", options), Contains("cut.png"));
}

TEST_CASE("a preview tells what an import would give") {
  const TemporaryFolder folder;
  auto rows = slope_rows(600, 40);
  rows[10][10] = -9999;
  RasterRecipe recipe;
  recipe.no_data = -9999;
  write_raster(folder / "dem.tif", rows, recipe);
  const auto preview = preview_dem(folder / "dem.tif");
  REQUIRE(preview);
  CHECK(preview->format == "GTiff");
  CHECK(preview->sample_type == "Float32");
  CHECK(preview->width == 600);
  CHECK(preview->height == 40);
  CHECK(preview->cell_size == 10.0);
  CHECK_THAT(preview->crs_name, Contains("UTM zone 31N"));
  CHECK_FALSE(preview->geographic);
  CHECK(preview->lowest == 100);
  CHECK(preview->highest == 100 + 3 * 599 + 5 * 39);
  CHECK(preview->void_cells == 1);
  CHECK(preview->total_cells == 24000);
  CHECK(preview->thumbnail.height.width() == 512);
  REQUIRE_FALSE(preview->notes.empty());
  CHECK_THAT(preview->notes.back(), Contains("no data"));

  RasterRecipe bare;
  bare.epsg = 0;
  bare.transform.reset();
  write_raster(folder / "bare.tif", slope_rows(4, 4), bare);
  const auto unknown = preview_dem(folder / "bare.tif");
  REQUIRE(unknown);
  CHECK_FALSE(unknown->cell_size);
}

TEST_CASE("a stopped import ends without a terrain") {
  const TemporaryFolder folder;
  write_raster(folder / "dem.tif", slope_rows(6, 6));
  std::stop_source stop;
  stop.request_stop();
  CHECK_FALSE(import_dem(folder / "dem.tif", {}, {{}, stop.get_token()}));
}

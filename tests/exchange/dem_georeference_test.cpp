#include <catch2/catch.hpp>
#include <cmath>

#include "core/exchange/dem_import.hpp"
#include "tests/exchange/raster_files.hpp"

using namespace biotope;
using namespace biotope_test;
using Catch::Matchers::Contains;

namespace {

std::string notes_of(const std::filesystem::path& file) {
  const auto preview = preview_dem(file);
  REQUIRE(preview);
  std::string all;
  for (const auto& note : preview->notes) all += note + "\n";
  return all;
}

/// Rows of a plane over degrees that falls evenly to the south.
std::vector<std::vector<double>> southward_rows(int width, int height) {
  std::vector<std::vector<double>> rows(std::size_t(height), std::vector<double>(std::size_t(width), 0.0));
  for (int y = 0; y < height; ++y) {
    for (double& cell : rows[std::size_t(y)]) cell = 1000 - y;
  }
  return rows;
}

}  // namespace

TEST_CASE("degrees become square metres of the local UTM zone") {
  const TemporaryFolder folder;
  RasterRecipe degrees;
  degrees.epsg = 4326;
  const double step = 1.0 / 3600;
  degrees.transform = {{2.7, step, 0, 42.9, 0, -step}};
  write_raster(folder / "dem.tif", southward_rows(240, 240), degrees);
  const auto terrain = import_dem(folder / "dem.tif");
  REQUIRE(terrain);
  // One second of arc at 42.87 N is 22.7 m by 30.9 m; square cells keep the area.
  CHECK(terrain->cell_size == Approx(26.5).margin(0.2));
  CHECK(terrain->latitude == Approx(42.867).margin(0.01));
  CHECK_THAT(terrain->georeference.wkt, Contains("UTM zone 31N"));
  CHECK(terrain->voids.empty());
  const double width = terrain->width_metres();
  const double height = terrain->height_metres();
  CHECK(width == Approx(240 * 22.7).epsilon(0.03));
  CHECK(height == Approx(240 * 30.9).epsilon(0.03));
  // The plane falls 1 m every 30.9 m to the south, whatever the cells are.
  const int middle = terrain->height.width() / 2;
  const double fall = double(terrain->height(middle, 10) - terrain->height(middle, 110));
  CHECK(fall == Approx(100 * terrain->cell_size / 30.86).epsilon(0.01));
  CHECK_THAT(notes_of(folder / "dem.tif"), Contains("UTM 31N"));
}

TEST_CASE("a void in degrees stays a void of about its size") {
  const TemporaryFolder folder;
  auto rows = southward_rows(120, 120);
  for (int y = 50; y < 60; ++y) {
    for (int x = 50; x < 60; ++x) rows[std::size_t(y)][std::size_t(x)] = -32768;
  }
  RasterRecipe degrees;
  degrees.epsg = 4326;
  degrees.type = GDT_Int16;
  degrees.no_data = -32768;
  degrees.transform = {{-70.5, 1.0 / 3600, 0, -33, 0, -1.0 / 3600}};
  write_raster(folder / "dem.tif", rows, degrees);
  const auto terrain = import_dem(folder / "dem.tif");
  REQUIRE(terrain);
  CHECK_THAT(terrain->georeference.wkt, Contains("UTM zone 19S"));
  const auto voids = std::count(terrain->voids.cells().begin(), terrain->voids.cells().end(), 1);
  CHECK(voids > 80);
  CHECK(voids < 120);
  for (const float height : terrain->height.cells()) {
    CHECK(height <= 1000);
    CHECK(height >= 880);
  }
}

TEST_CASE("feet on the ground become metres") {
  const TemporaryFolder folder;
  RasterRecipe feet;
  feet.epsg = 2229;  // NAD83 / California zone 5 (ftUS)
  feet.transform = {{6500000, 100, 0, 1900000, 0, -100}};
  write_raster(folder / "dem.tif", slope_rows(8, 8), feet);
  const auto terrain = import_dem(folder / "dem.tif");
  REQUIRE(terrain);
  CHECK(terrain->cell_size == Approx(30.48006));
  CHECK(terrain->height(3, 2) == 119);
  CHECK(terrain->georeference.transform[1] == 100);
}

TEST_CASE("a projection that stretches distances is put right") {
  const TemporaryFolder folder;
  RasterRecipe web;
  web.epsg = 3857;
  web.transform = {{300000, 30, 0, 5300000, 0, -30}};
  write_raster(folder / "dem.tif", slope_rows(60, 60), web);
  const auto terrain = import_dem(folder / "dem.tif");
  REQUIRE(terrain);
  // 5300 km of Mercator are 42.9 N, where it stretches by 1 / cos(latitude).
  CHECK(terrain->cell_size == Approx(30 * std::cos(42.9 * 3.14159265 / 180)).epsilon(0.005));
  CHECK_THAT(notes_of(folder / "dem.tif"), Contains("stretches"));
}

TEST_CASE("mirrored grids are turned north-up without a change of value") {
  const TemporaryFolder folder;
  RasterRecipe south_up;
  south_up.transform = {{500000, 10, 0, 4700000, 0, 10}};
  write_raster(folder / "dem.tif", slope_rows(4, 3), south_up);
  const auto terrain = import_dem(folder / "dem.tif");
  REQUIRE(terrain);
  CHECK(terrain->height(0, 0) == 110);
  CHECK(terrain->height(3, 2) == 109);
  CHECK(terrain->georeference.transform == std::array<double, 6>{500000, 10, 0, 4700030, 0, -10});
}

TEST_CASE("oblong cells become square ones") {
  const TemporaryFolder folder;
  RasterRecipe oblong;
  oblong.transform = {{500000, 20, 0, 4700000, 0, -5}};
  write_raster(folder / "dem.tif", slope_rows(20, 80), oblong);
  const auto terrain = import_dem(folder / "dem.tif");
  REQUIRE(terrain);
  CHECK(terrain->cell_size == Approx(10));
  CHECK(terrain->height.width() == 40);
  CHECK(terrain->height.height() == 40);
  // 3 m a column of 20 m and 5 m a row of 5 m.
  CHECK(terrain->height(21, 20) - terrain->height(20, 20) == Approx(1.5));
  CHECK(terrain->height(20, 21) - terrain->height(20, 20) == Approx(10));
}

TEST_CASE("a turned grid is laid north-up") {
  const TemporaryFolder folder;
  const double c = 10 * std::cos(0.3);
  const double s = 10 * std::sin(0.3);
  RasterRecipe turned;
  turned.transform = {{500000, c, s, 4700000, s, -c}};
  write_raster(folder / "dem.tif", slope_rows(60, 60), turned);
  const auto terrain = import_dem(folder / "dem.tif");
  REQUIRE(terrain);
  CHECK(terrain->cell_size == Approx(10));
  CHECK(terrain->voids.empty());
  CHECK(terrain->height.width() >= 25);
  // The plane 3 m a column + 5 m a row, measured along east: (3 cos - 5 sin ...) per 10 m.
  const double east = double(terrain->height(15, 12) - terrain->height(14, 12));
  const double determinant = -(c * c + s * s);
  const double columns_a_metre = -c / determinant;
  const double rows_a_metre = -s / determinant;
  CHECK(east == Approx(10 * (3 * columns_a_metre + 5 * rows_a_metre)).margin(1e-3));
}

TEST_CASE("no CRS: a pixel size is metres, degrees in disguise and none at all are asked for") {
  const TemporaryFolder folder;
  RasterRecipe local;
  local.epsg = 0;
  local.transform = {{0, 20, 0, 100, 0, -20}};
  write_raster(folder / "local.tif", slope_rows(5, 5), local);
  const auto terrain = import_dem(folder / "local.tif");
  REQUIRE(terrain);
  CHECK(terrain->cell_size == 20);
  CHECK(terrain->georeference.wkt.empty());
  CHECK_THAT(notes_of(folder / "local.tif"), Contains("No coordinate system"));

  local.transform = {{2.7, 0.000277, 0, 42.9, 0, -0.000277}};
  write_raster(folder / "degrees.tif", slope_rows(5, 5), local);
  const auto degrees = import_dem(folder / "degrees.tif");
  REQUIRE_FALSE(degrees);
  CHECK_THAT(degrees.error().message, Contains("degrees") && Contains("--cell-size M"));

  DemImportOptions options;
  options.cell_size = 12.5;
  options.latitude = -20;
  const auto given = import_dem(folder / "degrees.tif", options);
  REQUIRE(given);
  CHECK(given->cell_size == 12.5);
  CHECK(given->latitude == -20);
  CHECK(given->height(4, 4) == 132);
}

TEST_CASE("a given cell size overrules the georeference") {
  const TemporaryFolder folder;
  write_raster(folder / "dem.tif", slope_rows(5, 5));
  DemImportOptions options;
  options.cell_size = 3;
  const auto terrain = import_dem(folder / "dem.tif", options);
  REQUIRE(terrain);
  CHECK(terrain->cell_size == 3);
  CHECK(terrain->georeference.wkt.empty());
  CHECK(terrain->georeference.transform == std::array<double, 6>{0, 3, 0, 15, 0, -3});
  options.cell_size = 0;
  CHECK_FALSE(import_dem(folder / "dem.tif", options));
}

TEST_CASE("half the world is no landscape") {
  const TemporaryFolder folder;
  RasterRecipe world;
  world.epsg = 4326;
  world.transform = {{-180, 1, 0, 90, 0, -1}};
  write_raster(folder / "world.tif", slope_rows(360, 180), world);
  const auto terrain = import_dem(folder / "world.tif");
  REQUIRE_FALSE(terrain);
  CHECK_THAT(terrain.error().message, Contains("Take a part"));
}

TEST_CASE("the DEMs people try first") {
  const std::filesystem::path data = std::filesystem::path(BIOTOPE_SHARED_DATA) / "dem";
  if (!std::filesystem::exists(data)) return;
  struct Expected {
    const char* file;
    int width, height;
    double cell_size;
    float lowest, highest;
  };
  for (const Expected& expected : {Expected{"SainteHelens.dem", 327, 468, 30, 682, 2543},
                                   {"bigtujunga_utm11.tif", 1197, 643, 30, 315, 2295},
                                   {"monterey_topobathy_utm10_180m.tif", 504, 622, 180, -2805.5F, 1520.54F},
                                   {"mtperdu_20m.tif", 1500, 1500, 20, 656.5F, 3343.5F},
                                   {"sthelens_10m.tif", 2000, 2000, 10, 567.5F, 2538.2F}}) {
    INFO(expected.file);
    const auto terrain = import_dem(data / expected.file);
    REQUIRE(terrain);
    CHECK(terrain->height.width() == expected.width);
    CHECK(terrain->height.height() == expected.height);
    CHECK(terrain->cell_size == Approx(expected.cell_size));
    const auto cells = terrain->height.cells();
    const auto [lowest, highest] = std::minmax_element(cells.begin(), cells.end());
    CHECK(*lowest == Approx(expected.lowest).epsilon(0.001));
    CHECK(*highest == Approx(expected.highest).epsilon(0.001));
  }
}

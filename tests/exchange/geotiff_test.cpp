#include <catch2/catch.hpp>

#include "core/base/random.hpp"
#include "core/exchange/dem_import.hpp"
#include "core/exchange/geotiff.hpp"
#include "tests/exchange/raster_files.hpp"

using namespace biotope;
using namespace biotope_test;
using Catch::Matchers::Contains;

namespace {

Terrain some_terrain(const TemporaryFolder& folder) {
  write_raster(folder / "dem.tif", slope_rows(300, 270));
  const auto terrain = import_dem(folder / "dem.tif");
  REQUIRE(terrain);
  return *terrain;
}

}  // namespace

TEST_CASE("a written map is read back to the bit, in its place on the Earth") {
  const TemporaryFolder folder;
  const Terrain terrain = some_terrain(folder);
  Grid<float> map(300, 270);
  for (std::size_t i = 0; i < map.size(); ++i) map[i] = float(random_unit({3, i}) * 1e6 - 5e5);
  REQUIRE(write_geotiff(folder / "map.tif", map, terrain));
  const auto back = read_raster(folder / "map.tif");
  REQUIRE(back);
  CHECK(*back == map);

  GDALDatasetH dataset = GDALOpen((folder / "map.tif").c_str(), GA_ReadOnly);
  REQUIRE(dataset != nullptr);
  std::array<double, 6> transform{};
  GDALGetGeoTransform(dataset, transform.data());
  CHECK(transform == terrain.georeference.transform);
  CHECK_THAT(GDALGetProjectionRef(dataset), Contains("32631"));
  CHECK(GDALGetRasterDataType(GDALGetRasterBand(dataset, 1)) == GDT_Float32);
  GDALClose(dataset);
}

TEST_CASE("the same map gives the same bytes") {
  const TemporaryFolder folder;
  const Terrain terrain = some_terrain(folder);
  REQUIRE(write_geotiff(folder / "a.tif", terrain.height, terrain));
  REQUIRE(write_geotiff(folder / "b.tif", terrain.height, terrain));
  CHECK(bytes_of(folder / "a.tif") == bytes_of(folder / "b.tif"));
}

TEST_CASE("a map that cannot be written leaves nothing") {
  const TemporaryFolder folder;
  const Terrain terrain = some_terrain(folder);
  const Status missing_folder = write_geotiff(folder / "none" / "map.tif", terrain.height, terrain);
  REQUIRE_FALSE(missing_folder);
  CHECK_THAT(missing_folder.error().message, Contains("map.tif"));
  std::filesystem::create_directory(folder / "taken.tif");
  std::ofstream(folder / "taken.tif" / "inside") << "x";
  CHECK_FALSE(write_geotiff(folder / "taken.tif", terrain.height, terrain));
  CHECK(folder.names().size() == 2);
}

TEST_CASE("reading what is no one-band raster names the file") {
  const TemporaryFolder folder;
  std::ofstream(folder / "text.tif") << "no raster";
  const auto text = read_raster(folder / "text.tif");
  REQUIRE_FALSE(text);
  CHECK_THAT(text.error().message, Contains("text.tif"));
  RasterRecipe photo;
  photo.bands = 3;
  write_raster(folder / "photo.tif", slope_rows(4, 4), photo);
  const auto bands = read_raster(folder / "photo.tif");
  REQUIRE_FALSE(bands);
  CHECK_THAT(bands.error().message, Contains("3 bands"));
}

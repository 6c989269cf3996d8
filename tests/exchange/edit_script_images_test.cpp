#include <catch2/catch.hpp>

#include <cmath>

#include "core/exchange/geotiff.hpp"
#include "core/exchange/layer_image.hpp"
#include "tests/exchange/raster_files.hpp"
#include "tests/scenes/small_valley.hpp"

using namespace biotope;
using namespace biotope_test;
using Catch::Matchers::Contains;

namespace {

Terrain flat(int width, int height) {
  Terrain terrain;
  terrain.height = Grid<float>(width, height);
  terrain.georeference.transform = {100, 10, 0, 900, 0, -10};
  return terrain;
}

const LayerId moisture{LayerKind::resource, "moisture"};
const LayerId oak{LayerKind::plant_density, "quercus"};
const LayerId geology{LayerKind::geology, "class"};
const LayerId ground{LayerKind::ground, "height"};
const LayerId deer{LayerKind::animal_density, "deer"};

RasterRecipe picture(const std::string& driver, int bands, GDALDataType type = GDT_Byte) {
  RasterRecipe recipe;
  recipe.type = type;
  recipe.bands = bands;
  recipe.driver = driver;
  recipe.epsg = 0;
  recipe.transform.reset();
  return recipe;
}

}  // namespace

TEST_CASE("black and white of a picture are the ends of the layer's range") {
  const TemporaryFolder folder;
  write_raster(folder / "a.png", {{0, 255}, {51, 102}}, picture("PNG", 1));
  const auto resource = read_layer_image(folder / "a.png", moisture, flat(2, 2));
  REQUIRE(resource);
  CHECK((*resource)(0, 0) == 1);
  CHECK((*resource)(1, 0) == 9);
  CHECK((*resource)(0, 1) == Approx(1 + 8 * 0.2));
  const auto cover = read_layer_image(folder / "a.png", oak, flat(2, 2));
  REQUIRE(cover);
  CHECK((*cover)(1, 1) == Approx(0.4));
  const auto told = read_layer_image(folder / "a.png", ground, flat(2, 2), ValueRange{100, 200});
  REQUIRE(told);
  CHECK((*told)(0, 1) == Approx(120));
  const auto untold = read_layer_image(folder / "a.png", deer, flat(2, 2));
  REQUIRE_FALSE(untold);
  CHECK_THAT(untold.error().message, Contains("a.png") && Contains("black and white"));
}

TEST_CASE("sixteen bits are finer than eight, and numbers are taken as they are") {
  const TemporaryFolder folder;
  write_raster(folder / "a.png", {{1, 65535}}, picture("PNG", 1, GDT_UInt16));
  const auto fine = read_layer_image(folder / "a.png", oak, flat(2, 1));
  REQUIRE(fine);
  CHECK((*fine)(0, 0) == Approx(1 / 65535.0));
  RasterRecipe numbers = picture("GTiff", 1, GDT_Float32);
  numbers.no_data = -1;
  write_raster(folder / "a.tif", {{12.5, -1}}, numbers);
  const auto values = read_layer_image(folder / "a.tif", deer, flat(2, 1));
  REQUIRE(values);
  CHECK((*values)(0, 0) == 12.5F);
  CHECK(std::isnan((*values)(1, 0)));
}

TEST_CASE("an image is stretched over the terrain: means where it is finer, linear where it is coarser") {
  const TemporaryFolder folder;
  RasterRecipe numbers = picture("GTiff", 1, GDT_Float32);
  write_raster(folder / "fine.tif", {{1, 3, 5, 7}, {1, 3, 5, 7}}, numbers);
  const auto means = read_layer_image(folder / "fine.tif", deer, flat(2, 1));
  REQUIRE(means);
  CHECK((*means)(0, 0) == Approx(2));
  CHECK((*means)(1, 0) == Approx(6));
  write_raster(folder / "coarse.tif", {{0, 8}}, numbers);
  const auto ramp = read_layer_image(folder / "coarse.tif", deer, flat(8, 3));
  REQUIRE(ramp);
  CHECK((*ramp)(0, 0) == 0);
  CHECK((*ramp)(7, 2) == 8);
  CHECK((*ramp)(3, 1) == Approx(3));
  CHECK((*ramp)(4, 1) == Approx(5));
}

TEST_CASE("what is transparent is left alone") {
  const TemporaryFolder folder;
  PaintLayer paint(3, 1);
  paint.set(0, 0, {4, 1});
  paint.set(1, 0, {8, 0.2F});
  REQUIRE(write_paint_png(folder / "a.png", paint, flat(3, 1), ValueRange{0, 9}));
  const auto values = read_layer_image(folder / "a.png", deer, flat(3, 1), ValueRange{0, 9});
  REQUIRE(values);
  CHECK((*values)(0, 0) == Approx(4).epsilon(1e-4));
  CHECK(std::isnan((*values)(1, 0)));
  CHECK(std::isnan((*values)(2, 0)));
}

TEST_CASE("geology goes out in its colours and comes back as its classes") {
  const TemporaryFolder folder;
  Grid<float> classes(5, 2);
  for (int x = 0; x < 5; ++x) classes(x, 0) = classes(x, 1) = float(x);
  classes(4, 1) = std::nanf("");
  REQUIRE(write_geology_png(folder / "a.png", classes, flat(5, 2)));
  const auto read = read_layer_image(folder / "a.png", geology, flat(5, 2));
  REQUIRE(read);
  for (int x = 0; x < 5; ++x) CHECK((*read)(x, 0) == float(x));
  CHECK(std::isnan((*read)(4, 1)));
  const auto larger = read_layer_image(folder / "a.png", geology, flat(50, 20));
  REQUIRE(larger);
  for (const float rock : larger->cells()) CHECK((std::isnan(rock) || rock == std::round(rock)));
  write_raster(folder / "numbers.png", {{0, 4}}, picture("PNG", 1));
  CHECK((*read_layer_image(folder / "numbers.png", geology, flat(2, 1)))(1, 0) == 4);
  write_raster(folder / "wrong.png", {{0, 5}}, picture("PNG", 1));
  const auto wrong = read_layer_image(folder / "wrong.png", geology, flat(2, 1));
  REQUIRE_FALSE(wrong);
  CHECK_THAT(wrong.error().message, Contains("wrong.png") && Contains("geology class"));
}

TEST_CASE("a map written as PNG comes back within a step of sixteen bits, with its place on Earth beside it") {
  const TemporaryFolder folder;
  Grid<float> map(40, 30);
  for (std::size_t i = 0; i < map.size(); ++i) map[i] = 200 + float(i) / 7;
  map(5, 5) = std::nanf("");
  const Terrain terrain = flat(40, 30);
  const auto range = write_map_png(folder / "a.png", map, terrain);
  REQUIRE(range);
  CHECK(range->low == 200);
  const auto read = read_layer_image(folder / "a.png", ground, terrain, *range);
  REQUIRE(read);
  for (std::size_t i = 0; i < map.size(); ++i) {
    if (std::isnan(map[i])) {
      CHECK(std::isnan((*read)[i]));
    } else {
      CHECK(std::abs((*read)[i] - map[i]) <= (range->high - range->low) / 65535);
    }
  }
  CHECK(bytes_of(folder / "a.pgw") == "10\n0\n0\n-10\n105\n895\n");
}

TEST_CASE("paint written as a GeoTIFF holds value and coverage to the bit") {
  const TemporaryFolder folder;
  PaintLayer paint(90, 70);
  paint.set(80, 3, {1.0F / 3, 0.7F});
  REQUIRE(write_paint_geotiff(folder / "a.tif", paint, flat(90, 70)));
  const auto values = read_layer_image(folder / "a.tif", deer, flat(90, 70));
  REQUIRE(values);
  CHECK((*values)(80, 3) == 1.0F / 3);
  CHECK(std::isnan((*values)(0, 0)));
}

TEST_CASE("missing and odd files say which and why") {
  const TemporaryFolder folder;
  std::ofstream(folder / "text.png") << "hello";
  write_raster(folder / "many.tif", {{1, 2}}, picture("GTiff", 7, GDT_Float32));
  write_raster(folder / "cut.tif", slope_rows(200, 200), picture("GTiff", 1, GDT_Float32));
  truncate(folder / "cut.tif", 60000);
  for (const auto& [name, word] :
       {std::pair{"none.png", "no such file"}, {"text.png", "not an image"}, {"many.tif", "7 bands"}, {"cut.tif", "damaged"}}) {
    const auto read = read_layer_image(folder / name, oak, flat(2, 2));
    INFO(name);
    REQUIRE_FALSE(read);
    CHECK_THAT(read.error().message, Contains(name) && Contains(word));
  }
  CHECK_FALSE(write_map_png(folder / "no/where/a.png", Grid<float>(2, 2), flat(2, 2)));
  CHECK_FALSE(read_stamp(folder / "none.png"));
}

TEST_CASE("a stamp is brightness times opacity on its own pixels") {
  const TemporaryFolder folder;
  write_raster(folder / "a.png", {{0, 255, 51}}, picture("PNG", 3));
  const auto stamp = read_stamp(folder / "a.png");
  REQUIRE(stamp);
  CHECK(stamp->width() == 3);
  CHECK((*stamp)(0, 0) == 0);
  CHECK((*stamp)(1, 0) == Approx(1));
  CHECK((*stamp)(2, 0) == Approx(0.2));
}

#include <catch2/catch.hpp>
#include <cstdlib>

#include "core/exchange/document_scale.hpp"
#include "core/exchange/open_input.hpp"
#include "core/exchange/scene_file.hpp"
#include "core/species/species_library.hpp"
#include "tests/exchange/raster_files.hpp"
#include "tests/exchange/scene_sample.hpp"

using namespace biotope;
using namespace biotope_test;
using Catch::Matchers::Contains;

namespace {

std::string month_name(const std::string& resource, int month) {
  return resource + (month < 10 ? "-0" : "-") + std::to_string(month) + ".tif";
}

void write_months(const TemporaryFolder& folder, const std::string& resource, double value, int except = 0) {
  for (int month = 1; month <= 12; ++month) {
    if (month == except) continue;
    write_raster(folder / month_name(resource, month), {{value, value, value}, {value, value, value}});
  }
}

std::string environment_error(const TemporaryFolder& folder) {
  const auto given = load_given_environment(folder.path(), 3, 2);
  REQUIRE_FALSE(given);
  return given.error().message;
}

}  // namespace

TEST_CASE("the assets are found and hold species and climates") {
  const auto assets = assets_folder();
  REQUIRE(assets);
  CHECK(std::filesystem::exists(default_species_file(*assets)));
  CHECK(climate_named("mild-humid"));
  const auto unknown = climate_named("martian");
  REQUIRE_FALSE(unknown);
  CHECK_THAT(unknown.error().message, Contains("martian") && Contains("mild-humid") && Contains("alpine"));
}

TEST_CASE("BIOTOPE_ASSETS that names no assets is an error that says so") {
  const TemporaryFolder folder;
  setenv("BIOTOPE_ASSETS", folder.path().c_str(), 1);
  const auto assets = assets_folder();
  unsetenv("BIOTOPE_ASSETS");
  REQUIRE_FALSE(assets);
  CHECK_THAT(assets.error().message, Contains("BIOTOPE_ASSETS"));
}

TEST_CASE("a DEM opens with the default climate and species") {
  const TemporaryFolder folder;
  write_raster(folder / "hill.tif", slope_rows(20, 10));
  DemImportOptions options;
  options.longer_side = 10;
  const auto document = open_input((folder / "hill.tif").string(), options);
  REQUIRE(document);
  CHECK(document->title == "hill");
  CHECK(document->climate.name == "mild-humid");
  CHECK(document->species->size() > 10);
  CHECK(document->terrain->height.width() == 10);
  CHECK(document->terrain->cell_size == 20);
}

TEST_CASE("a scene opens as saved, or resampled with its paint") {
  const TemporaryFolder folder;
  const Document document = full_document();
  REQUIRE(save_scene(folder / "a.biotope", document));
  const auto same = open_input((folder / "a.biotope").string());
  REQUIRE(same);
  require_same(document, *same);
  DemImportOptions options;
  options.longer_side = 80;
  const auto half = open_input((folder / "a.biotope").string(), options);
  REQUIRE(half);
  CHECK(half->terrain->height.width() == 80);
  CHECK(half->terrain->height.height() == 64);
  for (const auto& [id, layer] : half->layers) CHECK(layer->width() == 80);
  CHECK(half->given_environment.geology->width() == 80);
  CHECK(half->given_environment.monthly[1][3]->width() == 80);
  CHECK(half->inflows[1].x == 79);
  const auto moisture = half->layers.at({LayerKind::resource, "moisture"});
  CHECK((*moisture)(79, 63) == Paint{9, 0.25F});
}

TEST_CASE("an unknown sample lists the known ones") {
  const auto none = open_input("sample:moon");
  REQUIRE_FALSE(none);
  CHECK_THAT(none.error().message, Contains("valley"));
}

TEST_CASE("a given cell size scales what flows in") {
  const Document document = full_document();
  const Document doubled = with_cell_size(document, 2 * document.terrain->cell_size);
  CHECK(doubled.terrain->cell_size == 2 * document.terrain->cell_size);
  CHECK(doubled.inflows[1].catchment_area == Approx(4 * 42));
  CHECK(doubled.terrain->georeference.wkt.empty());
}

TEST_CASE("given environment maps are read month by month") {
  const TemporaryFolder folder;
  write_months(folder, "temperature", 4.5);
  RasterRecipe bytes;
  bytes.type = GDT_Byte;
  write_raster(folder / "geology.tif", {{0, 1, 2}, {3, 4, 0}}, bytes);
  const auto given = load_given_environment(folder.path(), 3, 2);
  REQUIRE(given);
  REQUIRE(given->monthly[1].size() == 12);
  CHECK(given->monthly[0].empty());
  CHECK((*given->monthly[1][11])(2, 1) == 4.5F);
  CHECK((*given->geology)(0, 0) == Geology::limestone);
  CHECK((*given->geology)(1, 1) == Geology::alluvium);
}

TEST_CASE("given maps that do not fit are errors that name the file") {
  {
    const TemporaryFolder folder;
    write_months(folder, "moisture", 5, 7);
    CHECK_THAT(environment_error(folder), Contains("moisture-07.tif") && Contains("missing"));
  }
  {
    const TemporaryFolder folder;
    write_months(folder, "illumination", 5);
    write_raster(folder / "illumination-03.tif", {{5, 5}, {5, 5}});
    CHECK_THAT(environment_error(folder), Contains("illumination-03.tif") && Contains("2 x 2") && Contains("3 x 2"));
  }
  {
    const TemporaryFolder folder;
    write_months(folder, "temperature", -4);
    CHECK_THAT(environment_error(folder), Contains("temperature-01.tif") && Contains("1..9"));
  }
  {
    const TemporaryFolder folder;
    write_raster(folder / "geology.tif", {{0, 1, 2}, {3, 7, 0}});
    CHECK_THAT(environment_error(folder),
               Contains("geology.tif") && Contains("column 1, row 1") && Contains("7") && Contains("alluvium"));
    write_raster(folder / "geology.tif", {{0, 1.5, 2}, {3, 4, 0}});
    CHECK_THAT(environment_error(folder), Contains("1.5"));
  }
  {
    const TemporaryFolder folder;
    CHECK_THAT(environment_error(folder), Contains("no environment map"));
    write_months(folder, "moisture", 5);
    write_raster(folder / "moisture-13.tif", {{5, 5, 5}, {5, 5, 5}});
    CHECK_THAT(environment_error(folder), Contains("moisture-13.tif"));
  }
}

TEST_CASE("options that say how to read a DEM are refused where there is none, latitude is not") {
  DemImportOptions options;
  options.crop = Rect{0, 0, 9, 9};
  const auto cropped = open_input("sample:valley", options);
  REQUIRE_FALSE(cropped);
  CHECK_THAT(cropped.error().message, Contains("sample:valley") && Contains("--crop"));

  const TemporaryFolder folder;
  Document document;
  document.terrain = std::make_shared<const Terrain>(Terrain{Grid<float>(4, 4, 100.0F), {}, 10, 42, {}, "flat"});
  const std::string scene = (folder / "flat.biotope").string();
  const auto defaults = load_species(default_species_file(*assets_folder()));
  document.species = std::make_shared<const std::vector<Species>>(*defaults);
  document.climate = *climate_named("mild-humid");
  REQUIRE(save_scene(scene, document));
  DemImportOptions south;
  south.latitude = -40;
  const auto opened = open_input(scene, south);
  REQUIRE(opened);
  CHECK(opened->terrain->latitude == -40);
}

TEST_CASE("a landscape of no place on earth lies in metres from its south-west corner") {
  const TemporaryFolder folder;
  auto document = scenes::small_document(std::string(BIOTOPE_SOURCE_DIR) + "/assets");
  REQUIRE(document);
  auto terrain = std::make_shared<Terrain>(*document->terrain);
  terrain->georeference = {};
  terrain->cell_size = 8;
  const double height = terrain->height_metres();
  document->terrain = terrain;
  REQUIRE(save_scene(folder / "a.biotope", *document));
  const auto opened = open_input((folder / "a.biotope").string());
  if (!opened) FAIL(opened.error().message);
  CHECK(opened->terrain->georeference.transform == std::array<double, 6>{0, 8, 0, height, 0, -8});
  CHECK(opened->terrain->georeference.wkt.empty());
}

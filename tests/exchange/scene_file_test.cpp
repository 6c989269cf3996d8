#include <catch2/catch.hpp>
#include <chrono>
#include <limits>

#include "core/document/brush.hpp"
#include "core/exchange/scene_file.hpp"
#include "tests/exchange/raster_files.hpp"
#include "tests/exchange/scene_sample.hpp"

using namespace biotope;
using namespace biotope_test;
using Catch::Matchers::Contains;

TEST_CASE("a scene comes back as it was saved, to the bit") {
  const TemporaryFolder folder;
  const Document document = full_document();
  const Status saved = save_scene(folder / "a.biotope", document);
  if (!saved) FAIL(saved.error().message);
  const auto loaded = load_scene(folder / "a.biotope");
  if (!loaded) FAIL(loaded.error().message);
  require_same(document, *loaded);
  CHECK(folder.names() == std::vector<std::string>{"a.biotope"});
}

TEST_CASE("saving what was loaded gives the same bytes") {
  const TemporaryFolder folder;
  REQUIRE(save_scene(folder / "a.biotope", full_document()));
  const auto loaded = load_scene(folder / "a.biotope");
  REQUIRE(loaded);
  REQUIRE(save_scene(folder / "b.biotope", *loaded));
  CHECK(bytes_of(folder / "a.biotope") == bytes_of(folder / "b.biotope"));
}

TEST_CASE("views are saved beside the document and change nothing of it") {
  const TemporaryFolder folder;
  const Document document = full_document();
  REQUIRE(save_scene(folder / "a.biotope", document, nullptr, "{\"bookmarks\": []}\n"));
  const auto views = load_scene_views(folder / "a.biotope");
  REQUIRE(views);
  CHECK(views->text == "{\"bookmarks\": []}\n");
  CHECK(views->damage.empty());
  const auto loaded = load_scene(folder / "a.biotope");
  REQUIRE(loaded);
  require_same(document, *loaded);
  REQUIRE(save_scene(folder / "b.biotope", document));
  CHECK(load_scene_views(folder / "b.biotope")->text.empty());
  CHECK_FALSE(load_scene_views(folder / "none.biotope"));
  // Too long to be read again: the scene that is there stays.
  const Status refused = save_scene(folder / "a.biotope", document, nullptr, std::string(most_view_bytes + 1, ' '));
  REQUIRE_FALSE(refused);
  CHECK(refused.error().message.find("bookmarks") != std::string::npos);
  CHECK(load_scene_views(folder / "a.biotope")->text == views->text);
}

TEST_CASE("a plain document needs no voids, layers or given maps") {
  const TemporaryFolder folder;
  const auto document = scenes::small_document(std::string(BIOTOPE_SOURCE_DIR) + "/assets");
  REQUIRE(document);
  REQUIRE(save_scene(folder / "a.biotope", *document));
  const auto loaded = load_scene(folder / "a.biotope");
  REQUIRE(loaded);
  require_same(*document, *loaded);
}

TEST_CASE("a save that fails leaves the old scene whole") {
  const TemporaryFolder folder;
  const Document document = full_document();
  const Status nowhere = save_scene(folder / "none" / "a.biotope", document);
  REQUIRE_FALSE(nowhere);
  CHECK_THAT(nowhere.error().message, Contains("a.biotope"));
  std::filesystem::create_directory(folder / "taken.biotope");
  std::ofstream(folder / "taken.biotope" / "inside") << "x";
  CHECK_FALSE(save_scene(folder / "taken.biotope", document));
  CHECK(folder.names() == std::vector<std::string>{"taken.biotope"});
}

TEST_CASE("saving replaces a scene at once") {
  const TemporaryFolder folder;
  Document document = full_document();
  REQUIRE(save_scene(folder / "a.biotope", document));
  document.title = "second";
  REQUIRE(save_scene(folder / "a.biotope", document));
  const auto loaded = load_scene(folder / "a.biotope");
  REQUIRE(loaded);
  CHECK(loaded->title == "second");
}

TEST_CASE("untouched tiles of a layer take no room") {
  const TemporaryFolder folder;
  auto made = scenes::small_document(std::string(BIOTOPE_SOURCE_DIR) + "/assets");
  REQUIRE(made);
  Document document = *made;
  Terrain large;
  large.height = Grid<float>(2048, 2048, 7);
  document.terrain = std::make_shared<const Terrain>(large);
  REQUIRE(save_scene(folder / "bare.biotope", document));
  PaintLayer layer(2048, 2048);
  for (int i = 0; i < 20; ++i) layer.set(100 * i, 50 * i, {1, 0.5F});
  document.layers[{LayerKind::resource, "temperature"}] = std::make_shared<PaintLayer>(layer);
  REQUIRE(save_scene(folder / "painted.biotope", document));
  const auto extra = std::filesystem::file_size(folder / "painted.biotope") - std::filesystem::file_size(folder / "bare.biotope");
  CHECK(extra < 60000);
  const auto loaded = load_scene(folder / "painted.biotope");
  REQUIRE(loaded);
  require_same(document, *loaded);
}

TEST_CASE("a climate that was edited beyond its limits is saved at the nearest that fits") {
  const TemporaryFolder folder;
  Document document = full_document();
  document.climate.temperature_mean[6] = 58;
  document.climate.temperature_max[6] = 63;
  document.climate.temperature_min[0] = document.climate.temperature_mean[0] + 1;
  document.climate.precipitation[3] = -4;
  REQUIRE(save_scene(folder / "a.biotope", document));
  const auto loaded = load_scene(folder / "a.biotope");
  if (!loaded) FAIL(loaded.error().message);
  CHECK(loaded->climate.temperature_max[6] == 60);
  CHECK(loaded->climate.temperature_min[0] == document.climate.temperature_mean[0]);
  CHECK(loaded->climate.precipitation[3] == 0);
}

TEST_CASE("what could not be opened again is not saved, and the old scene stays") {
  const TemporaryFolder folder;
  Document document = full_document();
  REQUIRE(save_scene(folder / "a.biotope", document));
  const std::string before = bytes_of(folder / "a.biotope");
  document.placements.places.fords = {{{std::numeric_limits<float>::quiet_NaN(), 1}, 5}};
  const Status saved = save_scene(folder / "a.biotope", document);
  REQUIRE_FALSE(saved);
  CHECK_THAT(saved.error().message, Contains("a.biotope") && Contains("fords[0]"));
  CHECK(bytes_of(folder / "a.biotope") == before);
}

#include "core/exchange/edit_script_open.hpp"

#include <catch2/catch.hpp>

#include <fstream>

#include "core/exchange/edit_script_files.hpp"
#include "core/exchange/edit_script_play.hpp"
#include "tests/exchange/edit_script_scene.hpp"
#include "tests/exchange/raster_files.hpp"

using namespace biotope;
using namespace biotope_test;
using Catch::Matchers::Contains;

namespace {

void write_script(const std::filesystem::path& file, const std::string& edits) { std::ofstream(file) << script_of(edits); }

Result<Document> played(const std::filesystem::path& file) {
  const auto script = load_edit_script(file);
  if (!script) return tl::unexpected(script.error());
  SolveCache cache;
  return play(valley(), *script, {file.filename().string(), file.parent_path()}, cache);
}

}  // namespace

TEST_CASE("an opened terrain takes the place of the landscape, and what follows is done to it") {
  const TemporaryFolder folder;
  write_raster(folder / "hill.tif", slope_rows(40, 30));
  write_script(folder / "edits.json",
               R"({"edit": "set", "seed": 5}, {"edit": "open", "file": "hill.tif"}, {"edit": "set", "title": "Hill"})");
  const auto document = played(folder / "edits.json");
  if (!document) FAIL(document.error().message);
  CHECK(document->terrain->height.width() == 40);
  CHECK(document->terrain->height(1, 0) == 103);
  CHECK(document->title == "Hill");
  // The seed was that of the landscape before.
  CHECK(document->seed != 5);
}

TEST_CASE("how a terrain is read is part of the script") {
  const TemporaryFolder folder;
  write_raster(folder / "hill.tif", slope_rows(40, 30));
  write_script(folder / "edits.json",
               R"({"edit": "open", "file": "hill.tif", "crop": {"x": 10, "y": 5, "width": 20, "height": 16}, "vertical_scale": 2,
                   "vertical_offset": -7, "cell_size": 25, "latitude": 50})");
  const auto document = played(folder / "edits.json");
  if (!document) FAIL(document.error().message);
  CHECK(document->terrain->height.width() == 20);
  CHECK(document->terrain->height.height() == 16);
  CHECK(document->terrain->cell_size == 25);
  CHECK(document->terrain->latitude == 50);
  CHECK(double(document->terrain->height(0, 0)) == Approx(2 * (100 + 3 * 10 + 5 * 5) - 7));
}

TEST_CASE("undo never reaches back beyond an opened terrain") {
  const TemporaryFolder folder;
  write_raster(folder / "hill.tif", slope_rows(20, 20));
  write_script(folder / "edits.json", R"({"edit": "set", "seed": 5}, {"edit": "open", "file": "hill.tif"}, {"edit": "undo"})");
  const auto document = played(folder / "edits.json");
  REQUIRE_FALSE(document);
  CHECK_THAT(document.error().message, Contains("edit 3") && Contains("nothing left to undo"));
}

TEST_CASE("a terrain that is not there, or cannot be read, is told with the script, the edit and the file") {
  const TemporaryFolder folder;
  write_script(folder / "missing.json", R"({"edit": "open", "file": "alps.tif"})");
  const auto missing = played(folder / "missing.json");
  REQUIRE_FALSE(missing);
  CHECK_THAT(missing.error().message, Contains("missing.json: edit 1 (open)") && Contains("alps.tif"));
  std::ofstream(folder / "noise.tif") << "no raster";
  write_script(folder / "noise.json", R"({"edit": "open", "file": "noise.tif"})");
  const auto noise = played(folder / "noise.json");
  REQUIRE_FALSE(noise);
  CHECK_THAT(noise.error().message, Contains("noise.json: edit 1 (open)") && Contains("noise.tif"));
  write_script(folder / "out.json", R"({"edit": "open", "file": "../alps.tif"})");
  CHECK_FALSE(played(folder / "out.json"));
}

TEST_CASE("an open entry stands alone: not in a group, and it names a file or a built-in landscape") {
  const auto error = [](const std::string& edits) {
    const auto script = parse_edit_script(script_of(edits), "edits.json");
    REQUIRE_FALSE(script);
    return script.error().message;
  };
  CHECK_THAT(error(R"({"edit": "group", "edits": [{"edit": "open", "sample": "valley"}]})"), Contains("open"));
  CHECK_THAT(error(R"({"edit": "open"})"), Contains("sample"));
  CHECK_THAT(error(R"({"edit": "open", "sample": "moon"})"), Contains("moon"));
  CHECK_THAT(error(R"({"edit": "open", "sample": "valley", "cell_size": 0})"), Contains("cell_size"));
}

TEST_CASE("what is written of an open entry reads back as the same") {
  OpenEntry entry;
  entry.file = "dem/alps.raw";
  entry.options.cell_size = 12.5;
  entry.options.longer_side = 512;
  entry.options.latitude = -33.25;
  entry.options.vertical_scale = 0.3048;
  entry.options.vertical_offset = 17;
  entry.options.voids = VoidHandling::keep_as_sea;
  entry.options.crop = Rect{3, 4, 103, 204};
  entry.options.raw = RawLayout{400, 300, "int16", true, 128};
  EditScript script;
  script.entries.push_back({entry});
  const std::string text = edit_script_to_json(script);
  const auto again = parse_edit_script(text, "edits.json");
  if (!again) FAIL(again.error().message);
  CHECK(edit_script_to_json(*again) == text);
  const auto& read = std::get<OpenEntry>(again->entries.at(0).what);
  CHECK(read.options.crop == entry.options.crop);
  CHECK(read.options.raw->header_bytes == 128);
  CHECK(read.options.voids == VoidHandling::keep_as_sea);
}

TEST_CASE(
    "saving a script brings a terrain from elsewhere beside it, with the files that belong to it; one in its folder stays") {
  const TemporaryFolder elsewhere;
  const TemporaryFolder folder;
  RasterRecipe ascii;
  ascii.driver = "AAIGrid";
  ascii.epsg = 32631;
  write_raster(elsewhere / "hill.asc", slope_rows(12, 10), ascii);
  const bool has_projection = std::filesystem::exists(elsewhere / "hill.prj");
  write_raster(folder / "near.tif", slope_rows(12, 10));
  EditScript script;
  for (const auto& file : {elsewhere / "hill.asc", folder / "near.tif", elsewhere / "hill.asc"}) {
    OpenEntry entry;
    entry.file = file.string();
    entry.options.cell_size = 10;
    script.entries.push_back({entry});
  }
  REQUIRE(save_edit_script(folder / "day.json", script));
  const auto saved = load_edit_script(folder / "day.json");
  if (!saved) FAIL(saved.error().message);
  CHECK(std::get<OpenEntry>(saved->entries.at(0).what).file == "day-files/hill.asc");
  CHECK(std::get<OpenEntry>(saved->entries.at(1).what).file == "near.tif");
  CHECK(std::get<OpenEntry>(saved->entries.at(2).what).file == "day-files/hill.asc");
  CHECK(std::filesystem::exists(folder / "day-files" / "hill.prj") == has_projection);
  const auto document = played(folder / "day.json");
  if (!document) FAIL(document.error().message);
  CHECK(document->terrain->height(0, 0) == 100);
}

TEST_CASE("a terrain that has gone since it was recorded keeps the script from being saved") {
  const TemporaryFolder folder;
  EditScript script;
  OpenEntry entry;
  entry.file = (folder / "gone.tif").string();
  script.entries.push_back({entry});
  const Status saved = save_edit_script(folder / "day.json", script);
  REQUIRE_FALSE(saved);
  CHECK_THAT(saved.error().message, Contains("gone.tif"));
}

#include <unistd.h>

#include <catch2/catch.hpp>
#include <fstream>

#include "ui/autosave.hpp"
#include "ui/file_listing.hpp"
#include "ui/settings.hpp"

using namespace biotope;

namespace {

/// A folder of its own that goes with the test.
struct Scratch {
  std::filesystem::path path = std::filesystem::temp_directory_path() / ("biotope-ui-test-" + std::to_string(getpid()));
  Scratch() { std::filesystem::create_directories(path); }
  ~Scratch() { std::filesystem::remove_all(path); }
  void touch(const std::string& name) const { std::ofstream(path / name) << "x"; }
};

}  // namespace

TEST_CASE("settings survive a restart") {
  const Scratch scratch;
  Settings settings;
  settings.dark = false;
  settings.scale = 2;
  settings.recent = {"sample:valley", "/a/b.tif"};
  settings.brush.radius = 77;
  settings.first_steps_closed = true;
  settings.shortcuts["tool.brush"] = "P";
  settings.window_width = 1920;
  settings.history_megabytes = 2048;
  settings.quality_level = QualityLevel::high;
  settings.weather.fog = 0.4F;
  settings.weather.snow_cover = false;
  settings.animate = false;
  settings.mini_map = false;
  const std::filesystem::path file = scratch.path / "deep" / "settings.json";
  REQUIRE(save_settings(file, settings));
  const Settings read = load_settings(file);
  CHECK_FALSE(read.dark);
  CHECK(read.scale == 2);
  CHECK(read.recent == settings.recent);
  CHECK(read.brush.radius == 77);
  CHECK(read.first_steps_closed);
  CHECK(read.shortcuts == settings.shortcuts);
  CHECK(read.window_width == 1920);
  CHECK(read.history_megabytes == 2048);
  CHECK(read.quality_level == QualityLevel::high);
  CHECK(read.weather == settings.weather);
  CHECK(read.animate == false);
  CHECK_FALSE(read.mini_map);
  CHECK_FALSE(std::filesystem::exists(file.string() + ".new"));
}

TEST_CASE("a damaged settings file gives defaults, and odd values are put right") {
  CHECK(settings_from_json("{ not json").dark);
  CHECK(settings_from_json("[1, 2]").window_width == 1280);
  const Settings odd = settings_from_json(
      R"({"scale": 900, "window": {"width": -5}, "brush": {"radius": "big", "strength": 7}, "recent": [1, "a"]})");
  CHECK(odd.scale == 4);
  CHECK(odd.window_width == 640);
  CHECK(odd.brush.radius == Settings().brush.radius);
  CHECK(odd.brush.strength == 1);
  CHECK(odd.recent == std::vector<std::string>{"a"});
  const Settings wild =
      settings_from_json(R"({"weather": {"cloud": 7, "wind": -3, "fog": "thick"}, "quality_level": "best", "animate": "yes"})");
  CHECK(wild.weather.cloud == 1);
  CHECK(wild.weather.wind == 0);
  CHECK(wild.weather.fog == 0);
  CHECK(wild.quality_level == QualityLevel::automatic);
  CHECK_FALSE(wild.animate);
}

TEST_CASE("recent files are the newest first, without doubles, and not endless") {
  Settings settings;
  for (int i = 0; i < 20; ++i) remember_recent(settings, std::to_string(i));
  remember_recent(settings, "15");
  CHECK(settings.recent.size() == most_recent_files);
  CHECK(settings.recent.front() == "15");
  CHECK(std::count(settings.recent.begin(), settings.recent.end(), "15") == 1);
}

TEST_CASE("a folder lists folders first and then what can be opened") {
  const Scratch scratch;
  for (const char* name : {"b.tif", "A.biotope", "notes.txt", ".hidden.tif"}) scratch.touch(name);
  std::filesystem::create_directories(scratch.path / "zoo");
  std::string problem;
  const auto entries = list_folder(scratch.path, false, problem);
  REQUIRE(entries.size() == 3);
  CHECK(entries[0].name == "zoo");
  CHECK(entries[1].name == "A.biotope");
  CHECK(entries[2].name == "b.tif");
  CHECK(list_folder(scratch.path, true, problem).size() == 2);
  CHECK(problem.empty());
  CHECK(list_folder(scratch.path / "nowhere", false, problem).empty());
  CHECK_FALSE(problem.empty());
}

TEST_CASE("only the work of an editor that no longer runs is offered for recovery") {
  const Scratch scratch;
  CHECK_FALSE(find_abandoned(scratch.path));
  scratch.touch("recovery-" + std::to_string(getpid()) + ".biotope");
  scratch.touch("recovery-x.biotope");
  scratch.touch("other-123.biotope");
  CHECK_FALSE(find_abandoned(scratch.path));
  scratch.touch("recovery-2147483000.biotope");  // beyond any process number
  REQUIRE(find_abandoned(scratch.path));
  CHECK(find_abandoned(scratch.path)->filename() == "recovery-2147483000.biotope");
}

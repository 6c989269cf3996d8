#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <filesystem>
#include <fstream>

#include "render/image.hpp"
#include "tests/app/command_line_run.hpp"

using namespace biotope;
using Catch::Matchers::Contains;
using Catch::Matchers::StartsWith;

namespace {

namespace fs = std::filesystem;

nlohmann::json summary_of(const std::string& folder) {
  std::ifstream stream(folder + "/summary.json");
  return nlohmann::json::parse(stream);
}

}  // namespace

TEST_CASE("help and version are answers, not errors") {
  const Outcome version = run({"--version"});
  CHECK(version.code == 0);
  CHECK_THAT(version.out, StartsWith("biotope ") && Contains("."));
  const Outcome help = run({"--help"});
  CHECK(help.code == 0);
  for (const char* command : {"solve", "render", "info", "sample"}) CHECK_THAT(help.out, Contains(command));
  CHECK_THAT(run({"solve", "--help"}).out, Contains("--environment") && Contains("--maps"));
}

TEST_CASE("a wrong command line ends with 2 and says what was wrong") {
  const Workplace place;
  for (const std::vector<std::string>& arguments :
       std::vector<std::vector<std::string>>{{"solve", place.dem()},
                                             {"solve", "--out", place.at("out")},
                                             {"solve", place.dem(), "--out", place.at("out"), "--bogus"},
                                             {"solve", place.dem(), "--out", place.at("out"), "--size", "one"},
                                             {"solve", place.dem(), "--out", place.at("out"), "--size", "1"},
                                             {"solve", place.dem(), "--out", place.at("out"), "--cell-size", "-3"},
                                             {"solve", place.dem(), "--out", place.at("out"), "--threads", "0"},
                                             {"solve", place.dem(), "--out", place.at("out"), "--cell-size", "nan"},
                                             {"solve", place.dem(), "--out", place.at("out"), "--seed", "-1"},
                                             {"solve", place.dem(), "--out", place.at("out"), "--seed", "18446744073709551616"},
                                             {"solve", place.dem(), "--out", place.at("out"), "--climate", ""},
                                             {"solve", place.dem(), "--out", ""},
                                             {place.dem(), "solve", place.dem(), "--out", place.at("out")},
                                             {"--cell-size", "30", "solve", place.dem(), "--out", place.at("out")},
                                             {"solve", place.dem(), "--out", place.at("out"), "--maps", "some"},
                                             {"solve", place.dem(), "--out", place.at("out"), "--raw", "12:uint16"},
                                             {"solve", place.dem(), "--out", place.at("out"), "--crop", "1,2,3"},
                                             {"render", place.dem(), "--out", place.at("a.png"), "--size", "1280"},
                                             {"render", place.dem(), "--out", place.at("a.png"), "--camera", "1,2,3"},
                                             {"render", place.dem(), "--out", place.at("a.png"), "--month", "13"},
                                             {"render", place.dem(), "--out", place.at("a.png"), "--hour", "25"},
                                             {"info"},
                                             {"sample", "valley"}}) {
    INFO(arguments.back());
    const Outcome outcome = run(arguments);
    CHECK(outcome.code == 2);
    CHECK_THAT(outcome.err, StartsWith("biotope: "));
    CHECK(std::count(outcome.err.begin(), outcome.err.end(), '\n') == 1);
    CHECK(outcome.out.empty());
  }
  CHECK(place.entries() == 1);
}

TEST_CASE("what cannot be done ends with 1, says why and leaves nothing") {
  const Workplace place;
  std::ofstream(place.at("text.tif")) << "no DEM";
  std::ofstream(place.at("species.json")) << "{}";
  const std::vector<std::pair<std::vector<std::string>, std::string>> cases{
      {{"solve", place.at("none.tif"), "--out", place.at("out"), "--quiet"}, "none.tif"},
      {{"solve", place.at("text.tif"), "--out", place.at("out"), "--quiet"}, "text.tif"},
      {{"solve", place.dem(), "--out", place.at("out"), "--climate", "martian", "--quiet"}, "mild-humid"},
      {{"solve", place.dem(), "--out", place.at("out"), "--species", place.at("species.json"), "--quiet"}, "species.json"},
      {{"solve", place.dem(), "--out", place.at("out"), "--environment", place.at("maps"), "--quiet"}, "maps"},
      {{"solve", place.dem(), "--out", place.at("text.tif"), "--quiet"}, "text.tif"},
      {{"solve", place.dem(), "--out", "/proc/nowhere/out", "--quiet"}, "/proc/nowhere"},
      {{"solve", place.dem(), "--out", place.at("deep/er/out"), "--species", place.at(""), "--quiet"}, "folder"},
      {{"solve", "sample:valley", "--out", place.at("out"), "--crop", "0,0,9,9", "--quiet"}, "--crop"},
      {{"render", place.dem(), "--out", place.at("nowhere/a.png"), "--quiet"}, "nowhere"},
      {{"solve", "sample:moon", "--out", place.at("out"), "--quiet"}, "sample"},
      {{"render", place.at("none.tif"), "--out", place.at("a.png"), "--quiet"}, "none.tif"},
      {{"info", place.at("none.biotope")}, "none.biotope"},
      {{"sample", "moon", "--out", place.at("a.biotope"), "--quiet"}, "sample"},
      {{"sample", "valley", "--out", place.at("a.zip"), "--quiet"}, ".biotope"}};
  for (const auto& [arguments, word] : cases) {
    INFO(arguments[0] << " " << arguments[1] << " " << word);
    const Outcome outcome = run(arguments);
    CHECK(outcome.code == 1);
    CHECK_THAT(outcome.err, StartsWith("biotope: ") && Contains(word));
    CHECK(outcome.out.empty());
  }
  CHECK(place.entries() == 3);
}

TEST_CASE("solve writes everything, with progress where wanted") {
  const Workplace place;
  const Outcome shown = run({"solve", place.dem(), "--out", place.at("out")});
  INFO(shown.err);
  REQUIRE(shown.code == 0);
  CHECK_THAT(shown.err, Contains("plants") && Contains("trails"));
  for (const char* name : {"summary.json", "trails.geojson", "plans.json", "graph.json", "maps/trails.tif"}) {
    CHECK(fs::exists(place.at("out") + "/" + name));
  }
  const auto summary = summary_of(place.at("out"));
  CHECK(summary.at("grid").at("width") == 96);
  CHECK(summary.at("climate") == "mild-humid");
  const Outcome quiet = run({"solve", place.dem(), "--out", place.at("out"), "--quiet"});
  CHECK(quiet.code == 0);
  CHECK(quiet.err.empty());
}

TEST_CASE("what was in the folder before stays, but maps of an earlier run go") {
  const Workplace place;
  fs::create_directories(place.at("out/maps"));
  std::ofstream(place.at("out/maps/notes.txt")) << "mine";
  std::ofstream(place.at("out/maps/density-dodo.tif")) << "of an earlier run";
  REQUIRE(run({"solve", place.dem(), "--out", place.at("out"), "--size", "24", "--quiet"}).code == 0);
  CHECK(file_bytes(place.at("out/maps/notes.txt")) == "mine");
  CHECK_FALSE(fs::exists(place.at("out/maps/density-dodo.tif")));
  CHECK(fs::exists(place.at("out/maps/density-quercus.tif")));
}

TEST_CASE("progress names the stages of the pipeline, each once") {
  const Workplace place;
  const Outcome shown = run({"solve", place.dem(), "--out", place.at("out"), "--size", "24"});
  REQUIRE(shown.code == 0);
  std::string expected;
  for (const char* stage : {"reading heights", "species", "slopes", "water", "environment", "plants", "animals", "travel",
                            "trails", "daily plans", "writing maps"}) {
    expected += std::string("biotope: ") + stage + "\n";
  }
  CHECK(shown.err == expected);
}

TEST_CASE("options of solve reach the result") {
  const Workplace place;
  REQUIRE(run({"solve", place.dem(), "--out", place.at("out"), "--quiet", "--climate", "alpine", "--seed", "77", "--size", "48",
               "--cell-size", "20"})
              .code == 0);
  const auto summary = summary_of(place.at("out"));
  CHECK(summary.at("climate") == "alpine");
  CHECK(summary.at("seed") == 77);
  CHECK(summary.at("grid") == nlohmann::json{{"width", 48}, {"height", 40}, {"cell_size_m", 40.0}});
}

TEST_CASE("any number of threads gives the same maps") {
  const Workplace place;
  REQUIRE(run({"solve", place.dem(), "--out", place.at("one"), "--quiet", "--threads", "1"}).code == 0);
  REQUIRE(run({"solve", place.dem(), "--out", place.at("four"), "--quiet", "--threads", "4"}).code == 0);
  std::size_t compared = 0;
  for (const auto& entry : fs::recursive_directory_iterator(place.at("one"))) {
    if (!entry.is_regular_file() || entry.path().filename() == "summary.json") continue;
    const std::string other = place.at("four") + "/" + entry.path().lexically_relative(place.at("one")).string();
    INFO(other);
    CHECK(file_bytes(entry.path().string()) == file_bytes(other));
    ++compared;
  }
  CHECK(compared > 50);
}

TEST_CASE("given environment maps come back as the environment") {
  const Workplace place;
  REQUIRE(run({"solve", place.dem(), "--out", place.at("out"), "--quiet", "--maps", "all"}).code == 0);
  fs::create_directories(place.at("given"));
  Terrain valley = scenes::small_valley(96, 80);
  for (int month = 1; month <= 12; ++month) {
    const std::string name = (month < 10 ? "moisture-0" : "moisture-") + std::to_string(month) + ".tif";
    REQUIRE(write_geotiff(place.at("given") + "/" + name, Grid<float>(96, 80, 6.5F), valley));
  }
  REQUIRE(run({"solve", place.dem(), "--out", place.at("wet"), "--quiet", "--environment", place.at("given")}).code == 0);
  const auto wet = read_raster(place.at("wet") + "/maps/environment-moisture.tif");
  REQUIRE(wet);
  CHECK((*wet)(40, 40) == 6.5F);
  fs::remove(place.at("given") + "/moisture-05.tif");
  const Outcome missing = run({"solve", place.dem(), "--out", place.at("dry"), "--quiet", "--environment", place.at("given")});
  CHECK(missing.code == 1);
  CHECK_THAT(missing.err, Contains("moisture-05.tif"));
  CHECK_FALSE(fs::exists(place.at("dry")));
}

TEST_CASE("info tells what a DEM is") {
  const Workplace place;
  const Outcome info = run({"info", place.dem()});
  REQUIRE(info.code == 0);
  CHECK_THAT(info.out, Contains("96 x 80") && Contains("cell size: 10 m") && Contains("range:") && Contains("crs: none"));
  CHECK(info.err.empty());
}

TEST_CASE("render draws a picture of the size asked, without a display") {
  const Workplace place;
  const Outcome drawn = run({"render", place.dem(), "--out", place.at("a.png"), "--size", "160x90", "--hour", "17", "--month",
                             "9", "--camera", "-100,-100,400,45,-20", "--quiet"});
  if (drawn.code != 0 && drawn.err.find("EGL") != std::string::npos) {
    WARN("no OpenGL on this machine: " << drawn.err);
    return;
  }
  INFO(drawn.err);
  REQUIRE(drawn.code == 0);
  const auto picture = read_png(place.at("a.png"));
  REQUIRE(picture);
  CHECK(picture->width == 160);
  CHECK(picture->height == 90);
}

TEST_CASE("render flies along a path, a picture a moment") {
  const Workplace place;
  std::ofstream(place.at("path.json")) << R"({"keys": [
    {"seconds": 0, "x": 200, "y": 200, "z": 400, "heading": 0, "pitch": -20},
    {"seconds": 0.3, "x": 260, "y": 220, "z": 400, "heading": 20, "pitch": -20}], "hours": [8, 12]})";
  const Outcome flown = run({"render", place.dem(), "--path", place.at("path.json"), "--out", place.at("frames"), "--size",
                             "64x48", "--fps", "10", "--quality", "0.5", "--quiet"});
  if (flown.code != 0 && flown.err.find("EGL") != std::string::npos) {
    WARN("no OpenGL on this machine: " << flown.err);
    return;
  }
  INFO(flown.err);
  REQUIRE(flown.code == 0);
  for (const char* name : {"frame-00001.png", "frame-00002.png", "frame-00003.png", "frame-00004.png"}) {
    const auto picture = read_png(place.at("frames") + "/" + name);
    REQUIRE(picture);
    CHECK(picture->width == 64);
    CHECK(picture->height == 48);
  }
  CHECK_FALSE(fs::exists(place.at("frames") + "/frame-00005.png"));
}

TEST_CASE("a path that cannot be flown is told before anything is computed") {
  const Workplace place;
  const Outcome missing = run({"render", place.dem(), "--path", place.at("none.json"), "--out", place.at("frames"), "--quiet"});
  CHECK(missing.code == exit_failure);
  CHECK_THAT(missing.err, Contains("none.json"));
  std::ofstream(place.at("path.json")) << R"({"keys": [{"seconds": 0, "x": 1}]})";
  const Outcome wrong = run({"render", place.dem(), "--path", place.at("path.json"), "--out", place.at("frames"), "--quiet"});
  CHECK(wrong.code == exit_failure);
  CHECK_THAT(wrong.err, Contains("key 1"));
  CHECK_FALSE(fs::exists(place.at("frames")));
  const Outcome rate = run({"render", place.dem(), "--path", place.at("path.json"), "--out", place.at("frames"), "--fps", "0"});
  CHECK(rate.code == exit_usage);
}

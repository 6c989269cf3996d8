#include <catch2/catch.hpp>

#include <algorithm>
#include <filesystem>
#include <fstream>

#include "core/exchange/scene_file.hpp"
#include "tests/app/command_line_run.hpp"

using namespace biotope;
using Catch::Matchers::Contains;
using Catch::Matchers::StartsWith;

namespace {

namespace fs = std::filesystem;

const std::string some_edits = R"(
  {"edit": "stroke", "targets": [{"layer": "plant-density:quercus"}], "brush": {"mode": "add", "radius": 12, "value": 0.9}, "points": [[20, 30], [50, 40]]},
  {"edit": "fill", "targets": [{"layer": "resource:moisture"}], "brush": {"mode": "noise", "value": 1}},
  {"edit": "set", "seed": 5},
  {"edit": "undo"},
  {"edit": "stroke", "targets": [{"layer": "ground:height"}], "brush": {"mode": "raise", "radius": 10, "value": 4}, "points": [[60, 60]]})";

}  // namespace

TEST_CASE("edit plays a script and saves a scene that solves to the same maps, byte by byte") {
  const Workplace place;
  const Outcome edited = run({"edit", place.dem(), "--script", place.script(some_edits), "--out", place.at("b.biotope"), "--maps",
                              place.at("kept"), "--verify"});
  INFO(edited.err);
  REQUIRE(edited.code == 0);
  CHECK_THAT(edited.out, Contains("to the bit") && Contains("5 edits") && Contains("b.biotope"));
  CHECK_THAT(edited.err, Contains("playing edits"));
  const auto scene = load_scene(place.at("b.biotope"));
  REQUIRE(scene);
  CHECK(scene->seed == 1);
  CHECK(scene->layers.contains({LayerKind::ground, "height"}));
  REQUIRE(run({"solve", place.at("b.biotope"), "--out", place.at("fresh"), "--from-scratch", "--quiet"}).code == 0);
  std::size_t compared = 0;
  for (const auto& entry : fs::recursive_directory_iterator(place.at("fresh"))) {
    if (!entry.is_regular_file() || entry.path().filename() == "summary.json") continue;
    const std::string other = place.at("kept") + "/" + entry.path().lexically_relative(place.at("fresh")).string();
    INFO(other);
    CHECK(file_bytes(entry.path().string()) == file_bytes(other));
    ++compared;
  }
  CHECK(compared > 50);
}

TEST_CASE("edit gives the same scene for any number of threads, and says nothing when quiet") {
  const Workplace place;
  const std::string script = place.script(some_edits);
  const Outcome one =
      run({"edit", place.dem(), "--script", script, "--out", place.at("one.biotope"), "--threads", "1", "--quiet"});
  const Outcome four =
      run({"edit", place.dem(), "--script", script, "--out", place.at("four.biotope"), "--threads", "4", "--quiet"});
  REQUIRE(one.code == 0);
  REQUIRE(four.code == 0);
  CHECK(one.out.empty());
  CHECK(one.err.empty());
  CHECK(file_bytes(place.at("one.biotope")) == file_bytes(place.at("four.biotope")));
}

TEST_CASE("a wrong edit command ends with 2") {
  const Workplace place;
  for (const std::vector<std::string>& arguments : std::vector<std::vector<std::string>>{
           {"edit"},
           {"edit", place.dem()},
           {"edit", place.dem(), "--out", place.at("a.biotope")},
           {"edit", place.dem(), "--script", "a.json"},
           {"edit", place.dem(), "--script", "a.json", "--out", ""},
           {"edit", place.dem(), "--script", "a.json", "--out", "a.biotope", "--threads", "0"}}) {
    const Outcome outcome = run(arguments);
    CHECK(outcome.code == 2);
    CHECK_THAT(outcome.err, StartsWith("biotope: "));
    CHECK_THAT(outcome.err, Contains("edit --help"));
  }
  CHECK_THAT(run({"edit", "--help"}).out, Contains("--script") && Contains("--verify"));
  CHECK_THAT(run({"--help"}).out, Contains("edit"));
}

TEST_CASE("edits that cannot be played end with 1, name the edit, and write nothing") {
  const Workplace place;
  const std::string good = R"({"edit": "set", "seed": 5}, )";
  const std::vector<std::pair<std::string, std::string>> cases{
      {R"({"edit": "clear", "layer": "plant-density:dodo"})", "edit 2 (clear)"},
      {R"({"edit": "image", "layer": "resource:moisture", "file": "none.png"})", "none.png"},
      {R"({"edit": "image", "layer": "resource:moisture", "file": "../valley.tif"})", "edit 2 (image)"},
      {R"({"edit": "undo", "steps": 3})", "nothing left to undo"},
      {R"({"edit": "dance"})", "edit 2"},
      {"{", "edits.json"}};
  for (const auto& [edit, words] : cases) {
    const Outcome outcome = run({"edit", place.dem(), "--script", place.script(good + edit), "--out", place.at("a.biotope"),
                                 "--maps", place.at("maps"), "--quiet"});
    INFO(outcome.err);
    CHECK(outcome.code == 1);
    CHECK_THAT(outcome.err, StartsWith("biotope: ") && Contains("edits.json") && Contains(words));
    CHECK(std::count(outcome.err.begin(), outcome.err.end(), '\n') == 1);
    CHECK_FALSE(fs::exists(place.at("a.biotope")));
    CHECK_FALSE(fs::exists(place.at("maps/summary.json")));
  }
  const std::string script = place.script(good + R"({"edit": "redo", "steps": 1})");
  for (const auto& [arguments, words] : std::vector<std::pair<std::vector<std::string>, std::string>>{
           {{"edit", place.dem(), "--script", place.at("none.json"), "--out", place.at("a.biotope")}, "none.json"},
           {{"edit", place.at("none.tif"), "--script", place.script(R"({"edit": "set", "seed": 5})"), "--out",
             place.at("a.biotope")},
            "none.tif"},
           {{"edit", place.dem(), "--script", script, "--out", place.at("a.zip")}, ".biotope"},
           {{"edit", place.dem(), "--script", script, "--out", place.at("no/where/a.biotope")}, "no/where"},
           {{"edit", place.dem(), "--script", place.dem(), "--out", place.at("a.biotope")}, "valley.tif"}}) {
    std::vector<std::string> quiet = arguments;
    quiet.emplace_back("--quiet");
    const Outcome outcome = run(quiet);
    INFO(outcome.err);
    CHECK(outcome.code == 1);
    CHECK_THAT(outcome.err, StartsWith("biotope: ") && Contains(words));
  }
}

TEST_CASE("edit opens the terrain that a script names, and says when it is not there") {
  const Workplace place;
  const Outcome opened =
      run({"edit", place.dem(), "--script", place.script(R"({"edit": "open", "file": "valley.tif", "size": 48})"), "--out",
           place.at("half.biotope"), "--quiet"});
  CHECK(opened.err.empty());
  REQUIRE(opened.code == 0);
  const auto half = load_scene(place.at("half.biotope"));
  REQUIRE(half);
  CHECK(half->terrain->height.width() == 48);
  const Outcome missing = run({"edit", place.dem(), "--script", place.script(R"({"edit": "open", "file": "alps.tif"})"), "--out",
                               place.at("none.biotope"), "--quiet"});
  CHECK(missing.code == 1);
  CHECK_THAT(missing.err, StartsWith("biotope: ") && Contains("edit 1 (open)") && Contains("alps.tif"));
  CHECK_FALSE(fs::exists(place.at("none.biotope")));
}

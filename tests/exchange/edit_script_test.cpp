#include <catch2/catch.hpp>

#include <regex>

#include "core/exchange/edit_script.hpp"
#include "tests/exchange/edit_script_random.hpp"
#include "tests/exchange/edit_script_same.hpp"
#include "tests/exchange/edit_script_scene.hpp"

using namespace biotope;
using namespace biotope_test;
using Catch::Matchers::Contains;
using Catch::Matchers::StartsWith;

namespace {

std::string error_of(const std::string& text) {
  const auto script = parse_edit_script(text, "a.json");
  REQUIRE_FALSE(script);
  CHECK_THAT(script.error().message, StartsWith("a.json"));
  CHECK(script.error().message.find('\n') == std::string::npos);
  return script.error().message;
}

std::string error_of_edit(const std::string& edit) { return error_of(script_of(R"({"edit": "undo"}, )" + edit)); }

}  // namespace

TEST_CASE("a script reads as it was meant") {
  const auto script = parse_edit_script(script_of(R"(
    {"edit": "stroke", "targets": [{"layer": "plant-density:quercus", "value": 0.4}], "brush": {"mode": "add", "radius": 12},
     "points": [[10, 20], [30.5, 40, 0.25]]},
    {"edit": "select", "shape": "rectangle", "points": [[0, 0], [9, 9]]},
    {"edit": "set", "seed": 18446744073709551615},
    {"edit": "undo", "steps": 2}, {"edit": "redo"})"),
                                        "a.json");
  REQUIRE(script);
  REQUIRE(script->entries.size() == 5);
  const auto& stroke = std::get<StrokeEntry>(script->entries[0].what).edit;
  CHECK(stroke.targets.front().layer == LayerId{LayerKind::plant_density, "quercus"});
  CHECK(stroke.targets.front().value == 0.4F);
  CHECK(stroke.targets.front().weight == 1);
  CHECK(stroke.brush.radius == 12);
  CHECK(stroke.brush.strength == Brush{}.strength);
  CHECK(stroke.points == std::vector<StrokePoint>{{10, 20, 1}, {30.5F, 40, 0.25F}});
  CHECK(std::get<SelectEdit>(script->entries[1].what).shape == SelectEdit::Shape::rectangle);
  CHECK(std::get<PartsPatch>(script->entries[2].what).seed == 18446744073709551615ULL);
  CHECK(std::get<UndoEntry>(script->entries[3].what).steps == 2);
  CHECK(std::get<RedoEntry>(script->entries[4].what).steps == 1);
}

TEST_CASE("what is written reads back the same, to the last bit of every number") {
  const Document document = valley();
  for (std::uint64_t seed = 0; seed < 60; ++seed) {
    const EditScript written = RandomScript(seed, *document.species, document.climate).script(12);
    const std::string text = edit_script_to_json(written);
    const auto read = parse_edit_script(text, "a.json");
    INFO("script " << seed);
    if (!read) FAIL(read.error().message);
    CHECK(read->width == written.width);
    CHECK(read->height == written.height);
    biotope_test::require_same(written.entries, read->entries);
    CHECK(edit_script_to_json(*read) == text);
  }
}

TEST_CASE("a message names the file, the edit, the key and what was expected") {
  CHECK_THAT(error_of_edit(R"({"edit": "scratch"})"), Contains("edit 2") && Contains("\"edit\"") && Contains("\"stroke\""));
  CHECK_THAT(error_of_edit(R"({"edit": "clear"})"), Contains("edit 2 (clear)") && Contains("\"layer\" is missing"));
  CHECK_THAT(error_of_edit(R"({"edit": "clear", "layer": "trees"})"), Contains("\"layer\"") && Contains("trees"));
  CHECK_THAT(error_of_edit(R"({"edit": "clear", "layer": "resource:gold"})"), Contains("gold"));
  CHECK_THAT(error_of_edit(R"({"edit": "clear", "layer": "loss:quercus", "colour": 1})"), Contains("unknown key \"colour\""));
  const std::string target = R"("targets": [{"layer": "loss:quercus"}])";
  CHECK_THAT(error_of_edit(R"({"edit": "stroke", "targets": [], "brush": {"mode": "add"}, "points": [[1, 2]]})"),
             Contains("targets"));
  CHECK_THAT(error_of_edit(R"({"edit": "stroke", )" + target + R"(, "brush": {"mode": "blur"}, "points": [[1, 2]]})"),
             Contains("\"brush.mode\"") && Contains("\"smooth\""));
  CHECK_THAT(error_of_edit(R"({"edit": "stroke", )" + target + R"(, "brush": {"mode": "add", "radius": 0}, "points": [[1, 2]]})"),
             Contains("\"brush.radius\"") && Contains("0.01..16384"));
  CHECK_THAT(error_of_edit(R"({"edit": "stroke", )" + target + R"(, "brush": {"mode": "add"}, "points": []})"),
             Contains("\"points\""));
  CHECK_THAT(error_of_edit(R"({"edit": "stroke", )" + target + R"(, "brush": {"mode": "add"}, "points": [[1, 2, 3]]})"),
             Contains("\"points\"") && Contains("pressure"));
  CHECK_THAT(error_of_edit(R"({"edit": "stroke", )" + target + R"(, "brush": {"mode": "add"}, "points": [[1e9, 2]]})"),
             Contains("points"));
  CHECK_THAT(error_of_edit(R"({"edit": "fill", )" + target + R"(, "brush": {"mode": "clone"}})"), Contains("clone_from"));
  CHECK_THAT(error_of_edit(R"({"edit": "fill", )" + target +
                           R"(, "brush": {"mode": "set", "filter": {"conditions": [{"quantity": "smell"}]}}})"),
             Contains("condition 1") && Contains("water-distance"));
  CHECK_THAT(error_of_edit(R"({"edit": "select", "shape": "lasso", "points": [[1, 2], [3, 4]]})"), Contains("at least 3"));
  CHECK_THAT(error_of_edit(R"({"edit": "select", "shape": "range"})"), Contains("\"range\" is missing"));
  CHECK_THAT(error_of_edit(R"({"edit": "undo", "steps": 0})"), Contains("\"steps\""));
  CHECK_THAT(error_of_edit(R"({"edit": "set", "seed": -1})"), Contains("\"seed\""));
  CHECK_THAT(error_of_edit(R"({"edit": "set", "climate": {"name": "mild"}})"), Contains("edit 2 (set)") && Contains("climate"));
  CHECK_THAT(error_of_edit(R"({"edit": "set", "species": {"changed": [{"name": "oak"}]}})"), Contains("edit 2 (set)"));
  CHECK_THAT(error_of_edit(R"({"edit": "set", "placements": {"fords": [{"at": [1]}]}})"), Contains("edit 2 (set), placements"));
  CHECK_THAT(error_of_edit(R"({"edit": "set", "inflows": [{"x": 1, "y": 2}]})"),
             Contains("inflow 1") && Contains("catchment_area_m2"));
  CHECK_THAT(error_of_edit(R"({"edit": "group", "edits": [{"edit": "undo"}]})"), Contains("edit 2 (group), part 1"));
  CHECK_THAT(error_of_edit("7"), Contains("edit 2"));
}

TEST_CASE("what is no script, or one of a newer program, says so") {
  CHECK_THAT(error_of("{\"format\": \"biotope-edits\", \"version\": 2, \"edits\": []}"), Contains("newer") && Contains("Update"));
  CHECK_THAT(error_of("{\"format\": \"biotope-edits\", \"edits\": []}"), Contains("version"));
  CHECK_THAT(error_of("{\"format\": \"biotope-edits\", \"version\": 1}"), Contains("\"edits\" is missing"));
  CHECK_THAT(error_of("{\"format\": \"biotope-edits\", \"version\": 1, \"edits\": [], \"terrain\": {\"width\": 1}}"),
             Contains("terrain.width"));
  CHECK_THAT(error_of("{\"species\": []}"), Contains("no edit script"));
  CHECK_THAT(error_of("[]"), Contains("no edit script"));
  CHECK_THAT(error_of("{,}"), Contains("a.json:1:2"));
  CHECK_THAT(error_of(""), Contains("JSON"));
  CHECK_THAT(error_of(script_of(std::string(100000, '['))), Contains("a.json"));
}

TEST_CASE("a file name that leads out of the script's folder is refused") {
  for (const char* name :
       {"../leaf.png", "/tmp/leaf.png", "a/../../leaf.png", "a\\\\leaf.png", "C:leaf.png", "", ".", "a//b/", "a\\u0000b"}) {
    INFO(name);
    CHECK_THAT(error_of_edit(R"({"edit": "image", "layer": "ground:height", "file": ")" + std::string(name) + "\"}"),
               Contains("\"file\"") && Contains("folder"));
  }
  CHECK(parse_edit_script(script_of(R"({"edit": "image", "layer": "ground:height", "file": "a b/..leaf.png"})"), "a.json"));
}

TEST_CASE("a script cut short anywhere, or with a byte changed, is read or refused, never more") {
  const Document document = valley();
  const std::string text = edit_script_to_json(RandomScript(7, *document.species, document.climate).script(6));
  for (std::size_t i = 0; i < 150; ++i) {
    const auto cut = parse_edit_script(std::string_view(text).substr(0, text.size() * i / 150), "a.json");
    CHECK_FALSE(cut);
    std::string hurt = text;
    hurt[std::size_t(random_int(0, int(text.size()) - 1, {i}))] = char(random_int(0, 255, {i, 1}));
    const auto read = parse_edit_script(hurt, "a.json");
    if (!read) CHECK_THAT(read.error().message, StartsWith("a.json"));
  }
}

TEST_CASE("a patch makes the one document's parts of the other's") {
  const Document before = valley();
  Document after = before;
  std::vector<Species> species = *before.species;
  std::swap(species[0], species[1]);
  species[2].common_name = "changed";
  species.erase(species.begin() + 5);
  after.species = std::make_shared<const std::vector<Species>>(species);
  after.seed = 9;
  after.title = "";
  after.inflows.clear();
  after.placements.places.fords.push_back({{3, 4}, 5});
  after.use_proportions[1] = false;
  after.layer_states[{LayerKind::ground, "height"}] = {true, false};
  const PartsPatch patch = patch_between(before, after);
  CHECK_FALSE(patch.climate);
  REQUIRE(patch.species);
  CHECK(patch.species->changed.size() == 1);
  CHECK(patch.species->removed.size() == 1);
  Document made = before;
  REQUIRE(apply(patch, made, "here"));
  CHECK(*made.species == *after.species);
  CHECK(patch_between(made, after).empty());
  CHECK(patch_between(after, after).empty());
}

TEST_CASE("a patch that does not fit leaves the document as it was and says why") {
  const Document before = valley();
  const auto error_with = [&](const auto& change) {
    PartsPatch patch;
    change(patch);
    patch.seed = 77;
    Document document = before;
    const Status applied = apply(patch, document, "here");
    REQUIRE_FALSE(applied);
    CHECK(document.seed == before.seed);
    CHECK(document.species == before.species);
    CHECK_THAT(applied.error().message, StartsWith("here: "));
    return applied.error().message;
  };
  CHECK_THAT(error_with([](PartsPatch& p) { p.species.emplace().removed = {"dodo"}; }), Contains("dodo"));
  CHECK_THAT(error_with([](PartsPatch& p) { p.species.emplace().order = {"dodo"}; }), Contains("dodo"));
  CHECK_THAT(error_with([&](PartsPatch& p) { p.species.emplace().order = {before.species->front().name}; }),
             Contains("leaves out"));
  CHECK_THAT(error_with([](PartsPatch& p) { p.inflows = {{5000, 0, 1}}; }), Contains("outside"));
}

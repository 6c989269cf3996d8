#include <zip.h>
#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include <fstream>
#include <limits>
#include <map>

#include "core/exchange/scene_archive.hpp"
#include "core/exchange/scene_file.hpp"
#include "core/exchange/scene_raster.hpp"
#include "tests/exchange/raster_files.hpp"
#include "tests/exchange/scene_sample.hpp"

using namespace biotope;
using namespace biotope_test;
using Catch::Matchers::Contains;

namespace {

ArchiveEntries entries_of(const std::filesystem::path& file) {
  ArchiveEntries entries;
  zip_t* archive = zip_open(file.c_str(), ZIP_RDONLY, nullptr);
  REQUIRE(archive != nullptr);
  for (zip_int64_t i = 0; i < zip_get_num_entries(archive, 0); ++i) {
    zip_stat_t stat;
    zip_stat_index(archive, zip_uint64_t(i), 0, &stat);
    std::string bytes(stat.size, '\0');
    zip_file_t* entry = zip_fopen_index(archive, zip_uint64_t(i), 0);
    zip_fread(entry, bytes.data(), bytes.size());
    zip_fclose(entry);
    entries[stat.name] = bytes;
  }
  zip_discard(archive);
  return entries;
}

/// A scene of one layer whose scene.json is changed by `change`.
template <class Change>
std::string error_after(const Change& change) {
  const TemporaryFolder folder;
  REQUIRE(save_scene(folder / "a.biotope", full_document()));
  ArchiveEntries entries = entries_of(folder / "a.biotope");
  auto json = nlohmann::ordered_json::parse(entries.at("scene.json"));
  change(json, entries);
  entries["scene.json"] = json.dump();
  REQUIRE(write_archive(folder / "b.biotope", entries));
  const auto loaded = load_scene(folder / "b.biotope");
  REQUIRE_FALSE(loaded);
  CHECK_THAT(loaded.error().message, Contains("b.biotope"));
  return loaded.error().message;
}

}  // namespace

TEST_CASE("the archive is a plain ZIP with the promised entries") {
  const TemporaryFolder folder;
  REQUIRE(save_scene(folder / "a.biotope", full_document()));
  const auto entries = entries_of(folder / "a.biotope");
  for (const char* name :
       {"scene.json", "climate.json", "species.json", "terrain.tif", "voids.tif", "layers/1-resource.tif", "selection.tif",
        "locked-area.tif", "placements.json", "environment/temperature-12.tif", "environment/geology.tif"}) {
    INFO(name);
    CHECK(entries.contains(name));
  }
  const auto json = nlohmann::json::parse(entries.at("scene.json"));
  CHECK(json.at("version") == scene_format_version);
  CHECK(json.at("layers").size() == 8);
  CHECK(nlohmann::json::parse(entries.at("placements.json")).at("fords").size() == 1);
}

TEST_CASE("a scene of a newer program is refused with advice") {
  CHECK_THAT(error_after([](auto& json, auto&) { json["version"] = scene_format_version + 1; }),
             Contains("newer") && Contains("Update"));
}

TEST_CASE("a scene whose parts do not fit together is refused") {
  CHECK_THAT(error_after([](auto&, auto& entries) { entries["climate.json"] += " "; }), Contains("checksum"));
  CHECK_THAT(error_after([](auto& json, auto&) { json["checksums"].erase("terrain.tif"); }), Contains("terrain.tif"));
  CHECK_THAT(error_after([](auto&, auto& entries) { entries.erase("species.json"); }), Contains("species.json"));
  CHECK_THAT(error_after([](auto& json, auto&) { json["terrain"]["width"] = 161; }), Contains("size"));
  CHECK_THAT(error_after([](auto& json, auto&) { json.erase("seed"); }), Contains("seed"));
  CHECK_THAT(error_after([](auto& json, auto&) { json["format"] = "other"; }), Contains("no Biotope scene"));
  CHECK_THAT(error_after([](auto& json, auto&) { json["layers"][0]["kind"] = "smell"; }), Contains("smell"));
  CHECK_THAT(error_after([](auto& json, auto&) { json["inflows"][0]["x"] = 4000; }), Contains("inflow"));
  CHECK_THAT(error_after([](auto& json, auto&) { json["terrain"]["cell_size_m"] = -1; }), Contains("cell_size_m"));
  CHECK_THAT(error_after([](auto& json, auto& entries) {
               entries["terrain.tif"] = "not a tiff";
               json["checksums"]["terrain.tif"] = checksum("not a tiff");
             }),
             Contains("terrain.tif") && Contains("damaged"));
  CHECK_THAT(error_after([](auto& json, auto& entries) {
               const std::string half = entries["terrain.tif"].substr(0, entries["terrain.tif"].size() / 2);
               entries["terrain.tif"] = half;
               json["checksums"]["terrain.tif"] = checksum(half);
             }),
             Contains("terrain.tif") && Contains("damaged"));
}

TEST_CASE("absurd sizes are refused before memory is taken") {
  CHECK_THAT(error_after([](auto& json, auto&) { json["terrain"]["width"] = 2000000000; }), Contains("width"));
  CHECK_THAT(error_after([](auto& json, auto& entries) {
               const std::string bomb(8 << 20, 'a');
               entries["voids.tif"] = bomb;
               json["checksums"]["voids.tif"] = checksum(bomb);
             }),
             Contains("voids.tif") && Contains("unpacks"));
}

TEST_CASE("a path that climbs out is refused, and nothing is written") {
  for (const char* name : {"../evil.txt", "/tmp/evil.txt", "layers/../../evil.txt", "..\\evil.txt", "C:evil.txt"}) {
    INFO(name);
    CHECK_THAT(error_after([&](auto&, auto& entries) { entries[name] = "x"; }), Contains("leads out"));
  }
}

TEST_CASE("a truncated or corrupt scene is refused at every length") {
  const TemporaryFolder folder;
  REQUIRE(save_scene(folder / "a.biotope", full_document()));
  const std::string whole = bytes_of(folder / "a.biotope");
  for (int part = 0; part < 20; ++part) {
    std::ofstream(folder / "cut.biotope", std::ios::binary) << whole.substr(0, whole.size() * std::size_t(part) / 20);
    const auto loaded = load_scene(folder / "cut.biotope");
    INFO(part << " twentieths");
    REQUIRE_FALSE(loaded);
    CHECK_THAT(loaded.error().message, Contains("cut.biotope"));
  }
  for (int hit = 0; hit < 40; ++hit) {
    std::string hurt = whole;
    const std::size_t at = whole.size() * std::size_t(2 * hit + 1) / 80;
    hurt[at] = char(hurt[at] ^ 0x5a);
    std::ofstream(folder / "hurt.biotope", std::ios::binary) << hurt;
    const auto loaded = load_scene(folder / "hurt.biotope");
    if (loaded) require_same(full_document(), *loaded);
  }
}

TEST_CASE("what is no scene says so") {
  const TemporaryFolder folder;
  CHECK_FALSE(load_scene(folder / "none.biotope"));
  CHECK_FALSE(load_scene(folder.path()));
  std::ofstream(folder / "text.biotope") << "hello";
  const auto text = load_scene(folder / "text.biotope");
  REQUIRE_FALSE(text);
  CHECK_THAT(text.error().message, Contains("no scene"));
  REQUIRE(write_archive(folder / "zip.biotope", {{"readme.txt", "hello"}}));
  const auto zip = load_scene(folder / "zip.biotope");
  REQUIRE_FALSE(zip);
  CHECK_THAT(zip.error().message, Contains("scene.json"));
}

TEST_CASE("a scene of an older version opens, and what it did not know is empty") {
  const TemporaryFolder folder;
  REQUIRE(save_scene(folder / "a.biotope", full_document()));
  ArchiveEntries entries = entries_of(folder / "a.biotope");
  auto json = nlohmann::ordered_json::parse(entries.at("scene.json"));
  json["version"] = 1;
  for (const char* key : {"layer_states", "selection", "locked_area", "placements"}) json.erase(key);
  for (const char* name : {"selection.tif", "locked-area.tif", "placements.json"}) {
    json["checksums"].erase(name);
    entries.erase(name);
  }
  std::erase_if(json["layers"].get_ref<nlohmann::ordered_json::array_t&>(), [](const auto& layer) {
    return layer["kind"] != "resource" && layer["kind"] != "plant-density" && layer["kind"] != "animal-density";
  });
  entries["scene.json"] = json.dump();
  REQUIRE(write_archive(folder / "old.biotope", entries));
  const auto loaded = load_scene(folder / "old.biotope");
  if (!loaded) FAIL(loaded.error().message);
  Document expected = full_document();
  expected.layer_states.clear();
  expected.selection = nullptr;
  expected.locked_area = nullptr;
  expected.placements = {};
  std::erase_if(expected.layers, [](const auto& layer) { return layer.first.kind > LayerKind::animal_density; });
  require_same(expected, *loaded);
}

TEST_CASE("layers, states and placements that cannot be are refused") {
  CHECK_THAT(error_after([](auto& json, auto&) { json["layers"].push_back(json["layers"][0]); }), Contains("no other layer"));
  CHECK_THAT(error_after([](auto& json, auto&) { json["layers"][1]["file"] = json["layers"][0]["file"]; }),
             Contains("no other layer"));
  CHECK_THAT(error_after([](auto& json, auto&) { json["layers"][0]["name"] = "smell"; }),
             Contains("layer 1") && Contains("smell"));
  CHECK_THAT(error_after([](auto& json, auto&) { json["layer_states"][0]["hidden"] = 3; }),
             Contains("layer state 1") && Contains("hidden"));
  CHECK_THAT(error_after([](auto& json, auto&) { json["smell"] = 1; }), Contains("smell"));
  CHECK_THAT(error_after([](auto& json, auto&) { json["seed"] = -1; }), Contains("seed"));
  CHECK_THAT(error_after([](auto& json, auto&) { json["version"] = 1e300; }), Contains("version"));
  CHECK_THAT(error_after([](auto& json, auto&) { json["version"] = 18446744073709551615ULL; }), Contains("newer"));
  CHECK_THAT(error_after([](auto& json, auto&) { json["use_proportions"]["one"] = true; }), Contains("use_proportions.one"));
  CHECK_THAT(error_after([](auto&, auto& entries) { entries.erase("selection.tif"); }), Contains("selection.tif"));
  CHECK_THAT(error_after([](auto& json, auto& entries) {
               entries["placements.json"] = R"({"fords": [{"at": [1, 1e9]}]})";
               json["checksums"]["placements.json"] = checksum(entries["placements.json"]);
             }),
             Contains("placements.json") && Contains("fords[0]") && Contains("at"));
}

TEST_CASE("paint that its layer cannot hold is refused") {
  const auto with_paint = [](const char* kind, Paint paint) {
    return error_after([&](auto& json, auto& entries) {
      PaintLayer layer(160, 128);
      layer.set(3, 3, paint);
      for (auto& one : json["layers"]) {
        if (one["kind"] != kind) continue;
        const std::string file = one["file"];
        entries[file] = encode_paint(layer).value();
        json["checksums"][file] = checksum(entries[file]);
      }
    });
  };
  CHECK_THAT(with_paint("geology", {7, 1}), Contains("geology") && Contains("range"));
  CHECK_THAT(with_paint("geology", {-1, 1}), Contains("geology") && Contains("range"));
}

TEST_CASE("paint that is no number does not make a scene unreadable") {
  const TemporaryFolder folder;
  Document document = full_document();
  PaintLayer layer(160, 128);
  layer.set(3, 3, {std::numeric_limits<float>::quiet_NaN(), 1});
  layer.set(4, 3, {5, 2});
  PaintLayer geology(160, 128);
  geology.set(1, 1, {9, 1});
  document.layers[{LayerKind::resource, "moisture"}] = std::make_shared<const PaintLayer>(layer);
  document.layers[{LayerKind::geology, "class"}] = std::make_shared<const PaintLayer>(geology);
  REQUIRE(save_scene(folder / "a.biotope", document));
  const auto loaded = load_scene(folder / "a.biotope");
  if (!loaded) FAIL(loaded.error().message);
  const PaintLayer& moisture = *loaded->layers.at({LayerKind::resource, "moisture"});
  CHECK(moisture(3, 3) == Paint{});
  CHECK(moisture(4, 3) == Paint{5, 1});
  CHECK((*loaded->layers.at({LayerKind::geology, "class"}))(1, 1) == Paint{4, 1});
}

TEST_CASE("JSON nested without end is refused") {
  for (const char* entry : {"climate.json", "species.json", "placements.json"}) {
    CHECK_THAT(error_after([&](auto& json, auto& entries) {
                 entries[entry] = std::string(1000000, '[');
                 json["checksums"][entry] = checksum(entries[entry]);
               }),
               Contains(entry) && Contains("nested"));
  }
  const TemporaryFolder folder;
  REQUIRE(write_archive(folder / "deep.biotope", {{"scene.json", std::string(1000000, '[')}}));
  const auto deep = load_scene(folder / "deep.biotope");
  REQUIRE_FALSE(deep);
  CHECK_THAT(deep.error().message, Contains("scene.json") && Contains("nested"));
}

namespace {

/// The error of a scene that holds entries of these names, of which every "bbb" is then overwritten.
std::string error_of_names(const std::string& instead) {
  const TemporaryFolder folder;
  REQUIRE(write_archive(folder / "a.biotope", {{"aaa", "x"}, {"bbb", "y"}}));
  std::string bytes = bytes_of(folder / "a.biotope");
  for (std::size_t at = bytes.find("bbb"); at != std::string::npos; at = bytes.find("bbb", at + 3)) bytes.replace(at, 3, instead);
  std::ofstream(folder / "b.biotope", std::ios::binary) << bytes;
  const auto loaded = load_scene(folder / "b.biotope");
  REQUIRE_FALSE(loaded);
  CHECK_THAT(loaded.error().message, Contains("b.biotope"));
  return loaded.error().message;
}

}  // namespace

TEST_CASE("an archive that lists one name twice, or names that are no text, is refused") {
  CHECK_THAT(error_of_names("aaa"), Contains("twice"));
  CHECK_THAT(error_of_names("b\xff\xfe"), Contains("UTF-8"));
  CHECK_THAT(error_of_names("b\xc0\x80"), Contains("UTF-8"));
  CHECK_THAT(error_of_names("b\x01z"), Contains("UTF-8"));
  CHECK_THAT(error_of_names("../"), Contains("leads out"));
}

TEST_CASE("a scene without a locked area can be read by programs that know none") {
  const TemporaryFolder folder;
  Document document = full_document();
  document.locked_area = nullptr;
  REQUIRE(save_scene(folder / "a.biotope", document));
  const auto json = nlohmann::json::parse(entries_of(folder / "a.biotope").at("scene.json"));
  CHECK(json.at("version") == 2);
  CHECK_FALSE(json.contains("locked_area"));
}

TEST_CASE("text that repeats itself without end is called what it is") {
  const TemporaryFolder folder;
  REQUIRE(write_archive(folder / "blank.biotope", {{"scene.json", std::string(std::size_t(20) << 20, ' ')}}));
  const auto blank = load_scene(folder / "blank.biotope");
  REQUIRE_FALSE(blank);
  CHECK_THAT(blank.error().message, Contains("blank.biotope") && Contains("ZIP bomb") && !Contains("comma"));
}

TEST_CASE("a bomb is refused before it goes off") {
  const TemporaryFolder folder;
  REQUIRE(write_archive(folder / "bomb.biotope", {{"scene.json", std::string(std::size_t(80) << 20, ' ')}}));
  REQUIRE(std::filesystem::file_size(folder / "bomb.biotope") < 200000);
  const auto bomb = load_scene(folder / "bomb.biotope");
  REQUIRE_FALSE(bomb);
  CHECK_THAT(bomb.error().message, Contains("bomb.biotope") && Contains("unpacks"));
  // A map of which every block is left out is a few bytes that claim any size.
  GDALAllRegister();
  char block_x[] = "BLOCKXSIZE=512";
  char block_y[] = "BLOCKYSIZE=512";
  char tiled[] = "TILED=YES";
  char sparse_ok[] = "SPARSE_OK=TRUE";
  char* options[] = {tiled, block_x, block_y, sparse_ok, nullptr};
  GDALClose(GDALCreate(GDALGetDriverByName("GTiff"), (folder / "a.tif").c_str(), 16384, 16384, 1, GDT_Byte, options));
  const std::string sparse = bytes_of(folder / "a.tif");
  REQUIRE(sparse.size() < 100000);
  const auto cells = decode_bytes(sparse, 16384, 16384, "a.tif");
  REQUIRE_FALSE(cells);
  CHECK_THAT(cells.error().message, Contains("a.tif") && Contains("too short"));
}

TEST_CASE("views with a wrong checksum are told and given all the same, and take the document with them nowhere") {
  const TemporaryFolder folder;
  const std::string views = "{\"bookmarks\": [{\"name\": \"Ford\"}]}\n";
  REQUIRE(save_scene(folder / "a.biotope", full_document(), nullptr, views));
  ArchiveEntries entries = entries_of(folder / "a.biotope");
  entries["views.json"] = "{\"bookmarks\": [{\"name\": \"Bridge\"}]}\n";
  REQUIRE(write_archive(folder / "b.biotope", entries));
  const auto changed = load_scene_views(folder / "b.biotope");
  REQUIRE(changed);
  CHECK(changed->text == entries["views.json"]);
  CHECK_THAT(changed->damage, Contains("views.json") && Contains("checksum"));
  CHECK(load_scene(folder / "b.biotope"));
}

TEST_CASE("of views whose bytes are damaged what can be unpacked is given") {
  const TemporaryFolder folder;
  // Does not pack: a scene's text that is stored byte for byte.
  std::string views = "{\"name\": \"";
  for (std::uint64_t i = 0; i < 200; ++i) views += char(random_int('a', 'z', {5, i}));
  views += "\"}\n";
  REQUIRE(save_scene(folder / "a.biotope", full_document(), nullptr, views));
  std::string bytes = bytes_of(folder / "a.biotope");
  // The last byte before the entry after it: its local header begins with its own name.
  const std::size_t name = bytes.find("views.json");
  REQUIRE(name != std::string::npos);
  bytes[name + 40] = char(bytes[name + 40] ^ 0x10);
  std::ofstream(folder / "b.biotope", std::ios::binary) << bytes;
  const auto damaged = load_scene_views(folder / "b.biotope");
  if (!damaged) FAIL(damaged.error().message);
  CHECK_THAT(damaged->damage, Contains("damaged"));
  CHECK(damaged->text.size() <= views.size());
  CHECK(load_scene(folder / "b.biotope"));
}

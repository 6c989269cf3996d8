#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>
#include <zip.h>

#include <map>

#include "core/exchange/scene_archive.hpp"
#include "core/exchange/scene_file.hpp"
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
  for (const char* name : {"scene.json", "climate.json", "species.json", "terrain.tif", "voids.tif",
                           "layers/1-resource.tif", "environment/temperature-12.tif", "environment/geology.tif"}) {
    INFO(name);
    CHECK(entries.contains(name));
  }
  const auto json = nlohmann::json::parse(entries.at("scene.json"));
  CHECK(json.at("version") == scene_format_version);
  CHECK(json.at("layers").size() == 3);
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
  CHECK_THAT(error_after([](auto& json, auto&) { json["terrain"]["width"] = 2000000000; }), Contains("cells"));
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

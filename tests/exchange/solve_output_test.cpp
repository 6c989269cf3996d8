#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>
#include <tbb/global_control.h>

#include <set>

#include "core/exchange/geotiff.hpp"
#include "core/exchange/solve_output.hpp"
#include "core/pipeline/solve.hpp"
#include "tests/exchange/raster_files.hpp"
#include "tests/scenes/small_valley.hpp"

using namespace biotope;
using namespace biotope_test;
using Json = nlohmann::json;

namespace {

const MapsSnapshot& solved_valley() {
  static const std::shared_ptr<const MapsSnapshot> snapshot = [] {
    auto document = scenes::small_document(std::string(BIOTOPE_SOURCE_DIR) + "/assets");
    if (!document) FAIL(document.error().message);
    auto maps = solve(*document);
    if (!maps) FAIL(maps.error().message);
    return *maps;
  }();
  return *snapshot;
}

Json read_json(const std::filesystem::path& file) { return Json::parse(bytes_of(file)); }

void write_all(const std::filesystem::path& folder, bool all_maps = false) {
  SolveOutputOptions options;
  options.all_maps = all_maps;
  options.program_version = "1.2.3";
  options.total_ms = 1000;
  const Status written = write_solve_output(folder, solved_valley(), options);
  if (!written) FAIL(written.error().message);
}

std::set<std::string> keys_of(const Json& json) {
  std::set<std::string> keys;
  for (const auto& [key, value] : json.items()) keys.insert(key);
  return keys;
}

/// Every file below a folder with its bytes.
std::map<std::string, std::string> tree_of(const std::filesystem::path& folder) {
  std::map<std::string, std::string> files;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(folder)) {
    if (entry.is_regular_file()) files[entry.path().lexically_relative(folder).string()] = bytes_of(entry.path());
  }
  return files;
}

}  // namespace

TEST_CASE("summary.json has the promised keys with sound values") {
  const TemporaryFolder folder;
  write_all(folder / "out");
  const MapsSnapshot& maps = solved_valley();
  const Json summary = read_json(folder / "out" / "summary.json");
  CHECK(keys_of(summary) == std::set<std::string>{"version", "seed", "grid", "climate", "species", "regions", "graph",
                                                  "trails", "warnings", "timings_ms", "peak_memory_mb"});
  CHECK(summary.at("version") == "1.2.3");
  CHECK(summary.at("seed") == 1);
  CHECK(summary.at("grid") == Json{{"width", 160}, {"height", 128}, {"cell_size_m", 10.0}});
  CHECK(summary.at("climate") == "mild-humid");
  REQUIRE(summary.at("species").size() == maps.web->species.size());
  double plant_shares = 0;
  for (const Json& species : summary.at("species")) {
    CHECK(keys_of(species) == std::set<std::string>{"name", "level", "kind", "cover", "individuals", "herds", "desired",
                                                    "achieved", "surplus"});
    const bool plant = species.at("kind") == "plant";
    CHECK(plant == (species.at("level") == 0));
    CHECK(species.at("cover") >= 0);
    CHECK(species.at("cover") <= 1);
    CHECK(species.at("individuals") >= 0);
    CHECK(species.at("surplus") >= -1e-6);
    if (plant) plant_shares += species.at("achieved").get<double>();
  }
  CHECK(plant_shares == Approx(1));
  for (const auto& [animal, count] : summary.at("regions").items()) CHECK(count >= 0);
  CHECK(summary.at("regions").size() + maps.web->levels[0].size() == maps.web->species.size());
  REQUIRE(summary.at("graph").size() == maps.web->levels.size());
  CHECK(summary.at("graph")[0] == Json{{"level", 0}, {"nodes", 160 * 128}, {"edges", 0}});
  CHECK(summary.at("trails").at("routes") == maps.trails->routes.size());
  CHECK(summary.at("timings_ms").at("total") >= 1000);
  CHECK(summary.at("timings_ms").contains("plants"));
  CHECK(summary.at("peak_memory_mb") > 1);
}

TEST_CASE("mean cover in the summary is the mean of the density map") {
  const TemporaryFolder folder;
  write_all(folder / "out");
  const Json summary = read_json(folder / "out" / "summary.json");
  for (const Json& species : summary.at("species")) {
    const std::string name = species.at("name");
    const auto map = read_raster(folder / "out" / "maps" / ("density-" + name + ".tif"));
    INFO(name);
    REQUIRE(map);
    double sum = 0;
    for (const float value : map->cells()) sum += double(value);
    if (species.at("kind") == "plant") {
      CHECK(sum / double(map->size()) == Approx(species.at("cover").get<double>()).margin(1e-6));
    } else {
      // Individuals / km2 over cells of 100 m2.
      CHECK(sum * 100 / 1e6 == Approx(species.at("individuals").get<double>()).margin(0.01));
    }
  }
}

TEST_CASE("every promised map is there, and only the promised ones") {
  const TemporaryFolder folder;
  write_all(folder / "few");
  write_all(folder / "all", true);
  const MapsSnapshot& maps = solved_valley();
  std::set<std::string> few{"trails", "water", "environment-slope", "environment-illumination", "environment-temperature",
                            "environment-moisture", "environment-texture", "environment-geology"};
  for (std::size_t s = 0; s < maps.web->species.size(); ++s) {
    const std::string& name = maps.web->species[s].name;
    few.insert("density-" + name);
    few.insert("surplus-" + name);
    if (!maps.web->species[s].is_plant()) few.insert("regions-" + name);
  }
  std::set<std::string> all = few;
  for (const int plant : maps.web->levels[0]) all.insert("fitness-" + maps.web->species[std::size_t(plant)].name);
  for (const std::string resource : {"illumination", "temperature", "moisture"}) {
    for (int month = 1; month <= 12; ++month) {
      all.insert("environment-" + resource + (month < 10 ? "-0" : "-") + std::to_string(month));
    }
  }
  const auto names = [](const std::filesystem::path& out) {
    std::set<std::string> found;
    for (const auto& entry : std::filesystem::directory_iterator(out / "maps")) found.insert(entry.path().stem());
    return found;
  };
  CHECK(names(folder / "few") == few);
  CHECK(names(folder / "all") == all);

  const auto mean = read_raster(folder / "all" / "maps" / "environment-moisture.tif");
  REQUIRE(mean);
  float sum = 0;
  for (int month = 1; month <= 12; ++month) {
    const std::string number = (month < 10 ? "0" : "") + std::to_string(month);
    sum += (*read_raster(folder / "all" / "maps" / ("environment-moisture-" + number + ".tif")))(80, 60);
  }
  CHECK((*mean)(80, 60) == Approx(sum / 12));
}

TEST_CASE("trails, plans and graph are sound JSON that fits the snapshot") {
  const TemporaryFolder folder;
  write_all(folder / "out");
  const MapsSnapshot& maps = solved_valley();
  const Json trails = read_json(folder / "out" / "trails.geojson");
  CHECK(trails.at("type") == "FeatureCollection");
  REQUIRE(trails.at("features").size() == maps.trails->routes.size());
  for (const Json& feature : trails.at("features")) {
    CHECK(feature.at("geometry").at("type") == "LineString");
    CHECK(feature.at("properties").at("length_m") > 0);
    CHECK(feature.at("geometry").at("coordinates").size() >= 2);
  }
  const Json plans = read_json(folder / "out" / "plans.json").at("plans");
  REQUIRE(plans.size() == maps.plans->size());
  for (const Json& plan : plans) {
    CHECK(maps.web->find(plan.at("species").get<std::string>()) >= 0);
    CHECK(plan.at("way").size() <= 98);
    CHECK_FALSE(plan.at("stops").empty());
  }
  const Json levels = read_json(folder / "out" / "graph.json").at("levels");
  REQUIRE(levels.size() == maps.graph->levels.size());
  for (std::size_t i = 1; i < levels.size(); ++i) {
    REQUIRE(levels[i].at("nodes").size() == maps.graph->levels[i].nodes.size());
    REQUIRE(levels[i].at("edges").size() == maps.graph->levels[i].edges.size());
  }
}

TEST_CASE("one thread or more, the written bytes are the same") {
  const TemporaryFolder folder;
  const auto write = [&](const char* name, std::size_t threads) {
    const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, threads);
    write_all(folder / name, true);
    auto files = tree_of(folder / name);
    auto summary = Json::parse(files.at("summary.json"));
    summary.erase("timings_ms");
    summary.erase("peak_memory_mb");
    files["summary.json"] = summary.dump();
    return files;
  };
  CHECK(write("one", 1) == write("three", 3));
}

TEST_CASE("a second run replaces the first and spares other files") {
  const TemporaryFolder folder;
  write_all(folder / "out", true);
  std::ofstream(folder / "out" / "notes.txt") << "mine";
  write_all(folder / "out", false);
  CHECK(std::filesystem::exists(folder / "out" / "notes.txt"));
  CHECK_FALSE(std::filesystem::exists(folder / "out" / "maps" / "environment-moisture-01.tif"));
  CHECK(folder.names() == std::vector<std::string>{"out"});
}

TEST_CASE("a run that fails or is stopped leaves nothing") {
  const TemporaryFolder folder;
  std::ofstream(folder / "taken") << "a file";
  CHECK_FALSE(write_solve_output(folder / "taken", solved_valley(), {}));
  std::stop_source stop;
  stop.request_stop();
  CHECK_FALSE(write_solve_output(folder / "out", solved_valley(), {}, {{}, stop.get_token()}));
  CHECK(folder.names() == std::vector<std::string>{"taken"});
}

#include <sys/resource.h>

#include <cmath>
#include <nlohmann/json.hpp>
#include <numbers>

#include "core/base/parallel.hpp"
#include "core/ecosystem/surplus.hpp"
#include "core/exchange/solve_reports.hpp"

namespace biotope {
namespace {

using Json = nlohmann::ordered_json;

/// Sum of a map's covered fractions over its cells.
double covered_cells(const CoverMap& cover) {
  std::uint64_t sum = 0;
  for (std::size_t i = 0; i < cover.tile_count(); ++i) {
    const auto& tile = cover.tile(i);
    if (!tile) continue;
    const Rect rect = cover.tile_rect(i);
    for (int y = rect.y0; y < rect.y1; ++y) {
      for (int x = rect.x0; x < rect.x1; ++x) sum += (*tile)[CoverMap::offset(x, y)];
    }
  }
  return double(sum) / full_cover;
}

Json share_or_null(const std::vector<double>& shares, std::size_t index) {
  return index < shares.size() ? Json(shares[index]) : Json(nullptr);
}

/// Plants that stand on the covered ground when each takes its crown's circle.
std::int64_t plant_count(const PlantTraits& plant, double covered_area) {
  const double crown = std::numbers::pi / 4 * double(plant.shape.crown_diameter) * double(plant.shape.crown_diameter);
  return crown > 0 ? std::llround(covered_area / crown) : 0;
}

Json plant_entry(const MapsSnapshot& snapshot, std::size_t index) {
  const FoodWeb& web = *snapshot.web;
  const int number = web.levels[0][index];
  const Species& species = web.species[std::size_t(number)];
  const Terrain& terrain = snapshot.terrain();
  const CoverMap* cover = index < snapshot.cover.size() ? snapshot.cover[index].get() : nullptr;
  const double cells = cover ? covered_cells(*cover) : 0;
  Json entry;
  entry["name"] = species.name;
  entry["level"] = 0;
  entry["kind"] = "plant";
  entry["cover"] = cells / double(terrain.height.size());
  entry["individuals"] = plant_count(species.plant(), cells * terrain.cell_area());
  entry["herds"] = 0;
  entry["desired"] = share_or_null(snapshot.plant_desired, index);
  entry["achieved"] = share_or_null(snapshot.plant_achieved, index);
  entry["surplus"] =
      cover ? surplus_total(web, number, cover, terrain.cell_area(), snapshot.animals, snapshot.loss(number).get()).surplus()
            : 0.0;
  return entry;
}

Json animal_entry(const MapsSnapshot& snapshot, const AnimalLevel& level, std::size_t index) {
  const FoodWeb& web = *snapshot.web;
  const int number = level.species[index];
  double individuals = 0;
  for (const double count : level.population[index]) individuals += count;
  const auto herds =
      std::count_if(level.herds.begin(), level.herds.end(), [&](const Herd& herd) { return herd.species == number; });
  Json entry;
  entry["name"] = web.species[std::size_t(number)].name;
  entry["level"] = level.level;
  entry["kind"] = "animal";
  entry["cover"] = 0;
  entry["individuals"] = individuals;
  entry["herds"] = herds;
  entry["desired"] = share_or_null(level.desired, index);
  entry["achieved"] = share_or_null(level.achieved, index);
  entry["surplus"] =
      surplus_total(web, number, nullptr, snapshot.terrain().cell_area(), snapshot.animals, snapshot.loss(number).get())
          .surplus();
  return entry;
}

Json species_entries(const MapsSnapshot& snapshot) {
  const auto& plants = snapshot.web->levels[0];
  std::vector<Json> of_plants(plants.size());
  parallel_each(plants.size(), [&](std::size_t i) { of_plants[i] = plant_entry(snapshot, i); });
  Json entries = of_plants;
  for (const auto& level : snapshot.animals) {
    for (std::size_t i = 0; i < level->species.size(); ++i) entries.push_back(animal_entry(snapshot, *level, i));
  }
  return entries;
}

Json region_counts(const MapsSnapshot& snapshot) {
  Json counts = Json::object();
  for (const auto& level : snapshot.animals) {
    for (std::size_t i = 0; i < level->species.size(); ++i) {
      counts[snapshot.web->species[std::size_t(level->species[i])].name] = level->regions[i]->regions.size();
    }
  }
  return counts;
}

Json graph_sizes(const MapsSnapshot& snapshot) {
  Json sizes = Json::array();
  sizes.push_back({{"level", 0}, {"nodes", snapshot.terrain().height.size()}, {"edges", 0}});
  for (std::size_t i = 1; snapshot.graph && i < snapshot.graph->levels.size(); ++i) {
    const GraphLevel& level = snapshot.graph->levels[i];
    sizes.push_back({{"level", level.level}, {"nodes", level.nodes.size()}, {"edges", level.edges.size()}});
  }
  return sizes;
}

Json timings(const MapsSnapshot& snapshot, const SolveOutputOptions& options, double writing_ms) {
  Json times = Json::object();
  for (const auto& [stage, milliseconds] : snapshot.timings) times[stage] = milliseconds;
  times["writing"] = writing_ms;
  times["total"] = options.total_ms + writing_ms;
  return times;
}

double peak_memory_megabytes() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return double(usage.ru_maxrss) / 1024;
}

}  // namespace

std::string summary_json(const MapsSnapshot& snapshot, const SolveOutputOptions& options, double writing_ms) {
  const Terrain& terrain = snapshot.terrain();
  Json summary;
  summary["version"] = options.program_version;
  summary["seed"] = snapshot.document.seed;
  summary["grid"] = {{"width", terrain.height.width()}, {"height", terrain.height.height()}, {"cell_size_m", terrain.cell_size}};
  summary["climate"] = snapshot.document.climate.name;
  summary["species"] = species_entries(snapshot);
  summary["regions"] = region_counts(snapshot);
  summary["graph"] = graph_sizes(snapshot);
  summary["trails"] = {{"length_m", snapshot.trails ? snapshot.trails->total_length() : 0.0},
                       {"routes", snapshot.trails ? snapshot.trails->routes.size() : 0}};
  summary["warnings"] = Json::array();
  for (const Warning& warning : snapshot.warnings) summary["warnings"].push_back(warning.text);
  summary["timings_ms"] = timings(snapshot, options, writing_ms);
  summary["peak_memory_mb"] = peak_memory_megabytes();
  return summary.dump(2) + "\n";
}

}  // namespace biotope

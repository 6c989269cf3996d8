#include <tbb/task_arena.h>

#include <algorithm>
#include <atomic>
#include <functional>
#include <thread>

#include "core/base/parallel.hpp"
#include "core/ecosystem/surplus.hpp"
#include "core/exchange/geotiff.hpp"
#include "core/exchange/solve_reports.hpp"
#include "core/pipeline/solve.hpp"

namespace biotope {
namespace {

/// A file and how its map is made. Maps are made one by one when they are written, so that few are in memory at a time.
struct MapJob {
  std::string name;
  std::function<Grid<float>()> make;
};

template <class Cell>
Grid<float> map_of_cells(const Terrain& terrain, const Cell& cell) {
  Grid<float> map(terrain.height.width(), terrain.height.height());
  parallel_rows(0, map.height(), [&](int y) {
    for (int x = 0; x < map.width(); ++x) map(x, y) = cell(x, y);
  });
  return map;
}

Grid<float> cover_map(const CoverMap& cover) {
  Grid<float> map(cover.width(), cover.height());
  parallel_rows(0, map.height(), [&](int y) {
    std::vector<Cover> row(std::size_t(map.width()));
    cover.read_row(y, 0, row);
    std::transform(row.begin(), row.end(), map.row(y).begin(), cover_fraction);
  });
  return map;
}

constexpr std::array<const char*, monthly_resources> resource_names{"illumination", "temperature", "moisture"};

float resource_mean(const PlantEnvironment& environment, std::size_t resource, int x, int y) {
  if (!environment.paint[resource]) return environment.maps->monthly[resource].mean(x, y);
  const CellEnvironment cell = environment.cell(x, y);
  float sum = 0;
  for (const float value : cell.monthly[resource]) sum += value;
  return sum / float(months);
}

float resource_value(const PlantEnvironment& environment, std::size_t resource, int month, int x, int y) {
  if (!environment.paint[resource]) return environment.maps->monthly[resource].value(month, x, y);
  return environment.cell(x, y).monthly[resource][std::size_t(month)];
}

std::string two_digits(int number) { return (number < 10 ? "0" : "") + std::to_string(number); }

void add_environment(std::vector<MapJob>& jobs, const MapsSnapshot& snapshot, bool all_maps) {
  if (!snapshot.environment) return;
  const Terrain& terrain = snapshot.terrain();
  const PlantEnvironment environment = snapshot.plant_environment();
  for (std::size_t r = 0; r < monthly_resources; ++r) {
    jobs.push_back({std::string("environment-") + resource_names[r], [&terrain, environment, r] {
                      return map_of_cells(terrain, [&](int x, int y) { return resource_mean(environment, r, x, y); });
                    }});
    for (int month = 0; all_maps && month < months; ++month) {
      jobs.push_back(
          {std::string("environment-") + resource_names[r] + "-" + two_digits(month + 1), [&terrain, environment, r, month] {
             return map_of_cells(terrain, [&](int x, int y) { return resource_value(environment, r, month, x, y); });
           }});
    }
  }
  jobs.push_back({"environment-texture", [environment] { return *environment.maps->texture; }});
  jobs.push_back({"environment-geology", [&terrain, environment] {
                    return map_of_cells(terrain, [&](int x, int y) { return float((*environment.maps->geology)(x, y)); });
                  }});
}

void add_ground(std::vector<MapJob>& jobs, const MapsSnapshot& snapshot) {
  if (snapshot.derivatives) {
    jobs.push_back({"environment-slope", [&snapshot] { return snapshot.derivatives->slope; }});
  }
  if (snapshot.hydrology) jobs.push_back({"water", [&snapshot] { return snapshot.hydrology->water_depth; }});
  if (snapshot.trails) jobs.push_back({"trails", [&snapshot] { return snapshot.trails->wear; }});
}

void add_plants(std::vector<MapJob>& jobs, const MapsSnapshot& snapshot, bool all_maps) {
  for (std::size_t i = 0; i < snapshot.cover.size(); ++i) {
    const int number = snapshot.web->levels[0][i];
    const Species& species = snapshot.web->species[std::size_t(number)];
    const CoverMap& cover = *snapshot.cover[i];
    jobs.push_back({"density-" + species.name, [&cover] { return cover_map(cover); }});
    jobs.push_back({"surplus-" + species.name, [&snapshot, &cover, number] {
                      return plant_surplus(*snapshot.web, number, cover, snapshot.animals, snapshot.loss(number).get());
                    }});
    if (!all_maps) continue;
    jobs.push_back({"fitness-" + species.name,
                    [&snapshot, &species] { return fitness_map(species.plant(), snapshot.plant_environment()); }});
  }
}

void add_animals(std::vector<MapJob>& jobs, const MapsSnapshot& snapshot) {
  for (const auto& pointer : snapshot.animals) {
    const AnimalLevel& level = *pointer;
    for (std::size_t i = 0; i < level.species.size(); ++i) {
      const int number = level.species[i];
      const std::string& name = snapshot.web->species[std::size_t(number)].name;
      jobs.push_back({"density-" + name, [&snapshot, &level, &name, i] {
                        const auto paint = snapshot.paint({LayerKind::animal_density, name});
                        return animal_density(level, int(i), paint.get());
                      }});
      jobs.push_back({"surplus-" + name, [&snapshot, &level, number] {
                        return animal_surplus(*snapshot.web, number, level, snapshot.animals, snapshot.loss(number).get());
                      }});
      jobs.push_back({"regions-" + name, [&snapshot, &level, i] {
                        const auto& label = level.regions[i]->label;
                        return map_of_cells(snapshot.terrain(), [&](int x, int y) { return float(label(x, y)); });
                      }});
    }
  }
}

}  // namespace

Status write_maps(const std::filesystem::path& folder, const MapsSnapshot& snapshot, bool all_maps, const TaskContext& context) {
  std::vector<MapJob> jobs;
  add_ground(jobs, snapshot);
  add_environment(jobs, snapshot, all_maps);
  add_plants(jobs, snapshot, all_maps);
  add_animals(jobs, snapshot);

  std::vector<Status> written(jobs.size());
  std::atomic<std::size_t> done{0};
  const auto caller = std::this_thread::get_id();
  parallel_each(jobs.size(), [&](std::size_t i) {
    if (context.stopped()) return;
    // Isolated, so that a thread that waits for its rows does not start another map and hold two at once.
    tbb::this_task_arena::isolate(
        [&] { written[i] = write_geotiff(folder / (jobs[i].name + ".tif"), jobs[i].make(), snapshot.terrain()); });
    const double fraction = double(done.fetch_add(1) + 1) / double(jobs.size());
    if (std::this_thread::get_id() == caller) context.report("writing maps", fraction);
  });
  if (context.stopped()) return fail(stopped_message);
  for (const Status& status : written) {
    if (!status) return status;
  }
  return {};
}

}  // namespace biotope

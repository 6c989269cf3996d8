// A brush dab of 100 cells' radius: how long until its own level, the levels beside it, and everything up to trails and plans
// answer.
//   bench_dab [INPUT [DABS]]   INPUT: sample:valley (1024 x 1024, the default), sample:valley-1m (4096 x 4096), a DEM or a scene

#include <sys/resource.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <map>
#include <string>
#include <vector>

#include "core/base/random.hpp"
#include "core/document/brush.hpp"
#include "core/ecosystem/surplus.hpp"
#include "core/exchange/open_input.hpp"
#include "core/pipeline/solve.hpp"
#include "core/species/desired_shares.hpp"

using namespace biotope;

namespace {

using Clock = std::chrono::steady_clock;

/// Milliseconds of processor time that this process used so far, over all its threads.
double processor_milliseconds() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  const auto milliseconds = [](const timeval& time) { return double(time.tv_sec) * 1e3 + double(time.tv_usec) * 1e-3; };
  return milliseconds(usage.ru_utime) + milliseconds(usage.ru_stime);
}

/// Megabytes of memory that this process holds, pages that several maps share counted once (Linux).
double memory_held() {
  std::ifstream file("/proc/self/smaps_rollup");
  for (std::string word; file >> word;) {
    double kilobytes = 0;
    if (word == "Pss:" && file >> kilobytes) return kilobytes / 1024;
  }
  return 0;
}

double milliseconds_since(Clock::time_point start) {
  return std::chrono::duration<double, std::milli>(Clock::now() - start).count();
}

/// What is painted.
struct Painted {
  std::string name;
  LayerId layer;
  float value = 0;     ///< set by the brush, or how far it raises
  float computed = 0;  ///< the map below is taken as flat
  /// The levels that must answer first, by their number in the food chain; -1: none.
  int own_level = -1;
  int level_above = -1;
  /// A species of the level below, whose surplus a person may be looking at.
  int species_below = -1;
  BrushMode mode = BrushMode::set;
};

/// Measurements in milliseconds, by what was waited for, in the order of first measurement.
class Measurements {
 public:
  void add(const std::string& what, double milliseconds) {
    if (!values_.contains(what)) order_.push_back(what);
    values_[what].push_back(milliseconds);
  }
  void print() {
    for (const std::string& what : order_) {
      auto& values = values_[what];
      std::sort(values.begin(), values.end());
      const auto percentile = [&](double share) {
        return values[std::min(values.size() - 1, std::size_t(std::ceil(share * double(values.size()))) - 1)];
      };
      std::printf("    %-34s p50 %7.1f  p90 %7.1f  p99 %7.1f  worst %7.1f ms\n", what.c_str(), percentile(0.5), percentile(0.9),
                  percentile(0.99), values.back());
    }
  }

 private:
  std::vector<std::string> order_;
  std::map<std::string, std::vector<double>> values_;
};

/// Notes when each level is first published.
class LevelClock {
 public:
  explicit LevelClock(Clock::time_point start) : start_(start) {}
  void see(const MapsSnapshot& maps) {
    const std::size_t known = maps.cover.empty() ? 0 : 1 + maps.animals.size();
    while (answered_.size() < known) {
      answered_.push_back(milliseconds_since(start_));
      processor_.push_back(processor_milliseconds() - processor_at_start_);
    }
    if (maps.trails && trails_ < 0) trails_ = milliseconds_since(start_);
    if (!maps.complete) return;
    all_ = milliseconds_since(start_);
    all_processor_ = processor_milliseconds() - processor_at_start_;
  }
  [[nodiscard]] double level(int number) const { return answered_.at(std::size_t(number)); }
  /// Processor time until then.
  [[nodiscard]] double processor(int number) const { return processor_.at(std::size_t(number)); }
  [[nodiscard]] double trails() const { return trails_; }
  /// Everything, with shares or far shade of before; less than 0 where there is none.
  [[nodiscard]] double all() const { return all_; }
  [[nodiscard]] double all_processor() const { return all_processor_; }

 private:
  Clock::time_point start_;
  double processor_at_start_ = processor_milliseconds();
  std::vector<double> answered_;
  std::vector<double> processor_;
  double trails_ = -1;
  double all_ = -1;
  double all_processor_ = -1;
};

/// Milliseconds to make the surplus map of one species.
double surplus_milliseconds(const MapsSnapshot& maps, int species) {
  const auto start = Clock::now();
  const int level = maps.web->level[std::size_t(species)];
  const LayerId loss{LayerKind::loss, maps.web->species[std::size_t(species)].name};
  const auto lost = maps.paint(loss);
  if (level == 0) {
    const auto& plants = maps.web->levels[0];
    const auto place = std::size_t(std::find(plants.begin(), plants.end(), species) - plants.begin());
    (void)plant_surplus(*maps.web, species, *maps.cover[place], maps.animals, lost.get());
  } else {
    (void)animal_surplus(*maps.web, species, *maps.animals[std::size_t(level) - 1], maps.animals, lost.get());
  }
  return milliseconds_since(start);
}

/// Paints and solves again; false when a solve failed.
bool run(const Painted& painted, int dabs, const Document& start, SolveCache& cache) {
  const int width = start.terrain->height.width();
  const int height = start.terrain->height.height();
  const bool raises = painted.mode == BrushMode::raise;
  const Grid<float> flat(raises ? 1 : width, raises ? 1 : height, painted.computed);
  const Grid<float>& computed = raises ? start.terrain->height : flat;
  Brush brush;
  brush.mode = painted.mode;
  brush.radius = 100;
  brush.strength = 1;
  if (painted.mode == BrushMode::raise) brush.hardness = 0;
  brush.value = painted.value;
  Document document = start;
  // What the layer painted before left behind must not count here.
  if (const auto settled = solve(document, &cache); !settled) return false;
  Measurements measured;
  double held = 0;
  for (int i = 0; i < dabs; ++i) {
    const auto before = Clock::now();
    const auto place = std::uint64_t(i);
    const int x = random_int(100, width - 100, {7, place, 1});
    const int y = random_int(100, height - 100, {7, place, 2});
    Stroke stroke(painted.layer, &computed);
    stroke.dab(document, brush, float(x), float(y));
    measured.add("the dab itself", milliseconds_since(before));
    const auto posted = Clock::now();
    const double processor = processor_milliseconds();
    LevelClock clock(posted);
    const auto maps = solve(document, &cache, {}, [&](std::shared_ptr<const MapsSnapshot> partial) { clock.see(*partial); });
    const double consistent = milliseconds_since(posted);
    if (!maps) {
      std::printf("%s: %s\n", painted.name.c_str(), maps.error().message.c_str());
      return false;
    }
    if (painted.own_level >= 0) measured.add("its own level", clock.level(painted.own_level));
    if (painted.level_above >= 0) {
      measured.add("the level above", clock.level(painted.level_above));
      measured.add("the level above, processor time", clock.processor(painted.level_above));
    }
    if (painted.species_below >= 0)
      measured.add("the level below, with its surplus",
                   clock.level(painted.own_level) + surplus_milliseconds(**maps, painted.species_below));
    measured.add("trails", clock.trails());
    measured.add("all, with plans", clock.all() < 0 ? consistent : clock.all());
    measured.add("all, processor time", clock.all() < 0 ? processor_milliseconds() - processor : clock.all_processor());
    if (clock.all() >= 0) {
      measured.add("all, exactly", consistent);
      measured.add("all, exactly, processor time", processor_milliseconds() - processor);
    }
    for (const auto& [stage, milliseconds] : (*maps)->timings) measured.add("  stage: " + stage, milliseconds);
    held = std::max(held, memory_held());
  }
  std::printf("%s (%d dabs); after a dab at most %.0f MB held\n", painted.name.c_str(), dabs, held);
  measured.print();
  std::fflush(stdout);
  return true;
}

std::vector<Painted> paintable(const MapsSnapshot& maps) {
  const FoodWeb& web = *maps.web;
  const auto first = [&](std::size_t level) { return web.levels[level].front(); };
  const auto name = [&](int species) { return web.species[std::size_t(species)].name; };
  std::vector<Painted> all;
  all.push_back({"moisture", {LayerKind::resource, "moisture"}, 8, 4, -1, 0, -1});
  for (const Stratum stratum : {Stratum::herb, Stratum::tree}) {
    for (const int plant : web.levels[0]) {
      if (web.species[std::size_t(plant)].plant().stratum != stratum) continue;
      all.push_back({stratum == Stratum::herb ? "a herb's density" : "a tree's density",
                     {LayerKind::plant_density, name(plant)},
                     0.9F,
                     0.2F,
                     0,
                     1,
                     -1});
      break;
    }
  }
  for (std::size_t level = 1; level < web.levels.size(); ++level) {
    const int above = level + 1 < web.levels.size() ? int(level) + 1 : -1;
    all.push_back({"an animal's density, level " + std::to_string(level),
                   {LayerKind::animal_density, name(first(level))},
                   level == 1 ? 80.0F : 5.0F,
                   0.2F,
                   int(level),
                   above,
                   first(level - 1)});
  }
  all.push_back({"passage", {LayerKind::passage, "all"}, 1, 0, -1, 1, -1});
  all.push_back({"ground height, a table mountain", {LayerKind::ground, "height"}, 700, 500, -1, 0, -1});
  all.push_back({"ground height, raised by 10 m", {LayerKind::ground, "height"}, 10, 0, -1, 0, -1, BrushMode::raise});
  return all;
}

/// Moisture again, on a landscape whose plants have desired shares.
bool run_with_shares(const MapsSnapshot& maps, int dabs, const std::string& only, Document document) {
  Painted painted = paintable(maps).front();
  painted.name += ", plants with shares";
  if (!only.empty() && painted.name.find(only) == std::string::npos) return true;
  const FoodWeb& web = *maps.web;
  const std::string& asking = web.species[std::size_t(web.levels[0].front())].name;
  document.species = std::make_shared<const std::vector<Species>>(
      with_desired_share(*document.species, web, 0, document.climate.name, asking, 0.3, maps.plant_achieved));
  SolveCache cache;
  const auto begun = Clock::now();
  if (const auto solved = solve(document, &cache); !solved) {
    std::printf("%s\n", solved.error().message.c_str());
    return false;
  }
  std::printf("with shares: first complete maps after %.0f ms\n", milliseconds_since(begun));
  return run(painted, dabs, document, cache);
}

/// Two rivers and a lake that a person drew.
DrawnWater drawn_water(float side) {
  DrawnWater water;
  water.rivers.push_back({{{0.1F * side, 0.1F * side}, {0.15F * side, 0.2F * side}, {0.25F * side, 0.35F * side}}, 3});
  water.rivers.push_back({{{0.9F * side, 0.15F * side}, {0.8F * side, 0.25F * side}, {0.75F * side, 0.4F * side}}, 1});
  water.lakes.push_back({{}, 5});
  for (int i = 0; i < 6; ++i) {
    water.lakes.front().shore.push_back({0.3F * side + 60 * std::cos(float(i)), 0.7F * side + 60 * std::sin(float(i))});
  }
  return water;
}

/// The ground raised again, where water is drawn.
bool run_with_water(const MapsSnapshot& maps, int dabs, const std::string& only, Document document) {
  Painted painted = paintable(maps).back();
  painted.name += ", drawn water";
  if (!only.empty() && painted.name.find(only) == std::string::npos) return true;
  document.placements.water = drawn_water(float(document.terrain->height.width()));
  SolveCache cache;
  return run(painted, dabs, document, cache);
}

}  // namespace

int main(int count, char** arguments) {
  const std::string input = count > 1 ? arguments[1] : "sample:valley";
  const int dabs = count > 2 ? std::max(1, std::atoi(arguments[2])) : 30;
  const std::string only = count > 3 ? arguments[3] : "";
  const auto opened = Clock::now();
  const auto document = open_input(input);
  if (!document) {
    std::printf("%s\n", document.error().message.c_str());
    return 1;
  }
  std::printf("%s: %d x %d cells, opened in %.0f ms\n", input.c_str(), document->terrain->height.width(),
              document->terrain->height.height(), milliseconds_since(opened));
  SolveCache cache;
  const auto begun = Clock::now();
  const auto start = solve(*document, &cache);
  if (!start) {
    std::printf("%s\n", start.error().message.c_str());
    return 1;
  }
  std::printf("first complete maps after %.0f ms; %.0f MB held\n", milliseconds_since(begun), memory_held());
  for (const auto& [stage, milliseconds] : (*start)->timings) std::printf("    %-12s %9.1f ms\n", stage.c_str(), milliseconds);
  for (const Painted& painted : paintable(**start)) {
    if (!only.empty() && painted.name.find(only) == std::string::npos) continue;
    if (!run(painted, dabs, *document, cache)) return 1;
  }
  cache = SolveCache();
  if (!run_with_water(**start, dabs, only, *document)) return 1;
  return run_with_shares(**start, dabs, only, *document) ? 0 : 1;
}

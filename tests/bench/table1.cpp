// The paper's table 1: from the terrain to trails and plans, stage by stage.
//   bench_table1 [CASE...]   CASE: mild, ice-age, canyon, small (all when none is given)

#include <sys/resource.h>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <string>
#include <vector>

#include "core/exchange/dem_import.hpp"
#include "core/exchange/open_input.hpp"
#include "core/pipeline/solve.hpp"
#include "core/species/species_library.hpp"
#include "core/terrain/synthetic.hpp"

using namespace biotope;

namespace {

struct Case {
  std::string name;
  std::string sample;
  int side;
  std::string species;
  std::string climate;
  double paper_seconds;
};

const std::vector<Case> cases{{"mild", "valley-1m", 4096, "authors-2021", "mild-humid", 1551},
                              {"ice-age", "valley-1m", 4096, "authors-2021", "ice-age", 1559},
                              {"canyon", "canyon", 3072, "grand-canyon", "hot-dry-canyon", 76},
                              {"small", "canyon", 390, "authors-2021", "mild-humid", 8}};

Result<Document> document_of(const Case& one) {
  const std::string assets = std::string(BIOTOPE_SOURCE_DIR) + "/assets";
  auto document = open_input("sample:" + one.sample);
  if (!document) return document;
  if (document->terrain->height.width() != one.side) {
    const double scale = double(one.side) / document->terrain->height.width();
    document->terrain = std::make_shared<const Terrain>(resampled(*document->terrain, one.side));
    for (Inflow& inflow : document->inflows) {
      inflow.x = int(inflow.x * scale);
      inflow.y = int(inflow.y * scale);
    }
  }
  auto species = load_species(assets + "/species/" + one.species + ".json");
  if (!species) return tl::unexpected<Error>(species.error());
  document->species = std::make_shared<const std::vector<Species>>(std::move(*species));
  auto climates = load_climates(assets + "/climates");
  if (!climates) return tl::unexpected<Error>(climates.error());
  for (const Climate& climate : *climates) {
    if (climate.name == one.climate) document->climate = climate;
  }
  return document;
}

void run(const Case& one) {
  const auto document = document_of(one);
  if (!document) {
    std::printf("%s: %s\n", one.name.c_str(), document.error().message.c_str());
    return;
  }
  const auto started = std::chrono::steady_clock::now();
  const auto maps = solve(*document);
  const std::chrono::duration<double> elapsed = std::chrono::steady_clock::now() - started;
  if (!maps) {
    std::printf("%s: %s\n", one.name.c_str(), maps.error().message.c_str());
    return;
  }
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  std::printf("%-8s %dx%d: %.2f s (paper %.0f s), peak memory of the process so far %.0f MB\n", one.name.c_str(),
              (*maps)->terrain().height.width(), (*maps)->terrain().height.height(), elapsed.count(), one.paper_seconds,
              double(usage.ru_maxrss) / 1024);
  for (const auto& [stage, milliseconds] : (*maps)->timings) std::printf("    %-12s %9.1f ms\n", stage.c_str(), milliseconds);
  std::size_t herds = 0;
  for (const auto& level : (*maps)->animals) herds += level->herds.size();
  std::printf("    herds %zu, nodes %zu, routes %zu, trails %.1f km\n", herds, (*maps)->graph->levels.at(1).nodes.size(),
              (*maps)->trails->routes.size(), (*maps)->trails->total_length() / 1000);
}

}  // namespace

int main(int count, char** arguments) {
  const std::vector<std::string> wanted(arguments + 1, arguments + count);
  for (const Case& one : cases) {
    if (wanted.empty() || std::find(wanted.begin(), wanted.end(), one.name) != wanted.end()) run(one);
  }
  return 0;
}

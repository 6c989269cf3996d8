// A brush dab of 100 cells' radius on the 1024 x 1024 sample: how long until every level and the trails agree again.

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <vector>

#include "core/document/brush.hpp"
#include "core/exchange/open_input.hpp"
#include "core/pipeline/solve.hpp"

using namespace biotope;

namespace {

constexpr int dabs = 15;

LayerId layer_of(const MapsSnapshot& maps, int kind) {
  if (kind == 0) return {LayerKind::resource, "moisture"};
  const auto& level = maps.web->levels[kind == 1 ? 0 : 1];
  return {kind == 1 ? LayerKind::plant_density : LayerKind::animal_density, maps.web->species[std::size_t(level.front())].name};
}

void run(const char* name, int kind, const Document& document, SolveCache& cache, const MapsSnapshot& start) {
  const int side = document.terrain->height.width();
  const Grid<float> computed(side, document.terrain->height.height(), kind == 0 ? 4.0F : 0.2F);
  Document painted = document;
  std::vector<double> paint_ms;
  std::vector<double> solve_ms;
  std::shared_ptr<const MapsSnapshot> last;
  for (int i = 0; i < dabs; ++i) {
    const auto before = std::chrono::steady_clock::now();
    Stroke stroke(layer_of(start, kind), &computed);
    const Brush brush{.mode = BrushMode::set, .radius = 100, .strength = 1, .hardness = 0.5F, .value = kind == 0 ? 8.0F : kind == 1 ? 0.9F : 80.0F};
    stroke.dab(painted, brush, float(150 + (i * 211) % (side - 300)), float(150 + (i * 307) % (side - 300)));
    const auto dabbed = std::chrono::steady_clock::now();
    const auto maps = solve(painted, &cache);
    const auto solved = std::chrono::steady_clock::now();
    if (!maps) return;
    last = *maps;
    paint_ms.push_back(std::chrono::duration<double, std::milli>(dabbed - before).count());
    solve_ms.push_back(std::chrono::duration<double, std::milli>(solved - dabbed).count());
  }
  std::sort(paint_ms.begin(), paint_ms.end());
  std::sort(solve_ms.begin(), solve_ms.end());
  std::printf("%-16s dab %.1f ms (median), consistent after %.0f ms (median), %.0f ms (worst of %d)\n", name, paint_ms[dabs / 2],
              solve_ms[dabs / 2], solve_ms.back(), dabs);
  for (const auto& [stage, milliseconds] : last->timings) std::printf("    %-12s %9.1f ms\n", stage.c_str(), milliseconds);
}

}  // namespace

int main() {
  const auto opened = std::chrono::steady_clock::now();
  auto document = open_input("sample:valley");
  if (!document) {
    std::printf("%s\n", document.error().message.c_str());
    return 1;
  }
  SolveCache cache;
  const auto generated = std::chrono::steady_clock::now();
  const auto start = solve(*document, &cache);
  const auto solved = std::chrono::steady_clock::now();
  if (!start) {
    std::printf("%s\n", start.error().message.c_str());
    return 1;
  }
  std::printf("sample generated in %.2f s, first complete maps after %.2f s more\n",
              std::chrono::duration<double>(generated - opened).count(), std::chrono::duration<double>(solved - generated).count());
  for (const auto& [stage, milliseconds] : (*start)->timings) std::printf("    %-12s %9.1f ms\n", stage.c_str(), milliseconds);
  run("moisture", 0, *document, cache, **start);
  run("plant density", 1, *document, cache, **start);
  run("animal density", 2, *document, cache, **start);
  return 0;
}

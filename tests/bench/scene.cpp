// Nothing is lost, in numbers: a scene of 4096 x 4096 cells with 100 painted strokes, saved and opened; and 1,000 strokes in the
// history.
//   bench_scene [FOLDER]   where the scene is written (default: the folder for temporary files)

#include <sys/resource.h>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <filesystem>
#include <vector>

#include "core/base/random.hpp"
#include "core/document/brush.hpp"
#include "core/document/history.hpp"
#include "core/exchange/open_input.hpp"
#include "core/exchange/scene_file.hpp"

using namespace biotope;

namespace {

using Clock = std::chrono::steady_clock;

double seconds_since(Clock::time_point start) { return std::chrono::duration<double>(Clock::now() - start).count(); }

/// A stroke of 600 cells with a soft brush of 100 cells' radius over one of three maps.
std::unique_ptr<Command> paint_stroke(Document& document, const Grid<float>& computed, std::uint64_t number) {
  const std::array<LayerId, 3> layers{LayerId{LayerKind::resource, "moisture"}, LayerId{LayerKind::plant_density, "quercus"},
                                      LayerId{LayerKind::ground, "height"}};
  Brush brush;
  brush.mode = number % 4 == 3 ? BrushMode::smooth : BrushMode::add;
  brush.radius = 100;
  brush.strength = 0.3F;
  brush.value = float(1 + random_int(1, 8, {number, 1}));
  Stroke stroke(layers[number % 3], &computed);
  const auto at = [&](std::uint64_t axis) { return float(random_int(0, computed.width(), {number, 2, axis})); };
  const float x = at(0);
  const float y = at(1);
  stroke.move_to(document, brush, x, y);
  stroke.move_to(document, brush, x + 300, y + 200);
  stroke.move_to(document, brush, x + 500, y + 100);
  return stroke.finish(document);
}

void print_percentiles(const char* what, std::vector<double> milliseconds) {
  std::sort(milliseconds.begin(), milliseconds.end());
  const auto at = [&](double part) { return milliseconds[std::size_t(part * double(milliseconds.size() - 1))]; };
  std::printf("%-28s median %8.2f ms, 95 %% %8.2f ms, worst %8.2f ms (%zu)\n", what, at(0.5), at(0.95), at(1),
              milliseconds.size());
}

bool save(const char* what, const std::filesystem::path& file, const Document& document, SceneCache* cache) {
  const auto start = Clock::now();
  const Status saved = save_scene(file, document, cache);
  if (!saved) {
    std::printf("%s\n", saved.error().message.c_str());
    return false;
  }
  std::printf("%-28s %8.2f s, %.1f MB\n", what, seconds_since(start), double(std::filesystem::file_size(file)) / 1e6);
  return true;
}

bool measure_scene(const Document& start, const Grid<float>& computed, const std::filesystem::path& file) {
  Document document = start;
  for (std::uint64_t number = 0; number < 100; ++number) paint_stroke(document, computed, number);
  SceneCache cache;
  if (!save("save, 100 strokes", file, document, &cache)) return false;
  paint_stroke(document, computed, 100);
  if (!save("save again, 1 stroke more", file, document, &cache)) return false;
  const auto opening = Clock::now();
  const auto opened = load_scene(file);
  if (!opened) return false;
  std::printf("%-28s %8.2f s\n", "open", seconds_since(opening));
  for (const auto& [id, layer] : document.layers) {
    if (!(*opened->layers.at(id) == *layer)) std::printf("the layer %s came back otherwise\n", id.name.c_str());
  }
  return true;
}

void measure_history(const Document& start, const Grid<float>& computed) {
  constexpr std::uint64_t strokes = 1000;
  Document document = start;
  History history;
  std::vector<double> recording;
  std::size_t most = 0;
  for (std::uint64_t number = 0; number < strokes; ++number) {
    auto command = paint_stroke(document, computed, number);
    if (!command) continue;
    const auto begin = Clock::now();
    history.record(std::move(command));
    recording.push_back(1000 * seconds_since(begin));
    most = std::max(most, history.bytes());
  }
  print_percentiles("record a stroke", recording);
  history.settle();
  std::printf("%-28s %8.1f MB for %zu steps, %zu dropped; at most %.1f MB while painting\n", "history",
              double(history.bytes()) / 1e6, history.size(), history.dropped(), double(most) / 1e6);
  std::vector<double> undoing;
  while (history.can_undo()) {
    const auto begin = Clock::now();
    history.undo(document);
    undoing.push_back(1000 * seconds_since(begin));
  }
  print_percentiles("undo", undoing);
  std::printf("%-28s %s\n", "all undone", document.layers == start.layers ? "to what was opened" : "to something else");
}

}  // namespace

int main(int count, char** arguments) {
  const std::filesystem::path folder = count > 1 ? std::filesystem::path(arguments[1]) : std::filesystem::temp_directory_path();
  const auto document = open_input("sample:valley-1m");
  if (!document) {
    std::printf("%s\n", document.error().message.c_str());
    return 1;
  }
  const Grid<float> computed(document->terrain->height.width(), document->terrain->height.height(), 0.5F);
  const std::filesystem::path file = folder / "bench-scene.biotope";
  const bool measured = measure_scene(*document, computed, file);
  std::error_code ignored;
  std::filesystem::remove(file, ignored);
  if (!measured) return 1;
  measure_history(*document, computed);
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  std::printf("%-28s %8.0f MB\n", "peak memory", double(usage.ru_maxrss) / 1024);
  return 0;
}

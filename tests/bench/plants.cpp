// How long the plants around a camera take to be placed, and after an edit to be placed anew.
//   bench_plants [SAMPLE] [METRES]   the sample (valley) and how far around its middle plants are wanted (600)

#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <string>

#include "core/exchange/open_input.hpp"
#include "core/pipeline/solve.hpp"
#include "render/plant_blocks.hpp"

using namespace biotope;

namespace {

using Clock = std::chrono::steady_clock;

double milliseconds_since(Clock::time_point begin) {
  return std::chrono::duration<double, std::milli>(Clock::now() - begin).count();
}

/// All blocks around a place, on one thread as the frames of a window build them.
double build(PlantBlocks& blocks, double x, double y, float reach) {
  const auto begin = Clock::now();
  const auto never = begin + std::chrono::hours(1);
  (void)blocks.build(Stratum::tree, x, y, reach, never);
  (void)blocks.build(Stratum::shrub, x, y, reach, never);
  (void)blocks.build(Stratum::herb, x, y, 60, never);
  return milliseconds_since(begin);
}

std::size_t plants(const PlantBlocks& blocks) {
  std::size_t sum = 0;
  for (const Stratum stratum : {Stratum::tree, Stratum::shrub, Stratum::herb}) {
    for (const auto& [place, block] : blocks.blocks(stratum)) sum += block.plants.size();
  }
  return sum;
}

}  // namespace

int main(int count, char** arguments) {
  const std::string sample = count > 1 ? arguments[1] : "valley";
  const float reach = count > 2 ? float(std::atof(arguments[2])) : 600;
  const auto document = open_input("sample:" + sample, {}, TaskContext{});
  const auto solved = document ? solve(*document, nullptr, TaskContext{}) : tl::unexpected(document.error());
  if (!solved) {
    std::printf("%s\n", solved.error().message.c_str());
    return 1;
  }
  const auto before = *solved;
  const double x = 0.5 * before->terrain().width_metres();
  const double y = 0.5 * before->terrain().height_metres();
  PlantBlocks blocks;
  blocks.set_snapshot(before);
  const double first = build(blocks, x, y, reach);
  std::printf("%s: %zu plants within %.0f m (herbs 60 m), %.1f MB, placed in %.1f ms\n", sample.c_str(), plants(blocks),
              double(reach), double(blocks.bytes()) / 1e6, first);

  // A dab of 100 m of another cover for the first plant, where the camera is.
  const auto after = std::make_shared<MapsSnapshot>(*before);
  CoverMap map = *before->cover.front();
  const int radius = int(100 / before->terrain().cell_size);
  for (int dy = -radius; dy <= radius; ++dy) {
    for (int dx = -radius; dx <= radius; ++dx) {
      const int cx = map.width() / 2 + dx;
      const int cy = map.height() / 2 + dy;
      if (dx * dx + dy * dy <= radius * radius && map.rect().contains(cx, cy)) map.set(cx, cy, to_cover(0.5F));
    }
  }
  after->cover.front() = std::make_shared<const CoverMap>(std::move(map));
  const auto begin = Clock::now();
  blocks.set_snapshot(after);
  const double marked = milliseconds_since(begin);
  std::printf("edit of 100 m: marked in %.1f ms, placed anew in %.1f ms\n", marked, build(blocks, x, y, reach));
  return 0;
}

#include "core/exchange/resample.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include "core/base/parallel.hpp"
#include "core/exchange/dem_import.hpp"

namespace biotope {
namespace {

/// Source cells that a larger cell covers along one axis and the share of each.
struct Footprint {
  int first = 0;
  std::vector<double> weight;
};

std::vector<Footprint> footprints(double ratio, int count, int source_count) {
  std::vector<Footprint> result;
  result.reserve(std::size_t(count));
  for (int i = 0; i < count; ++i) {
    const double from = std::min(i * ratio, source_count - 1.0);
    const double to = std::max(from + 1e-9, std::min((i + 1) * ratio, double(source_count)));
    Footprint footprint;
    footprint.first = int(from);
    for (int cell = footprint.first; cell < to; ++cell) {
      const double covered = std::min(to, cell + 1.0) - std::max(from, double(cell));
      footprint.weight.push_back(covered / (to - from));
    }
    result.push_back(std::move(footprint));
  }
  return result;
}

Grid<float> area_means(const Grid<float>& source, double ratio, int width, int height) {
  const auto columns = footprints(ratio, width, source.width());
  const auto rows = footprints(ratio, height, source.height());
  Grid<float> result(width, height);
  parallel_rows(0, height, [&](int y) {
    std::vector<double> sum(std::size_t(width), 0.0);
    const Footprint& row = rows[std::size_t(y)];
    for (std::size_t r = 0; r < row.weight.size(); ++r) {
      const auto cells = source.row(row.first + int(r));
      for (int x = 0; x < width; ++x) {
        const Footprint& column = columns[std::size_t(x)];
        double mean = 0;
        for (std::size_t c = 0; c < column.weight.size(); ++c) {
          mean += column.weight[c] * double(cells[std::size_t(column.first) + c]);
        }
        sum[std::size_t(x)] += row.weight[r] * mean;
      }
    }
    for (int x = 0; x < width; ++x) result(x, y) = float(sum[std::size_t(x)]);
  });
  return result;
}

Grid<float> interpolated(const Grid<float>& source, double ratio, int width, int height) {
  Grid<float> result(width, height);
  parallel_rows(0, height, [&](int y) {
    for (int x = 0; x < width; ++x) {
      result(x, y) = sample_bilinear(source, (x + 0.5) * ratio - 0.5, (y + 0.5) * ratio - 0.5);
    }
  });
  return result;
}

}  // namespace

Grid<float> resampled_grid(const Grid<float>& source, double ratio, int width, int height) {
  if (ratio > 1) return area_means(source, ratio, width, height);
  return interpolated(source, ratio, width, height);
}

Terrain resampled(const Terrain& terrain, int longer_side) {
  const int source_longer = std::max(terrain.height.width(), terrain.height.height());
  assert(longer_side >= 2 && source_longer >= 2);
  if (longer_side == source_longer) return terrain;
  const double ratio = double(source_longer) / longer_side;
  const int width = std::max(2, int(std::lround(terrain.height.width() / ratio)));
  const int height = std::max(2, int(std::lround(terrain.height.height() / ratio)));

  Terrain result;
  result.height = resampled_grid(terrain.height, ratio, width, height);
  if (!terrain.voids.empty()) {
    Grid<float> share(terrain.voids.width(), terrain.voids.height());
    std::copy(terrain.voids.cells().begin(), terrain.voids.cells().end(), share.cells().begin());
    share = resampled_grid(share, ratio, width, height);
    result.voids = Grid<std::uint8_t>(width, height);
    std::transform(share.cells().begin(), share.cells().end(), result.voids.cells().begin(),
                   [](float part) { return std::uint8_t(part >= 0.5F); });
  }
  result.cell_size = terrain.cell_size * ratio;
  result.latitude = terrain.latitude;
  result.georeference = terrain.georeference;
  for (const std::size_t term : {1U, 2U, 4U, 5U}) result.georeference.transform[term] *= ratio;
  result.name = terrain.name;
  return result;
}

}  // namespace biotope

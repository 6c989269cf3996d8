#include "core/exchange/void_fill.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "core/base/parallel.hpp"

namespace biotope {
namespace {

/// Relaxations at each level of the pyramid; enough to hide the edges of coarse cells (our choice).
constexpr int relaxations = 12;

struct PyramidLevel {
  Grid<float> height;
  Grid<std::uint8_t> missing;
};

PyramidLevel coarser(const Grid<float>& height, const Grid<std::uint8_t>& missing) {
  const int width = (height.width() + 1) / 2;
  const int rows = (height.height() + 1) / 2;
  PyramidLevel result{Grid<float>(width, rows), Grid<std::uint8_t>(width, rows)};
  parallel_rows(0, rows, [&](int y) {
    for (int x = 0; x < width; ++x) {
      double sum = 0;
      int known = 0;
      for (int cy = 2 * y; cy < std::min(2 * y + 2, height.height()); ++cy) {
        for (int cx = 2 * x; cx < std::min(2 * x + 2, height.width()); ++cx) {
          if (missing(cx, cy)) continue;
          sum += double(height(cx, cy));
          ++known;
        }
      }
      result.missing(x, y) = known == 0;
      result.height(x, y) = known == 0 ? 0.0F : float(sum / known);
    }
  });
  return result;
}

/// Missing cells by the colour of a checkerboard, so that relaxing one colour reads only the other.
std::array<std::vector<std::size_t>, 2> checkerboard(const Grid<std::uint8_t>& missing) {
  std::array<std::vector<std::size_t>, 2> cells;
  for (int y = 0; y < missing.height(); ++y) {
    for (int x = 0; x < missing.width(); ++x) {
      if (missing(x, y)) cells[std::size_t((x + y) % 2)].push_back(missing.index(x, y));
    }
  }
  return cells;
}

void relax(Grid<float>& height, const std::vector<std::size_t>& cells) {
  constexpr std::size_t block = 16384;
  parallel_each((cells.size() + block - 1) / block, [&](std::size_t i) {
    for (std::size_t c = i * block; c < std::min(cells.size(), (i + 1) * block); ++c) {
      const int x = int(cells[c] % std::size_t(height.width()));
      const int y = int(cells[c] / std::size_t(height.width()));
      height[cells[c]] = 0.25F * (height.clamped(x - 1, y) + height.clamped(x + 1, y) +
                                  height.clamped(x, y - 1) + height.clamped(x, y + 1));
    }
  });
}

void fill_level(Grid<float>& height, const Grid<std::uint8_t>& missing) {
  const auto cells = checkerboard(missing);
  if (cells[0].empty() && cells[1].empty()) return;
  PyramidLevel coarse = coarser(height, missing);
  fill_level(coarse.height, coarse.missing);
  for (const auto& colour : cells) {
    for (const std::size_t cell : colour) {
      const int x = int(cell % std::size_t(height.width()));
      const int y = int(cell / std::size_t(height.width()));
      height[cell] = sample_bilinear(coarse.height, x / 2.0 - 0.25, y / 2.0 - 0.25);
    }
  }
  for (int i = 0; i < relaxations; ++i) {
    relax(height, cells[0]);
    relax(height, cells[1]);
  }
}

}  // namespace

Grid<std::uint8_t> missing_cells(const Grid<float>& height) {
  Grid<std::uint8_t> missing(height.width(), height.height());
  parallel_rows(0, height.height(), [&](int y) {
    for (int x = 0; x < height.width(); ++x) missing(x, y) = std::isnan(height(x, y));
  });
  return missing;
}

void fill_missing(Grid<float>& height, const Grid<std::uint8_t>& missing) {
  assert(std::any_of(missing.cells().begin(), missing.cells().end(), [](auto cell) { return cell == 0; }));
  fill_level(height, missing);
}

}  // namespace biotope

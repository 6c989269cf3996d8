#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "core/base/parallel.hpp"
#include "core/terrain/sun.hpp"
#include "core/terrain/sunlight.hpp"

namespace biotope {
namespace {

/// Longest side of the horizon grid unless the caller asks for another stride. Our choice: far horizons change slowly.
constexpr int longest_horizon_side = 512;

int chosen_stride(const Grid<float>& height) {
  int stride = 1;
  while (std::max(height.width(), height.height()) > longest_horizon_side * stride) stride *= 2;
  return stride;
}

/// Mean height of one stride x stride block, cut at the border.
float block_mean(const Grid<float>& height, int stride, int cx, int cy) {
  const int x1 = std::min((cx + 1) * stride, height.width());
  const int y1 = std::min((cy + 1) * stride, height.height());
  double sum = 0;
  for (int y = cy * stride; y < y1; ++y) {
    const auto row = height.row(y);
    for (int x = cx * stride; x < x1; ++x) sum += double(row[std::size_t(x)]);
  }
  return float(sum / ((x1 - cx * stride) * (y1 - cy * stride)));
}

/// Mean heights of stride x stride blocks.
Grid<float> coarse_heights(const Grid<float>& height, int stride) {
  if (stride == 1) return height;
  Grid<float> coarse((height.width() + stride - 1) / stride, (height.height() + stride - 1) / stride);
  parallel_rows(0, coarse.height(), [&](int cy) {
    for (int cx = 0; cx < coarse.width(); ++cx) coarse(cx, cy) = block_mean(height, stride, cx, cy);
  });
  return coarse;
}

/// A family of parallel lines that visits every cell once: step along the major axis, drift along the minor one.
struct LineFamily {
  bool along_x = true;    ///< major axis
  bool ascending = true;  ///< whether the sector's direction is toward greater major coordinates
  double drift = 0;       ///< minor cells per major cell
};

LineFamily line_family(double azimuth) {
  const double east = std::sin(azimuth);
  const double south = -std::cos(azimuth);
  if (std::abs(east) >= std::abs(south)) return {true, east > 0, south / east};
  return {false, south > 0, east / south};
}

struct HullPoint {
  float distance;
  float height;
};

/// The lines of one sector over a grid, ready to be scanned one by one.
class SectorScan {
 public:
  SectorScan(const Grid<float>& height, double azimuth, float cell)
      : height_(height),
        family_(line_family(azimuth)),
        major_(family_.along_x ? height.width() : height.height()),
        minor_(family_.along_x ? height.height() : height.width()),
        shift_(std::size_t(major_), 0),
        aside_(std::size_t(major_), 0),
        step_(cell * float(std::sqrt(1 + family_.drift * family_.drift))) {
    for (int m = 0; m < major_; ++m) {
      shift_[std::size_t(m)] = int(std::floor(m * family_.drift + 0.5));
      aside_[std::size_t(m)] = float(m * family_.drift - shift_[std::size_t(m)]);
    }
    first_ = -std::max(0, shift_.back());
    end_ = minor_ - std::min(0, shift_.back());
  }

  [[nodiscard]] int first_line() const { return first_; }
  [[nodiscard]] int end_line() const { return end_; }
  /// Number of the line through a cell; the lines beside it read the cell too.
  [[nodiscard]] int line_of(int x, int y) const {
    return family_.along_x ? y - shift_[std::size_t(x)] : x - shift_[std::size_t(y)];
  }

  /// Scans a line from its far end, keeping the upper convex hull of what lies ahead; calls
  /// changed(x, y, before) where the tangent is another.
  template <class Changed>
  void scan(int line, std::vector<HullPoint>& hull, Grid<float>& tangents, const Changed& changed) const {
    hull.resize(std::size_t(major_) + 1);
    std::size_t top = 0;
    for (int k = 0; k < major_; ++k) {
      const int m = family_.ascending ? major_ - 1 - k : k;
      const int n = line + shift_[std::size_t(m)];
      if (n < 0 || n >= minor_) continue;
      const std::size_t cell = family_.along_x ? height_.index(m, n) : height_.index(n, m);
      // A line passes beside the cells' centres: its height there is between those of two cells, or a step aside would pass for a
      // slope.
      const float beyond = aside_[std::size_t(m)];
      const int beside = std::clamp(n + (beyond < 0 ? -1 : 1), 0, minor_ - 1);
      const float other = family_.along_x ? height_(m, beside) : height_(beside, m);
      const HullPoint here{float(k) * step_, height_[cell] + std::abs(beyond) * (other - height_[cell])};
      float tangent = 0;
      if (top > 0) {
        tangent = (hull[top - 1].height - here.height) / (here.distance - hull[top - 1].distance);
        while (top > 1) {
          const float next = (hull[top - 2].height - here.height) / (here.distance - hull[top - 2].distance);
          if (next < tangent) break;
          tangent = next;
          --top;
        }
      }
      tangent = std::max(tangent, 0.0F);
      if (tangents[cell] != tangent) {
        changed(family_.along_x ? m : n, family_.along_x ? n : m, std::exchange(tangents[cell], tangent));
      }
      hull[top++] = here;
    }
  }

 private:
  const Grid<float>& height_;
  LineFamily family_;
  int major_;
  int minor_;
  std::vector<int> shift_;
  std::vector<float> aside_;
  float step_;
  int first_ = 0;
  int end_ = 0;
};

double azimuth_of(std::size_t sector, std::size_t sectors) { return 2 * std::numbers::pi * double(sector) / double(sectors); }

/// A cell of the horizon grid.
struct CoarseCell {
  int x;
  int y;
};

/// Puts the means of blocks in changed tiles in place; returns those that are others than before.
std::vector<CoarseCell> follow_heights(const Grid<float>& height, int stride, const TileSet& changed, Grid<float>& coarse) {
  std::vector<CoarseCell> cells;
  for (const std::size_t tile : changed.list()) {
    const Rect rect = changed.rect(tile);
    for (int cy = rect.y0 / stride; cy <= (rect.y1 - 1) / stride; ++cy) {
      for (int cx = rect.x0 / stride; cx <= (rect.x1 - 1) / stride; ++cx) {
        const float mean = stride == 1 ? height(cx, cy) : block_mean(height, stride, cx, cy);
        if (coarse(cx, cy) == mean) continue;
        coarse(cx, cy) = mean;
        cells.push_back({cx, cy});
      }
    }
  }
  return cells;
}

}  // namespace

HorizonField::HorizonField(const Terrain& terrain, int sectors, int stride) {
  horizons_.stride = stride > 0 ? stride : chosen_stride(terrain.height);
  coarse_ = coarse_heights(terrain.height, horizons_.stride);
  horizons_.sectors.assign(std::size_t(sectors), Grid<float>(coarse_.width(), coarse_.height()));
  const float cell = float(terrain.cell_size * horizons_.stride);
  parallel_each(horizons_.sectors.size(), [&](std::size_t sector) {
    const SectorScan scan(coarse_, azimuth_of(sector, horizons_.sectors.size()), cell);
    std::vector<HullPoint> hull;
    for (int line = scan.first_line(); line < scan.end_line(); ++line) {
      scan.scan(line, hull, horizons_.sectors[sector], [](int, int, float) {});
    }
  });
}

void HorizonField::update(const Terrain& terrain, const TileSet& changed, MovedHorizons& moved) {
  const int stride = horizons_.stride;
  const std::vector<CoarseCell> cells = follow_heights(terrain.height, stride, changed, coarse_);
  if (cells.empty()) return;
  const float cell = float(terrain.cell_size * stride);
  parallel_each(horizons_.sectors.size(), [&](std::size_t sector) {
    const SectorScan scan(coarse_, azimuth_of(sector, horizons_.sectors.size()), cell);
    std::vector<char> asked(std::size_t(scan.end_line() - scan.first_line()) + 2, 0);
    for (const CoarseCell& at : cells) {
      const auto line = std::size_t(scan.line_of(at.x, at.y) - scan.first_line()) + 1;
      for (std::size_t beside = line - 1; beside <= line + 1; ++beside) asked[beside] = 1;
    }
    std::vector<HullPoint> hull;
    // Terrain cells between the centres of a horizon cell and its neighbours are the ones that read it.
    const auto changed_at = [&](int x, int y, float before) {
      moved.note(sector, {(x - 1) * stride, (y - 1) * stride, (x + 2) * stride, (y + 2) * stride}, before);
    };
    for (int line = scan.first_line(); line < scan.end_line(); ++line) {
      if (asked[std::size_t(line - scan.first_line()) + 1] != 0) scan.scan(line, hull, horizons_.sectors[sector], changed_at);
    }
  });
}

Horizons compute_horizons(const Terrain& terrain, int sectors, int stride) {
  return HorizonField(terrain, sectors, stride).horizons();
}

}  // namespace biotope

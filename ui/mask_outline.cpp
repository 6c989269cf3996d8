#include "ui/mask_outline.hpp"

#include <algorithm>
#include <cmath>

namespace biotope {
namespace {

constexpr int film_levels = 4;

/// `cells` cut into blocks of `step`, with a test of each block's middle.
class Blocks {
 public:
  Blocks(const SelectionMask& mask, const Rect& cells, int step)
      : x0_(cells.x0 / step),
        y0_(cells.y0 / step),
        columns_((cells.x1 + step - 1) / step - x0_),
        rows_((cells.y1 + step - 1) / step - y0_),
        map_columns_((mask.width() + step - 1) / step),
        map_rows_((mask.height() + step - 1) / step) {
    inside_.resize(std::size_t(columns_) * std::size_t(rows_));
    for (int row = 0; row < rows_; ++row) {
      const int y = std::min((y0_ + row) * step + step / 2, mask.height() - 1);
      for (int column = 0; column < columns_; ++column) {
        const int x = std::min((x0_ + column) * step + step / 2, mask.width() - 1);
        inside_[index(column, row)] = mask(x, y) >= 128;
      }
    }
  }
  /// Beside the map nothing is selected; beside the view it goes on as at its edge, so that the view's edge is no outline.
  [[nodiscard]] bool inside(int column, int row) const {
    const int x = x0_ + column;
    const int y = y0_ + row;
    if (x < 0 || y < 0 || x >= map_columns_ || y >= map_rows_) return false;
    return inside_[index(std::clamp(column, 0, columns_ - 1), std::clamp(row, 0, rows_ - 1))];
  }
  [[nodiscard]] int columns() const { return columns_; }
  [[nodiscard]] int rows() const { return rows_; }
  [[nodiscard]] int x0() const { return x0_; }
  [[nodiscard]] int y0() const { return y0_; }

 private:
  [[nodiscard]] std::size_t index(int column, int row) const {
    return std::size_t(row) * std::size_t(columns_) + std::size_t(column);
  }
  int x0_, y0_, columns_, rows_, map_columns_, map_rows_;
  std::vector<char> inside_;
};

/// Calls `piece(begin, end)` for every run of places 0 .. count - 1 where `crosses` holds.
template <class Crosses, class Piece>
void for_runs(int count, const Crosses& crosses, const Piece& piece) {
  int begin = -1;
  for (int at = 0; at <= count; ++at) {
    const bool here = at < count && crosses(at);
    if (here && begin < 0) begin = at;
    if (!here && begin >= 0) {
      piece(begin, at);
      begin = -1;
    }
  }
}

/// Runs of blocks of the same level of `share(x, y)`, which is 0..1; blocks of level 0 are left out.
template <class Share>
std::vector<FilmRun> runs_over(const Rect& cells, int step, const Share& share) {
  std::vector<FilmRun> runs;
  for (int y = cells.y0; y < cells.y1; y += step) {
    const int middle_y = std::min(y + step / 2, cells.y1 - 1);
    FilmRun run{{cells.x0, y, cells.x0, std::min(y + step, cells.y1)}, 0};
    for (int x = cells.x0; x < cells.x1; x += step) {
      const int middle_x = std::min(x + step / 2, cells.x1 - 1);
      const int level = std::clamp(int(std::lround(share(middle_x, middle_y) * film_levels)), 0, film_levels);
      if (level != run.level) {
        if (run.level > 0) runs.push_back(run);
        run.cells.x0 = x;
        run.level = level;
      }
      run.cells.x1 = std::min(x + step, cells.x1);
    }
    if (run.level > 0) runs.push_back(run);
  }
  return runs;
}

}  // namespace

std::vector<OutlinePiece> outline_of(const SelectionMask& mask, const Rect& cells, int step) {
  std::vector<OutlinePiece> pieces;
  if (cells.empty()) return pieces;
  const Blocks blocks(mask, cells, step);
  const auto across = [&](int column) { return float((blocks.x0() + column) * step) - 0.5F; };
  const auto down = [&](int row) { return float((blocks.y0() + row) * step) - 0.5F; };
  for (int row = 0; row <= blocks.rows(); ++row) {
    for_runs(
        blocks.columns(), [&](int column) { return blocks.inside(column, row - 1) != blocks.inside(column, row); },
        [&](int begin, int end) {
          pieces.push_back({across(begin), down(row), across(end), down(row)});
        });
  }
  for (int column = 0; column <= blocks.columns(); ++column) {
    for_runs(
        blocks.rows(), [&](int row) { return blocks.inside(column - 1, row) != blocks.inside(column, row); },
        [&](int begin, int end) {
          pieces.push_back({across(column), down(begin), across(column), down(end)});
        });
  }
  return pieces;
}

std::vector<FilmRun> film_of(const BrushFilter& filter, const FilterMaps& maps, const SelectionMask* mask, const Rect& cells,
                             int step) {
  const SelectionMask* const used = filter.use_selection ? mask : nullptr;
  return runs_over(cells, step, [&](int x, int y) { return 1 - filter_weight(filter, maps, x, y) * selected(used, x, y); });
}

std::vector<FilmRun> runs_of(const SelectionMask& mask, const Rect& cells, int step) {
  return runs_over(cells, step, [&](int x, int y) { return selected(&mask, x, y); });
}

Rect visible_cells(const MapView& view, PixelPoint canvas, const Rect& map) {
  const PathPoint low = cell_at(view, canvas, {0, 0});
  const PathPoint high = cell_at(view, canvas, canvas);
  return intersection(map,
                      {int(std::floor(low.x)), int(std::floor(low.y)), int(std::ceil(high.x)) + 1, int(std::ceil(high.y)) + 1});
}

int block_cells(const MapView& view, double pixels) { return std::max(1, int(std::ceil(pixels / view.pixels_per_cell))); }

}  // namespace biotope

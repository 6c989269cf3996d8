#include "core/document/brush_surroundings.hpp"

#include <algorithm>

namespace biotope {
namespace {

/// Final values of a rectangle that may reach beyond the map.
Grid<float> final_values(const PaintLayer* layer, const Grid<float>& computed, Rect area) {
  Grid<float> values(area.width(), area.height());
  const Rect inside = intersection(area, computed.rect());
  std::vector<Paint> paint(std::size_t(inside.width()));
  for (int y = inside.y0; y < inside.y1; ++y) {
    const auto below = computed.row(y);
    const auto row = values.row(y - area.y0);
    if (layer != nullptr) layer->read_row(y, inside.x0, paint);
    for (int x = inside.x0; x < inside.x1; ++x) {
      row[std::size_t(x - area.x0)] = painted(below[std::size_t(x)], paint[std::size_t(x - inside.x0)]);
    }
    std::fill(row.begin(), row.begin() + (inside.x0 - area.x0), row[std::size_t(inside.x0 - area.x0)]);
    std::fill(row.end() - (area.x1 - inside.x1), row.end(), row[std::size_t(inside.x1 - 1 - area.x0)]);
  }
  for (int y = area.y0; y < inside.y0; ++y)
    std::copy_n(values.row(inside.y0 - area.y0).data(), area.width(), values.row(y - area.y0).data());
  for (int y = inside.y1; y < area.y1; ++y)
    std::copy_n(values.row(inside.y1 - 1 - area.y0).data(), area.width(), values.row(y - area.y0).data());
  return values;
}

/// Means of the squares of `side` cells, by running sums along rows, then along columns.
std::vector<float> box_means(const Grid<float>& values, int side) {
  const auto width = std::size_t(values.width() - side + 1);
  const int height = values.height() - side + 1;
  // Sums count from one value of the map, so that flat parts add up exactly.
  const float origin = values[0];
  Grid<double> row_sums(int(width), values.height());
  for (int y = 0; y < values.height(); ++y) {
    const auto row = values.row(y);
    double sum = 0;
    for (int x = 0; x < side; ++x) sum += double(row[std::size_t(x)] - origin);
    for (std::size_t x = 0; x < width; ++x) {
      if (x > 0) sum += double(row[x + std::size_t(side) - 1] - origin) - double(row[x - 1] - origin);
      row_sums(int(x), y) = sum;
    }
  }
  std::vector<float> means(width * std::size_t(height));
  std::vector<double> sums(width, 0.0);
  const double count = double(side) * double(side);
  for (int y = 0; y < values.height(); ++y) {
    const int top = y - side;
    for (std::size_t x = 0; x < width; ++x) sums[x] += row_sums(int(x), y) - (top >= 0 ? row_sums(int(x), top) : 0.0);
    if (top + 1 < 0) continue;
    float* out = means.data() + std::size_t(top + 1) * width;
    for (std::size_t x = 0; x < width; ++x) out[x] = origin + float(sums[x] / count);
  }
  return means;
}

/// The chosen one (`pick`: the lesser or the greater of two) of each square of `side` cells: windows double until they are as
/// long as the greatest power of two inside `side`; two of those cover it.
template <class Pick>
std::vector<float> box_extremes(Grid<float> values, int side, const Pick& pick) {
  const int width = values.width() - side + 1;
  const int height = values.height() - side + 1;
  int length = 1;
  for (; 2 * length <= side; length *= 2) {
    for (int y = 0; y < values.height(); ++y) {
      const auto row = values.row(y);
      for (std::size_t x = 0; x + std::size_t(length) < row.size(); ++x) row[x] = pick(row[x], row[x + std::size_t(length)]);
    }
    for (int y = 0; y + length < values.height(); ++y) {
      const auto row = values.row(y);
      const auto later = values.row(y + length);
      for (std::size_t x = 0; x < row.size(); ++x) row[x] = pick(row[x], later[x]);
    }
  }
  const int rest = side - length;
  std::vector<float> chosen(std::size_t(width) * std::size_t(height));
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      const float north = pick(values(x, y), values(x + rest, y));
      const float south = pick(values(x, y + rest), values(x + rest, y + rest));
      chosen[std::size_t(y) * std::size_t(width) + std::size_t(x)] = pick(north, south);
    }
  }
  return chosen;
}

}  // namespace

Surroundings surroundings(const PaintLayer* layer, const Grid<float>& computed, Rect cells, int reach, bool extremes) {
  const Grid<float> values = final_values(layer, computed, grown(cells, reach));
  const int side = 2 * reach + 1;
  Surroundings around{box_means(values, side), {}, {}};
  if (extremes) {
    around.least = box_extremes(values, side, [](float a, float b) { return b < a ? b : a; });
    around.greatest = box_extremes(values, side, [](float a, float b) { return b > a ? b : a; });
  }
  return around;
}

}  // namespace biotope

#include <cmath>

#include "core/document/selection_rows.hpp"

namespace biotope {
namespace {

/// Lines that each row of cells is cut into: cover goes in steps of a sixteenth upwards, and is exact sideways (our choice).
constexpr int lines_per_row = 16;

struct Edge {
  PathPoint from;
  PathPoint to;
  [[nodiscard]] bool crosses(double y) const { return (double(from.y) <= y) != (double(to.y) <= y); }
  [[nodiscard]] double crossing(double y) const {
    return double(from.x) + (y - double(from.y)) * (double(to.x) - double(from.x)) / (double(to.y) - double(from.y));
  }
};

std::vector<Edge> closed_edges(std::span<const PathPoint> line) {
  std::vector<PathPoint> points;
  for (const PathPoint point : line) {
    if (std::isfinite(point.x) && std::isfinite(point.y)) points.push_back(point);
  }
  std::vector<Edge> edges;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const Edge edge{points[i], points[(i + 1) % points.size()]};
    if (edge.from.y != edge.to.y) edges.push_back(edge);
  }
  return edges;
}

/// Adds the part of every cell that lies in [from, to) to a row of covers.
void cover_span(std::span<float> covers, double from, double to) {
  // Cell x reaches from x - 0.5 to x + 0.5.
  const double left = std::clamp(from + 0.5, 0.0, double(covers.size()));
  const double right = std::clamp(to + 0.5, 0.0, double(covers.size()));
  if (!(right > left)) return;
  const auto first = std::size_t(left);
  const auto last = std::min(std::size_t(right), covers.size() - 1);
  if (first == last) {
    covers[first] += float(right - left);
    return;
  }
  covers[first] += float(double(first) + 1 - left);
  for (std::size_t x = first + 1; x < last; ++x) covers[x] += 1;
  covers[last] += float(right - double(last));
}

void cover_row(const std::vector<Edge>& edges, int y, std::span<std::uint8_t> row) {
  std::vector<Edge> near;
  for (const Edge& edge : edges) {
    if (std::min(edge.from.y, edge.to.y) <= float(y) + 0.5F && std::max(edge.from.y, edge.to.y) >= float(y) - 0.5F)
      near.push_back(edge);
  }
  if (near.empty()) return;
  std::vector<float> covers(row.size());
  std::vector<double> crossings;
  for (int line = 0; line < lines_per_row; ++line) {
    const double at = double(y) - 0.5 + (line + 0.5) / lines_per_row;
    crossings.clear();
    for (const Edge& edge : near) {
      if (edge.crosses(at)) crossings.push_back(edge.crossing(at));
    }
    std::sort(crossings.begin(), crossings.end());
    for (std::size_t i = 0; i + 1 < crossings.size(); i += 2) cover_span(covers, crossings[i], crossings[i + 1]);
  }
  for (std::size_t x = 0; x < row.size(); ++x) row[x] = selection_step(covers[x] / lines_per_row);
}

}  // namespace

SelectionMask lasso_selection(int width, int height, std::span<const PathPoint> line) {
  const std::vector<Edge> edges = closed_edges(line);
  return selection_of_rows(width, height, [&](int y, std::span<std::uint8_t> row) { cover_row(edges, y, row); });
}

}  // namespace biotope

#include "ui/trail_figures.hpp"

#include <algorithm>
#include <cmath>

namespace biotope {
namespace {

float weight_at(const TrailRoute& route, std::size_t point) {
  return point < route.weight.size() ? route.weight[point] : 0;
}

void add_lengths(const TrailRoute& route, double cell_size, TrailFigures& figures) {
  for (std::size_t i = 1; i < route.points.size(); ++i) {
    const PathPoint& a = route.points[i - 1];
    const PathPoint& b = route.points[i];
    const double metres = std::hypot(double(b.x - a.x), double(b.y - a.y)) * cell_size;
    const float use = (weight_at(route, i - 1) + weight_at(route, i)) / 2;
    double& sum = use > 0.1F * figures.busiest    ? figures.heavy_length
                  : use > 0.01F * figures.busiest ? figures.middle_length
                                                  : figures.light_length;
    sum += metres;
  }
}

}  // namespace

TrailFigures trail_figures(const TrailNetwork& trails, double cell_size, std::size_t count) {
  TrailFigures figures;
  for (std::size_t i = 0; i < trails.routes.size(); ++i) {
    const TrailRoute& route = trails.routes[i];
    if (route.points.empty()) continue;
    float greatest = 0;
    for (const float weight : route.weight) greatest = std::max(greatest, weight);
    figures.busiest = std::max(figures.busiest, greatest);
    figures.most_used.push_back({i, greatest, route.length, route.points[route.points.size() / 2]});
  }
  for (const TrailRoute& route : trails.routes) add_lengths(route, cell_size, figures);
  std::stable_sort(figures.most_used.begin(), figures.most_used.end(),
                   [](const TrailFigures::Route& a, const TrailFigures::Route& b) { return a.greatest > b.greatest; });
  if (figures.most_used.size() > count) figures.most_used.resize(count);
  return figures;
}

}  // namespace biotope

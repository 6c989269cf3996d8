#include "ui/placing.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace biotope {
namespace {

float distance(PathPoint a, PathPoint b) { return std::hypot(a.x - b.x, a.y - b.y); }

/// Distance from a point to a piece of a line.
float distance_to_piece(PathPoint at, PathPoint a, PathPoint b) {
  const float dx = b.x - a.x;
  const float dy = b.y - a.y;
  const float square = dx * dx + dy * dy;
  const float t = square > 0 ? std::clamp(((at.x - a.x) * dx + (at.y - a.y) * dy) / square, 0.0F, 1.0F) : 0;
  return distance(at, {a.x + t * dx, a.y + t * dy});
}

/// The line of a thing, or null when it has but one point.
template <class Things>
auto* line_of(Things& things, const PlacedItem& item) {
  auto& placements = things.placements;
  switch (item.kind) {
    case PlacedKind::river:
      return &placements.water.rivers[item.index].course;
    case PlacedKind::lake:
      return &placements.water.lakes[item.index].shore;
    case PlacedKind::pinned_trail:
      return &placements.places.pinned_trails[item.index].points;
    case PlacedKind::forbidden_trail:
      return &placements.places.forbidden_trails[item.index].points;
    default:
      return decltype(&placements.water.rivers[0].course)(nullptr);
  }
}

/// Number of line pieces; a lake's shore is closed.
std::size_t pieces(PlacedKind kind, std::size_t points) {
  return points < 2 ? 0 : kind == PlacedKind::lake ? points : points - 1;
}

PathPoint on_map(PathPoint at, const Terrain& terrain) {
  return {std::clamp(at.x, 0.0F, float(terrain.height.width() - 1)), std::clamp(at.y, 0.0F, float(terrain.height.height() - 1))};
}

double line_length(const std::vector<PathPoint>& points) {
  double sum = 0;
  for (std::size_t i = 1; i < points.size(); ++i) sum += double(distance(points[i - 1], points[i]));
  return sum;
}

/// Goes on from the end of a line along the route that passes there and turns least; false when none does. `before` stands in for
/// the last but one point of a line of one point: the way is not turned back on.
bool follow_on(const TrailNetwork& trails, std::vector<char>& used, PathPoint before, std::vector<PathPoint>& line) {
  constexpr float touching = 2.5F;  // cells
  const PathPoint end = line.back();
  const PathPoint from = line.size() > 1 ? line[line.size() > 4 ? line.size() - 5 : 0] : before;
  const PathPoint heading{end.x - from.x, end.y - from.y};
  float best = -0.2F;  // cosine: sharper turns are other ways
  std::size_t best_route = trails.routes.size();
  std::size_t best_point = 0;
  int best_step = 0;
  for (std::size_t r = 0; r < trails.routes.size(); ++r) {
    const auto& points = trails.routes[r].points;
    if (used[r] != 0) continue;
    for (std::size_t i = 0; i < points.size(); ++i) {
      if (distance(points[i], end) > touching) continue;
      for (const int step : {-1, 1}) {
        const std::ptrdiff_t ahead = std::ptrdiff_t(i) + 4 * step;
        const auto next = points[std::size_t(std::clamp<std::ptrdiff_t>(ahead, 0, std::ptrdiff_t(points.size()) - 1))];
        const PathPoint way{next.x - end.x, next.y - end.y};
        const float lengths = std::hypot(way.x, way.y) * std::hypot(heading.x, heading.y);
        const float cosine = lengths > 0 ? (way.x * heading.x + way.y * heading.y) / lengths : -1;
        if (cosine <= best) continue;
        best = cosine;
        best_route = r;
        best_point = i;
        best_step = step;
      }
    }
  }
  if (best_route == trails.routes.size()) return false;
  used[best_route] = 1;
  const auto& points = trails.routes[best_route].points;
  for (auto i = std::ptrdiff_t(best_point) + best_step; i >= 0 && i < std::ptrdiff_t(points.size()); i += best_step) {
    line.push_back(points[std::size_t(i)]);
  }
  return true;
}

template <class Visit>
void for_each_item(const PlacedThings& things, const Visit& visit) {
  for (int kind = 0; kind < placed_kinds; ++kind) {
    const std::size_t count = count_of(things, PlacedKind(kind));
    for (std::size_t i = 0; i < count; ++i) visit(PlacedItem{PlacedKind(kind), i});
  }
}

}  // namespace

PlacedThings placed_things(const Document& document) { return {document.inflows, document.placements}; }

void set_placed(Document& document, const PlacedThings& things) {
  document.inflows = things.inflows;
  document.placements = things.placements;
}

const char* placed_name(PlacedKind kind) {
  static constexpr std::array<const char*, placed_kinds> names{"Inflow", "River",    "Lake",         "Ford",
                                                               "Exit",   "Waypoint", "Pinned trail", "Forbidden trail"};
  return names[std::size_t(kind)];
}

bool is_line(PlacedKind kind) {
  return kind == PlacedKind::river || kind == PlacedKind::lake || kind == PlacedKind::pinned_trail ||
         kind == PlacedKind::forbidden_trail;
}

std::size_t least_points(PlacedKind kind) { return kind == PlacedKind::lake ? 3 : is_line(kind) ? 2 : 1; }

std::size_t count_of(const PlacedThings& things, PlacedKind kind) {
  const Placements& placements = things.placements;
  switch (kind) {
    case PlacedKind::inflow:
      return things.inflows.size();
    case PlacedKind::river:
      return placements.water.rivers.size();
    case PlacedKind::lake:
      return placements.water.lakes.size();
    case PlacedKind::ford:
      return placements.places.fords.size();
    case PlacedKind::exit:
      return placements.places.exits.size();
    case PlacedKind::waypoint:
      return placements.places.waypoints.size();
    case PlacedKind::pinned_trail:
      return placements.places.pinned_trails.size();
    case PlacedKind::forbidden_trail:
      return placements.places.forbidden_trails.size();
  }
  return 0;
}

std::vector<PathPoint> points_of(const PlacedThings& things, const PlacedItem& item) {
  if (const auto* line = line_of(things, item)) return *line;
  const Places& places = things.placements.places;
  switch (item.kind) {
    case PlacedKind::inflow:
      return {{float(things.inflows[item.index].x), float(things.inflows[item.index].y)}};
    case PlacedKind::ford:
      return {places.fords[item.index].at};
    case PlacedKind::exit:
      return {places.exits[item.index].at};
    default:
      return {places.waypoints[item.index].at};
  }
}

float radius_of(const PlacedThings& things, const PlacedItem& item) {
  const Places& places = things.placements.places;
  switch (item.kind) {
    case PlacedKind::ford:
      return places.fords[item.index].radius;
    case PlacedKind::exit:
      return places.exits[item.index].radius;
    case PlacedKind::forbidden_trail:
      return places.forbidden_trails[item.index].radius;
    default:
      return 0;
  }
}

std::optional<PlacedHandle> handle_near(const PlacedThings& things, PathPoint at, float reach,
                                        const std::optional<PlacedItem>& first) {
  std::optional<PlacedHandle> found;
  float nearest = reach;
  for_each_item(things, [&](const PlacedItem& item) {
    const std::vector<PathPoint> points = points_of(things, item);
    for (std::size_t i = 0; i < points.size(); ++i) {
      // A point of the chosen thing is taken even when another's lies a little nearer.
      const float away = distance(at, points[i]) * (first == item ? 0.5F : 1.0F);
      if (away >= nearest) continue;
      nearest = away;
      found = PlacedHandle{item, i, points[i]};
    }
  });
  return found;
}

std::optional<PlacedItem> item_near(const PlacedThings& things, PathPoint at, float reach) {
  std::optional<PlacedItem> found;
  float nearest = reach;
  for_each_item(things, [&](const PlacedItem& item) {
    const std::vector<PathPoint> points = points_of(things, item);
    float away = points.size() == 1 ? distance(at, points[0]) : std::numeric_limits<float>::max();
    for (std::size_t i = 0; i < pieces(item.kind, points.size()); ++i) {
      away = std::min(away, distance_to_piece(at, points[i], points[(i + 1) % points.size()]));
    }
    if (away >= nearest) return;
    nearest = away;
    found = item;
  });
  return found;
}

PlacedItem add_thing(PlacedThings& things, PlacedKind kind, std::vector<PathPoint> points, const Terrain& terrain) {
  for (PathPoint& point : points) point = on_map(point, terrain);
  Places& places = things.placements.places;
  DrawnWater& water = things.placements.water;
  const auto cell = float(terrain.cell_size);
  switch (kind) {
    case PlacedKind::inflow:
      things.inflows.push_back({int(std::lround(points[0].x)), int(std::lround(points[0].y)), 5e7});
      break;
    case PlacedKind::river:
      water.rivers.push_back({std::move(points), 1.0});
      break;
    case PlacedKind::lake:
      water.lakes.push_back({std::move(points), 3});
      break;
    case PlacedKind::ford:
      places.fords.push_back({points[0], std::max(12.0F, 2 * cell)});
      break;
    case PlacedKind::exit:
      places.exits.push_back({points[0], std::max(20.0F, 2 * cell)});
      break;
    case PlacedKind::waypoint:
      places.waypoints.push_back({points[0], 0.2F});
      break;
    case PlacedKind::pinned_trail:
      places.pinned_trails.push_back({std::move(points), 50000});
      break;
    case PlacedKind::forbidden_trail:
      places.forbidden_trails.push_back({std::move(points), std::max(25.0F, 2 * cell)});
      break;
  }
  return {kind, count_of(things, kind) - 1};
}

void move_point(PlacedThings& things, const PlacedHandle& handle, PathPoint to, const Terrain& terrain) {
  to = on_map(to, terrain);
  if (auto* line = line_of(things, handle.item)) {
    (*line)[handle.point] = to;
    return;
  }
  Places& places = things.placements.places;
  const std::size_t index = handle.item.index;
  switch (handle.item.kind) {
    case PlacedKind::inflow:
      things.inflows[index].x = int(std::lround(to.x));
      things.inflows[index].y = int(std::lround(to.y));
      break;
    case PlacedKind::ford:
      places.fords[index].at = to;
      break;
    case PlacedKind::exit:
      places.exits[index].at = to;
      break;
    default:
      places.waypoints[index].at = to;
  }
}

void insert_point(PlacedThings& things, const PlacedItem& item, PathPoint at) {
  auto* line = line_of(things, item);
  if (line == nullptr) return;
  std::size_t best = 0;
  float nearest = std::numeric_limits<float>::max();
  for (std::size_t i = 0; i < pieces(item.kind, line->size()); ++i) {
    const float away = distance_to_piece(at, (*line)[i], (*line)[(i + 1) % line->size()]);
    if (away >= nearest) continue;
    nearest = away;
    best = i;
  }
  line->insert(line->begin() + std::ptrdiff_t(best) + 1, at);
}

void remove_point(PlacedThings& things, const PlacedHandle& handle) {
  auto* line = line_of(things, handle.item);
  if (line == nullptr || line->size() <= least_points(handle.item.kind)) {
    remove_thing(things, handle.item);
  } else {
    line->erase(line->begin() + std::ptrdiff_t(handle.point));
  }
}

void remove_thing(PlacedThings& things, const PlacedItem& item) {
  const auto take = [&](auto& list) { list.erase(list.begin() + std::ptrdiff_t(item.index)); };
  Places& places = things.placements.places;
  switch (item.kind) {
    case PlacedKind::inflow:
      return take(things.inflows);
    case PlacedKind::river:
      return take(things.placements.water.rivers);
    case PlacedKind::lake:
      return take(things.placements.water.lakes);
    case PlacedKind::ford:
      return take(places.fords);
    case PlacedKind::exit:
      return take(places.exits);
    case PlacedKind::waypoint:
      return take(places.waypoints);
    case PlacedKind::pinned_trail:
      return take(places.pinned_trails);
    case PlacedKind::forbidden_trail:
      return take(places.forbidden_trails);
  }
}

std::optional<RouteHit> route_near(const TrailNetwork& trails, PathPoint at, float reach) {
  std::optional<RouteHit> found;
  float nearest = reach;
  for (std::size_t r = 0; r < trails.routes.size(); ++r) {
    const auto& points = trails.routes[r].points;
    for (std::size_t i = 0; i < points.size(); ++i) {
      const float away = distance(at, points[i]);
      if (away >= nearest) continue;
      nearest = away;
      found = RouteHit{r, i};
    }
  }
  return found;
}

TrailStretch stretch_around(const TrailNetwork& trails, const RouteHit& hit, double cell_size, double reach) {
  const TrailRoute& route = trails.routes[hit.route];
  std::vector<PathPoint> back(route.points.begin(), route.points.begin() + std::ptrdiff_t(hit.point) + 1);
  std::reverse(back.begin(), back.end());
  std::vector<PathPoint> forth(route.points.begin() + std::ptrdiff_t(hit.point), route.points.end());
  // Seen from the grip both halves begin with it; one that is shorter than the reach goes on along other routes.
  for (auto* half : {&back, &forth}) {
    std::vector<char> used(trails.routes.size());
    used[hit.route] = 1;
    const PathPoint other = half == &back ? (forth.size() > 1 ? forth[1] : forth[0]) : (back.size() > 1 ? back[1] : back[0]);
    while (line_length(*half) * cell_size < reach && follow_on(trails, used, other, *half)) {
    }
  }
  TrailStretch stretch;
  stretch.points.assign(back.rbegin(), back.rend());
  stretch.grip = stretch.points.size() - 1;
  stretch.points.insert(stretch.points.end(), forth.begin() + 1, forth.end());
  stretch.weight = hit.point < route.weight.size() ? route.weight[hit.point] : 0;
  return stretch;
}

TrailBend bent(const TrailStretch& stretch, PathPoint to, double cell_size, double reach) {
  const auto& points = stretch.points;
  const std::size_t grip = stretch.grip;
  std::vector<double> along(points.size());
  for (std::size_t i = 1; i < points.size(); ++i)
    along[i] = along[i - 1] + double(distance(points[i - 1], points[i])) * cell_size;
  const PathPoint pull{to.x - points[grip].x, to.y - points[grip].y};
  TrailBend bend;
  bend.weight = stretch.weight;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const double away = std::abs(along[i] - along[grip]) / reach;
    if (away > 1) continue;
    const auto moved = float(1 - away * away * (3 - 2 * away));
    bend.before.push_back(points[i]);
    bend.after.push_back({points[i].x + pull.x * moved, points[i].y + pull.y * moved});
  }
  return bend;
}

void place_bend(PlacedThings& things, const TrailBend& bend, double cell_size) {
  if (bend.after.size() < 2) return;
  float farthest = 0;
  for (std::size_t i = 0; i < bend.after.size(); ++i) farthest = std::max(farthest, distance(bend.before[i], bend.after[i]));
  // Only the stretch that was really left is forbidden, and so narrow that the new way is free.
  std::vector<PathPoint> left;
  for (std::size_t i = 0; i < bend.after.size(); ++i) {
    if (distance(bend.before[i], bend.after[i]) > 0.6F * farthest) left.push_back(bend.before[i]);
  }
  Places& places = things.placements.places;
  places.pinned_trails.push_back({bend.after, std::max(bend.weight, 1000.0F)});
  const float radius = std::min(25.0F, 0.4F * farthest * float(cell_size));
  if (left.size() >= 2 && radius >= float(cell_size)) places.forbidden_trails.push_back({std::move(left), radius});
}

}  // namespace biotope

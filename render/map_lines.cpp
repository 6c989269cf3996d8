#include "render/map_lines.hpp"

#include <algorithm>
#include <cmath>

namespace biotope {
namespace {

constexpr std::array<std::uint8_t, 4> trail_tone{92, 54, 28, 255};
constexpr std::array<std::uint8_t, 4> river_tone{62, 112, 150, 255};
constexpr int tail_steps = 12;  // every five minutes of the last hour

struct Direction {
  float x = 0;
  float y = 0;
};

Direction direction(const RibbonPoint& from, const RibbonPoint& to) {
  const float dx = to.x - from.x;
  const float dy = to.y - from.y;
  const float length = std::sqrt(dx * dx + dy * dy);
  return length > 0 ? Direction{dx / length, dy / length} : Direction{};
}

/// The normal at a point between two directions, lengthened so that the band keeps its width around the bend (at most doubled).
Direction miter(Direction before, Direction after) {
  if (before.x == 0 && before.y == 0) before = after;
  if (after.x == 0 && after.y == 0) after = before;
  const Direction sum{before.x + after.x, before.y + after.y};
  const float length = std::sqrt(sum.x * sum.x + sum.y * sum.y);
  if (length < 1e-3F) return {-before.y, before.x};
  const Direction normal{-sum.y / length, sum.x / length};
  const float cosine = normal.x * -before.y + normal.y * before.x;
  const float stretch = 1 / std::max(cosine, 0.5F);
  return {normal.x * stretch, normal.y * stretch};
}

std::array<std::uint8_t, 4> tone_of(const std::array<float, 3>& colour) {
  std::array<std::uint8_t, 4> tone{0, 0, 0, 255};
  for (std::size_t i = 0; i < 3; ++i) tone[i] = std::uint8_t(std::lround(std::clamp(colour[i], 0.0F, 1.0F) * 255));
  return tone;
}

/// The species' colour, never so dark that it is lost on shaded ground.
std::array<std::uint8_t, 4> marker_tone(const std::array<float, 3>& colour) {
  const float value = 0.3F * colour[0] + 0.59F * colour[1] + 0.11F * colour[2];
  const float lift = std::max(0.0F, 0.42F - value);
  return tone_of({colour[0] + lift, colour[1] + lift, colour[2] + lift});
}

void add_tail(HerdPicture& picture, const DailyPlan& plan, const GraphLevel& graph, double hour, double cell_size,
              std::array<std::uint8_t, 4> tone) {
  std::vector<RibbonPoint> points;
  for (int step = tail_steps; step >= 0; --step) {
    const double when = hour - double(step) / tail_steps;
    const HerdState state = herd_state(plan, graph, when, cell_size);
    const float age = float(step) / tail_steps;
    if (!points.empty() && std::hypot(points.back().x - state.at.x, points.back().y - state.at.y) < 0.05F) continue;
    points.push_back({state.at.x, state.at.y, 1 - age, 0});
  }
  add_ribbon(picture.tails, points, tone);
}

}  // namespace

void add_ribbon(RibbonMesh& mesh, std::span<const RibbonPoint> points, std::array<std::uint8_t, 4> tone) {
  if (points.size() < 2) return;
  const auto first = std::uint32_t(mesh.vertices.size());
  for (std::size_t i = 0; i < points.size(); ++i) {
    const RibbonPoint& point = points[i];
    const Direction before = i > 0 ? direction(points[i - 1], point) : Direction{};
    const Direction after = i + 1 < points.size() ? direction(point, points[i + 1]) : Direction{};
    const Direction normal = miter(before, after);
    for (const float side : {-1.0F, 1.0F}) {
      mesh.vertices.push_back({point.x, point.y, normal.x * side, normal.y * side, side, point.strength, point.metres, tone});
    }
    if (i == 0) continue;
    const auto corner = first + std::uint32_t(2 * (i - 1));
    for (const std::uint32_t offset : {0U, 1U, 2U, 2U, 1U, 3U}) mesh.indices.push_back(corner + offset);
  }
}

RibbonMesh trail_ribbons(const TrailNetwork& trails) {
  float most = 0;
  for (const TrailRoute& route : trails.routes) {
    for (const float weight : route.weight) most = std::max(most, weight);
  }
  RibbonMesh mesh;
  if (most <= 0) return mesh;
  // Three decades of use are told apart; less than a thousandth of the busiest trail is a faint line.
  const float top = std::log10(most);
  std::vector<RibbonPoint> points;
  for (const TrailRoute& route : trails.routes) {
    points.clear();
    for (std::size_t i = 0; i < route.points.size(); ++i) {
      const float weight = i < route.weight.size() ? route.weight[i] : 0;
      const float strength = weight > 0 ? std::clamp(1 + (std::log10(weight) - top) / 3, 0.0F, 1.0F) : 0;
      points.push_back({route.points[i].x, route.points[i].y, strength, 0.4F + 1.6F * strength});
    }
    add_ribbon(mesh, points, trail_tone);
  }
  return mesh;
}

RibbonMesh river_ribbons(const Hydrology& hydrology, int columns) {
  RibbonMesh mesh;
  std::vector<RibbonPoint> points;
  for (const RiverReach& reach : hydrology.reaches) {
    points.clear();
    for (const std::uint32_t cell : reach.cells) {
      const float discharge = hydrology.discharge[cell];
      // 0.01 m3/s is a brook one steps over, 10 m3/s a river.
      const float strength = std::clamp((std::log10(std::max(discharge, 1e-4F)) + 2) / 3, 0.0F, 1.0F);
      points.push_back({float(cell % std::uint32_t(columns)), float(cell / std::uint32_t(columns)), strength,
                        river_width(std::max(discharge, 0.0F))});
    }
    // Cells step in eight directions; two passes of a moving mean take the stairs out of the line.
    for (int pass = 0; pass < 2; ++pass) {
      const std::vector<RibbonPoint> raw = points;
      for (std::size_t i = 1; i + 1 < points.size(); ++i) {
        points[i].x = (raw[i - 1].x + 2 * raw[i].x + raw[i + 1].x) / 4;
        points[i].y = (raw[i - 1].y + 2 * raw[i].y + raw[i + 1].y) / 4;
      }
    }
    add_ribbon(mesh, points, river_tone);
  }
  return mesh;
}

std::vector<HerdMarker> merged_marks(std::vector<HerdMarker> marks, double pixels_per_cell,
                                     const std::function<float(int species, int animals)>& pixels_of) {
  std::stable_sort(marks.begin(), marks.end(), [](const HerdMarker& a, const HerdMarker& b) { return a.animals > b.animals; });
  std::vector<HerdMarker> merged;
  for (const HerdMarker& mark : marks) {
    const auto under = std::find_if(merged.begin(), merged.end(), [&](const HerdMarker& each) {
      const double away = std::hypot(double(each.x - mark.x), double(each.y - mark.y)) * pixels_per_cell;
      return each.species == mark.species && away < 0.4 * double(std::max(each.pixels, mark.pixels));
    });
    if (under == merged.end()) {
      merged.push_back(mark);
    } else {
      under->animals += mark.animals;
      under->pixels = pixels_of(under->species, under->animals);
    }
  }
  return merged;
}

HerdPicture herds_at(const MapsSnapshot& snapshot, double hour, const std::vector<bool>& visible, float mark_scale,
                     double pixels_per_cell) {
  HerdPicture picture;
  if (!snapshot.plans || !snapshot.graph || !snapshot.web) return picture;
  const double cell_size = snapshot.terrain().cell_size;
  const auto pixels_of = [&](int species, int animals) {
    const Species& who = snapshot.web->species[std::size_t(species)];
    const float body = who.is_plant() ? 1 : std::clamp(who.animal().shape.body_length, 0.6F, 4.0F);
    return (6.5F + 3.0F * std::sqrt(body) + 2.0F * std::log2(float(std::max(animals, 1)))) * mark_scale;
  };
  for (const DailyPlan& plan : *snapshot.plans) {
    const auto species = std::size_t(plan.species);
    if (species < visible.size() && !visible[species]) continue;
    if (std::size_t(plan.level) >= snapshot.graph->levels.size() || species >= snapshot.web->species.size()) continue;
    const GraphLevel& graph = snapshot.graph->levels[std::size_t(plan.level)];
    const Species& who = snapshot.web->species[species];
    const auto tone = marker_tone(who.colour);
    add_tail(picture, plan, graph, hour, cell_size, tone);
    const HerdState state = herd_state(plan, graph, hour, cell_size);
    picture.markers.push_back({state.at.x, state.at.y, state.heading, pixels_of(plan.species, plan.size), tone, plan.species, plan.size});
  }
  picture.markers = merged_marks(std::move(picture.markers), pixels_per_cell, pixels_of);
  return picture;
}

}  // namespace biotope

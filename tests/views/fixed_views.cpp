#include "tests/views/fixed_views.hpp"

#include <cmath>
#include <optional>

#include "core/movement/daily_plan.hpp"
#include "render/animal_world.hpp"
#include "render/plant_placement.hpp"

namespace biotope::test {
namespace {

glm::dvec2 metres_of(const Terrain& terrain, PathPoint cell) {
  return {(double(cell.x) + 0.5) * terrain.cell_size, (terrain.height.height() - 0.5 - double(cell.y)) * terrain.cell_size};
}

/// Looks at a place on the ground from `away` metres in a direction (degrees), `up` metres over the ground there.
Camera looking_at(const Terrain& terrain, glm::dvec2 place, double bearing, double away, double up) {
  const double angle = bearing * 0.01745329;
  const glm::dvec2 stand = place - away * glm::dvec2(std::sin(angle), std::cos(angle));
  const double ground = double(ground_height(terrain, place.x, place.y));
  Camera camera;
  camera.position = {stand.x, stand.y, double(ground_height(terrain, stand.x, stand.y)) + up};
  camera.heading = float(bearing);
  camera.pitch = float(std::atan2(ground + 0.8 - camera.position.z, away) * 57.29578);
  return camera;
}

struct HerdMoment {
  glm::dvec2 place;
  double hour = 0;
  /// Toward the water that it drinks, degrees.
  double bearing = 0;
};

/// Direction (degrees) from a place to the middle of the water within a distance (m); nothing where there is none.
std::optional<double> bearing_to_water(const MapsSnapshot& snapshot, glm::dvec2 place, double reach) {
  const Terrain& terrain = snapshot.terrain();
  const Rect cells = cells_under(terrain, place.x - reach, place.y - reach, 2 * reach);
  glm::dvec2 sum(0);
  for (int y = cells.y0; y < cells.y1; ++y) {
    for (int x = cells.x0; x < cells.x1; ++x) {
      if (snapshot.hydrology->water_depth(x, y) <= 0) continue;
      const glm::dvec2 to = metres_of(terrain, {float(x), float(y)}) - place;
      if (glm::length(to) < reach) sum += to;
    }
  }
  if (glm::length(sum) < 1) return std::nullopt;
  return std::atan2(sum.x, sum.y) * 57.29578;
}

/// Trees that stand between the eye and what it looks at.
int trees_in_the_way(const PlantPlacement& plants, const Camera& camera, glm::dvec2 place) {
  const glm::dvec2 eye(camera.position);
  const glm::dvec2 along = glm::normalize(place - eye);
  int count = 0;
  for (int row = int(place.y / 64) - 1; row <= int(place.y / 64) + 1; ++row) {
    for (int column = int(place.x / 64) - 1; column <= int(place.x / 64) + 1; ++column) {
      for (const PlantInstance& tree : plants.block(Stratum::tree, column, row)) {
        const glm::dvec2 to = glm::dvec2(tree.x, tree.y) - eye;
        const double ahead = glm::dot(to, along);
        const double aside = std::abs(to.x * along.y - to.y * along.x);
        count += ahead > -4 && ahead < glm::length(place - eye) + 4 && aside < 3 + 0.3 * std::max(0.0, ahead) ? 1 : 0;
      }
    }
  }
  return count;
}

/// Looks over a herd toward the water, from where the fewest trees are in the way.
Camera looking_at_herd(const MapsSnapshot& snapshot, const HerdMoment& herd) {
  const PlantPlacement plants(std::make_shared<const MapsSnapshot>(snapshot));
  Camera best;
  int fewest = 1 << 30;
  for (const double turn : {0.0, -20.0, 20.0, -40.0, 40.0, -60.0, 60.0}) {
    const Camera camera = looking_at(snapshot.terrain(), herd.place, herd.bearing + turn, 15, 3.5);
    const int trees = trees_in_the_way(plants, camera, herd.place);
    if (trees >= fewest) continue;
    fewest = trees;
    best = camera;
  }
  return best;
}

/// The first herd of at least six that drinks in full daylight: the middle of its animals, and where the water is.
std::optional<HerdMoment> drinking_herd(const MapsSnapshot& snapshot) {
  HerdSimulation simulation(herd_world(snapshot, nullptr));
  for (double hour = 8; hour < 17; hour += 0.25) {
    for (std::size_t number = 0; number < snapshot.plans->size(); ++number) {
      const DailyPlan& plan = (*snapshot.plans)[number];
      if (plan.size < 6 || plan.level == 0) continue;
      const auto& graph = snapshot.graph->levels[std::size_t(plan.level)];
      if (herd_state(plan, graph, hour, snapshot.terrain().cell_size).activity != HerdActivity::drinking) continue;
      glm::dvec2 mean(0);
      const auto animals = simulation.animals(int(number), hour);
      for (const HerdAnimal& animal : animals) mean += glm::dvec2(animal.place.x, animal.place.y) / double(animals.size());
      const auto bearing = bearing_to_water(snapshot, mean, 60);
      if (bearing) return HerdMoment{mean, hour, *bearing};
    }
  }
  return std::nullopt;
}

/// Where the end of a trail meets the middle of another one, the most used such place.
std::optional<glm::dvec2> trail_fork(const MapsSnapshot& snapshot) {
  std::optional<PathPoint> best;
  float most = 0;
  const auto& routes = snapshot.trails->routes;
  for (std::size_t a = 0; a < routes.size(); ++a) {
    for (const bool last : {false, true}) {
      const PathPoint end = last ? routes[a].points.back() : routes[a].points.front();
      const float weight = last ? routes[a].weight.back() : routes[a].weight.front();
      if (weight <= most) continue;
      for (std::size_t b = 0; b < routes.size(); ++b) {
        if (b == a || routes[b].points.size() < 40) continue;
        for (std::size_t i = 15; i + 15 < routes[b].points.size(); ++i) {
          const PathPoint& on = routes[b].points[i];
          if (std::hypot(on.x - end.x, on.y - end.y) > 1) continue;
          best = end;
          most = weight;
        }
      }
    }
  }
  if (!best) return std::nullopt;
  return metres_of(snapshot.terrain(), *best);
}

/// The most overgrown open place, of one in sixteen cells each way: herbs as dense as can be where no tree and no water is.
glm::dvec2 meadow(const MapsSnapshot& snapshot) {
  const Terrain& terrain = snapshot.terrain();
  PathPoint best{float(terrain.height.width()) / 2, float(terrain.height.height()) / 2};
  float most = -1;
  const auto& plants = snapshot.web->levels[0];
  for (int y = 40; y < terrain.height.height() - 40; y += 16) {
    for (int x = 40; x < terrain.height.width() - 40; x += 16) {
      if (snapshot.hydrology->water_depth(x, y) > 0 || snapshot.trails->wear(x, y) > 0.02F) continue;
      float herbs = 0;
      float woody = 0;
      for (std::size_t i = 0; i < plants.size(); ++i) {
        const Stratum stratum = snapshot.web->species[std::size_t(plants[i])].plant().stratum;
        (stratum == Stratum::herb ? herbs : woody) += cover_fraction((*snapshot.cover[i])(x, y));
      }
      const float value = herbs - 3 * woody;
      if (value <= most) continue;
      most = value;
      best = {float(x), float(y)};
    }
  }
  return metres_of(terrain, best);
}

LandscapeOptions at(int month, double hour, const char* weather = "fair") {
  LandscapeOptions options;
  options.month = month;
  options.hour = hour;
  options.weather = weather_named(weather).value_or(Weather{});
  options.quality = 1;
  return options;
}

}  // namespace

FixedView brush_view(const MapsSnapshot& snapshot) {
  const Terrain& terrain = snapshot.terrain();
  const glm::dvec2 middle(terrain.width_metres() / 2, terrain.height_metres() / 2);
  // Steep enough that trees hide little of it.
  FixedView view{"brush", looking_at(terrain, middle, 30, 110, 150), at(5, 10.5)};
  view.options.brush = glm::vec3(middle.x / terrain.cell_size - 0.5, terrain.height.height() - 0.5 - middle.y / terrain.cell_size,
                                 60 / terrain.cell_size);
  return view;
}

std::vector<FixedView> fixed_views(const MapsSnapshot& snapshot) {
  const Terrain& terrain = snapshot.terrain();
  const Camera first = first_view(snapshot);
  const Camera above = overview(snapshot);
  const Camera close = looking_at(terrain, meadow(snapshot), 30, 7, 1.1);
  Camera down = above;
  down.position = {terrain.width_metres() / 2, terrain.height_metres() / 2, above.position.z + 800};
  down.heading = 0;
  down.pitch = -89;

  std::vector<FixedView> views{
      {"first", first, at(5, 10.5)},         {"dawn", first, at(5, 4.8)},          {"noon", first, at(6, 12, "clear")},
      {"night", first, at(8, 0.5, "clear")}, {"winter", first, at(0, 12)},         {"autumn", first, at(9, 15)},
      {"rain", first, at(9, 11, "rain")},    {"fog", first, at(10, 9, "fog")},     {"grass", close, at(4, 11)},
      {"above", above, at(5, 10.5)},         {"winter-above", above, at(0, 12.5)}, {"evening-above", above, at(8, 18)},
      {"top-down", down, at(5, 10.5)},
  };
  views.push_back(brush_view(snapshot));
  if (const auto herd = drinking_herd(snapshot)) {
    views.push_back({"herd", looking_at_herd(snapshot, *herd), at(5, herd->hour)});
  }
  if (const auto fork = trail_fork(snapshot)) views.push_back({"fork", looking_at(terrain, *fork, 20, 16, 6), at(5, 9.5)});
  return views;
}

std::vector<FixedView> snow_views(const MapsSnapshot& snapshot) {
  const Terrain& terrain = snapshot.terrain();
  Camera over = first_view(snapshot);
  over.position.z = double(ground_height(terrain, over.position.x, over.position.y)) + 45;
  over.pitch = -6;
  return {{"snow-noon", over, at(0, 12)}, {"snow-night", over, at(1, 23, "clear")}, {"snow-fall", over, at(11, 10, "rain")}};
}

}  // namespace biotope::test

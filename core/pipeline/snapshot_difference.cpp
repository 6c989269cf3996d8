#include "core/pipeline/snapshot_difference.hpp"

#include <algorithm>
#include <vector>

namespace biotope {
namespace {

/// Same object, or the same content.
template <class T>
bool same(const std::shared_ptr<const T>& a, const std::shared_ptr<const T>& b) {
  return a == b || (a && b && *a == *b);
}

template <class List, class Equal>
bool same_lists(const List& a, const List& b, const Equal& equal) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(), equal);
}

std::string water_difference(const Hydrology& a, const Hydrology& b) {
  if (!(a.filled == b.filled)) return "filled ground";
  if (!(a.catchment_area == b.catchment_area)) return "catchment area";
  if (!(a.water_depth == b.water_depth)) return "water depth";
  if (!(a.discharge == b.discharge)) return "discharge";
  if (!(a.water == b.water)) return "kind of water";
  if (!(a.receiver == b.receiver)) return "direction of flow";
  const auto same_ford = [](const Ford& one, const Ford& other) {
    return one.x == other.x && one.y == other.y && one.depth == other.depth;
  };
  return same_lists(a.fords, b.fords, same_ford) ? "" : "fords";
}

std::string environment_difference(const EnvironmentMaps& a, const EnvironmentMaps& b) {
  static const std::array<const char*, monthly_resources> names{"illumination", "temperature", "moisture"};
  for (std::size_t r = 0; r < monthly_resources; ++r) {
    const bool alike =
        a.monthly[r].offset == b.monthly[r].offset && same_lists(a.monthly[r].layers, b.monthly[r].layers, same<Grid<float>>);
    if (!alike) return names[r];
  }
  if (!same(a.texture, b.texture)) return "texture";
  return same(a.geology, b.geology) ? "" : "geology";
}

std::string plant_difference(const MapsSnapshot& a, const MapsSnapshot& b) {
  if (a.cover.size() != b.cover.size()) return "number of plants";
  for (std::size_t i = 0; i < a.cover.size(); ++i) {
    const std::string& name = a.web->species[std::size_t(a.web->levels.front()[i])].name;
    if (!same(a.computed_cover[i], b.computed_cover[i])) return "computed cover of " + name;
    if (!same(a.cover[i], b.cover[i])) return "cover of " + name;
  }
  if (!same(a.tree_cover, b.tree_cover)) return "tree cover";
  return a.plant_achieved == b.plant_achieved ? "" : "shares of plants";
}

std::string level_difference(const AnimalLevel& a, const AnimalLevel& b) {
  if (!(a.partition->label == b.partition->label)) return "partition";
  const auto same_regions = [](const auto& one, const auto& other) { return one->label == other->label; };
  if (!same_lists(a.regions, b.regions, same_regions)) return "regions";
  if (a.computed_population != b.computed_population) return "computed populations";
  if (a.population != b.population) return "populations";
  if (a.attraction != b.attraction) return "attraction";
  if (a.eaten != b.eaten || a.available != b.available) return "what is eaten";
  const auto same_herd = [](const Herd& one, const Herd& other) {
    return one.species == other.species && one.region == other.region && one.size == other.size;
  };
  if (!same_lists(a.herds, b.herds, same_herd)) return "herds";
  return a.achieved == b.achieved ? "" : "shares";
}

std::string graph_difference(const ResourceAccessGraph& a, const ResourceAccessGraph& b) {
  const auto same_node = [](const ResourceNode& one, const ResourceNode& other) {
    return one.kind == other.kind && one.group == other.group && one.cells == other.cells && one.x == other.x &&
           one.y == other.y && one.piece == other.piece && one.attraction == other.attraction &&
           one.built_from == other.built_from;
  };
  const auto same_edge = [](const SpatialEdge& one, const SpatialEdge& other) {
    return one.from == other.from && one.to == other.to && one.species == other.species && one.seconds == other.seconds;
  };
  if (a.levels.size() != b.levels.size()) return "levels of the graph";
  for (std::size_t i = 0; i < a.levels.size(); ++i) {
    const std::string level = " of level " + std::to_string(i) + " of the graph";
    if (!same_lists(a.levels[i].nodes, b.levels[i].nodes, same_node)) return "nodes" + level;
    if (!same_lists(a.levels[i].edges, b.levels[i].edges, same_edge)) return "edges" + level;
  }
  return {};
}

std::string trail_difference(const TrailNetwork& a, const TrailNetwork& b) {
  if (!(a.wear == b.wear)) return "wear of trails";
  if (!(a.carving == b.carving)) return "carving of trails";
  const auto same_route = [](const TrailRoute& one, const TrailRoute& other) {
    return one.points == other.points && one.weight == other.weight && one.length == other.length;
  };
  return same_lists(a.routes, b.routes, same_route) ? "" : "trails";
}

bool same_plans(const std::vector<DailyPlan>& a, const std::vector<DailyPlan>& b) {
  const auto same_stop = [](const PlanStop& one, const PlanStop& other) {
    return one.node == other.node && one.arrive == other.arrive && one.leave == other.leave;
  };
  const auto same_point = [](const DailyPlan::Waypoint& one, const DailyPlan::Waypoint& other) {
    return one.hour == other.hour && one.at == other.at;
  };
  return same_lists(a, b, [&](const DailyPlan& one, const DailyPlan& other) {
    return one.level == other.level && one.herd == other.herd && one.species == other.species && one.size == other.size &&
           one.pursuits == other.pursuits && same_lists(one.stops, other.stops, same_stop) &&
           same_lists(one.way, other.way, same_point);
  });
}

}  // namespace

std::string snapshot_difference(const MapsSnapshot& a, const MapsSnapshot& b) {
  if (a.web->species != b.web->species) return "species";
  if (!(a.terrain().height == b.terrain().height)) return "ground";
  if (std::string water = water_difference(*a.hydrology, *b.hydrology); !water.empty()) return water;
  if (std::string resource = environment_difference(*a.environment, *b.environment); !resource.empty()) return resource;
  if (std::string plants = plant_difference(a, b); !plants.empty()) return plants;
  if (a.animals.size() != b.animals.size()) return "number of levels";
  for (std::size_t i = 0; i < a.animals.size(); ++i) {
    const std::string level = level_difference(*a.animals[i], *b.animals[i]);
    if (!level.empty()) return level + " of level " + std::to_string(i + 1);
  }
  if (std::string graph = graph_difference(*a.graph, *b.graph); !graph.empty()) return graph;
  if (std::string trails = trail_difference(*a.trails, *b.trails); !trails.empty()) return trails;
  if (!same_plans(*a.plans, *b.plans)) return "daily plans";
  return a.warnings == b.warnings ? "" : "warnings";
}

}  // namespace biotope

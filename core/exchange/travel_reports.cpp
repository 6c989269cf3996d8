#include <ogr_spatialref.h>

#include <algorithm>
#include <charconv>
#include <cmath>

#include "core/exchange/gdal_support.hpp"
#include "core/exchange/solve_reports.hpp"

// These files may have millions of points, so they are written straight as text.
namespace biotope {
namespace {

/// Most points of a herd's way in plans.json: about one a quarter of an hour (our choice).
constexpr std::size_t most_waypoints = 96;

void append_number(std::string& text, double value, int decimals) {
  char buffer[400];
  const auto end = std::to_chars(buffer, buffer + sizeof buffer, value, std::chars_format::fixed, decimals).ptr;
  std::string_view number(buffer, std::size_t(end - buffer));
  if (number.find('.') != std::string_view::npos) {
    number.remove_suffix(number.size() - 1 - number.find_last_not_of('0'));
    if (number.back() == '.') number.remove_suffix(1);
  }
  text += number == "-0" ? "0" : number;
}

/// A point of the grid in the terrain's CRS, to the centimetre.
void append_position(std::string& text, const Terrain& terrain, double x, double y) {
  const auto& t = terrain.georeference.transform;
  text += '[';
  append_number(text, t[0] + (x + 0.5) * t[1] + (y + 0.5) * t[2], 2);
  text += ',';
  append_number(text, t[3] + (x + 0.5) * t[4] + (y + 0.5) * t[5], 2);
  text += ']';
}

/// Species names are lower case, digits and '-', so they need no escapes.
const std::string& species_name(const MapsSnapshot& snapshot, int species) {
  return snapshot.web->species[std::size_t(species)].name;
}

/// `"crs": {...},` when the CRS has an EPSG code: GeoJSON's older way, which GIS programs read.
std::string crs_member(const Terrain& terrain) {
  if (terrain.georeference.wkt.empty()) return "";
  const GdalErrorScope errors;
  OGRSpatialReference reference;
  if (reference.importFromWkt(terrain.georeference.wkt.c_str()) != OGRERR_NONE) return "";
  const char* code = reference.GetAuthorityCode(nullptr);
  const char* authority = reference.GetAuthorityName(nullptr);
  if (code == nullptr || authority == nullptr || std::string_view(authority) != "EPSG") return "";
  return std::string("\"crs\":{\"type\":\"name\",\"properties\":{\"name\":\"urn:ogc:def:crs:EPSG::") + code + "\"}},\n";
}

void append_route(std::string& text, const Terrain& terrain, const TrailRoute& route) {
  const auto strongest = std::max_element(route.weight.begin(), route.weight.end());
  text += "{\"type\":\"Feature\",\"properties\":{\"length_m\":";
  append_number(text, route.length, 2);
  text += ",\"weight\":";
  append_number(text, strongest == route.weight.end() ? 0.0 : double(*strongest), 3);
  text += "},\"geometry\":{\"type\":\"LineString\",\"coordinates\":[";
  for (std::size_t i = 0; i < route.points.size(); ++i) {
    if (i > 0) text += ',';
    append_position(text, terrain, double(route.points[i].x), double(route.points[i].y));
  }
  text += "]}}";
}

const char* kind_name(NodeKind kind) {
  switch (kind) {
    case NodeKind::bank:
      return "bank";
    case NodeKind::vegetation:
      return "vegetation";
    case NodeKind::prey:
      return "prey";
    case NodeKind::waypoint:
      return "waypoint";
  }
  return "";
}

const ResourceNode* node_of(const MapsSnapshot& snapshot, int level, int node) {
  if (!snapshot.graph || level < 0 || std::size_t(level) >= snapshot.graph->levels.size()) return nullptr;
  const auto& nodes = snapshot.graph->levels[std::size_t(level)].nodes;
  return node >= 0 && std::size_t(node) < nodes.size() ? &nodes[std::size_t(node)] : nullptr;
}

void append_plan(std::string& text, const MapsSnapshot& snapshot, const DailyPlan& plan) {
  text += "{\"level\":" + std::to_string(plan.level) + ",\"herd\":" + std::to_string(plan.herd) + ",\"species\":\"" +
          species_name(snapshot, plan.species) + "\",\"size\":" + std::to_string(plan.size) +
          ",\"followed\":" + (plan.pursuits.empty() ? "null" : std::to_string(plan.pursuits.front().plan)) + ",\n \"pursuits\":[";
  for (std::size_t i = 0; i < plan.pursuits.size(); ++i) {
    const HerdPursuit& pursuit = plan.pursuits[i];
    text += (i > 0 ? ",{\"plan\":" : "{\"plan\":") + std::to_string(pursuit.plan) + ",\"from\":";
    append_number(text, double(pursuit.from), 4);
    text += ",\"until\":";
    append_number(text, double(pursuit.until), 4);
    text += '}';
  }
  text += "],\n \"stops\":[";
  for (std::size_t i = 0; i < plan.stops.size(); ++i) {
    const PlanStop& stop = plan.stops[i];
    if (i > 0) text += ',';
    text += "{\"node\":" + std::to_string(stop.node);
    if (const ResourceNode* node = node_of(snapshot, plan.level, stop.node)) {
      text += std::string(",\"kind\":\"") + kind_name(node->kind) + "\",\"position\":";
      append_position(text, snapshot.terrain(), node->x, node->y);
    }
    text += ",\"arrive\":";
    append_number(text, double(stop.arrive), 4);
    text += ",\"leave\":";
    append_number(text, double(stop.leave), 4);
    text += '}';
  }
  text += "],\n \"way\":[";
  const std::size_t stride = std::max<std::size_t>(1, (plan.way.size() + most_waypoints - 1) / most_waypoints);
  bool first = true;
  for (std::size_t i = 0; i < plan.way.size(); ++i) {
    if (i % stride != 0 && i + 1 != plan.way.size()) continue;
    if (!first) text += ',';
    first = false;
    text += "{\"hour\":";
    append_number(text, double(plan.way[i].hour), 4);
    text += ",\"position\":";
    append_position(text, snapshot.terrain(), double(plan.way[i].at.x), double(plan.way[i].at.y));
    text += '}';
  }
  text += "]}";
}

void append_node(std::string& text, const MapsSnapshot& snapshot, const ResourceNode& node, std::size_t number) {
  text += "{\"node\":" + std::to_string(number) + ",\"kind\":\"" + kind_name(node.kind) + "\"";
  if (node.kind == NodeKind::prey) {
    text += ",\"prey\":\"" + species_name(snapshot, node.group) + "\",\"prey_region\":" + std::to_string(node.prey_region);
  }
  if (node.kind == NodeKind::vegetation) {
    constexpr std::array<const char*, strata> names{"tree", "shrub", "herb"};
    text += std::string(",\"stratum\":\"") + names[std::size_t(std::clamp(node.group, 0, strata - 1))] + "\"";
  }
  text += ",\"area_m2\":";
  append_number(text, node.area, 2);
  text += ",\"cells\":" + std::to_string(node.cells) + ",\"position\":";
  append_position(text, snapshot.terrain(), node.x, node.y);
  text += ",\"piece\":" + std::to_string(node.piece) + ",\"quantities\":[";
  for (std::size_t i = 0; i < node.quantities.size(); ++i) {
    if (i > 0) text += ',';
    text += "{\"species\":\"" + species_name(snapshot, node.quantities[i].species) + "\",\"kg_per_year\":";
    append_number(text, node.quantities[i].kilograms_per_year, 3);
    text += '}';
  }
  text += "],\"built_from\":[";
  for (std::size_t i = 0; i < node.built_from.size(); ++i) {
    if (i > 0) text += ',';
    text += std::to_string(node.built_from[i]);
  }
  text += "]}";
}

void append_edge(std::string& text, const MapsSnapshot& snapshot, const SpatialEdge& edge) {
  text += "{\"from\":" + std::to_string(edge.from) + ",\"to\":" + std::to_string(edge.to) + ",\"species\":\"" +
          species_name(snapshot, edge.species) + "\",\"seconds\":";
  append_number(text, double(edge.seconds), 1);
  text += '}';
}

}  // namespace

std::string trails_geojson(const MapsSnapshot& snapshot) {
  std::string text = "{\"type\":\"FeatureCollection\",\n" + crs_member(snapshot.terrain()) + "\"features\":[\n";
  for (std::size_t i = 0; snapshot.trails && i < snapshot.trails->routes.size(); ++i) {
    if (i > 0) text += ",\n";
    append_route(text, snapshot.terrain(), snapshot.trails->routes[i]);
  }
  return text + "\n]}\n";
}

std::string plans_json(const MapsSnapshot& snapshot) {
  std::string text = "{\"plans\":[\n";
  for (std::size_t i = 0; snapshot.plans && i < snapshot.plans->size(); ++i) {
    if (i > 0) text += ",\n";
    append_plan(text, snapshot, (*snapshot.plans)[i]);
  }
  return text + "\n]}\n";
}

std::string graph_json(const MapsSnapshot& snapshot) {
  std::string text =
      "{\"levels\":[\n{\"level\":0,\"nodes_are_cells\":true,\"cells\":" + std::to_string(snapshot.terrain().height.size()) + "}";
  for (std::size_t i = 1; snapshot.graph && i < snapshot.graph->levels.size(); ++i) {
    const GraphLevel& level = snapshot.graph->levels[i];
    text += ",\n{\"level\":" + std::to_string(level.level) + ",\n\"nodes\":[";
    for (std::size_t n = 0; n < level.nodes.size(); ++n) {
      text += n > 0 ? ",\n" : "\n";
      append_node(text, snapshot, level.nodes[n], n);
    }
    text += "],\n\"edges\":[";
    for (std::size_t e = 0; e < level.edges.size(); ++e) {
      text += e > 0 ? ",\n" : "\n";
      append_edge(text, snapshot, level.edges[e]);
    }
    text += "]}";
  }
  return text + "\n]}\n";
}

}  // namespace biotope

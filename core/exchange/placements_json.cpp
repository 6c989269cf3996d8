#include "core/exchange/placements_json.hpp"

#include <cmath>

#include "core/climate/json_reader.hpp"

namespace biotope {
namespace {

/// Further than this from the map's corner (cells) no drag beyond the border reaches: such a point is damage. Our choice.
constexpr double farthest_point = 1e6;
constexpr Limits radius_limits{0, 1e5};
constexpr Limits discharge_limits{0, 1e6};
constexpr Limits depth_limits{0, 1000};
constexpr Limits weight_limits{0, 1e12};
constexpr Limits hour_limits{0, 48};
constexpr Limits number_limits{0, 1e9};

constexpr std::size_t shortest_line = 2;
constexpr std::size_t shortest_shore = 3;

Json point_to_json(PathPoint point) { return Json::array({tidy_number(point.x), tidy_number(point.y)}); }

/// A list of the items, each as `to_json` writes it; null leaves one out, and an empty list is not written.
template <class Item, class ToJson>
void write_list(Json& json, const char* key, const std::vector<Item>& items, const ToJson& to_json) {
  Json list = Json::array();
  for (const Item& item : items) {
    Json one = to_json(item);
    if (!one.is_null()) list.push_back(std::move(one));
  }
  if (!list.empty()) json[key] = std::move(list);
}

template <class Place>
Json place_to_json(const Place& place) {
  return {{"at", point_to_json(place.at)}, {"radius_m", tidy_number(place.radius)}};
}

Json plan_to_json(const PlanEdit& plan) {
  Json stops = Json::array();
  for (const PlanStopEdit& stop : plan.stops) {
    stops.push_back({{"at", point_to_json(stop.at)}, {"arrive", tidy_number(stop.arrive)}, {"leave", tidy_number(stop.leave)}});
  }
  return {{"species", plan.species}, {"home", point_to_json(plan.home)}, {"number", plan.number}, {"stops", std::move(stops)}};
}

bool is_point(const Json& json) {
  const auto fits = [](const Json& number) { return number.is_number() && std::abs(number.get<double>()) <= farthest_point; };
  return json.is_array() && json.size() == 2 && fits(json[0]) && fits(json[1]);
}

PathPoint point_of(const Json& json) { return {json[0].get<float>(), json[1].get<float>()}; }

void read_point(JsonReader& reader, std::string_view key, PathPoint& point) {
  const std::string_view expected = "a point [x, y] in cells, within a million of the map";
  const Json* const found = reader.value(key, Presence::required, expected);
  if (found == nullptr) return;
  if (!is_point(*found)) return reader.refuse(key, expected, *found);
  point = point_of(*found);
}

void read_points(JsonReader& reader, std::string_view key, std::size_t fewest, std::vector<PathPoint>& points) {
  const std::string expected = "a list of at least " + std::to_string(fewest) + " points [x, y]";
  const Json* const found = reader.value(key, Presence::required, expected);
  if (found == nullptr) return;
  if (!found->is_array() || found->size() < fewest) return reader.refuse(key, expected, *found);
  points.reserve(found->size());
  for (std::size_t i = 0; i < found->size(); ++i) {
    if (!is_point((*found)[i])) {
      return reader.refuse(std::string(key) + "[" + std::to_string(i) + "]",
                           "a point [x, y] in cells, within a million of the map", (*found)[i]);
    }
    points.push_back(point_of((*found)[i]));
  }
}

/// Reads every object of a list that may be missing; `read_one` gets a reader of the object and the item to fill.
class ListReader {
 public:
  ListReader(const Json& json, std::string where, std::string& problem)
      : reader_(json, where, problem), where_(std::move(where)), problem_(problem) {}

  template <class Item, class ReadOne>
  void list(const char* key, std::vector<Item>& items, const ReadOne& read_one) {
    const Json* const found = reader_.value(key, Presence::optional, "a list");
    if (found == nullptr || !reader_.ok()) return;
    if (!found->is_array()) return reader_.refuse(key, "a list [...]", *found);
    for (std::size_t i = 0; i < found->size() && reader_.ok(); ++i) {
      JsonReader one((*found)[i], where_ + ": " + key + "[" + std::to_string(i) + "]", problem_);
      Item item;
      read_one(one, item);
      one.finish();
      items.push_back(std::move(item));
    }
  }
  void finish() { reader_.finish(); }

 private:
  JsonReader reader_;
  std::string where_;
  std::string& problem_;
};

void read_water(ListReader& lists, DrawnWater& water) {
  lists.list("rivers", water.rivers, [](JsonReader& reader, DrawnRiver& river) {
    read_points(reader, "course", shortest_line, river.course);
    reader.number("discharge_m3_s", river.discharge, discharge_limits);
  });
  lists.list("lakes", water.lakes, [](JsonReader& reader, DrawnLake& lake) {
    read_points(reader, "shore", shortest_shore, lake.shore);
    reader.number("depth_m", lake.depth, depth_limits);
  });
}

void read_places(ListReader& lists, Places& places) {
  const auto read_place = [](JsonReader& reader, auto& place) {
    read_point(reader, "at", place.at);
    reader.number("radius_m", place.radius, radius_limits);
  };
  lists.list("fords", places.fords, read_place);
  lists.list("exits", places.exits, read_place);
  lists.list("waypoints", places.waypoints, [](JsonReader& reader, Waypoint& waypoint) {
    read_point(reader, "at", waypoint.at);
    reader.number("attraction", waypoint.attraction, {0, 1});
  });
  lists.list("pinned_trails", places.pinned_trails, [](JsonReader& reader, PinnedTrail& trail) {
    read_points(reader, "points", shortest_line, trail.points);
    reader.number("weight", trail.weight, weight_limits);
  });
  lists.list("forbidden_trails", places.forbidden_trails, [](JsonReader& reader, ForbiddenTrail& trail) {
    read_points(reader, "points", shortest_line, trail.points);
    reader.number("radius_m", trail.radius, radius_limits);
  });
}

void read_stops(JsonReader& reader, const std::string& where, std::string& problem, std::vector<PlanStopEdit>& stops) {
  const Json* const found = reader.value("stops", Presence::required, "a list of stops");
  if (found == nullptr || !reader.ok()) return;
  if (!found->is_array()) return reader.refuse("stops", "a list [...]", *found);
  for (std::size_t i = 0; i < found->size() && reader.ok(); ++i) {
    JsonReader one((*found)[i], where + " stops[" + std::to_string(i) + "]", problem);
    PlanStopEdit stop;
    read_point(one, "at", stop.at);
    one.number("arrive", stop.arrive, {0, 24}, Presence::required);
    one.number("leave", stop.leave, hour_limits, Presence::required);
    one.finish();
    if (one.ok() && stop.leave < stop.arrive) one.refuse("leave", "no earlier than \"arrive\"", (*found)[i]["leave"]);
    stops.push_back(stop);
  }
}

void read_plans(ListReader& lists, const std::string& where, std::string& problem, std::vector<PlanEdit>& plans) {
  std::size_t index = 0;
  lists.list("plans", plans, [&](JsonReader& reader, PlanEdit& plan) {
    reader.text("species", plan.species, Presence::required);
    read_point(reader, "home", plan.home);
    reader.number("number", plan.number, number_limits);
    read_stops(reader, where + ": plans[" + std::to_string(index++) + "]", problem, plan.stops);
  });
}

}  // namespace

Json points_to_json(const std::vector<PathPoint>& points) {
  Json list = Json::array();
  for (const PathPoint& point : points) list.push_back(point_to_json(point));
  return list;
}

Json placements_to_json(const Placements& placements) {
  Json json = Json::object();
  const auto line = [](const std::vector<PathPoint>& points, std::size_t fewest, const char* key, const char* unit,
                       double value) {
    return points.size() < fewest ? Json() : Json{{key, points_to_json(points)}, {unit, value}};
  };
  const auto tidy = [](float value) { return tidy_number(value).get<double>(); };
  write_list(json, "rivers", placements.water.rivers, [&](const DrawnRiver& river) {
    return line(river.course, shortest_line, "course", "discharge_m3_s", river.discharge);
  });
  write_list(json, "lakes", placements.water.lakes,
             [&](const DrawnLake& lake) { return line(lake.shore, shortest_shore, "shore", "depth_m", tidy(lake.depth)); });
  const Places& places = placements.places;
  write_list(json, "fords", places.fords, place_to_json<PlacedFord>);
  write_list(json, "exits", places.exits, place_to_json<PlacedExit>);
  write_list(json, "waypoints", places.waypoints, [](const Waypoint& waypoint) -> Json {
    return {{"at", point_to_json(waypoint.at)}, {"attraction", tidy_number(waypoint.attraction)}};
  });
  write_list(json, "pinned_trails", places.pinned_trails,
             [&](const PinnedTrail& trail) { return line(trail.points, shortest_line, "points", "weight", tidy(trail.weight)); });
  write_list(json, "forbidden_trails", places.forbidden_trails, [&](const ForbiddenTrail& trail) {
    return line(trail.points, shortest_line, "points", "radius_m", tidy(trail.radius));
  });
  write_list(json, "plans", placements.plans, plan_to_json);
  return json;
}

Result<Placements> parse_placements(const Json& json, const std::string& where) {
  std::string problem;
  Placements placements;
  ListReader lists(json, where, problem);
  read_water(lists, placements.water);
  read_places(lists, placements.places);
  read_plans(lists, where, problem, placements.plans);
  lists.finish();
  if (!problem.empty()) return fail(problem);
  return placements;
}

Result<Placements> parse_placements_text(std::string_view text, std::string_view origin) {
  const Result<Json> json = parse_json(text, origin);
  if (!json) return tl::unexpected(json.error());
  return parse_placements(*json, std::string(origin));
}

}  // namespace biotope

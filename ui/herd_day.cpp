#include "ui/herd_day.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "ui/editor_actions.hpp"
#include "ui/format.hpp"

namespace biotope {
namespace {

constexpr float shortest_stay = 0.25F;  // hours
constexpr float hour_steps = 12;        // five minutes

float rounded(float hour) { return std::round(hour * hour_steps) / hour_steps; }

std::optional<NamedHerd> named(const EditorState& state, const PlanEdit& edit) {
  if (!state.shown || !state.shown->web) return std::nullopt;
  return find_planned_herd(edit, *state.shown->web, state.shown->animals);
}

/// The document's day of the chosen herd; the end of the list when it has none.
std::vector<PlanEdit>::const_iterator own_day(const EditorState& state, const std::vector<PlanEdit>& days) {
  if (!state.herd_day.herd) return days.end();
  const PlanEdit& herd = *state.herd_day.herd;
  const auto wanted = named(state, herd);
  return std::find_if(days.begin(), days.end(), [&](const PlanEdit& day) {
    if (day.species != herd.species) return false;
    if (day.home == herd.home && day.number == herd.number) return true;
    return wanted && named(state, day) == wanted;
  });
}

}  // namespace

int herd_near(const MapsSnapshot& maps, const std::vector<bool>& visible_species, double hour, PathPoint at, float reach) {
  if (!maps.plans || !maps.graph) return -1;
  int found = -1;
  double nearest = double(reach);
  for (std::size_t i = 0; i < maps.plans->size(); ++i) {
    const DailyPlan& plan = (*maps.plans)[i];
    const auto species = std::size_t(plan.species);
    if (species < visible_species.size() && !visible_species[species]) continue;
    if (std::size_t(plan.level) >= maps.graph->levels.size()) continue;
    const HerdState where = herd_state(plan, maps.graph->levels[std::size_t(plan.level)], hour, maps.terrain().cell_size);
    const double away = std::hypot(double(where.at.x - at.x), double(where.at.y - at.y));
    if (away >= nearest) continue;
    nearest = away;
    found = int(i);
  }
  return found;
}

const DailyPlan* chosen_plan(const EditorState& state) {
  if (!state.herd_day.herd || !state.shown || !state.shown->plans) return nullptr;
  const auto herd = named(state, *state.herd_day.herd);
  if (!herd || herd->level >= state.shown->animals.size()) return nullptr;
  const int level = state.shown->animals[herd->level]->level;
  for (const DailyPlan& plan : *state.shown->plans) {
    if (plan.level == level && plan.herd == herd->herd) return &plan;
  }
  return nullptr;
}

std::optional<PlanEdit> chosen_day(const EditorState& state) {
  if (!state.herd_day.herd) return std::nullopt;
  if (state.herd_day.preview) return state.herd_day.preview;
  const auto& days = state.document.placements.plans;
  if (const auto own = own_day(state, days); own != days.end()) return *own;
  const DailyPlan* plan = chosen_plan(state);
  return plan != nullptr ? edit_of_plan(*plan, *state.shown->web, state.shown->animals) : state.herd_day.herd;
}

bool day_is_edited(const EditorState& state) {
  const auto& days = state.document.placements.plans;
  return own_day(state, days) != days.end();
}

PathPoint stop_place(const EditorState& state, const PlanEdit& day, std::size_t stop) {
  const DailyPlan* plan = state.herd_day.preview ? nullptr : chosen_plan(state);
  if (plan == nullptr || plan->pursuits.empty() || plan->stops.size() != day.stops.size()) return day.stops[stop].at;
  const double middle = 0.5 * (double(plan->stops[stop].arrive) + double(plan->stops[stop].leave));
  return herd_state(*plan, state.shown->graph->levels[std::size_t(plan->level)], middle, state.shown->terrain().cell_size).at;
}

bool choose_herd(EditorState& state, PathPoint at, float reach) {
  if (!state.shown || !state.shown->web) return false;
  const int index = herd_near(*state.shown, state.view.visible_species, state.clock.hour, at, reach);
  if (index < 0) return false;
  const DailyPlan& plan = (*state.shown->plans)[std::size_t(index)];
  auto edit = edit_of_plan(plan, *state.shown->web, state.shown->animals);
  if (!edit) return false;
  state.herd_day = {};
  state.herd_day.herd = std::move(edit);
  return true;
}

void forget_herd(EditorState& state) { state.herd_day = {}; }

void change_day(EditorState& state, const std::string& name, const std::function<void(PlanEdit&)>& change) {
  auto day = chosen_day(state);
  if (!day) return;
  change(*day);
  change_document(state, name, [&state, &day](Document& document) {
    auto& days = document.placements.plans;
    const auto own = own_day(state, days);
    if (own == days.end()) {
      days.push_back(*day);
    } else {
      days[std::size_t(own - days.begin())] = *day;
    }
  });
}

void restore_day(EditorState& state) {
  change_document(state, "Computed day", [&](Document& document) {
    auto& days = document.placements.plans;
    if (const auto own = own_day(state, days); own != days.end()) days.erase(own);
  });
}

void add_stop(PlanEdit& day, PathPoint at, double hour) {
  const float arrive = rounded(float(hour));
  PlanStopEdit stop{at, arrive, arrive + 1};
  const auto after = std::find_if(day.stops.begin(), day.stops.end(), [&](const auto& other) { return other.arrive > arrive; });
  const auto place = std::size_t(after - day.stops.begin());
  // The stop before makes room; one that follows soon is not run over.
  if (place > 0)
    day.stops[place - 1].leave =
        std::min(day.stops[place - 1].leave, std::max(arrive, day.stops[place - 1].arrive + shortest_stay));
  if (place < day.stops.size()) stop.leave = std::clamp(day.stops[place].arrive, arrive + shortest_stay, stop.leave);
  day.stops.insert(day.stops.begin() + std::ptrdiff_t(place), stop);
}

void swap_stops(PlanEdit& day, std::size_t a, std::size_t b) { std::swap(day.stops[a].at, day.stops[b].at); }

void set_hours(PlanEdit& day, std::size_t stop, float arrive, float leave) {
  const float from = stop > 0 ? day.stops[stop - 1].leave : 0;
  const float until = stop + 1 < day.stops.size() ? day.stops[stop + 1].arrive : std::max(24.0F, day.stops[stop].leave);
  if (until - from < shortest_stay) return;
  arrive = std::clamp(rounded(arrive), from, until - shortest_stay);
  day.stops[stop].arrive = arrive;
  day.stops[stop].leave = std::clamp(rounded(leave), arrive + shortest_stay, until);
}

const char* activity_word(HerdActivity activity) {
  static constexpr std::array<const char*, 5> words{"resting", "drinking", "feeding", "walking", "hunting"};
  return words[std::size_t(activity)];
}

std::string resource_name(const MapsSnapshot& maps, int level, int node) {
  if (!maps.graph || std::size_t(level) >= maps.graph->levels.size() || node < 0) return "nothing";
  const auto& nodes = maps.graph->levels[std::size_t(level)].nodes;
  if (std::size_t(node) >= nodes.size()) return "nothing";
  const ResourceNode& resource = nodes[std::size_t(node)];
  const std::string hectares = ", " + format_value(resource.area / 10000, "ha");
  switch (resource.kind) {
    case NodeKind::bank:
      return "Water";
    case NodeKind::waypoint:
      return "Waypoint";
    case NodeKind::prey:
      return display_name(maps.web->species[std::size_t(resource.group)]) + hectares;
    case NodeKind::vegetation: {
      const auto most =
          std::max_element(resource.quantities.begin(), resource.quantities.end(),
                           [](const auto& a, const auto& b) { return a.kilograms_per_year < b.kilograms_per_year; });
      if (most == resource.quantities.end()) return "Plants" + hectares;
      return display_name(maps.web->species[std::size_t(most->species)]) + hectares;
    }
  }
  return "nothing";
}

std::string herd_name(const MapsSnapshot& maps, int plan) {
  if (!maps.plans || !maps.web || plan < 0 || std::size_t(plan) >= maps.plans->size()) return "nobody";
  const int species = (*maps.plans)[std::size_t(plan)].species;
  const auto number = std::count_if(maps.plans->begin(), maps.plans->begin() + plan + 1,
                                    [&](const DailyPlan& other) { return other.species == species; });
  return display_name(maps.web->species[std::size_t(species)]) + " " + std::to_string(number);
}

std::string stop_name(const MapsSnapshot& maps, const DailyPlan& plan, const PlanStop& stop) {
  if (plan.pursuits.empty()) return resource_name(maps, plan.level, stop.node);
  const bool known = maps.graph && std::size_t(plan.level) < maps.graph->levels.size() && stop.node >= 0 &&
                     std::size_t(stop.node) < maps.graph->levels[std::size_t(plan.level)].nodes.size();
  if (!known || maps.graph->levels[std::size_t(plan.level)].nodes[std::size_t(stop.node)].kind != NodeKind::prey)
    return resource_name(maps, plan.level, stop.node);
  const HerdPursuit* pursuit = pursuit_at(plan, 0.5 * (double(stop.arrive) + double(stop.leave)));
  return pursuit == nullptr ? "Resting place" : herd_name(maps, pursuit->plan);
}

std::string pursuit_text(const MapsSnapshot& maps, const DailyPlan& plan, double hour) {
  if (plan.pursuits.empty()) return {};
  std::vector<int> herds;
  for (const HerdPursuit& pursuit : plan.pursuits) {
    if (std::find(herds.begin(), herds.end(), pursuit.plan) == herds.end()) herds.push_back(pursuit.plan);
  }
  const HerdPursuit* now = pursuit_at(plan, hour);
  const std::string following = now == nullptr
                                    ? "Follows no herd now"
                                    : "Follows " + herd_name(maps, now->plan) + " until " + format_clock(double(now->until));
  return following + "; " + (herds.size() == 1 ? "one herd" : std::to_string(herds.size()) + " herds") + " in its day";
}

int node_near(const MapsSnapshot& maps, int level, PathPoint at) {
  if (!maps.graph || std::size_t(level) >= maps.graph->levels.size()) return -1;
  const auto& nodes = maps.graph->levels[std::size_t(level)].nodes;
  int found = -1;
  double nearest = std::numeric_limits<double>::max();
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    const double away = std::hypot(double(nodes[i].x) - double(at.x), double(nodes[i].y) - double(at.y));
    if (away >= nearest) continue;
    nearest = away;
    found = int(i);
  }
  return found;
}

bool press_day(EditorState& state, PathPoint at, float reach) {
  HerdDay& own = state.herd_day;
  const auto day = chosen_day(state);
  if (!day) return false;
  if (own.adding) {
    own.adding = false;
    change_day(state, "Add a stop", [&](PlanEdit& edit) { add_stop(edit, at, state.clock.hour); });
    return true;
  }
  float nearest = reach * 1.3F;
  for (std::size_t i = 0; i < day->stops.size(); ++i) {
    const PathPoint place = stop_place(state, *day, i);
    const float away = std::hypot(place.x - at.x, place.y - at.y);
    if (away >= nearest) continue;
    nearest = away;
    own.held_stop = int(i);
  }
  return own.held_stop >= 0;
}

void drag_day(EditorState& state, PathPoint at) {
  HerdDay& own = state.herd_day;
  auto day = chosen_day(state);
  if (!day || own.held_stop < 0 || std::size_t(own.held_stop) >= day->stops.size()) return;
  // A stop stays on the map, wherever the pointer goes.
  const Grid<float>& height = state.document.terrain->height;
  day->stops[std::size_t(own.held_stop)].at = {std::clamp(at.x, 0.0F, float(height.width() - 1)),
                                               std::clamp(at.y, 0.0F, float(height.height() - 1))};
  own.preview = std::move(day);
}

void release_day(EditorState& state) {
  HerdDay& own = state.herd_day;
  own.held_stop = -1;
  if (!own.preview) return;
  const PlanEdit moved = std::move(*own.preview);
  own.preview.reset();
  change_day(state, "Move a stop", [&](PlanEdit& day) { day.stops = moved.stops; });
}

}  // namespace biotope

#include "ui/herd_needs.hpp"

#include <algorithm>
#include <cctype>
#include <cmath>

#include "ui/herd_day.hpp"

namespace biotope {
namespace {

/// Hours from one hour of the day to another, 0..24.
double hours_until(double from, double to) {
  const double rest = std::fmod(to - from, 24.0);
  return rest < 0 ? rest + 24 : rest;
}

bool lies_within(const PlanStop& stop, double hour) {
  return hours_until(double(stop.arrive), hour) < double(stop.leave) - double(stop.arrive);
}

std::string capital(std::string text) {
  if (!text.empty()) text[0] = char(std::toupper(static_cast<unsigned char>(text[0])));
  std::replace(text.begin(), text.end(), '-', ' ');
  return text;
}

bool offers(const ResourceNode& node, const std::vector<int>& foods) {
  const auto eaten = [&](int species) { return std::find(foods.begin(), foods.end(), species) != foods.end(); };
  if (node.kind == NodeKind::prey) return eaten(node.group);
  if (node.kind != NodeKind::vegetation) return false;
  return std::any_of(node.quantities.begin(), node.quantities.end(),
                     [&](const ResourceQuantity& quantity) { return quantity.available > 0 && eaten(quantity.species); });
}

/// Whether painted numbers of the herd's species want more of these foods (or water) in its region than there is.
bool lacks(const MapsSnapshot& maps, const DailyPlan& plan, const std::string& need, const std::vector<int>& foods) {
  for (const auto& level : maps.animals) {
    if (!level || level->level != plan.level || std::size_t(plan.herd) >= level->herds.size()) continue;
    const int region = level->herds[std::size_t(plan.herd)].region;
    for (const AnimalLevel::Shortage& shortage : level->shortages) {
      if (shortage.species != plan.species || shortage.region != region) continue;
      const bool named = shortage.resource == need || std::any_of(foods.begin(), foods.end(), [&](int food) {
                           return maps.web->species[std::size_t(food)].name == shortage.resource;
                         });
      if (named) return true;
    }
  }
  return false;
}

template <class Offers>
HerdNeed need_of(const DailyPlan& plan, const GraphLevel& graph, double hour, std::string name, const Offers& gives) {
  HerdNeed need;
  need.name = std::move(name);
  std::vector<int> visited;
  for (const PlanStop& stop : plan.stops) {
    if (stop.node < 0 || std::size_t(stop.node) >= graph.nodes.size() || !gives(graph.nodes[std::size_t(stop.node)])) continue;
    need.hours += double(stop.leave) - double(stop.arrive);
    need.now = need.now || lies_within(stop, hour);
    if (std::find(visited.begin(), visited.end(), stop.node) == visited.end()) visited.push_back(stop.node);
  }
  need.places = int(visited.size());
  return need;
}

/// Who follows herds it lives on has its prey at hand as long as it follows them: places are herds.
void count_pursuits(const MapsSnapshot& maps, const DailyPlan& plan, double hour, const std::vector<int>& foods, HerdNeed& need) {
  if (!maps.plans) return;
  const HerdPursuit* now = pursuit_at(plan, hour);
  std::vector<int> herds;
  double hours = 0;
  for (const HerdPursuit& pursuit : plan.pursuits) {
    if (pursuit.plan < 0 || std::size_t(pursuit.plan) >= maps.plans->size()) continue;
    const int prey = (*maps.plans)[std::size_t(pursuit.plan)].species;
    if (std::find(foods.begin(), foods.end(), prey) == foods.end()) continue;
    hours += double(pursuit.until) - double(pursuit.from);
    need.now = need.now || &pursuit == now;
    if (std::find(herds.begin(), herds.end(), pursuit.plan) == herds.end()) herds.push_back(pursuit.plan);
  }
  if (herds.empty()) return;
  need.herds = need.places = int(herds.size());
  need.hours = hours;
}

/// Where the herd is or goes to, and when it gets or leaves there.
void find_next(const MapsSnapshot& maps, const DailyPlan& plan, double hour, HerdOutlook& out) {
  const PlanStop* next = nullptr;
  double soonest = 25;
  for (const PlanStop& stop : plan.stops) {
    if (lies_within(stop, hour)) {
      out.where = stop_name(maps, plan, stop);
      out.until = std::fmod(double(stop.leave), 24.0);
      return;
    }
    const double wait = hours_until(hour, double(stop.arrive));
    if (wait >= soonest) continue;
    soonest = wait;
    next = &stop;
  }
  if (next == nullptr) return;
  out.where = stop_name(maps, plan, *next);
  out.until = std::fmod(double(next->arrive), 24.0);
}

}  // namespace

HerdOutlook herd_outlook(const MapsSnapshot& maps, const DailyPlan& plan, double hour) {
  HerdOutlook out;
  if (!maps.web || !maps.graph || std::size_t(plan.level) >= maps.graph->levels.size()) return out;
  const GraphLevel& graph = maps.graph->levels[std::size_t(plan.level)];
  out.doing = activity_word(herd_state(plan, graph, hour, maps.terrain().cell_size).activity);
  for (const DailyPlan::Span& span : plan.active) out.awake += double(span.until) - double(span.from);
  find_next(maps, plan, hour, out);
  const auto species = std::size_t(plan.species);
  const AnimalTraits& traits = maps.web->species[species].animal();
  if (traits.water_visits > 0) {
    out.needs.push_back(
        need_of(plan, graph, hour, "Water", [](const ResourceNode& node) { return node.kind == NodeKind::bank; }));
    out.needs.back().short_supply = lacks(maps, plan, "water", {});
  }
  const auto& diet = maps.web->diets[species];
  for (std::size_t i = 0; i < diet.size() && i < traits.diet.size(); ++i) {
    const std::vector<int>& foods = diet[i].foods;
    HerdNeed need =
        need_of(plan, graph, hour, capital(traits.diet[i].name), [&](const ResourceNode& node) { return offers(node, foods); });
    need.short_supply = lacks(maps, plan, traits.diet[i].name, foods);
    count_pursuits(maps, plan, hour, foods, need);
    out.needs.push_back(std::move(need));
  }
  return out;
}

}  // namespace biotope

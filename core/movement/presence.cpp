#include <algorithm>

#include "core/movement/trails.hpp"

namespace biotope {
namespace {

/// Share of its stays that a species spends drinking: 7.5 % a visit, at most 30 % (two visits: 15 %; the 2021 authors take a
/// fixed 20 %). Our choice.
double water_share(const AnimalTraits& animal) { return std::min(0.3, 0.075 * animal.water_visits); }

/// Share of all stays that waypoints get together, at most. Our choice.
constexpr double most_at_waypoints = 0.5;

double waypoint_attraction(const ResourceNode& node) {
  return node.kind == NodeKind::waypoint ? std::clamp(double(node.attraction), 0.0, 1.0) : 0.0;
}

/// What a node offers to a need: its foods, weighted by preference; kg per year.
double offered(const ResourceNode& node, const FoodWeb::ResolvedNeed& need) {
  double sum = 0;
  for (const ResourceQuantity& quantity : node.quantities) {
    for (std::size_t food = 0; food < need.foods.size(); ++food) {
      if (need.foods[food] == quantity.species) sum += quantity.kilograms_per_year * double(need.preferences[food]);
    }
  }
  return sum;
}

}  // namespace

int region_of_node(const AnimalLevel& level, int species_index, const ResourceNode& node) {
  const auto species = std::size_t(species_index);
  if (node.piece >= 0 && level.partition && std::size_t(node.piece) < level.partition->pieces.size()) {
    return level.partition->pieces[std::size_t(node.piece)].region[species];
  }
  return level.regions[species]->label(node.x, node.y);
}

std::vector<LevelTravel::Presence> presence_in_region(const FoodWeb& web, const AnimalLevel& level, int species_index,
                                                      int region) {
  const auto number = std::size_t(level.species[std::size_t(species_index)]);
  const AnimalTraits& animal = web.species[number].animal();
  const auto& nodes = level.graph->nodes;
  std::vector<int> inside;
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    if (region_of_node(level, species_index, nodes[i]) == region) inside.push_back(int(i));
  }
  // A person's paint on the density says where in the region the herd would rather be.
  const bool drawn =
      std::size_t(species_index) < level.attraction.size() && !level.attraction[std::size_t(species_index)].empty();
  const auto attraction = [&](int node) {
    return drawn ? double(level.attraction[std::size_t(species_index)][std::size_t(node)]) : 1.0;
  };
  std::vector<double> probability(inside.size(), 0.0);
  const auto share_out = [&](double share, const auto& quantity_at) {
    double total = 0;
    std::vector<double> quantity(inside.size());
    for (std::size_t i = 0; i < inside.size(); ++i) {
      quantity[i] = quantity_at(nodes[std::size_t(inside[i])]) * attraction(inside[i]);
      total += quantity[i];
    }
    if (total <= 0) return;
    for (std::size_t i = 0; i < inside.size(); ++i) probability[i] += share * quantity[i] / total;
  };
  double amount = 0;
  for (const auto& need : web.diets[number]) amount += double(need.amount);
  const double water = water_share(animal);
  for (const auto& need : web.diets[number]) {
    if (amount <= 0) break;
    share_out((1 - water) * double(need.amount) / amount, [&](const ResourceNode& node) { return offered(node, need); });
  }
  share_out(water, [](const ResourceNode& node) { return node.kind == NodeKind::bank ? node.area : 0.0; });

  // A need that nothing in the region meets leaves its share to the others: the animal is somewhere.
  double sum = 0;
  for (const double p : probability) sum += p;
  std::vector<LevelTravel::Presence> presence;
  if (sum <= 0) return presence;
  double waypoints = 0;
  for (const int node : inside) waypoints += waypoint_attraction(nodes[std::size_t(node)]);
  const double at_waypoints = std::min(most_at_waypoints, waypoints);
  for (std::size_t i = 0; i < inside.size(); ++i) {
    const double drawn_by = waypoint_attraction(nodes[std::size_t(inside[i])]);
    const double p = drawn_by > 0 ? drawn_by * at_waypoints / waypoints : probability[i] / sum * (1 - at_waypoints);
    if (p > 0) presence.push_back({inside[i], float(p)});
  }
  return presence;
}

}  // namespace biotope

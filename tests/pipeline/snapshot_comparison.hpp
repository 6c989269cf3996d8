#pragma once

#include <catch2/catch.hpp>

#include <string>

#include "core/pipeline/maps_snapshot.hpp"

namespace biotope {

/// Finds what differs between two snapshots; everything is compared to the bit.
class SnapshotComparison {
 public:
  SnapshotComparison(const MapsSnapshot& a, const MapsSnapshot& b) {
    land(a, b);
    plants(a, b);
    same("number of animal levels", a.animals.size() == b.animals.size());
    for (std::size_t i = 0; first_.empty() && i < a.animals.size(); ++i) animals(*a.animals[i], *b.animals[i]);
    same("number of graph levels", a.graph->levels.size() == b.graph->levels.size());
    for (std::size_t i = 0; first_.empty() && i < a.graph->levels.size(); ++i) graph(a.graph->levels[i], b.graph->levels[i]);
    for (std::size_t i = 0; first_.empty() && i < a.movement.size(); ++i) movement(a.movement[i], b.movement[i]);
    if (first_.empty()) trails(*a.trails, *b.trails);
    same("number of plans", a.plans->size() == b.plans->size());
    for (std::size_t i = 0; first_.empty() && i < a.plans->size(); ++i) plan((*a.plans)[i], (*b.plans)[i]);
    same("warnings", a.warnings == b.warnings);
  }
  /// What differs first, in the order of computation; empty when nothing does.
  [[nodiscard]] const std::string& first() const { return first_; }

 private:
  void same(const std::string& what, bool equal) {
    if (!equal && first_.empty()) first_ = what;
  }

  void land(const MapsSnapshot& a, const MapsSnapshot& b) {
    same("ground", a.terrain().height == b.terrain().height);
    same("slopes", a.derivatives->slope == b.derivatives->slope);
    same("catchment areas", a.hydrology->catchment_area == b.hydrology->catchment_area);
    same("discharge", a.hydrology->discharge == b.hydrology->discharge);
    same("water depth", a.hydrology->water_depth == b.hydrology->water_depth);
    same("receivers of water", a.hydrology->receiver == b.hydrology->receiver);
    for (std::size_t r = 0; r < monthly_resources; ++r) {
      const auto& one = a.environment->monthly[r];
      const auto& other = b.environment->monthly[r];
      same("environment", one.offset == other.offset && one.layers.size() == other.layers.size());
      for (std::size_t i = 0; first_.empty() && i < one.layers.size(); ++i)
        same("environment", *one.layers[i] == *other.layers[i]);
    }
    same("soil texture", *a.environment->texture == *b.environment->texture);
    same("geology", *a.environment->geology == *b.environment->geology);
  }

  void plants(const MapsSnapshot& a, const MapsSnapshot& b) {
    same("number of plants", a.cover.size() == b.cover.size());
    for (std::size_t i = 0; first_.empty() && i < a.cover.size(); ++i) {
      same("computed cover of plant " + std::to_string(i), *a.computed_cover[i] == *b.computed_cover[i]);
      same("cover of plant " + std::to_string(i), *a.cover[i] == *b.cover[i]);
    }
    same("tree cover", *a.tree_cover == *b.tree_cover);
    same("shares of plants", a.plant_achieved == b.plant_achieved && a.plant_desired == b.plant_desired);
  }

  void animals(const AnimalLevel& a, const AnimalLevel& b) {
    const std::string level = "level " + std::to_string(a.level) + ": ";
    same(level + "species", a.species == b.species);
    same(level + "partition", a.partition->label == b.partition->label);
    for (std::size_t i = 0; first_.empty() && i < a.species.size(); ++i) {
      same(level + "regions",
           a.regions[i]->label == b.regions[i]->label && a.regions[i]->regions.size() == b.regions[i]->regions.size());
    }
    same(level + "available", a.available == b.available);
    same(level + "computed population", a.computed_population == b.computed_population);
    same(level + "population", a.population == b.population);
    same(level + "attraction", a.attraction == b.attraction);
    same(level + "eaten", a.eaten == b.eaten);
    same(level + "shares", a.desired == b.desired && a.achieved == b.achieved);
    same(level + "herds", a.herds.size() == b.herds.size() &&
                              std::equal(a.herds.begin(), a.herds.end(), b.herds.begin(), [](const Herd& x, const Herd& y) {
                                return x.species == y.species && x.region == y.region && x.size == y.size;
                              }));
    same(level + "prey", a.prey.size() == b.prey.size() &&
                             std::equal(a.prey.begin(), a.prey.end(), b.prey.begin(), [](const auto& x, const auto& y) {
                               return x.species == y.species && x.region == y.region && x.piece == y.piece &&
                                      x.available == y.available;
                             }));
    same(level + "shortages",
         a.shortages.size() == b.shortages.size() &&
             std::equal(a.shortages.begin(), a.shortages.end(), b.shortages.begin(), [](const auto& x, const auto& y) {
               return x.species == y.species && x.region == y.region && x.resource == y.resource && x.missing == y.missing;
             }));
    same(level + "warnings", a.warnings == b.warnings);
  }

  static bool same_node(const ResourceNode& a, const ResourceNode& b) {
    const auto same_quantity = [](const ResourceQuantity& x, const ResourceQuantity& y) {
      return x.species == y.species && x.kilograms_per_year == y.kilograms_per_year && x.available == y.available;
    };
    return a.kind == b.kind && a.group == b.group && a.cells == b.cells && a.bounds == b.bounds && a.centroid_x == b.centroid_x &&
           a.centroid_y == b.centroid_y && a.x == b.x && a.y == b.y && a.piece == b.piece && a.attraction == b.attraction &&
           a.prey_region == b.prey_region && a.built_from == b.built_from &&
           std::equal(a.quantities.begin(), a.quantities.end(), b.quantities.begin(), b.quantities.end(), same_quantity);
  }

  void graph(const GraphLevel& a, const GraphLevel& b) {
    const std::string level = "graph of level " + std::to_string(a.level) + ": ";
    same(level + "nodes", std::equal(a.nodes.begin(), a.nodes.end(), b.nodes.begin(), b.nodes.end(), same_node));
    same(level + "edges", std::equal(a.edges.begin(), a.edges.end(), b.edges.begin(), b.edges.end(),
                                     [](const SpatialEdge& x, const SpatialEdge& y) {
                                       return x.from == y.from && x.to == y.to && x.species == y.species &&
                                              x.seconds == y.seconds;
                                     }));
    for (std::size_t i = 0; i < a.node_of_cell.size(); ++i) {
      if (!a.node_of_cell[i] && !b.node_of_cell[i]) continue;
      same(level + "cells of nodes", *a.node_of_cell[i] == *b.node_of_cell[i]);
    }
  }

  void movement(const LevelMovement& a, const LevelMovement& b) {
    const LevelTravel& one = *a.travel;
    const LevelTravel& other = *b.travel;
    same("vertices of nodes", one.vertex_of_node == other.vertex_of_node && one.graph_of_species == other.graph_of_species);
    same("onward probabilities", one.onward == other.onward);
    same("presence", one.presence.size() == other.presence.size());
    for (std::size_t s = 0; first_.empty() && s < one.presence.size(); ++s) {
      same("presence", one.presence[s].size() == other.presence[s].size());
      for (std::size_t r = 0; first_.empty() && r < one.presence[s].size(); ++r) {
        const auto& x = one.presence[s][r];
        const auto& y = other.presence[s][r];
        same("presence", std::equal(x.begin(), x.end(), y.begin(), y.end(), [](const auto& p, const auto& q) {
               return p.node == q.node && p.probability == q.probability;
             }));
      }
    }
  }

  void trails(const TrailNetwork& a, const TrailNetwork& b) {
    same("number of trails", a.routes.size() == b.routes.size());
    for (std::size_t i = 0; first_.empty() && i < a.routes.size(); ++i) {
      same("trails", a.routes[i].points == b.routes[i].points && a.routes[i].weight == b.routes[i].weight &&
                         a.routes[i].length == b.routes[i].length);
    }
    same("wear", a.wear == b.wear);
    same("carving", a.carving == b.carving);
  }

  void plan(const DailyPlan& a, const DailyPlan& b) {
    same("herds of plans",
         a.level == b.level && a.herd == b.herd && a.species == b.species && a.size == b.size && a.pursuits == b.pursuits);
    same("edits of plans",
         a.edited == b.edited && a.unreachable_stops == b.unreachable_stops && a.shifted_stops == b.shifted_stops);
    same("stops of plans",
         std::equal(a.stops.begin(), a.stops.end(), b.stops.begin(), b.stops.end(), [](const PlanStop& x, const PlanStop& y) {
           return x.node == y.node && x.arrive == y.arrive && x.leave == y.leave;
         }));
    same("ways of plans", std::equal(a.way.begin(), a.way.end(), b.way.begin(), b.way.end(),
                                     [](const auto& x, const auto& y) { return x.hour == y.hour && x.at == y.at; }));
  }

  std::string first_;
};

/// What differs first between two snapshots; empty when nothing does.
inline std::string first_difference(const MapsSnapshot& a, const MapsSnapshot& b) { return SnapshotComparison(a, b).first(); }

/// Requires that two snapshots hold the same results to the bit.
inline void require_same(const MapsSnapshot& a, const MapsSnapshot& b) { REQUIRE(first_difference(a, b) == ""); }

}  // namespace biotope

#pragma once

#include <catch2/catch.hpp>

#include "core/pipeline/maps_snapshot.hpp"

namespace biotope {

/// Requires that two snapshots hold the same results to the bit.
inline void require_same_plants(const MapsSnapshot& a, const MapsSnapshot& b) {
  REQUIRE(a.hydrology->catchment_area == b.hydrology->catchment_area);
  REQUIRE(a.hydrology->water_depth == b.hydrology->water_depth);
  REQUIRE(a.hydrology->receiver == b.hydrology->receiver);
  for (std::size_t r = 0; r < monthly_resources; ++r) {
    REQUIRE(a.environment->monthly[r].offset == b.environment->monthly[r].offset);
    REQUIRE(a.environment->monthly[r].layers.size() == b.environment->monthly[r].layers.size());
    for (std::size_t i = 0; i < a.environment->monthly[r].layers.size(); ++i) {
      REQUIRE(*a.environment->monthly[r].layers[i] == *b.environment->monthly[r].layers[i]);
    }
  }
  REQUIRE(*a.environment->texture == *b.environment->texture);
  REQUIRE(*a.environment->geology == *b.environment->geology);
  REQUIRE(a.cover.size() == b.cover.size());
  for (std::size_t i = 0; i < a.cover.size(); ++i) {
    REQUIRE(*a.computed_cover[i] == *b.computed_cover[i]);
    REQUIRE(*a.cover[i] == *b.cover[i]);
  }
  REQUIRE(*a.tree_cover == *b.tree_cover);
  REQUIRE(a.plant_achieved == b.plant_achieved);
}

inline void require_same_animals(const MapsSnapshot& a, const MapsSnapshot& b) {
  REQUIRE(a.animals.size() == b.animals.size());
  for (std::size_t level = 0; level < a.animals.size(); ++level) {
    const AnimalLevel& one = *a.animals[level];
    const AnimalLevel& other = *b.animals[level];
    REQUIRE(one.partition->label == other.partition->label);
    for (std::size_t s = 0; s < one.species.size(); ++s) REQUIRE(one.regions[s]->label == other.regions[s]->label);
    REQUIRE(one.computed_population == other.computed_population);
    REQUIRE(one.population == other.population);
    REQUIRE(one.eaten == other.eaten);
    REQUIRE(one.herds.size() == other.herds.size());
    for (std::size_t h = 0; h < one.herds.size(); ++h) {
      REQUIRE(one.herds[h].species == other.herds[h].species);
      REQUIRE(one.herds[h].region == other.herds[h].region);
      REQUIRE(one.herds[h].size == other.herds[h].size);
    }
  }
}

inline void require_same_movement(const MapsSnapshot& a, const MapsSnapshot& b) {
  REQUIRE(a.graph->levels.size() == b.graph->levels.size());
  for (std::size_t level = 0; level < a.graph->levels.size(); ++level) {
    const auto& one = a.graph->levels[level];
    const auto& other = b.graph->levels[level];
    REQUIRE(one.nodes.size() == other.nodes.size());
    REQUIRE(one.edges.size() == other.edges.size());
    for (std::size_t e = 0; e < one.edges.size(); ++e) {
      REQUIRE(one.edges[e].from == other.edges[e].from);
      REQUIRE(one.edges[e].to == other.edges[e].to);
      REQUIRE(one.edges[e].seconds == other.edges[e].seconds);
    }
  }
  REQUIRE(a.trails->wear == b.trails->wear);
  REQUIRE(a.trails->carving == b.trails->carving);
  REQUIRE(a.trails->routes.size() == b.trails->routes.size());
  REQUIRE(a.plans->size() == b.plans->size());
  for (std::size_t p = 0; p < a.plans->size(); ++p) {
    const DailyPlan& one = (*a.plans)[p];
    const DailyPlan& other = (*b.plans)[p];
    REQUIRE(one.followed == other.followed);
    REQUIRE(one.stops.size() == other.stops.size());
    REQUIRE(one.way.size() == other.way.size());
    for (std::size_t w = 0; w < one.way.size(); ++w) {
      REQUIRE(one.way[w].hour == other.way[w].hour);
      REQUIRE(one.way[w].at.x == other.way[w].at.x);
      REQUIRE(one.way[w].at.y == other.way[w].at.y);
    }
  }
}

inline void require_same(const MapsSnapshot& a, const MapsSnapshot& b) {
  require_same_plants(a, b);
  require_same_animals(a, b);
  require_same_movement(a, b);
}

}  // namespace biotope

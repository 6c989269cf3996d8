#pragma once

#include <map>
#include <memory>
#include <vector>

#include "core/pipeline/maps_snapshot.hpp"

namespace biotope {

/// What the species list says about one species; NaN where it is not known yet.
struct SpeciesFigures {
  /// Mean covered fraction of a plant; individuals of an animal.
  double amount = 0;
  /// kg / year of a plant, individuals / year of an animal.
  double growth = 0;
  double eaten = 0;
  /// Shares of the level; desired is NaN when none is asked.
  double desired = 0;
  double achieved = 0;
  int herds = 0;
  int regions = 0;
  [[nodiscard]] double surplus() const { return growth - eaten; }
};

/// Figures of every species of the web, by species number. Reads whole maps: call it off the window's thread.
[[nodiscard]] std::vector<SpeciesFigures> species_figures(const MapsSnapshot& snapshot);

/// Where a species was painted beyond what resources allow, by species number: coverage 1 in those regions.
using ShortageMaps = std::map<int, std::shared_ptr<const PaintLayer>>;
[[nodiscard]] ShortageMaps shortage_maps(const MapsSnapshot& snapshot);

}  // namespace biotope

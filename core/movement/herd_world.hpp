#pragma once

#include <cmath>
#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "core/movement/daily_plan.hpp"

namespace biotope {

/// A place in metres east and north of the terrain's south-west corner, or a difference of two.
struct Place {
  double x = 0;
  double y = 0;
  bool operator==(const Place&) const = default;
};
[[nodiscard]] constexpr Place operator+(Place a, Place b) { return {a.x + b.x, a.y + b.y}; }
[[nodiscard]] constexpr Place operator-(Place a, Place b) { return {a.x - b.x, a.y - b.y}; }
[[nodiscard]] constexpr Place operator*(Place a, double s) { return {a.x * s, a.y * s}; }
[[nodiscard]] constexpr double dot(Place a, Place b) { return a.x * b.x + a.y * b.y; }
/// Of metres within a map: nothing that std::hypot's care for the largest and smallest numbers is needed for.
[[nodiscard]] inline double length(Place a) { return std::sqrt(dot(a, a)); }
/// `a` shortened or stretched to 1; `otherwise` where it has no direction.
[[nodiscard]] inline Place unit_of(Place a, Place otherwise = {0, 1}) {
  const double metres = length(a);
  return metres > 1e-9 ? a * (1 / metres) : otherwise;
}
/// 0 below `low`, 1 above `high`, smooth between.
[[nodiscard]] constexpr double smooth_step(double low, double high, double value) {
  const double t = (value - low) / (high - low);
  const double c = t < 0 ? 0 : t > 1 ? 1 : t;
  return c * c * (3 - 2 * c);
}

/// The foot of a tree's trunk.
struct Stem {
  Place at;
  double radius = 0;  ///< m
  bool operator==(const Stem&) const = default;
};

/// What animals heed that is finer than the terrain's cells. Asked from several threads; an answer never changes.
class HerdDetails {
 public:
  virtual ~HerdDetails() = default;
  /// Metres from the nearest shore, positive in water, where water is drawn finer than the terrain's cells; nothing where it is
  /// not.
  [[nodiscard]] virtual std::optional<float> shore(Place place) const = 0;
  /// Appends the trunks whose middle is within low <= middle < high, in an order that depends on the rectangle alone.
  virtual void stems(Place low, Place high, std::vector<Stem>& stems) const = 0;
  /// Whether another one answers the same within a rectangle.
  [[nodiscard]] virtual bool same_within(const HerdDetails& other, Place low, Place high) const = 0;
};

/// What individual animals need to know of a landscape: a value, shared and never changed.
struct HerdWorld {
  std::shared_ptr<const FoodWeb> web;
  Ground ground;
  std::vector<std::shared_ptr<const AnimalLevel>> levels;
  std::shared_ptr<const ResourceAccessGraph> graph;
  std::shared_ptr<const std::vector<DailyPlan>> plans;
  std::uint64_t seed = 1;
  /// Without it water is where the hydrology has any, and there are no trunks.
  std::shared_ptr<const HerdDetails> details;

  [[nodiscard]] const Terrain& terrain() const { return *ground.terrain; }
  [[nodiscard]] const AnimalTraits& traits(const DailyPlan& plan) const {
    return web->species[std::size_t(plan.species)].animal();
  }
  [[nodiscard]] const GraphLevel& graph_of(const DailyPlan& plan) const { return graph->levels[std::size_t(plan.level)]; }

  [[nodiscard]] Place place_of(PathPoint at) const;
  /// Column and row of the cell that holds a place; the nearest for places beyond the border.
  struct Cell {
    int x = 0;
    int y = 0;
  };
  [[nodiscard]] Cell cell_of(Place place) const;
  /// Water above the ground of the place's cell, m.
  [[nodiscard]] float depth_at(Place place) const;
  /// Metres to the nearest shore, positive in water, as far as it is known.
  [[nodiscard]] float shore_at(Place place) const;
  /// Rise over run in a direction (unit vector).
  [[nodiscard]] double slope_along(Place place, Place direction) const;
  [[nodiscard]] HerdState state(const DailyPlan& plan, double seconds) const;
  /// Whether water, slopes and details are the same in another world of the same extent within a rectangle.
  [[nodiscard]] bool same_within(const HerdWorld& other, Place low, Place high) const;
};

/// Seconds of a day.
inline constexpr double day_seconds = 86400;

/// Packs whose mass (of one, times the root of their number) is a smaller share of the mass of one of their prey are not feared.
/// Our choice.
inline constexpr double feared_mass = 0.2;

/// For every plan the plans of predators that eat its species and are feared, ascending.
[[nodiscard]] std::vector<std::vector<int>> predators_of_plans(const HerdWorld& world);

}  // namespace biotope

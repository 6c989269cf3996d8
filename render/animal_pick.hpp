#pragma once

#include <glm/glm.hpp>
#include <limits>
#include <optional>
#include <span>

#include "core/movement/daily_plan.hpp"
#include "core/pipeline/maps_snapshot.hpp"

namespace biotope {

/// One animal where it was drawn.
struct AnimalAt {
  int plan = -1;    ///< index in MapsSnapshot::plans
  int member = 0;   ///< 0 .. plan.size - 1; the same animal keeps its number all day
  int species = 0;  ///< number in the food web
  /// Its feet: metres east and north of the terrain's south-west corner, and above sea level on the drawn ground.
  glm::dvec3 place{0};
  float heading = 0;    ///< radians clockwise from north
  float speed = 0;      ///< m/s
  float height = 1;     ///< at the shoulder, m; the young are smaller
  float length = 1.5F;  ///< head and body, m
  bool young = false;
  bool male = false;
};

/// The animal that a ray hits first: origin in metres, `direction` of any length. An animal is a ball around its trunk, never
/// smaller than `least_angle` radians as seen from the origin, so that far ones can be clicked. Only animals nearer than `reach`
/// metres count (pass the distance to the ground the ray hits, plus a few metres). `drawn`: LandscapeRenderer::animals().
[[nodiscard]] std::optional<AnimalAt> pick_animal(std::span<const AnimalAt> drawn, const glm::dvec3& origin,
                                                  const glm::vec3& direction,
                                                  double reach = std::numeric_limits<double>::infinity(),
                                                  double least_angle = 0.008);

/// The animal nearest to a place on the ground, within `radius` metres.
[[nodiscard]] std::optional<AnimalAt> animal_near(std::span<const AnimalAt> drawn, const glm::dvec2& place, double radius);

/// Where a herd is, for a camera that follows it and for what a panel says.
struct HerdPlace {
  /// The plan's place at that hour, on the ground (z above sea level).
  glm::dvec3 centre{0};
  float heading = 0;  ///< radians clockwise from north; of the last walk while it stands
  float speed = 0;    ///< m/s
  /// Metres around the centre within which most of its members are.
  float radius = 0;
  HerdActivity activity = HerdActivity::resting;
};
/// A pure function of plan and hour, smooth in time (the place moves no faster than the herd walks). Nothing when there is no
/// such plan.
[[nodiscard]] std::optional<HerdPlace> herd_place(const MapsSnapshot& maps, int plan, double hour);

}  // namespace biotope

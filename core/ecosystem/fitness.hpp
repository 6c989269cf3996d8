#pragma once

#include <array>
#include <cstdint>
#include <string_view>

#include "core/climate/climate.hpp"
#include "core/species/species.hpp"

namespace biotope {

/// A plant does not settle where its fitness is less than this: under an hour of the year (our choice).
inline constexpr float least_fitness = 1e-4F;

/// Slope, in 1 / index, that stands for an interval of zero length: steep enough to be a step for any two distinct indices.
inline constexpr float point_slope = 1e30F;

/// What can limit a plant.
enum class LimitingFactor : std::uint8_t { none, illumination, temperature, moisture, texture, geology };
[[nodiscard]] std::string_view to_string(LimitingFactor factor);

/// Mean over the 12 month-to-month intervals (December to January included) of the share of the interval that lies in `range`:
/// thesis eq. 5.4 for one resource. An interval of zero length counts 1 inside the range (ends included), 0 outside. 0..1.
[[nodiscard]] float resource_fitness(Range range, const std::array<float, months>& values);

/// The resources of one cell.
struct CellEnvironment {
  std::array<std::array<float, months>, 3> monthly{};  ///< by Resource
  float texture = 0;
  int geology = 0;
};

struct Fitness {
  float value = 0;
  LimitingFactor limiting = LimitingFactor::none;
};

/// Fitness of a plant at a cell: the minimum over its resources, with the resource that attains it (first on ties; none where
/// every resource is perfect). Texture is one value a year: 1 inside the range, 0 outside. Geology gives its viability.
[[nodiscard]] Fitness plant_fitness(const PlantTraits& plant, const CellEnvironment& cell);

}  // namespace biotope

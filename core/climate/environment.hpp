#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <memory>
#include <vector>

#include "core/base/grid.hpp"
#include "core/base/status.hpp"
#include "core/base/task_context.hpp"
#include "core/climate/climate.hpp"
#include "core/terrain/derivatives.hpp"
#include "core/terrain/hydrology.hpp"
#include "core/terrain/terrain.hpp"

namespace biotope {

/// The environmental resources of plants that change from month to month.
enum class Resource : std::uint8_t { illumination, temperature, moisture };
inline constexpr int monthly_resources = 3;

/// Geology classes, numbered as in `geology.tif`.
enum class Geology : std::uint8_t { limestone, water, marl, scree, alluvium };
inline constexpr int geology_classes = 5;

/// Twelve maps on the 1..9 index scale that may share one: value(month) = clamp(layer + offset[month], 1, 9), where the
/// layer is `layers[0]` when there is one layer and `layers[month]` when there are twelve.
struct MonthlyMap {
  std::vector<std::shared_ptr<const Grid<float>>> layers;
  std::array<float, months> offset{};

  [[nodiscard]] const Grid<float>& layer(int month) const {
    return *layers[layers.size() == 1 ? 0 : std::size_t(month)];
  }
  /// Index 1..9 of a month (0 is January) at a cell.
  [[nodiscard]] float value(int month, int x, int y) const {
    return std::clamp(layer(month)(x, y) + offset[std::size_t(month)], 1.0F, 9.0F);
  }
  /// Mean of the twelve values at a cell.
  [[nodiscard]] float mean(int x, int y) const {
    float sum = 0;
    for (int month = 0; month < months; ++month) sum += value(month, x, y);
    return sum / float(months);
  }
};

/// Everything a plant can feel at a cell, before paint.
struct EnvironmentMaps {
  std::array<MonthlyMap, monthly_resources> monthly;
  /// Soil texture index 1 (clay) .. 9 (stones).
  std::shared_ptr<const Grid<float>> texture;
  std::shared_ptr<const Grid<Geology>> geology;

  [[nodiscard]] const MonthlyMap& map(Resource resource) const { return monthly[std::size_t(resource)]; }
};

/// Calibration of an index: a physical value that is 1 and one that is 9, linear between.
struct IndexScale {
  double one;
  double nine;
  [[nodiscard]] constexpr double index(double value) const { return 1 + 8 * (value - one) / (nine - one); }
  [[nodiscard]] constexpr double physical(double index) const { return one + (index - 1) * (nine - one) / 8; }
};
/// Mean irradiance ratio over 24 h (authors' public code).
inline constexpr IndexScale illumination_scale{0.01, 0.25};
/// Degrees C (authors' public code).
inline constexpr IndexScale temperature_scale{-15, 25};
/// ln(water) + ln(mm per month), where water = (a / (0.1 + sqrt(slope)))^(2/3) and a is the specific catchment area in m.
/// The authors divide water by the map's maximum, about e^13 on theirs, and use -8..2: the same scale made absolute.
inline constexpr IndexScale moisture_scale{5, 15};

/// Illumination, temperature, moisture, texture and geology of a terrain under a climate. `hydrology` was computed with the
/// climate's runoff. Parallel and deterministic; nothing when stopped.
[[nodiscard]] Result<EnvironmentMaps> compute_environment(const Terrain& terrain, const Derivatives& derivatives,
                                                          const Hydrology& hydrology, const Climate& climate,
                                                          const TaskContext& context = {});

}  // namespace biotope

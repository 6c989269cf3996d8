#include "core/ecosystem/fitness.hpp"

#include <algorithm>
#include <cstddef>

#include "core/climate/environment.hpp"

namespace biotope {

namespace {

/// 1 / length of an interval; a point gets a slope so steep that it is a step.
float inverse_length(float length) { return length > 0 ? 1 / length : point_slope; }

}  // namespace

std::string_view to_string(LimitingFactor factor) {
  switch (factor) {
    case LimitingFactor::none:
      return "none";
    case LimitingFactor::illumination:
      return "illumination";
    case LimitingFactor::temperature:
      return "temperature";
    case LimitingFactor::moisture:
      return "moisture";
    case LimitingFactor::texture:
      return "texture";
    case LimitingFactor::geology:
      return "geology";
  }
  return "none";
}

float resource_fitness(Range range, const std::array<float, months>& values) {
  float below = 0;
  float above = 0;
  for (std::size_t month = 0; month < values.size(); ++month) {
    const float next = values[(month + 1) % values.size()];
    const float low = std::min(values[month], next);
    const float high = std::max(values[month], next);
    const float inverse = inverse_length(high - low);
    below += std::clamp((range.low - low) * inverse, 0.0F, 1.0F);
    above += std::clamp((high - range.high) * inverse, 0.0F, 1.0F);
  }
  return std::clamp((float(months) - below - above) / float(months), 0.0F, 1.0F);
}

Fitness plant_fitness(const PlantTraits& plant, const CellEnvironment& cell) {
  const auto& light = cell.monthly[std::size_t(Resource::illumination)];
  const auto& warmth = cell.monthly[std::size_t(Resource::temperature)];
  const auto& water = cell.monthly[std::size_t(Resource::moisture)];
  Fitness fitness{1, LimitingFactor::none};
  const auto limit = [&fitness](float value, LimitingFactor factor) {
    if (value < fitness.value) fitness = {value, factor};
  };
  limit(resource_fitness(plant.illumination, light), LimitingFactor::illumination);
  limit(resource_fitness(plant.temperature, warmth), LimitingFactor::temperature);
  limit(resource_fitness(plant.moisture, water), LimitingFactor::moisture);
  limit(plant.texture.contains(cell.texture) ? 1.0F : 0.0F, LimitingFactor::texture);
  limit(plant.geology[std::size_t(cell.geology)], LimitingFactor::geology);
  return fitness;
}

}  // namespace biotope

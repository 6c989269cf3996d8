#include <algorithm>

#include "core/base/parallel.hpp"
#include "core/ecosystem/plant_competition.hpp"

namespace biotope {

std::array<float, months> PlantEnvironment::year(Resource resource, int x, int y) const {
  const MonthlyMap& map = maps->map(resource);
  std::array<float, months> values{};
  float sum = 0;
  const std::size_t cell = map.layers[0]->index(x, y);
  for (std::size_t month = 0; month < months; ++month) {
    const float layer = (*map.layers[map.layers.size() == 1 ? 0 : month])[cell];
    values[month] = std::clamp(layer + map.offset[month], 1.0F, 9.0F);
  }
  for (const float value : values) sum += value;
  const PaintLayer* layer = paint[std::size_t(resource)].get();
  if (layer == nullptr) return values;
  const Paint stroke = (*layer)(x, y);
  const float shift = stroke.coverage * (stroke.value - sum / float(months));
  for (float& value : values) value = std::clamp(value + shift, 1.0F, 9.0F);
  return values;
}

float PlantEnvironment::texture(int x, int y) const {
  const float computed = (*maps->texture)(x, y);
  return soil.texture ? painted_texture(computed, (*soil.texture)(x, y)) : computed;
}

Geology PlantEnvironment::geology(int x, int y) const {
  const Geology computed = (*maps->geology)(x, y);
  return soil.geology ? painted_geology(computed, (*soil.geology)(x, y)) : computed;
}

CellEnvironment PlantEnvironment::cell(int x, int y) const {
  CellEnvironment cell;
  for (std::size_t r = 0; r < monthly_resources; ++r) cell.monthly[r] = year(Resource(r), x, y);
  cell.texture = texture(x, y);
  cell.geology = int(geology(x, y));
  return cell;
}

Grid<float> fitness_map(const PlantTraits& plant, const PlantEnvironment& environment) {
  const Grid<Geology>& geology = *environment.maps->geology;
  Grid<float> fitness(geology.width(), geology.height());
  parallel_rows(0, fitness.height(), [&](int y) {
    for (int x = 0; x < fitness.width(); ++x) fitness(x, y) = plant_fitness(plant, environment.cell(x, y)).value;
  });
  return fitness;
}

}  // namespace biotope

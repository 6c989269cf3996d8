#pragma once

#include <cmath>
#include <map>
#include <memory>

#include "core/document/edit.hpp"
#include "tests/document/brush_random.hpp"

namespace biotope {

inline const LayerId oak{LayerKind::plant_density, "oak"};
inline const LayerId pine{LayerKind::plant_density, "pine"};
inline const LayerId deer{LayerKind::animal_density, "deer"};
inline const LayerId moisture{LayerKind::resource, "moisture"};
inline const LayerId geology{LayerKind::geology, "class"};
inline const LayerId ground{LayerKind::ground, "height"};
inline const LayerId passage{LayerKind::passage, "all"};

/// A landscape of two plants and an animal.
inline Document small_landscape(int width, int height) {
  Document document = flat_document(width, height);
  std::vector<Species> species(3);
  species[0].name = "oak";
  species[1].name = "pine";
  species[2].name = "deer";
  species[2].traits = AnimalTraits{};
  document.species = std::make_shared<const std::vector<Species>>(std::move(species));
  return document;
}

/// Computed maps and filter maps of a landscape, made up.
inline EditGrounds made_up_grounds(int width, int height) {
  EditGrounds grounds;
  auto flat = [=](float value) { return std::make_shared<const Grid<float>>(width, height, value); };
  std::map<LayerId, std::shared_ptr<const Grid<float>>> maps{
      {oak, std::make_shared<const Grid<float>>(random_map(width, height, 1))},
      {pine, flat(0.1F)},
      {deer, flat(3)},
      {moisture, flat(5)},
      {geology, flat(1)},
      {ground, std::make_shared<const Grid<float>>(random_map(width, height, 2))}};
  Grid<float> cover = *maps[oak];
  for (float& cell : cover.cells()) cell /= 8;
  maps[oak] = std::make_shared<const Grid<float>>(std::move(cover));
  grounds.computed = [maps](const LayerId& layer) {
    const auto found = maps.find(layer);
    return found == maps.end() ? nullptr : found->second;
  };
  Grid<float> west_to_east(width, height);
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) west_to_east(x, y) = float(x);
  }
  grounds.filters.slope = std::make_shared<const Grid<float>>(std::move(west_to_east));
  grounds.filters.aspect = flat(200);
  return grounds;
}

inline Paint paint_at(const Document& document, const LayerId& layer, int x, int y) {
  const auto found = document.layers.find(layer);
  return found == document.layers.end() ? Paint{} : (*found->second)(x, y);
}

/// Cells in which the paint of two layers differs, or -1 when one has the layer and the other has not.
inline int different_cells(const Document& a, const Document& b, const LayerId& layer) {
  if (a.layers.contains(layer) != b.layers.contains(layer)) return -1;
  if (!a.layers.contains(layer)) return 0;
  const Grid<Paint> one = a.layers.at(layer)->to_grid();
  const Grid<Paint> other = b.layers.at(layer)->to_grid();
  int count = 0;
  for (std::size_t i = 0; i < one.size(); ++i) count += one[i] == other[i] ? 0 : 1;
  return count;
}

/// Same paint in every layer, same selection and parts, cell by cell and bit by bit.
inline bool same_state(const Document& a, const Document& b) {
  if (a.layers.size() != b.layers.size()) return false;
  for (const auto& [id, layer] : a.layers) {
    if (different_cells(a, b, id) != 0) return false;
  }
  if ((a.selection == nullptr) != (b.selection == nullptr)) return false;
  if (a.selection && !(a.selection->to_grid() == b.selection->to_grid())) return false;
  if ((a.locked_area == nullptr) != (b.locked_area == nullptr)) return false;
  if (a.locked_area && !(a.locked_area->to_grid() == b.locked_area->to_grid())) return false;
  return a.title == b.title && a.seed == b.seed && a.layer_states == b.layer_states && a.placements == b.placements;
}

}  // namespace biotope

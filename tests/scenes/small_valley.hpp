#pragma once

#include <cmath>
#include <filesystem>
#include <memory>

#include "core/base/random.hpp"
#include "core/climate/climate.hpp"
#include "core/document/document.hpp"
#include "core/species/species_library.hpp"

namespace biotope::scenes {

/// A valley of 10 m cells that runs from north to south, with a river that enters from the north, a steep western wall and a bumpy plateau:
/// the smallest ground on which every part of the ecosystem has something to do.
inline Terrain small_valley(int width = 160, int height = 128) {
  Terrain terrain;
  terrain.name = "small valley";
  terrain.cell_size = 10;
  terrain.height = Grid<float>(width, height);
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      const double middle = width * 0.5 + 8 * std::sin(y * 0.08);
      const double across = std::abs(x - middle);
      const double floor = 100 + 0.12 * (height - y) + across * 0.6;
      const double wall = across > 30 ? (across - 30) * (x < middle ? 9.0 : 2.5) : 0;
      const double bump = 2.5 * std::sin(x * 0.31) * std::cos(y * 0.27) * (across > 12 ? 1 : 0);
      terrain.height(x, y) = float(floor + std::min(wall, 140.0) + bump);
    }
  }
  return terrain;
}

/// The small valley with the built-in species under a built-in climate.
inline Result<Document> small_document(const std::filesystem::path& assets, const std::string& climate = "mild-humid") {
  Document document;
  document.terrain = std::make_shared<const Terrain>(small_valley());
  document.inflows = {{80, 0, 2.0e8}};
  document.title = "small valley";
  auto species = load_species(assets / "species" / "tautavel.json");
  if (!species) return tl::unexpected<Error>(species.error());
  document.species = std::make_shared<const std::vector<Species>>(std::move(*species));
  auto climates = load_climates(assets / "climates");
  if (!climates) return tl::unexpected<Error>(climates.error());
  for (const Climate& one : *climates) {
    if (one.name == climate) document.climate = one;
  }
  return document;
}

}  // namespace biotope::scenes

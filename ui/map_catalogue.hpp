#pragma once

#include <compare>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/document/document.hpp"
#include "core/species/species_library.hpp"
#include "render/map_renderer.hpp"

namespace biotope {

/// What the editor's tabs are about; each offers its own maps.
enum class Tab : std::uint8_t { terrain, climate, plants, animals, trails, project };
inline constexpr int tab_count = 6;
[[nodiscard]] std::string_view tab_title(Tab tab);

enum class MapKind : std::uint8_t {
  none,
  height,
  slope,
  water_depth,
  curvature,
  illumination,
  temperature,
  moisture,
  texture,
  geology,
  plant_cover,
  plant_fitness,
  plant_surplus,
  group_cover,  ///< item: stratum
  animal_density,
  animal_regions,
  animal_surplus,
  trail_wear,
  ground_change,  ///< painted ground against the file's
  passage,        ///< painted obstacles and passages
  loss            ///< item: species; share of its growth lost to an external event
};

/// Names one map of a landscape.
struct MapId {
  MapKind kind = MapKind::none;
  /// Species number in the food web, stratum, or 0.
  int item = 0;
  /// 0..11, or -1 for the yearly mean.
  int month = -1;
  auto operator<=>(const MapId&) const = default;
};

/// What a person sees about a map before its values are known.
struct MapEntry {
  MapId id;
  std::string title;
  /// "%" for fractions; empty for indices and classes.
  std::string unit;
  ColourMap colours = ColourMap::viridis;
  /// Ends of the colour scale; absent: taken from the values.
  std::optional<float> low;
  std::optional<float> high;
  /// Values at or below are clear; NaN: none.
  float clear_below = 0;
  /// Names of classes 0, 1, ...; empty for quantities.
  std::vector<std::string> classes;
};

/// The maps a tab offers, in the order of its list. `month` (-1: yearly mean) goes into the monthly ones. `web` may be null.
[[nodiscard]] std::vector<MapEntry> maps_of_tab(Tab tab, const FoodWeb* web, int month);
/// One map by its id.
[[nodiscard]] MapEntry describe_map(const MapId& id, const FoodWeb* web);

/// The map that shows what a layer of paint is about. `web` gives the species' number.
[[nodiscard]] MapId map_of_layer(const LayerId& layer, const FoodWeb& web);
/// The tab where that map is offered.
[[nodiscard]] Tab tab_of_layer(const LayerId& layer, const FoodWeb& web);
/// The layer one paints on while looking at a map; nothing where a map cannot be painted.
[[nodiscard]] std::optional<LayerId> layer_of_map(const MapId& id, const FoodWeb& web);

/// A species' name for people: its common name, else its scientific one, else its short one.
[[nodiscard]] std::string display_name(const Species& species);
/// Geology classes as people call them, by number.
[[nodiscard]] const std::vector<std::string>& geology_names();
/// What a person calls a layer of paint: "Moisture", "Oak", "Oak: lost to fire or disease", "Ground".
[[nodiscard]] std::string layer_title(const LayerId& layer, const FoodWeb* web);

}  // namespace biotope

#include "ui/map_catalogue.hpp"

#include <array>
#include <cmath>
#include <limits>

#include "ui/format.hpp"

namespace biotope {
namespace {

constexpr float nothing_clear = std::numeric_limits<float>::quiet_NaN();
constexpr std::array<std::string_view, tab_count> titles{"Terrain", "Climate", "Plants", "Animals", "Trails", "Project"};
constexpr std::array<std::string_view, strata> stratum_titles{"All trees", "All shrubs", "All herbs"};

std::string species_title(const FoodWeb* web, int species, std::string_view what) {
  if (web == nullptr || species < 0 || species >= int(web->species.size())) return std::string(what);
  return display_name(web->species[std::size_t(species)]) + ": " + std::string(what);
}

std::string monthly_title(std::string_view what, int month) {
  return std::string(what) + ", " + (month < 0 ? std::string("yearly mean") : std::string(month_name(month)));
}

MapEntry index_entry(const MapId& id, std::string title, ColourMap colours) {
  return {id, std::move(title), "", colours, 1.0F, 9.0F, nothing_clear, {}};
}

MapEntry describe_terrain(const MapId& id) {
  switch (id.kind) {
    case MapKind::height:
      return {id, "Height", "m", ColourMap::viridis, {}, {}, nothing_clear, {}};
    case MapKind::slope:
      return {id, "Slope", "°", ColourMap::inferno, 0.0F, 60.0F, nothing_clear, {}};
    case MapKind::water_depth:
      return {id, "Water depth", "m", ColourMap::blues, 0.0F, {}, 0, {}};
    case MapKind::ground_change:
      return {id, "Ground raised and lowered", "m", ColourMap::diverging, {}, {}, nothing_clear, {}};
    case MapKind::passage:
      return {id, "Obstacles and passages", "", ColourMap::categorical, {}, {}, -0.5F, {"obstacle", "open to all"}};
    default:
      return {id, "Curvature", "1/m", ColourMap::diverging, -0.05F, 0.05F, nothing_clear, {}};
  }
}

MapEntry describe_ground(const MapId& id) {
  if (id.kind == MapKind::texture) return index_entry(id, "Soil texture (1 clay, 9 stones)", ColourMap::browns);
  return {id, "Geology", "", ColourMap::categorical, {}, {}, nothing_clear, geology_names()};
}

void add(std::vector<MapEntry>& maps, const FoodWeb* web, const MapId& id) { maps.push_back(describe_map(id, web)); }

}  // namespace

std::string_view tab_title(Tab tab) { return titles[std::size_t(tab)]; }

std::string display_name(const Species& species) {
  if (!species.common_name.empty()) return species.common_name;
  return species.scientific_name.empty() ? species.name : species.scientific_name;
}

MapEntry describe_map(const MapId& id, const FoodWeb* web) {
  switch (id.kind) {
    case MapKind::none:
      return {id, "Terrain only", "", ColourMap::viridis, {}, {}, 0, {}};
    case MapKind::height:
    case MapKind::slope:
    case MapKind::water_depth:
    case MapKind::curvature:
    case MapKind::ground_change:
    case MapKind::passage:
      return describe_terrain(id);
    case MapKind::loss:
      return {id, species_title(web, id.item, "lost to an event"), "%", ColourMap::inferno, 0.0F, 1.0F, 0, {}};
    case MapKind::illumination:
      return index_entry(id, monthly_title("Illumination", id.month), ColourMap::inferno);
    case MapKind::temperature:
      return index_entry(id, monthly_title("Temperature", id.month), ColourMap::viridis);
    case MapKind::moisture:
      return index_entry(id, monthly_title("Moisture", id.month), ColourMap::blues);
    case MapKind::texture:
    case MapKind::geology:
      return describe_ground(id);
    case MapKind::plant_cover:
      return {id, species_title(web, id.item, "cover"), "%", ColourMap::greens, 0.0F, 1.0F, 0, {}};
    case MapKind::plant_fitness:
      return {id, species_title(web, id.item, "fitness"), "%", ColourMap::viridis, 0.0F, 1.0F, nothing_clear, {}};
    case MapKind::plant_surplus:
      return {id, species_title(web, id.item, "surplus"), "kg/m²/yr", ColourMap::browns, 0.0F, {}, 0, {}};
    case MapKind::group_cover:
      return {id, std::string(stratum_titles[std::size_t(id.item)]), "%", ColourMap::greens, 0.0F, 1.0F, 0, {}};
    case MapKind::animal_density:
      return {id, species_title(web, id.item, "density"), "/km²", ColourMap::browns, 0.0F, {}, 0, {}};
    case MapKind::animal_regions:
      return {id, species_title(web, id.item, "regions"), "", ColourMap::categorical, {}, {}, -0.5F, {}};
    case MapKind::animal_surplus:
      return {id, species_title(web, id.item, "surplus"), "/km²/yr", ColourMap::browns, 0.0F, {}, 0, {}};
    case MapKind::trail_wear:
      return {id, "Worn ground", "%", ColourMap::browns, 0.0F, 1.0F, 0, {}};
  }
  return {};
}

std::vector<MapEntry> maps_of_tab(Tab tab, const FoodWeb* web, int month) {
  std::vector<MapEntry> maps;
  add(maps, web, {MapKind::none});
  const auto for_level = [&](bool plants, std::initializer_list<MapKind> kinds) {
    if (web == nullptr) return;
    for (std::size_t level = 0; level < web->levels.size(); ++level) {
      if ((level == 0) != plants) continue;
      for (const int species : web->levels[level]) {
        for (const MapKind kind : kinds) add(maps, web, {kind, species});
      }
    }
  };
  switch (tab) {
    case Tab::terrain:
      for (const MapKind kind : {MapKind::height, MapKind::ground_change, MapKind::slope, MapKind::water_depth,
                                 MapKind::curvature, MapKind::geology, MapKind::passage}) {
        add(maps, web, {kind});
      }
      break;
    case Tab::climate:
      for (const MapKind kind : {MapKind::illumination, MapKind::temperature, MapKind::moisture})
        add(maps, web, {kind, 0, month});
      for (const MapKind kind : {MapKind::texture, MapKind::geology}) add(maps, web, {kind});
      break;
    case Tab::plants:
      for (int stratum = strata - 1; stratum >= 0; --stratum) add(maps, web, {MapKind::group_cover, stratum});
      for_level(true, {MapKind::plant_cover, MapKind::plant_fitness, MapKind::plant_surplus, MapKind::loss});
      break;
    case Tab::animals:
      add(maps, web, {MapKind::passage});
      for_level(false, {MapKind::animal_density, MapKind::animal_regions, MapKind::animal_surplus, MapKind::loss});
      break;
    case Tab::trails:
      add(maps, web, {MapKind::trail_wear});
      add(maps, web, {MapKind::passage});
      break;
    case Tab::project:
      break;
  }
  return maps;
}

MapId map_of_layer(const LayerId& layer, const FoodWeb& web) {
  switch (layer.kind) {
    case LayerKind::resource:
      if (layer.name == "illumination") return {MapKind::illumination};
      if (layer.name == "texture") return {MapKind::texture};
      return {layer.name == "temperature" ? MapKind::temperature : MapKind::moisture};
    case LayerKind::plant_density:
      return {MapKind::plant_cover, web.find(layer.name)};
    case LayerKind::animal_density:
      return {MapKind::animal_density, web.find(layer.name)};
    case LayerKind::geology:
      return {MapKind::geology};
    case LayerKind::loss:
      return {MapKind::loss, web.find(layer.name)};
    case LayerKind::passage:
      return {MapKind::passage};
    case LayerKind::ground:
      return {MapKind::ground_change};
  }
  return {};
}

Tab tab_of_layer(const LayerId& layer, const FoodWeb& web) {
  switch (layer.kind) {
    case LayerKind::resource:
    case LayerKind::geology:
      return Tab::climate;
    case LayerKind::plant_density:
      return Tab::plants;
    case LayerKind::animal_density:
      return Tab::animals;
    case LayerKind::loss: {
      const int species = web.find(layer.name);
      return species >= 0 && !web.species[std::size_t(species)].is_plant() ? Tab::animals : Tab::plants;
    }
    case LayerKind::passage:
      return Tab::animals;
    case LayerKind::ground:
      return Tab::terrain;
  }
  return Tab::terrain;
}

std::optional<LayerId> layer_of_map(const MapId& id, const FoodWeb& web) {
  switch (id.kind) {
    case MapKind::illumination:
      return LayerId{LayerKind::resource, "illumination"};
    case MapKind::temperature:
      return LayerId{LayerKind::resource, "temperature"};
    case MapKind::moisture:
      return LayerId{LayerKind::resource, "moisture"};
    case MapKind::texture:
      return LayerId{LayerKind::resource, "texture"};
    case MapKind::geology:
      return LayerId{LayerKind::geology, "class"};
    case MapKind::passage:
      return LayerId{LayerKind::passage, "all"};
    case MapKind::height:
    case MapKind::ground_change:
      return LayerId{LayerKind::ground, "height"};
    case MapKind::plant_cover:
    case MapKind::plant_fitness:
    case MapKind::plant_surplus:
    case MapKind::animal_density:
    case MapKind::animal_regions:
    case MapKind::animal_surplus:
    case MapKind::loss: {
      if (id.item < 0 || id.item >= int(web.species.size())) return std::nullopt;
      const Species& species = web.species[std::size_t(id.item)];
      if (id.kind == MapKind::loss) return LayerId{LayerKind::loss, species.name};
      return LayerId{species.is_plant() ? LayerKind::plant_density : LayerKind::animal_density, species.name};
    }
    default:
      return std::nullopt;
  }
}

const std::vector<std::string>& geology_names() {
  static const std::vector<std::string> names{"limestone", "water", "marl", "scree", "alluvium"};
  return names;
}

std::string layer_title(const LayerId& layer, const FoodWeb* web) {
  const int species = web == nullptr ? -1 : web->find(layer.name);
  const std::string of_species = species < 0 ? layer.name : display_name(web->species[std::size_t(species)]);
  switch (layer.kind) {
    case LayerKind::resource: {
      if (layer.name == "texture") return "Soil texture";
      std::string title = layer.name;
      if (!title.empty() && title[0] >= 'a' && title[0] <= 'z') title[0] = char(title[0] - 'a' + 'A');
      return title;
    }
    case LayerKind::plant_density:
    case LayerKind::animal_density:
      return of_species;
    case LayerKind::geology:
      return "Geology";
    case LayerKind::loss:
      return of_species + ": lost";
    case LayerKind::passage:
      return "Obstacles, passages";
    case LayerKind::ground:
      return "Ground";
  }
  return layer.name;
}

}  // namespace biotope

#include "core/exchange/scene_json.hpp"

#include <cmath>
#include <cstdio>
#include <nlohmann/json.hpp>

#include "core/exchange/height_source.hpp"
#include "core/exchange/scene_file.hpp"

namespace biotope {
namespace {

using Json = nlohmann::ordered_json;

constexpr const char* format_name = "biotope-scene";
constexpr std::array<const char*, monthly_resources> resource_names{"illumination", "temperature", "moisture"};
constexpr std::array<const char*, 3> kind_names{"resource", "plant-density", "animal-density"};

Json inflows_to_json(const std::vector<Inflow>& inflows) {
  Json list = Json::array();
  for (const Inflow& inflow : inflows) {
    list.push_back({{"x", inflow.x}, {"y", inflow.y}, {"catchment_area_m2", inflow.catchment_area}});
  }
  return list;
}

Json terrain_to_json(const SceneManifest& manifest) {
  Json terrain;
  terrain["file"] = "terrain.tif";
  terrain["name"] = manifest.terrain_name;
  terrain["width"] = manifest.width;
  terrain["height"] = manifest.height;
  terrain["cell_size_m"] = manifest.cell_size;
  terrain["latitude"] = manifest.latitude;
  terrain["transform"] = manifest.georeference.transform;
  terrain["crs"] = manifest.georeference.wkt;
  terrain["voids"] = manifest.has_voids;
  return terrain;
}

Json layers_to_json(const SceneManifest& manifest) {
  Json list = Json::array();
  for (const auto& layer : manifest.layers) {
    list.push_back({{"kind", kind_names[std::size_t(layer.id.kind)]}, {"name", layer.id.name}, {"file", layer.file}});
  }
  return list;
}

/// Reading throws nlohmann's exceptions for missing keys and wrong types; parse_manifest catches them in one place.
void read_inflows(const Json& json, SceneManifest& manifest) {
  for (const Json& item : json.at("inflows")) {
    manifest.inflows.push_back(
        {item.at("x").get<int>(), item.at("y").get<int>(), item.at("catchment_area_m2").get<double>()});
  }
}

void read_terrain(const Json& terrain, SceneManifest& manifest) {
  manifest.terrain_name = terrain.at("name").get<std::string>();
  manifest.width = terrain.at("width").get<int>();
  manifest.height = terrain.at("height").get<int>();
  manifest.cell_size = terrain.at("cell_size_m").get<double>();
  manifest.latitude = terrain.at("latitude").get<double>();
  manifest.georeference.transform = terrain.at("transform").get<std::array<double, 6>>();
  manifest.georeference.wkt = terrain.at("crs").get<std::string>();
  manifest.has_voids = terrain.at("voids").get<bool>();
}

Status read_layers(const Json& json, SceneManifest& manifest) {
  for (const Json& item : json.at("layers")) {
    const std::string kind = item.at("kind").get<std::string>();
    const auto found = std::find(kind_names.begin(), kind_names.end(), kind);
    if (found == kind_names.end()) return fail("unknown kind of layer '" + kind + "'");
    manifest.layers.push_back({{LayerKind(found - kind_names.begin()), item.at("name").get<std::string>()},
                               item.at("file").get<std::string>()});
  }
  return {};
}

Status check_values(const SceneManifest& manifest) {
  const auto side = [](int cells) { return cells >= 2 && cells <= largest_side; };
  if (!side(manifest.width) || !side(manifest.height)) {
    return fail("a terrain of " + std::to_string(manifest.width) + " x " + std::to_string(manifest.height) +
                " cells; expected 2 to " + std::to_string(largest_side) + " a side");
  }
  if (!(manifest.cell_size > 0) || !std::isfinite(manifest.cell_size)) return fail("cell_size_m must be more than 0");
  if (!(std::abs(manifest.latitude) <= 90)) return fail("latitude must lie between -90 and 90");
  for (const Inflow& inflow : manifest.inflows) {
    const bool inside = Rect{0, 0, manifest.width, manifest.height}.contains(inflow.x, inflow.y);
    if (!inside || !(inflow.catchment_area >= 0)) return fail("an inflow lies outside the terrain or has no area");
  }
  return {};
}

Status read_all(const Json& json, SceneManifest& manifest) {
  manifest.title = json.at("title").get<std::string>();
  manifest.seed = json.at("seed").get<std::uint64_t>();
  for (const auto& [level, use] : json.at("use_proportions").items()) {
    manifest.use_proportions[std::stoi(level)] = use.get<bool>();
  }
  read_inflows(json, manifest);
  read_terrain(json.at("terrain"), manifest);
  if (const Status layers = read_layers(json, manifest); !layers) return layers;
  for (const Json& name : json.at("given_environment")) {
    const auto resource = std::find(resource_names.begin(), resource_names.end(), name.get<std::string>());
    if (resource != resource_names.end()) {
      manifest.given_months[std::size_t(resource - resource_names.begin())] = true;
    } else if (name == "geology") {
      manifest.given_geology = true;
    } else {
      return fail("unknown given map " + name.dump());
    }
  }
  manifest.checksums = json.at("checksums").get<std::map<std::string, std::string>>();
  return check_values(manifest);
}

}  // namespace

std::string given_month_entry(int resource, int month) {
  char text[64];
  std::snprintf(text, sizeof text, "environment/%s-%02d.tif", resource_names[std::size_t(resource)], month + 1);
  return text;
}

SceneManifest manifest_of(const Document& document) {
  const Terrain& terrain = *document.terrain;
  SceneManifest manifest;
  manifest.title = document.title;
  manifest.seed = document.seed;
  manifest.use_proportions = document.use_proportions;
  manifest.inflows = document.inflows;
  manifest.width = terrain.height.width();
  manifest.height = terrain.height.height();
  manifest.cell_size = terrain.cell_size;
  manifest.latitude = terrain.latitude;
  manifest.georeference = terrain.georeference;
  manifest.terrain_name = terrain.name;
  manifest.has_voids = !terrain.voids.empty();
  for (const auto& [id, layer] : document.layers) {
    if (!layer) continue;
    const std::string number = std::to_string(manifest.layers.size() + 1);
    manifest.layers.push_back({id, "layers/" + number + "-" + kind_names[std::size_t(id.kind)] + ".tif"});
  }
  for (std::size_t r = 0; r < monthly_resources; ++r) {
    manifest.given_months[r] = !document.given_environment.monthly[r].empty();
  }
  manifest.given_geology = document.given_environment.geology != nullptr;
  return manifest;
}

std::string manifest_to_json(const SceneManifest& manifest) {
  Json json;
  json["format"] = format_name;
  json["version"] = scene_format_version;
  json["title"] = manifest.title;
  json["seed"] = manifest.seed;
  json["use_proportions"] = Json::object();
  for (const auto& [level, use] : manifest.use_proportions) json["use_proportions"][std::to_string(level)] = use;
  json["inflows"] = inflows_to_json(manifest.inflows);
  json["terrain"] = terrain_to_json(manifest);
  json["layers"] = layers_to_json(manifest);
  json["given_environment"] = Json::array();
  for (std::size_t r = 0; r < monthly_resources; ++r) {
    if (manifest.given_months[r]) json["given_environment"].push_back(resource_names[r]);
  }
  if (manifest.given_geology) json["given_environment"].push_back("geology");
  json["checksums"] = manifest.checksums;
  return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

Result<SceneManifest> parse_manifest(const std::string& text, const std::string& origin) {
  try {
    const Json json = Json::parse(text);
    if (json.at("format").get<std::string>() != format_name) return fail(origin + ": is no Biotope scene.");
    const int version = json.at("version").get<int>();
    if (version > scene_format_version) {
      return fail(origin + ": was made by a newer Biotope (scene format " + std::to_string(version) +
                  "; this one reads up to " + std::to_string(scene_format_version) + "). Update Biotope to open it.");
    }
    if (version < 1) return fail(origin + ": has the unknown scene format " + std::to_string(version) + ".");
    SceneManifest manifest;
    if (const Status read = read_all(json, manifest); !read) return fail(origin + ": " + read.error().message + ".");
    return manifest;
  } catch (const std::exception& error) {
    return fail(origin + ": is damaged (" + error.what() + ").");
  }
}

}  // namespace biotope

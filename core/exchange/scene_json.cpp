#include "core/exchange/scene_json.hpp"

#include <algorithm>
#include <charconv>
#include <cstdio>
#include <set>
#include <span>

#include "core/climate/json_reader.hpp"
#include "core/exchange/height_source.hpp"
#include "core/exchange/scene_file.hpp"

namespace biotope {
namespace {

constexpr const char* format_name = "biotope-scene";
constexpr std::array<const char*, monthly_resources> resource_names{"illumination", "temperature", "moisture"};

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
    list.push_back({{"kind", layer_kind_names()[std::size_t(layer.id.kind)]}, {"name", layer.id.name}, {"file", layer.file}});
  }
  return list;
}

Json states_to_json(const SceneManifest& manifest) {
  Json list = Json::array();
  for (const auto& [id, state] : manifest.layer_states) {
    list.push_back({{"kind", layer_kind_names()[std::size_t(id.kind)]},
                    {"name", id.name},
                    {"hidden", state.hidden},
                    {"locked", state.locked}});
  }
  return list;
}

/// A text that may be empty.
void read_text(JsonReader& reader, std::string_view key, std::string& target) {
  const Json* const found = reader.value(key, Presence::required, "a text");
  if (found == nullptr) return;
  if (!found->is_string()) return reader.refuse(key, "a text", *found);
  target = found->get<std::string>();
}

/// The items of a list, or nothing when there is none; `presence` says whether there must be one.
std::span<const Json> items_of(JsonReader& reader, std::string_view key, Presence presence) {
  const Json* const found = reader.value(key, presence, "a list [...]");
  if (found == nullptr) return {};
  if (!found->is_array()) {
    reader.refuse(key, "a list [...]", *found);
    return {};
  }
  return found->get_ref<const Json::array_t&>();
}

/// Reads one table of contents; the first problem is kept and makes what follows do nothing.
class ManifestReader {
 public:
  ManifestReader(const Json& json, const std::string& origin) : origin_(origin), reader_(json, origin, problem_) {}

  Result<SceneManifest> read() {
    read_head();
    read_terrain();
    read_inflows();
    read_layers();
    read_states();
    read_given();
    reader_.dictionary("checksums", manifest_.checksums);
    reader_.boolean("selection", manifest_.has_selection);
    reader_.boolean("locked_area", manifest_.has_locked_area);
    reader_.boolean("placements", manifest_.has_placements);
    reader_.finish();
    if (!problem_.empty()) return fail(problem_ + ".");
    return std::move(manifest_);
  }

 private:
  [[nodiscard]] JsonReader item(const Json& json, const std::string& name) { return {json, origin_ + ": " + name, problem_}; }

  void read_head() {
    std::string format;
    int version = 0;
    read_text(reader_, "format", format);
    reader_.number("version", version, {1, scene_format_version});
    read_text(reader_, "title", manifest_.title);
    reader_.number("seed", manifest_.seed, {0, 18446744073709551615.0}, Presence::required);
    const Json* const levels = reader_.value("use_proportions", Presence::required, "an object");
    if (levels == nullptr) return;
    if (!levels->is_object()) return reader_.refuse("use_proportions", "an object", *levels);
    for (const auto& [name, use] : levels->items()) {
      int level = 0;
      const auto [end, error] = std::from_chars(name.data(), name.data() + name.size(), level);
      const bool whole = error == std::errc() && end == name.data() + name.size();
      if (!whole || level < 0 || !use.is_boolean())
        return reader_.refuse("use_proportions." + name, "a level with true or false", use);
      manifest_.use_proportions[level] = use.get<bool>();
    }
  }

  void read_terrain() {
    JsonReader terrain = reader_.nested("terrain", Presence::required);
    std::string file;
    read_text(terrain, "file", file);
    read_text(terrain, "name", manifest_.terrain_name);
    terrain.number("width", manifest_.width, {2, double(largest_side)}, Presence::required);
    terrain.number("height", manifest_.height, {2, double(largest_side)}, Presence::required);
    terrain.number("cell_size_m", manifest_.cell_size, {1e-9, 1e9}, Presence::required);
    terrain.number("latitude", manifest_.latitude, {-90, 90}, Presence::required);
    terrain.numbers("transform", manifest_.georeference.transform, {-1e300, 1e300}, Presence::required);
    read_text(terrain, "crs", manifest_.georeference.wkt);
    terrain.boolean("voids", manifest_.has_voids, Presence::required);
    terrain.finish();
  }

  void read_inflows() {
    const auto list = items_of(reader_, "inflows", Presence::required);
    for (std::size_t i = 0; i < list.size() && reader_.ok(); ++i) {
      JsonReader one = item(list[i], "inflow " + std::to_string(i + 1));
      Inflow inflow;
      one.number("x", inflow.x, {0, double(manifest_.width - 1)}, Presence::required);
      one.number("y", inflow.y, {0, double(manifest_.height - 1)}, Presence::required);
      one.number("catchment_area_m2", inflow.catchment_area, {0, 1e300}, Presence::required);
      one.finish();
      manifest_.inflows.push_back(inflow);
    }
  }

  [[nodiscard]] LayerId read_id(JsonReader& reader) {
    std::string kind;
    LayerId id;
    reader.word("kind", kind, layer_kind_names(), Presence::required);
    read_text(reader, "name", id.name);
    const auto found = std::ranges::find(layer_kind_names(), kind);
    if (found != layer_kind_names().end()) id.kind = LayerKind(found - layer_kind_names().begin());
    const auto names = layer_names(id.kind);
    if (reader.ok() && !names.empty() && std::ranges::find(names, id.name) == names.end()) {
      reader.refuse("name", "a map of its kind", id.name);
    }
    return id;
  }

  void read_layers() {
    const auto list = items_of(reader_, "layers", Presence::required);
    std::set<LayerId> seen;
    std::set<std::string> files;
    for (std::size_t i = 0; i < list.size() && reader_.ok(); ++i) {
      JsonReader one = item(list[i], "layer " + std::to_string(i + 1));
      SceneManifest::Layer layer;
      layer.id = read_id(one);
      one.text("file", layer.file, Presence::required);
      one.finish();
      if (one.ok() && !seen.insert(layer.id).second) one.refuse("name", "of no other layer of its kind", layer.id.name);
      if (one.ok() && !files.insert(layer.file).second) one.refuse("file", "of no other layer", layer.file);
      manifest_.layers.push_back(std::move(layer));
    }
  }

  void read_states() {
    const auto list = items_of(reader_, "layer_states", Presence::optional);
    for (std::size_t i = 0; i < list.size() && reader_.ok(); ++i) {
      JsonReader one = item(list[i], "layer state " + std::to_string(i + 1));
      const LayerId id = read_id(one);
      LayerState state;
      one.boolean("hidden", state.hidden);
      one.boolean("locked", state.locked);
      one.finish();
      if (state != LayerState{}) manifest_.layer_states[id] = state;
    }
  }

  void read_given() {
    for (const Json& name : items_of(reader_, "given_environment", Presence::required)) {
      const auto resource = std::find(resource_names.begin(), resource_names.end(), name);
      if (resource != resource_names.end()) {
        manifest_.given_months[std::size_t(resource - resource_names.begin())] = true;
      } else if (name == "geology") {
        manifest_.given_geology = true;
      } else {
        return reader_.refuse("given_environment", "a list of known maps", name);
      }
    }
  }

  std::string origin_;
  std::string problem_;
  JsonReader reader_;
  SceneManifest manifest_;
};

/// The format's version, looked at before anything else: what else a newer file holds is unknown. An Error unless it can be read
/// here.
Status check_version(const Json& json, const std::string& origin) {
  const auto format = json.is_object() ? json.find("format") : json.end();
  if (!json.is_object() || format == json.end() || *format != format_name) return fail(origin + ": is no Biotope scene.");
  const auto version = json.find("version");
  if (version == json.end() || !version->is_number_integer()) return fail(origin + ": does not say its version.");
  if (version->get<double>() > scene_format_version) {
    return fail(origin + ": was made by a newer Biotope (scene format " + version->dump() + "; this one reads up to " +
                std::to_string(scene_format_version) + "). Update Biotope to open it.");
  }
  if (version->get<double>() < 1) return fail(origin + ": has the unknown scene format " + version->dump() + ".");
  return {};
}

}  // namespace

std::span<const std::string> layer_names(LayerKind kind) {
  static const std::vector<std::string> resources{"illumination", "temperature", "moisture", "texture"};
  static const std::vector<std::string> geology{"class"};
  static const std::vector<std::string> passage{"all"};
  static const std::vector<std::string> ground{"height"};
  switch (kind) {
    case LayerKind::resource:
      return resources;
    case LayerKind::geology:
      return geology;
    case LayerKind::passage:
      return passage;
    case LayerKind::ground:
      return ground;
    case LayerKind::plant_density:
    case LayerKind::animal_density:
    case LayerKind::loss:
      break;
  }
  return {};
}

std::span<const std::string> layer_kind_names() {
  static const std::vector<std::string> names{"resource", "plant-density", "animal-density", "geology",
                                              "loss",     "passage",       "ground"};
  return names;
}

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
    manifest.layers.push_back({id, "layers/" + number + "-" + layer_kind_names()[std::size_t(id.kind)] + ".tif"});
  }
  manifest.layer_states = document.layer_states;
  manifest.has_selection = document.selection != nullptr;
  manifest.has_locked_area = document.locked_area != nullptr;
  manifest.has_placements = document.placements != Placements{};
  for (std::size_t r = 0; r < monthly_resources; ++r) {
    manifest.given_months[r] = !document.given_environment.monthly[r].empty();
  }
  manifest.given_geology = document.given_environment.geology != nullptr;
  return manifest;
}

std::string manifest_to_json(const SceneManifest& manifest) {
  Json json;
  json["format"] = format_name;
  // What older programs can read they may: 3 is needed for a locked area only.
  json["version"] = manifest.has_locked_area ? scene_format_version : 2;
  json["title"] = manifest.title;
  json["seed"] = manifest.seed;
  json["use_proportions"] = Json::object();
  for (const auto& [level, use] : manifest.use_proportions) json["use_proportions"][std::to_string(level)] = use;
  json["inflows"] = inflows_to_json(manifest.inflows);
  json["terrain"] = terrain_to_json(manifest);
  json["layers"] = layers_to_json(manifest);
  json["layer_states"] = states_to_json(manifest);
  json["selection"] = manifest.has_selection;
  if (manifest.has_locked_area) json["locked_area"] = true;
  json["placements"] = manifest.has_placements;
  json["given_environment"] = Json::array();
  for (std::size_t r = 0; r < monthly_resources; ++r) {
    if (manifest.given_months[r]) json["given_environment"].push_back(resource_names[r]);
  }
  if (manifest.given_geology) json["given_environment"].push_back("geology");
  json["checksums"] = manifest.checksums;
  return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

Result<SceneManifest> parse_manifest(const std::string& text, const std::string& origin) {
  const Result<Json> json = parse_json(text, origin);
  if (!json) return tl::unexpected(json.error());
  if (const Status readable = check_version(*json, origin); !readable) return tl::unexpected(readable.error());
  return ManifestReader(*json, origin).read();
}

}  // namespace biotope

#include <charconv>
#include <cmath>
#include <limits>

#include "core/exchange/edit_script_json.hpp"
#include "core/exchange/placements_json.hpp"
#include "core/species/species_library.hpp"

namespace biotope::script_json {
namespace {

/// Most levels a food chain may be said to have. Our choice.
constexpr int most_levels = 100;
constexpr Limits cell_limits{0, 1e6};
constexpr Limits catchment_limits{0, 1e15};

Json species_patch_to_json(const SpeciesPatch& patch) {
  Json json = Json::object();
  if (!patch.changed.empty()) json["changed"] = Json::parse(species_to_json(patch.changed))["species"];
  if (!patch.removed.empty()) json["removed"] = patch.removed;
  if (!patch.order.empty()) json["order"] = patch.order;
  return json;
}

void read_names(JsonReader& reader, std::string_view key, std::vector<std::string>& names) {
  const std::string_view expected = "a list of species' names";
  const Json* const list = reader.value(key, Presence::optional, expected);
  if (!list) return;
  const bool sound =
      list->is_array() && std::all_of(list->begin(), list->end(), [](const Json& name) { return name.is_string(); });
  if (!sound) return reader.refuse(key, expected, *list);
  names = list->get<std::vector<std::string>>();
}

void note(const EntryReading& at, const std::string& message) {
  if (at.problem.empty()) at.problem = message;
}

void read_species_patch(JsonReader& entry, SpeciesPatch& patch, const EntryReading& at) {
  JsonReader reader = entry.nested("species", Presence::required);
  if (const Json* const changed = reader.value("changed", Presence::optional, "a list of species")) {
    auto species = parse_species(Json{{"species", *changed}}.dump(-1, ' ', false, Json::error_handler_t::replace), at.where);
    if (!species) return note(at, species.error().message);
    patch.changed = std::move(*species);
  }
  read_names(reader, "removed", patch.removed);
  read_names(reader, "order", patch.order);
  reader.finish();
}

void read_use_proportions(JsonReader& reader, const Json& json, std::map<int, bool>& use) {
  const std::string_view expected = "an object of levels such as {\"0\": true, \"1\": false}";
  if (!json.is_object()) return reader.refuse("use_proportions", expected, json);
  for (const auto& [key, value] : json.items()) {
    int level = 0;
    const auto [end, error] = std::from_chars(key.data(), key.data() + key.size(), level);
    const bool sound = error == std::errc() && end == key.data() + key.size() && level >= 0 && level < most_levels;
    if (!sound || !value.is_boolean()) return reader.refuse("use_proportions", expected, json);
    use[level] = value.get<bool>();
  }
}

void read_inflows(JsonReader& reader, const Json& json, std::vector<Inflow>& inflows, const EntryReading& at) {
  if (!json.is_array()) return reader.refuse("inflows", "a list of inflows", json);
  for (std::size_t i = 0; i < json.size() && reader.ok(); ++i) {
    JsonReader one(json[i], at.where + ", inflow " + std::to_string(i + 1), at.problem);
    Inflow inflow;
    one.number("x", inflow.x, cell_limits, Presence::required);
    one.number("y", inflow.y, cell_limits, Presence::required);
    one.number("catchment_area_m2", inflow.catchment_area, catchment_limits, Presence::required);
    one.finish();
    inflows.push_back(inflow);
  }
}

void read_layer_states(JsonReader& reader, const Json& json, std::map<LayerId, LayerState>& states, const EntryReading& at) {
  if (!json.is_array()) return reader.refuse("layer_states", "a list of layers", json);
  for (std::size_t i = 0; i < json.size() && reader.ok(); ++i) {
    JsonReader one(json[i], at.where + ", layer state " + std::to_string(i + 1), at.problem);
    LayerId layer;
    LayerState state;
    read_layer(one, "layer", layer);
    one.boolean("hidden", state.hidden);
    one.boolean("locked", state.locked);
    one.finish();
    states[layer] = state;
  }
}

}  // namespace

void write_parts(Json& entry, const PartsPatch& patch) {
  if (!patch.name.empty()) entry["name"] = patch.name;
  if (patch.title) entry["title"] = *patch.title;
  if (patch.seed) entry["seed"] = *patch.seed;
  if (patch.climate) entry["climate"] = Json::parse(climate_to_json(*patch.climate));
  if (patch.species) entry["species"] = species_patch_to_json(*patch.species);
  if (patch.use_proportions) {
    Json& levels = entry["use_proportions"] = Json::object();
    for (const auto& [level, use] : *patch.use_proportions) levels[std::to_string(level)] = use;
  }
  if (patch.inflows) {
    Json& list = entry["inflows"] = Json::array();
    for (const Inflow& inflow : *patch.inflows) {
      list.push_back({{"x", inflow.x}, {"y", inflow.y}, {"catchment_area_m2", inflow.catchment_area}});
    }
  }
  if (patch.placements) entry["placements"] = placements_to_json(*patch.placements);
  if (patch.layer_states) {
    Json& list = entry["layer_states"] = Json::array();
    for (const auto& [layer, state] : *patch.layer_states) {
      list.push_back({{"layer", layer_to_text(layer)}, {"hidden", state.hidden}, {"locked", state.locked}});
    }
  }
}

void read_parts(JsonReader& reader, PartsPatch& patch, const EntryReading& at) {
  reader.text("name", patch.name);
  if (const Json* const title = reader.value("title", Presence::optional, "a text")) {
    if (!title->is_string()) return reader.refuse("title", "a text", *title);
    patch.title = title->get<std::string>();
  }
  if (reader.value("seed", Presence::optional, "a whole number")) {
    reader.number("seed", patch.seed.emplace(), {0, double(std::numeric_limits<std::uint64_t>::max())});
  }
  if (const Json* const climate = reader.value("climate", Presence::optional, "a climate")) {
    auto read = parse_climate(climate->dump(-1, ' ', false, Json::error_handler_t::replace), at.where + ", climate");
    if (!read) return note(at, read.error().message);
    patch.climate = std::move(*read);
  }
  if (reader.value("species", Presence::optional, "an object {...}")) read_species_patch(reader, patch.species.emplace(), at);
  if (const Json* const use = reader.value("use_proportions", Presence::optional, "an object {...}")) {
    read_use_proportions(reader, *use, patch.use_proportions.emplace());
  }
  if (const Json* const list = reader.value("inflows", Presence::optional, "a list of inflows")) {
    read_inflows(reader, *list, patch.inflows.emplace(), at);
  }
  if (const Json* const placed = reader.value("placements", Presence::optional, "an object {...}")) {
    auto read = parse_placements(*placed, at.where + ", placements");
    if (!read) return note(at, read.error().message);
    patch.placements = std::move(*read);
  }
  if (const Json* const list = reader.value("layer_states", Presence::optional, "a list of layers")) {
    read_layer_states(reader, *list, patch.layer_states.emplace(), at);
  }
}

}  // namespace biotope::script_json

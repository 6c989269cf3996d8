#include <algorithm>
#include <array>
#include <cmath>
#include <nlohmann/json.hpp>

#include "ui/brush_presets.hpp"

namespace biotope {
namespace {

using nlohmann::json;

constexpr std::array<const char*, 13> tool_names{"select", "add",   "erase", "smooth", "restore", "set",  "sharpen",
                                                 "noise",  "clone", "raise", "lower",  "flatten", "carve"};
constexpr std::array<const char*, 4> falloff_names{"smooth", "linear", "sphere", "sharp"};
constexpr std::array<const char*, 7> kind_names{"resource", "plants", "animals", "geology", "loss", "passage", "ground"};
constexpr std::array<const char*, 5> quantity_names{"slope", "altitude", "aspect", "water_distance", "map"};

template <class Enum, std::size_t count>
const char* word(const std::array<const char*, count>& names, Enum value) {
  return names[std::min(std::size_t(value), count - 1)];
}

template <class Enum, std::size_t count>
bool read_word(const json& object, const char* key, const std::array<const char*, count>& names, Enum& value) {
  const auto found = object.find(key);
  if (found == object.end() || !found->is_string()) return false;
  const auto name = std::find(names.begin(), names.end(), found->get<std::string>());
  if (name == names.end()) return false;
  value = Enum(name - names.begin());
  return true;
}

void read_number(const json& object, const char* key, float low, float high, float& value) {
  const auto found = object.find(key);
  if (found == object.end() || !found->is_number()) return;
  const float number = found->get<float>();
  if (std::isfinite(number)) value = std::clamp(number, low, high);
}

void read_flag(const json& object, const char* key, bool& value) {
  const auto found = object.find(key);
  if (found != object.end() && found->is_boolean()) value = found->get<bool>();
}

std::string read_string(const json& object, const char* key) {
  const auto found = object.find(key);
  return found != object.end() && found->is_string() ? found->get<std::string>() : std::string();
}

json layer_json(const LayerId& layer) { return {{"kind", word(kind_names, layer.kind)}, {"name", layer.name}}; }

std::optional<LayerId> read_layer(const json& object, const char* key) {
  const auto found = object.find(key);
  LayerId layer;
  if (found == object.end() || !found->is_object() || !read_word(*found, "kind", kind_names, layer.kind)) return std::nullopt;
  layer.name = read_string(*found, "name");
  return layer;
}

json filter_json(const BrushFilter& filter) {
  json conditions = json::array();
  for (const FilterCondition& condition : filter.conditions) {
    json one{{"of", word(quantity_names, condition.quantity)},
             {"low", condition.low},
             {"high", condition.high},
             {"softness", condition.softness},
             {"inverted", condition.inverted}};
    if (condition.quantity == FilterQuantity::map) one["map"] = layer_json(condition.map);
    conditions.push_back(std::move(one));
  }
  return {{"inside_selection", filter.use_selection}, {"conditions", std::move(conditions)}};
}

BrushFilter read_filter(const json& object) {
  constexpr float any = 1e9F;
  BrushFilter filter;
  read_flag(object, "inside_selection", filter.use_selection);
  const auto conditions = object.find("conditions");
  if (conditions == object.end() || !conditions->is_array()) return filter;
  for (const json& one : *conditions) {
    FilterCondition condition;
    if (!one.is_object() || !read_word(one, "of", quantity_names, condition.quantity)) continue;
    if (condition.quantity == FilterQuantity::map) {
      const auto map = read_layer(one, "map");
      if (!map) continue;
      condition.map = *map;
    }
    read_number(one, "low", -any, any, condition.low);
    read_number(one, "high", -any, any, condition.high);
    read_number(one, "softness", 0, any, condition.softness);
    read_flag(one, "inverted", condition.inverted);
    filter.conditions.push_back(std::move(condition));
  }
  return filter;
}

json preset_json(const BrushPreset& preset) {
  const Brush& brush = preset.brush;
  json object{{"name", preset.name},
              {"tool", word(tool_names, preset.tool)},
              {"size_m", preset.size},
              {"strength", brush.strength},
              {"hardness", brush.hardness},
              {"falloff", word(falloff_names, brush.falloff)},
              {"spacing", brush.spacing},
              {"pressure_sizes", brush.pressure_sizes},
              {"pressure_strengthens", brush.pressure_strengthens},
              {"noise_size", brush.noise_size},
              {"stamp_turn", brush.stamp_turn},
              {"stamp_turns_by_chance", brush.stamp_turns_by_chance},
              {"filter", filter_json(brush.filter)}};
  if (!preset.stamp.empty()) object["stamp"] = preset.stamp;
  if (preset.target) object["paints"] = layer_json(*preset.target);
  if (preset.value) object["value"] = *preset.value;
  if (preset.all_plants) object["all_plants"] = true;
  return object;
}

BrushPreset read_preset(const json& object) {
  BrushPreset preset;
  preset.name = read_string(object, "name");
  (void)read_word(object, "tool", tool_names, preset.tool);
  read_number(object, "size_m", 0.1F, 1e6F, preset.size);
  read_number(object, "strength", 0.01F, 1, preset.brush.strength);
  read_number(object, "hardness", 0, 1, preset.brush.hardness);
  (void)read_word(object, "falloff", falloff_names, preset.brush.falloff);
  read_number(object, "spacing", 0.02F, 4, preset.brush.spacing);
  read_flag(object, "pressure_sizes", preset.brush.pressure_sizes);
  read_flag(object, "pressure_strengthens", preset.brush.pressure_strengthens);
  read_number(object, "noise_size", 1, 1000, preset.brush.noise_size);
  read_number(object, "stamp_turn", -360, 360, preset.brush.stamp_turn);
  read_flag(object, "stamp_turns_by_chance", preset.brush.stamp_turns_by_chance);
  if (const auto filter = object.find("filter"); filter != object.end() && filter->is_object()) {
    preset.brush.filter = read_filter(*filter);
  }
  preset.stamp = read_string(object, "stamp");
  preset.target = read_layer(object, "paints");
  float value = NAN;
  read_number(object, "value", -1e6F, 1e6F, value);
  if (std::isfinite(value)) preset.value = value;
  read_flag(object, "all_plants", preset.all_plants);
  return preset;
}

}  // namespace

std::string presets_to_json(const std::vector<BrushPreset>& presets) {
  json list = json::array();
  for (const BrushPreset& preset : presets) list.push_back(preset_json(preset));
  return json{{"brushes", std::move(list)}}.dump(2, ' ', false, json::error_handler_t::replace);
}

std::vector<BrushPreset> presets_from_json(std::string_view text) {
  std::vector<BrushPreset> presets;
  const json object = json::parse(text, nullptr, false);
  if (!object.is_object()) return presets;
  const auto list = object.find("brushes");
  if (list == object.end() || !list->is_array()) return presets;
  for (const json& one : *list) {
    if (!one.is_object()) continue;
    BrushPreset preset = read_preset(one);
    if (!preset.name.empty()) presets.push_back(std::move(preset));
  }
  return presets;
}

}  // namespace biotope

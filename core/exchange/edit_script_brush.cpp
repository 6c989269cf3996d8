#include <limits>

#include "core/exchange/edit_script_json.hpp"

namespace biotope::script_json {
namespace {

constexpr Limits share_limits{0, 1};
constexpr Limits radius_limits{0.01, 16384};
constexpr Limits spacing_limits{0.01, 100};
constexpr Limits noise_limits{0.1, 1e5};
constexpr Limits turn_limits{-360, 360};
constexpr Limits seed_limits{0, double(std::numeric_limits<std::uint64_t>::max())};

}  // namespace

Json filter_to_json(const BrushFilter& filter) {
  Json json{{"use_selection", filter.use_selection}};
  if (filter.conditions.empty()) return json;
  json["conditions"] = Json::array();
  for (const FilterCondition& condition : filter.conditions) json["conditions"].push_back(condition_to_json(condition));
  return json;
}

void read_filter(JsonReader& holder, BrushFilter& filter, const EntryReading& at) {
  JsonReader reader = holder.nested("filter", Presence::optional);
  reader.boolean("use_selection", filter.use_selection);
  const Json* const list = reader.value("conditions", Presence::optional, "a list of conditions");
  if (list && !list->is_array()) return reader.refuse("conditions", "a list of conditions", *list);
  for (std::size_t i = 0; list && i < list->size() && reader.ok(); ++i) {
    JsonReader one((*list)[i], at.where + ", condition " + std::to_string(i + 1), at.problem);
    filter.conditions.emplace_back();
    read_condition(one, filter.conditions.back());
    one.finish();
  }
  reader.finish();
}

void read_layer(JsonReader& reader, std::string_view key, LayerId& layer) {
  const std::string_view expected = "a layer such as \"plant-density:quercus\", \"resource:moisture\" or \"ground:height\"";
  const Json* const found = reader.value(key, Presence::required, expected);
  if (!found) return;
  const auto read = found->is_string() ? layer_from_text(found->get_ref<const std::string&>()) : std::nullopt;
  if (!read) return reader.refuse(key, expected, *found);
  layer = *read;
}

void read_point(JsonReader& reader, std::string_view key, PathPoint& point) {
  std::array<float, 2> numbers{point.x, point.y};
  reader.numbers(key, numbers, position_limits, Presence::required);
  point = {numbers[0], numbers[1]};
}

void read_file_name(JsonReader& reader, std::string_view key, std::string& file, Presence presence) {
  const std::string_view expected = "the name of a file in the script's folder or in a folder within";
  const Json* const found = reader.value(key, presence, expected);
  if (!found) return;
  if (!found->is_string()) return reader.refuse(key, expected, *found);
  const auto& name = found->get_ref<const std::string&>();
  const std::filesystem::path path(name);
  // A colon is a drive and a backslash a folder on other systems: neither belongs in a name that is to be shared.
  bool inside = !name.empty() && path.is_relative() && name.find_first_of(std::string("\\:\0", 3)) == std::string::npos;
  for (const auto& part : path) inside = inside && part != ".." && part != "." && !part.empty();
  if (!inside) return reader.refuse(key, expected, *found);
  file = name;
}

Json point_to_json(PathPoint point) { return Json::array({tidy_number(point.x), tidy_number(point.y)}); }

Json condition_to_json(const FilterCondition& condition) {
  Json json{{"quantity", quantity_words()[std::size_t(condition.quantity)]}};
  if (condition.quantity == FilterQuantity::map) json["map"] = layer_to_text(condition.map);
  json["low"] = tidy_number(condition.low);
  json["high"] = tidy_number(condition.high);
  json["softness"] = tidy_number(condition.softness);
  json["inverted"] = condition.inverted;
  return json;
}

void read_condition(JsonReader& reader, FilterCondition& condition) {
  read_word(reader, "quantity", quantity_words(), condition.quantity, Presence::required);
  if (condition.quantity == FilterQuantity::map) read_layer(reader, "map", condition.map);
  reader.number("low", condition.low, value_limits, Presence::required);
  reader.number("high", condition.high, value_limits, Presence::required);
  reader.number("softness", condition.softness, {0, value_limits.high});
  reader.boolean("inverted", condition.inverted);
}

Json brush_to_json(const Brush& brush, const std::string& stamp) {
  Json json{{"mode", brush_mode_words()[std::size_t(brush.mode)]},
            {"radius", tidy_number(brush.radius)},
            {"strength", tidy_number(brush.strength)},
            {"hardness", tidy_number(brush.hardness)},
            {"value", tidy_number(brush.value)},
            {"floor", tidy_number(brush.floor)},
            {"falloff", falloff_words()[std::size_t(brush.falloff)]},
            {"spacing", tidy_number(brush.spacing)},
            {"pressure_sizes", brush.pressure_sizes},
            {"pressure_strengthens", brush.pressure_strengthens},
            {"noise_size", tidy_number(brush.noise_size)},
            {"noise_seed", brush.noise_seed}};
  if (!stamp.empty()) json["stamp"] = stamp;
  json["stamp_turn"] = tidy_number(brush.stamp_turn);
  json["stamp_turns_by_chance"] = brush.stamp_turns_by_chance;
  json["clone_offset"] = point_to_json(brush.clone_offset);
  json["filter"] = filter_to_json(brush.filter);
  return json;
}

void read_brush(JsonReader& entry, Brush& brush, std::string& stamp, const EntryReading& at) {
  JsonReader reader = entry.nested("brush", Presence::required);
  read_word(reader, "mode", brush_mode_words(), brush.mode, Presence::required);
  reader.number("radius", brush.radius, radius_limits);
  reader.number("strength", brush.strength, share_limits);
  reader.number("hardness", brush.hardness, share_limits);
  reader.number("value", brush.value, value_limits);
  reader.number("floor", brush.floor, value_limits);
  read_word(reader, "falloff", falloff_words(), brush.falloff);
  reader.number("spacing", brush.spacing, spacing_limits);
  reader.boolean("pressure_sizes", brush.pressure_sizes);
  reader.boolean("pressure_strengthens", brush.pressure_strengthens);
  reader.number("noise_size", brush.noise_size, noise_limits);
  reader.number("noise_seed", brush.noise_seed, seed_limits);
  read_file_name(reader, "stamp", stamp, Presence::optional);
  reader.number("stamp_turn", brush.stamp_turn, turn_limits);
  reader.boolean("stamp_turns_by_chance", brush.stamp_turns_by_chance);
  std::array<float, 2> offset{brush.clone_offset.x, brush.clone_offset.y};
  reader.numbers("clone_offset", offset, position_limits);
  brush.clone_offset = {offset[0], offset[1]};
  read_filter(reader, brush.filter, at);
  reader.finish();
}

}  // namespace biotope::script_json

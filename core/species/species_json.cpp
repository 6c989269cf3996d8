#include <set>

#include "core/climate/json_reader.hpp"
#include "core/species/species_library.hpp"
#include "core/species/species_words.hpp"

namespace biotope {
namespace {

constexpr Limits index_limits{1, 9};
constexpr Limits unit_limits{0, 1};

bool is_short_name(std::string_view name) {
  const auto allowed = [](char c) { return (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9') || c == '-'; };
  return !name.empty() && std::ranges::all_of(name, allowed);
}

void read_range(JsonReader& reader, std::string_view key, Range& range) {
  reader.range(key, range.low, range.high, index_limits, Presence::required);
}

PlantShape read_plant_shape(JsonReader reader) {
  PlantShape shape;
  reader.word("model", shape.model, plant_models());
  reader.number("height", shape.height, {0.02, 120});
  reader.number("crown_diameter", shape.crown_diameter, {0.02, 60});
  reader.number("trunk_fraction", shape.trunk_fraction, {0, 0.95});
  reader.numbers("leaf_colour", shape.leaf_colour, unit_limits);
  shape.autumn_colour = shape.leaf_colour;
  reader.numbers("autumn_colour", shape.autumn_colour, unit_limits);
  reader.numbers("flower_colour", shape.flower_colour, unit_limits);
  reader.boolean("evergreen", shape.evergreen);
  reader.finish();
  return shape;
}

void read_geology(JsonReader reader, std::array<float, 5>& geology) {
  for (std::size_t i = 0; i < geology.size(); ++i) reader.number(geology_words()[i], geology[i], unit_limits);
  reader.finish();
}

PlantTraits read_plant(JsonReader reader) {
  PlantTraits plant;
  read_range(reader, "illumination", plant.illumination);
  read_range(reader, "temperature", plant.temperature);
  read_range(reader, "moisture", plant.moisture);
  read_range(reader, "texture", plant.texture);
  reader.number("light_consumption", plant.light_consumption, {0, 8});
  reader.number("water_consumption", plant.water_consumption, {0, 8});
  read_geology(reader.nested("geology", Presence::optional), plant.geology);
  std::string stratum;
  reader.word("stratum", stratum, stratum_words(), Presence::required);
  for (std::size_t i = 0; i < stratum_words().size(); ++i) {
    if (stratum == stratum_words()[i]) plant.stratum = Stratum(i);
  }
  reader.number("unit_cover", plant.unit_cover, {1.0 / 240, 1});
  reader.number("growth", plant.growth, {0, 10}, Presence::required);
  reader.word("biome", plant.biome, biome_words());
  plant.shape = read_plant_shape(reader.nested("shape", Presence::optional));
  reader.finish();
  return plant;
}

AnimalShape read_animal_shape(JsonReader reader) {
  AnimalShape shape;
  reader.word("model", shape.model, animal_models());
  reader.number("shoulder_height", shape.shoulder_height, {0.05, 6});
  reader.number("body_length", shape.body_length, {0.05, 12});
  reader.numbers("coat_colour", shape.coat_colour, unit_limits);
  reader.numbers("belly_colour", shape.belly_colour, unit_limits);
  reader.word("headgear", shape.headgear, headgear_words());
  reader.finish();
  return shape;
}

/// Foods of one need: {"poaceae": 3, "herbs": 1}, a preference by species or group.
void read_foods(JsonReader& reader, std::vector<Food>& foods) {
  const std::string expected = "an object of species or groups with a preference in 0.001..1000 each, such as {\"herbs\": 1}";
  const Json* const found = reader.value("foods", Presence::required, expected);
  if (!found) return;
  if (!found->is_object() || found->empty()) return reader.refuse("foods", expected, *found);
  for (const auto& [name, preference] : found->items()) {
    const bool number = preference.is_number();
    if (!number || preference.get<double>() < 0.001 || preference.get<double>() > 1000) {
      return reader.refuse("foods." + name, "a preference in 0.001..1000", preference);
    }
    foods.push_back({name, preference.get<float>()});
  }
}

void read_diet(JsonReader& reader, const std::string& where, std::string& problem, std::vector<Need>& diet) {
  const std::string expected = "a list of at least one need {\"need\", \"amount\", \"foods\"}";
  const Json* const found = reader.value("diet", Presence::required, expected);
  if (!found) return;
  if (!found->is_array() || found->empty()) return reader.refuse("diet", expected, *found);
  for (std::size_t i = 0; i < found->size(); ++i) {
    JsonReader need_reader((*found)[i], where, problem, "diet[" + std::to_string(i) + "].");
    Need need;
    need_reader.text("need", need.name, Presence::required);
    need_reader.number("amount", need.amount, {0.0001, 10000}, Presence::required);
    read_foods(need_reader, need.foods);
    need_reader.finish();
    diet.push_back(std::move(need));
  }
}

AnimalTraits read_animal(JsonReader reader, const std::string& where, std::string& problem) {
  AnimalTraits animal;
  reader.range("herd", animal.herd_min, animal.herd_max, {1, 100000}, Presence::required);
  reader.range("mass", animal.mass_min, animal.mass_max, {0.001, 200000}, Presence::required);
  reader.number("speed", animal.speed, {0.01, 40}, Presence::required);
  reader.number("max_slope", animal.max_slope, {0.01, 20});
  reader.number("slope_sensitivity", animal.slope_sensitivity, {0, 50});
  reader.number("wade_depth", animal.wade_depth, {0, 1000});
  reader.number("max_tree_cover", animal.max_tree_cover, unit_limits);
  std::string activity = activity_words()[std::size_t(animal.activity)];
  reader.word("activity", activity, activity_words());
  for (std::size_t i = 0; i < activity_words().size(); ++i) {
    if (activity == activity_words()[i]) animal.activity = Activity(i);
  }
  reader.number("water_visits", animal.water_visits, {0, 24});
  reader.number("growth_rate", animal.growth_rate, {0, 100});
  read_diet(reader, where, problem, animal.diet);
  animal.shape = read_animal_shape(reader.nested("shape", Presence::optional));
  reader.finish();
  return animal;
}

Species read_one(const Json& json, const std::string& origin, std::size_t number, std::string& problem) {
  std::string where = origin + ": species " + std::to_string(number + 1);
  if (json.is_object() && json.contains("name") && json["name"].is_string()) {
    where = origin + ": species \"" + json["name"].get<std::string>() + "\"";
  }
  JsonReader reader(json, where, problem);
  Species species;
  reader.text("name", species.name, Presence::required);
  if (!species.name.empty() && !is_short_name(species.name)) {
    reader.refuse("name", "lower-case letters, digits and '-'", species.name);
  }
  species.scientific_name = species.name;
  reader.text("scientific_name", species.scientific_name);
  species.common_name = species.scientific_name;
  reader.text("common_name", species.common_name);
  reader.numbers("colour", species.colour, unit_limits);
  reader.dictionary("proportions", species.proportions, {0, 1e6});
  reader.dictionary("sources", species.sources);

  const Json* const plant = reader.value("plant", Presence::optional, {});
  const Json* const animal = reader.value("animal", Presence::optional, {});
  reader.finish();
  if (!reader.ok()) return species;
  if (!plant == !animal) {
    problem = where + (plant ? ": has both \"plant\" and \"animal\"; " : ": has neither \"plant\" nor \"animal\"; ") +
              "exactly one of them must hold its traits";
  } else if (plant) {
    species.traits = read_plant(reader.nested("plant", Presence::required, true));
  } else {
    species.traits = read_animal(reader.nested("animal", Presence::required, true), where, problem);
  }
  return species;
}

Json tidy(std::span<const float> values) {
  Json array = Json::array();
  for (const float value : values) array.push_back(tidy_number(value));
  return array;
}

Json tidy(Range range) { return tidy(std::array{range.low, range.high}); }

Json plant_to_json(const PlantTraits& plant) {
  Json json;
  json["stratum"] = stratum_words()[std::size_t(plant.stratum)];
  json["biome"] = plant.biome;
  json["illumination"] = tidy(plant.illumination);
  json["temperature"] = tidy(plant.temperature);
  json["moisture"] = tidy(plant.moisture);
  json["texture"] = tidy(plant.texture);
  json["light_consumption"] = tidy_number(plant.light_consumption);
  json["water_consumption"] = tidy_number(plant.water_consumption);
  for (std::size_t i = 0; i < plant.geology.size(); ++i) json["geology"][geology_words()[i]] = tidy_number(plant.geology[i]);
  json["unit_cover"] = tidy_number(plant.unit_cover);
  json["growth"] = tidy_number(plant.growth);
  const PlantShape& shape = plant.shape;
  json["shape"] = {{"model", shape.model},
                   {"height", tidy_number(shape.height)},
                   {"crown_diameter", tidy_number(shape.crown_diameter)},
                   {"trunk_fraction", tidy_number(shape.trunk_fraction)},
                   {"leaf_colour", tidy(shape.leaf_colour)},
                   {"autumn_colour", tidy(shape.autumn_colour)},
                   {"flower_colour", tidy(shape.flower_colour)},
                   {"evergreen", shape.evergreen}};
  return json;
}

Json animal_to_json(const AnimalTraits& animal) {
  Json json;
  json["herd"] = {animal.herd_min, animal.herd_max};
  json["mass"] = tidy(std::array{animal.mass_min, animal.mass_max});
  json["speed"] = tidy_number(animal.speed);
  json["max_slope"] = tidy_number(animal.max_slope);
  json["slope_sensitivity"] = tidy_number(animal.slope_sensitivity);
  json["wade_depth"] = tidy_number(animal.wade_depth);
  json["max_tree_cover"] = tidy_number(animal.max_tree_cover);
  json["activity"] = activity_words()[std::size_t(animal.activity)];
  json["water_visits"] = animal.water_visits;
  json["growth_rate"] = tidy_number(animal.growth_rate);
  json["diet"] = Json::array();
  for (const Need& need : animal.diet) {
    Json foods = Json::object();
    for (const Food& food : need.foods) foods[food.name] = tidy_number(food.preference);
    json["diet"].push_back({{"need", need.name}, {"amount", tidy_number(need.amount)}, {"foods", foods}});
  }
  const AnimalShape& shape = animal.shape;
  json["shape"] = {{"model", shape.model},
                   {"shoulder_height", tidy_number(shape.shoulder_height)},
                   {"body_length", tidy_number(shape.body_length)},
                   {"coat_colour", tidy(shape.coat_colour)},
                   {"belly_colour", tidy(shape.belly_colour)},
                   {"headgear", shape.headgear}};
  return json;
}

}  // namespace

Result<std::vector<Species>> parse_species(std::string_view text, std::string_view origin) {
  const Result<Json> json = parse_json(text, origin);
  if (!json) return tl::unexpected(json.error());
  const std::string file(origin);
  std::string problem;
  JsonReader reader(*json, file, problem);
  std::string unused_description;
  reader.text("description", unused_description);
  const Json* const list = reader.value("species", Presence::required, "a list of species");
  if (list && (!list->is_array() || list->empty())) reader.refuse("species", "a list of at least one species", *list);
  reader.finish();
  if (!problem.empty()) return fail(problem);

  std::vector<Species> species;
  std::set<std::string> names;
  for (std::size_t i = 0; i < list->size(); ++i) {
    species.push_back(read_one((*list)[i], file, i, problem));
    if (!problem.empty()) return fail(problem);
    if (!names.insert(species.back().name).second) {
      return fail(file + ": two species are named \"" + species.back().name + "\"; names must differ");
    }
  }
  return species;
}

Result<std::vector<Species>> load_species(const std::filesystem::path& file) {
  const Result<std::string> text = read_text_file(file);
  if (!text) return tl::unexpected(text.error());
  return parse_species(*text, file.filename().string());
}

std::string species_to_json(const std::vector<Species>& species) {
  Json list = Json::array();
  for (const Species& one : species) {
    Json json;
    json["name"] = one.name;
    json["scientific_name"] = one.scientific_name;
    json["common_name"] = one.common_name;
    json["colour"] = tidy(one.colour);
    if (one.is_plant()) {
      json["plant"] = plant_to_json(one.plant());
    } else {
      json["animal"] = animal_to_json(one.animal());
    }
    if (!one.proportions.empty()) json["proportions"] = one.proportions;
    if (!one.sources.empty()) json["sources"] = one.sources;
    list.push_back(std::move(json));
  }
  return Json{{"species", list}}.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace biotope

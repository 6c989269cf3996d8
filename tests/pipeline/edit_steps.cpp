#include "tests/pipeline/edit_steps.hpp"

#include <algorithm>

namespace biotope {
namespace {

const std::string& random_species(const Document& document, bool plant, Chance& chance) {
  std::vector<const Species*> all;
  for (const Species& species : *document.species) {
    if (species.is_plant() == plant) all.push_back(&species);
  }
  return all[std::size_t(chance.whole(0, int(all.size()) - 1))]->name;
}

LayerId random_layer(const Document& document, Chance& chance) {
  static constexpr std::array<const char*, 4> resources{"illumination", "temperature", "moisture", "texture"};
  switch (chance.whole(0, 9)) {
    case 0:
    case 1:
      return {LayerKind::resource, resources[std::size_t(chance.whole(0, 3))]};
    case 2:
    case 3:
      return {LayerKind::plant_density, random_species(document, true, chance)};
    case 4:
    case 5:
      return {LayerKind::animal_density, random_species(document, false, chance)};
    case 6:
      return {LayerKind::geology, "class"};
    case 7:
      return {LayerKind::loss, random_species(document, chance.whole(0, 1) == 0, chance)};
    case 8:
      return {LayerKind::passage, "all"};
    default:
      return {LayerKind::ground, "height"};
  }
}

/// Value to paint with, in the layer's unit.
float random_value(const LayerId& layer, Chance& chance) {
  switch (layer.kind) {
    case LayerKind::resource:
      return chance.real(1, 9);
    case LayerKind::plant_density:
      return chance.real(0, 1);
    case LayerKind::animal_density:
      return chance.real(0, 300);
    case LayerKind::geology:
      return float(chance.whole(0, 4));
    case LayerKind::loss:
      return chance.real(0, 1);
    case LayerKind::passage:
      return chance.whole(0, 1) == 0 ? 1.0F : -1.0F;
    case LayerKind::ground:
      return chance.real(90, 220);
  }
  return 0;
}

PathPoint random_point(const Document& document, Chance& chance) {
  const Grid<float>& height = document.terrain->height;
  return {chance.real(0, float(height.width() - 1)), chance.real(0, float(height.height() - 1))};
}

std::vector<PathPoint> random_line(const Document& document, Chance& chance, int points) {
  std::vector<PathPoint> line;
  for (int i = 0; i < points; ++i) line.push_back(random_point(document, chance));
  return line;
}

void paint(Document& document, Chance& chance) {
  const LayerId layer = random_layer(document, chance);
  const Grid<float>& height = document.terrain->height;
  const Grid<float> flat(height.width(), height.height(), layer.kind == LayerKind::resource ? 4.0F : 0.0F);
  Brush brush;
  static constexpr std::array<BrushMode, 6> modes{BrushMode::set,      BrushMode::set,    BrushMode::add,
                                                  BrushMode::subtract, BrushMode::smooth, BrushMode::restore_computed};
  brush.mode = modes[std::size_t(chance.whole(0, 5))];
  brush.radius = chance.real(2, 30);
  brush.strength = chance.real(0.3F, 1);
  brush.hardness = chance.real(0, 1);
  brush.value = random_value(layer, chance);
  Stroke stroke(layer, layer.kind == LayerKind::ground ? &height : &flat);
  const int dabs = chance.whole(1, 2);
  for (int i = 0; i < dabs; ++i) {
    const PathPoint at = random_point(document, chance);
    stroke.dab(document, brush, at.x, at.y);
  }
}

void place(Document& document, Chance& chance) {
  Placements& placed = document.placements;
  switch (chance.whole(0, 6)) {
    case 0:
      placed.places.fords.push_back({random_point(document, chance), chance.real(5, 60)});
      break;
    case 1:
      placed.places.exits.push_back({random_point(document, chance), chance.real(5, 60)});
      break;
    case 2:
      placed.places.waypoints.push_back({random_point(document, chance), chance.real(0.05F, 0.6F)});
      break;
    case 3:
      placed.places.pinned_trails.push_back({random_line(document, chance, chance.whole(2, 4)), chance.real(1e3F, 1e5F)});
      break;
    case 4:
      placed.places.forbidden_trails.push_back({random_line(document, chance, chance.whole(2, 4)), chance.real(5, 60)});
      break;
    case 5:
      placed.water.rivers.push_back({random_line(document, chance, chance.whole(2, 4)), double(chance.real(0.05F, 5))});
      break;
    default:
      placed.water.lakes.push_back({random_line(document, chance, chance.whole(3, 5)), chance.real(1, 6)});
      break;
  }
}

template <class T>
bool remove_one(std::vector<T>& placed, Chance& chance) {
  if (placed.empty()) return false;
  placed.erase(placed.begin() + chance.whole(0, int(placed.size()) - 1));
  return true;
}

void remove_placed(Document& document, Chance& chance) {
  Placements& placed = document.placements;
  const int first = chance.whole(0, 7);
  for (int i = 0; i < 8; ++i) {
    bool removed = false;
    switch ((first + i) % 8) {
      case 0:
        removed = remove_one(placed.places.fords, chance);
        break;
      case 1:
        removed = remove_one(placed.places.exits, chance);
        break;
      case 2:
        removed = remove_one(placed.places.waypoints, chance);
        break;
      case 3:
        removed = remove_one(placed.places.pinned_trails, chance);
        break;
      case 4:
        removed = remove_one(placed.places.forbidden_trails, chance);
        break;
      case 5:
        removed = remove_one(placed.water.rivers, chance);
        break;
      case 6:
        removed = remove_one(placed.water.lakes, chance);
        break;
      default:
        removed = remove_one(placed.plans, chance);
        break;
    }
    if (removed) return;
  }
}

void plan(Document& document, Chance& chance) {
  PlanEdit edit;
  edit.species = random_species(document, false, chance);
  edit.home = random_point(document, chance);
  edit.number = chance.whole(0, 1);
  const int stops = chance.whole(1, 3);
  float hour = 6;
  for (int i = 0; i < stops; ++i) {
    const float arrive = hour + chance.real(0.5F, 2);
    const float leave = arrive + chance.real(0.5F, 2);
    edit.stops.push_back({random_point(document, chance), arrive, leave});
    hour = leave;
  }
  document.placements.plans.push_back(std::move(edit));
}

void change_climate(Document& document, Chance& chance) {
  if (chance.whole(0, 1) == 0) {
    document.climate.precipitation[std::size_t(chance.whole(0, 11))] += 10;
  } else {
    document.climate.lapse_rate = chance.real(4, 8);
  }
}

void change_species(Document& document, Chance& chance) {
  std::vector<Species> species = *document.species;
  Species& one = species[std::size_t(chance.whole(0, int(species.size()) - 1))];
  if (one.is_plant()) {
    std::get<PlantTraits>(one.traits).growth *= chance.real(0.7F, 1.4F);
  } else if (chance.whole(0, 1) == 0) {
    std::get<AnimalTraits>(one.traits).max_slope *= chance.real(0.8F, 1.3F);
  } else {
    one.proportions["default"] = double(chance.real(0.1F, 1));
  }
  document.species = std::make_shared<const std::vector<Species>>(std::move(species));
}

template <class Map>
typename Map::const_iterator random_entry(const Map& map, Chance& chance) {
  return std::next(map.begin(), map.empty() ? 0 : chance.whole(0, int(map.size()) - 1));
}

void edit(Document& document, const Step& step) {
  Chance chance(step.number);
  switch (step.kind) {
    case StepKind::paint:
      return paint(document, chance);
    case StepKind::clear:
      if (!document.layers.empty()) document.layers.erase(random_entry(document.layers, chance)->first);
      return;
    case StepKind::hide:
      if (!document.layers.empty()) {
        LayerState& state = document.layer_states[random_entry(document.layers, chance)->first];
        state.hidden = !state.hidden;
      }
      return;
    case StepKind::place:
      return place(document, chance);
    case StepKind::remove_placed:
      return remove_placed(document, chance);
    case StepKind::plan:
      return plan(document, chance);
    case StepKind::climate:
      return change_climate(document, chance);
    case StepKind::species:
      return change_species(document, chance);
    case StepKind::proportions: {
      const int level = chance.whole(1, 2);
      const auto known = document.use_proportions.find(level);
      document.use_proportions[level] = known != document.use_proportions.end() && !known->second;
      return;
    }
    case StepKind::seed:
      document.seed += 1;
      return;
    case StepKind::inflow:
      if (document.inflows.size() > 1) {
        document.inflows.pop_back();
      } else {
        document.inflows.push_back({chance.whole(0, document.terrain->height.width() - 1), 0, 5e7});
      }
      return;
    case StepKind::undo:
    case StepKind::redo:
      return;
  }
}

}  // namespace

void Session::perform(const Step& step) {
  if (step.kind == StepKind::undo) {
    position -= std::min<std::size_t>(position, 1 + step.number % 3);
    return;
  }
  if (step.kind == StepKind::redo) {
    position = std::min(states.size() - 1, position + 1 + std::size_t(step.number % 3));
    return;
  }
  states.resize(position + 1, states.front());
  Document next = states.back();
  edit(next, step);
  states.push_back(std::move(next));
  ++position;
}

std::string to_string(const Step& step) {
  static constexpr std::array<const char*, step_kinds> kinds{"paint",  "clear",   "hide",    "place",       "remove_placed",
                                                             "plan",   "climate", "species", "proportions", "seed",
                                                             "inflow", "undo",    "redo"};
  static constexpr std::array<const char*, 3> answers{"", ", solved", ", stopped"};
  return std::string(kinds[std::size_t(step.kind)]) + " #" + std::to_string(step.number) + answers[std::size_t(step.answer)];
}

std::vector<Step> random_steps(std::uint64_t seed, int count) {
  // Paint and placements are what people do most.
  static constexpr std::array<StepKind, 20> mix{StepKind::paint,         StepKind::paint, StepKind::paint,   StepKind::paint,
                                                StepKind::paint,         StepKind::paint, StepKind::paint,   StepKind::clear,
                                                StepKind::hide,          StepKind::place, StepKind::place,   StepKind::place,
                                                StepKind::remove_placed, StepKind::plan,  StepKind::climate, StepKind::species,
                                                StepKind::proportions,   StepKind::undo,  StepKind::redo,    StepKind::undo};
  std::vector<Step> steps;
  for (int i = 0; i < count; ++i) {
    const auto place = std::uint64_t(i);
    Step step;
    step.kind = mix[std::size_t(random_int(0, int(mix.size()) - 1, {seed, place, 1}))];
    if (random_int(0, 30, {seed, place, 2}) == 0) step.kind = StepKind::seed;
    if (random_int(0, 30, {seed, place, 3}) == 0) step.kind = StepKind::inflow;
    step.number = random_bits({seed, place, 4}) >> 40;
    const int answer = random_int(0, 9, {seed, place, 5});
    step.answer = answer < 2 ? Answer::none : (answer < 5 ? Answer::stopped : Answer::whole);
    steps.push_back(step);
  }
  return steps;
}

}  // namespace biotope

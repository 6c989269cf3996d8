#include "render/animal_proportions.hpp"

#include <array>
#include <utility>

#include "render/animal_builds.hpp"

namespace biotope {

namespace {

using namespace animal_builds;

using Maker = AnimalBuild (*)();

constexpr std::array<std::pair<std::string_view, Maker>, 25> genera{{
    {"Cervus", red_deer},
    {"Dama", fallow_deer},
    {"Rangifer", reindeer},
    {"Alces", moose},
    {"Odocoileus", mule_deer},
    {"Bison", bison},
    {"Bos", bison},
    {"Equus", horse},
    {"Capra", goat},
    {"Hemitragus", tahr},
    {"Antilocapra", pronghorn},
    {"Rupicapra", chamois},
    {"Ovis", sheep},
    {"Ursus", bear},
    {"Canis", wolf},
    {"Vulpes", fox},
    {"Lynx", lynx},
    {"Panthera", cat},
    {"Puma", cat},
    {"Felis", cat},
    {"Sus", boar},
    {"Stephanorhinus", rhino},
    {"Coelodonta", rhino},
    {"Capreolus", mule_deer},
    {"Megaloceros", moose},
}};

constexpr std::array<std::pair<std::string_view, Maker>, 11> models{{
    {"bovid", bison},
    {"deer", red_deer},
    {"horse", horse},
    {"goat", goat},
    {"sheep", sheep},
    {"bear", bear},
    {"wolf", wolf},
    {"cat", cat},
    {"fox", fox},
    {"boar", boar},
    {"rhino", rhino},
}};

/// A person's word on headgear counts before what the genus has.
void set_headgear(const AnimalShape& shape, AnimalBuild& build) {
  const auto antlered = [&] { return build.headgear >= Headgear::red_antlers && build.headgear <= Headgear::forked_antlers; };
  if (shape.headgear == "none") build.headgear = Headgear::none;
  if (shape.headgear == "antlers" && (!antlered() || build.headgear == Headgear::palmate_antlers))
    build.headgear = Headgear::red_antlers;
  if (shape.headgear == "palmate") build.headgear = Headgear::palmate_antlers;
  if (shape.headgear == "curled") build.headgear = Headgear::curled_horns;
  if (shape.headgear == "horns" && (antlered() || build.headgear == Headgear::none || build.headgear == Headgear::curled_horns)) {
    build.headgear = Headgear::ibex_horns;
    build.female_headgear = 0.6F;
  }
}

}  // namespace

AnimalBuild animal_build(const AnimalShape& shape, std::string_view scientific_name) {
  const std::string_view genus = scientific_name.substr(0, scientific_name.find(' '));
  AnimalBuild build = red_deer();
  bool found = false;
  for (const auto& [name, make] : models) {
    if (name == shape.model) build = make();
  }
  for (const auto& [name, make] : genera) {
    if (name != genus) continue;
    build = make();
    found = true;
  }
  if (found || shape.headgear != "horns" || build.headgear == Headgear::none) set_headgear(shape, build);
  return build;
}

}  // namespace biotope

#include <algorithm>
#include <cassert>
#include <utility>

#include "core/ecosystem/explanation.hpp"
#include "core/ecosystem/explanation_plant_text.hpp"
#include "core/ecosystem/losses.hpp"
#include "core/ecosystem/plant_competition_kernel.hpp"

namespace biotope {

namespace {

constexpr std::array<std::string_view, geology_classes> ground_names{"on limestone", "in water", "on marl", "on scree",
                                                                     "on alluvium"};

/// The plants of a cell, and the one that is asked about among them.
struct Stand {
  const FoodWeb& web;
  std::vector<int> cover;  ///< by position in web.levels[0], steps of 1/240
  std::size_t asked = 0;

  [[nodiscard]] const Species& species(std::size_t i) const { return web.species[std::size_t(web.levels[0][i])]; }
  [[nodiscard]] const PlantTraits& traits(std::size_t i) const { return species(i).plant(); }
  [[nodiscard]] const std::string& name(std::size_t i) const {
    return species(i).common_name.empty() ? species(i).name : species(i).common_name;
  }
  [[nodiscard]] double fraction(std::size_t i) const { return double(cover[i]) / full_cover; }
  [[nodiscard]] bool shares_ground(std::size_t i) const { return traits(i).stratum == traits(asked).stratum; }
  /// Whether a plant's shade and thirst come before those of the asked one: it does not stand below.
  [[nodiscard]] bool comes_first(std::size_t i) const { return i != asked && traits(i).stratum <= traits(asked).stratum; }
};

Stand stand_at(const FoodWeb& web, int plant, std::span<const std::shared_ptr<const CoverMap>> covers, int x, int y) {
  Stand stand{web, {}, 0};
  for (const auto& map : covers) stand.cover.push_back(map ? int((*map)(x, y)) : 0);
  stand.cover.resize(web.levels[0].size());
  const auto& level = web.levels[0];
  stand.asked = std::size_t(std::find(level.begin(), level.end(), plant) - level.begin());
  assert(stand.asked < level.size());
  return stand;
}

float consumption(const PlantTraits& plant, Resource resource) {
  if (resource == Resource::illumination) return plant.light_consumption;
  return resource == Resource::moisture ? plant.water_consumption : 0;
}

/// Index points of a resource that the asked plant's rivals take before it.
float taken_by_rivals(const Stand& stand, Resource resource) {
  double taken = 0;
  for (std::size_t i = 0; i < stand.cover.size(); ++i) {
    if (stand.comes_first(i)) taken += double(consumption(stand.traits(i), resource)) * stand.fraction(i);
  }
  return float(taken);
}

CellEnvironment without(CellEnvironment cell, float light, float water) {
  for (float& month : cell.monthly[std::size_t(Resource::illumination)]) month -= light;
  for (float& month : cell.monthly[std::size_t(Resource::moisture)]) month -= water;
  return cell;
}

CellEnvironment after_rivals(const Stand& stand, const CellEnvironment& cell) {
  return without(cell, taken_by_rivals(stand, Resource::illumination), taken_by_rivals(stand, Resource::moisture));
}

/// The rival that takes most of a resource, or of the stratum's ground when none is named; -1 when nobody does.
template <class Amount>
int greatest_rival(const Stand& stand, const Amount& amount) {
  int rival = -1;
  double most = 0;
  for (std::size_t i = 0; i < stand.cover.size(); ++i) {
    if (!stand.comes_first(i) || amount(i) <= most) continue;
    most = amount(i);
    rival = int(i);
  }
  return rival;
}

Range range_of(const PlantTraits& plant, Resource resource) {
  switch (resource) {
    case Resource::illumination:
      return plant.illumination;
    case Resource::temperature:
      return plant.temperature;
    case Resource::moisture:
      return plant.moisture;
  }
  return {};
}

bool is_monthly(LimitingFactor factor) {
  return factor == LimitingFactor::illumination || factor == LimitingFactor::temperature || factor == LimitingFactor::moisture;
}

/// The resource of a monthly limiting factor.
Resource resource_of(LimitingFactor factor) {
  assert(is_monthly(factor));
  return Resource(int(factor) - int(LimitingFactor::illumination));
}

std::string needs_text(Range range) {
  return "needs " + number_text(double(range.low), 1) + " to " + number_text(double(range.high), 1);
}

/// What is wrong with a place, in few words: "too dry from May to September".
std::string fault_text(const PlantTraits& plant, const CellEnvironment& cell, LimitingFactor factor) {
  if (is_monthly(factor)) {
    const Resource resource = resource_of(factor);
    return misfit_text(resource, year_misfit(range_of(plant, resource), cell.monthly[std::size_t(resource)]));
  }
  if (factor == LimitingFactor::texture) return cell.texture < plant.texture.low ? "soil too fine" : "soil too stony";
  if (factor == LimitingFactor::geology) {
    return "does not grow " + std::string(ground_names[std::size_t(cell.geology)]);
  }
  return "nothing is wrong";
}

/// One sentence on a resource that is less than perfect.
std::string monthly_detail(Resource resource, Range range, const std::array<float, months>& year, float fitness) {
  const YearMisfit misfit = year_misfit(range, year);
  const float value = year[std::size_t(misfit.worst_month)];
  std::string text = resource_text(resource) + ": " + std::to_string(misfit.months_low + misfit.months_high) + " of 12 months " +
                     misfit_text(resource, misfit) + "; index " + index_text(resource, value) + " in " +
                     month_text(misfit.worst_month) + ", " + needs_text(range) + " (" +
                     (misfit.missing > 0 ? number_text(double(misfit.missing), 1) + " missing"
                                         : number_text(double(misfit.excess), 1) + " too much") +
                     "). Fitness " + number_text(double(fitness), 2) + ".";
  if (resource == Resource::illumination && misfit.missing > 0) {
    text += " Slopes away from the sun, shadows of mountains and taller plants darken a place.";
  }
  return text;
}

/// Sentences on every resource that is less than perfect, the worst first.
std::vector<std::string> resource_details(const PlantTraits& plant, const CellEnvironment& cell) {
  std::vector<std::pair<float, std::string>> found;
  for (std::size_t r = 0; r < monthly_resources; ++r) {
    const Range range = range_of(plant, Resource(r));
    const float fitness = resource_fitness(range, cell.monthly[r]);
    if (fitness < 1) found.emplace_back(fitness, monthly_detail(Resource(r), range, cell.monthly[r], fitness));
  }
  if (!plant.texture.contains(cell.texture)) {
    found.emplace_back(0, "Soil texture: index " + number_text(double(cell.texture), 1) + ", " + needs_text(plant.texture) +
                              " (1 is clay, 9 is stones).");
  }
  const float viability = plant.geology[std::size_t(cell.geology)];
  if (viability < 1) {
    found.emplace_back(viability, "Ground: viability " + number_text(double(viability), 2) + " " +
                                      std::string(ground_names[std::size_t(cell.geology)]) + ".");
  }
  std::ranges::stable_sort(found, {}, [](const auto& detail) { return detail.first; });
  std::vector<std::string> details;
  for (auto& detail : found) details.push_back(std::move(detail.second));
  return details;
}

/// What the rivals have taken of light and water, with their covers.
void add_rival_details(const Stand& stand, const CellEnvironment& cell, std::vector<std::string>& details) {
  for (const Resource resource : {Resource::illumination, Resource::moisture}) {
    const float taken = taken_by_rivals(stand, resource);
    const int rival =
        greatest_rival(stand, [&](std::size_t i) { return double(consumption(stand.traits(i), resource)) * stand.fraction(i); });
    if (rival < 0) continue;
    float mean = 0;
    for (const float month : cell.monthly[std::size_t(resource)]) mean += month / float(months);
    details.push_back("Other plants take " + number_text(double(taken), 1) + " of its yearly mean " +
                      (resource == Resource::illumination ? "illumination" : "moisture") + " index " +
                      number_text(double(mean), 1) + ", most of it " + stand.name(std::size_t(rival)) + " (cover " +
                      percent_text(stand.fraction(std::size_t(rival))) + ").");
  }
}

int ground_left(const Stand& stand) {
  int left = full_cover;
  for (std::size_t i = 0; i < stand.cover.size(); ++i) {
    if (stand.shares_ground(i)) left -= stand.cover[i];
  }
  return left;
}

/// Who holds most of the stratum's ground, with its fitness against the asked plant's.
std::string ground_text(const Stand& stand, const CellEnvironment& cell, float own_fitness) {
  const int rival = greatest_rival(stand, [&](std::size_t i) { return stand.shares_ground(i) ? stand.fraction(i) : 0; });
  if (rival < 0) return "its own cover takes the ground";
  const auto i = std::size_t(rival);
  const float fitness = plant_fitness(stand.traits(i), cell).value;
  return stand.name(i) + " takes the ground first (cover " + percent_text(stand.fraction(i)) + ", fitness " +
         number_text(double(fitness), 2) + " against " + number_text(double(own_fitness), 2) + ")";
}

/// Whether the mean that is left of light or water feeds no unit of the plant.
bool is_used_up(const PlantTraits& plant, const CellEnvironment& left) {
  const auto short_of = [&](Resource resource) {
    float mean = 0;
    for (const float month : left.monthly[std::size_t(resource)]) mean += month / float(months);
    return mean <= unit_consumption(consumption(plant, resource), unit_of(plant));
  };
  return short_of(Resource::illumination) || short_of(Resource::moisture);
}

std::string absent_headline(const Stand& stand, const CellEnvironment& cell, const CellEnvironment& left, const Fitness& before,
                            const Fitness& now) {
  const PlantTraits& plant = stand.traits(stand.asked);
  if (before.value < least_fitness && now.value < least_fitness) return "Absent: " + fault_text(plant, cell, before.limiting);
  if (now.value < least_fitness) {
    const Resource resource = resource_of(now.limiting);
    const int rival =
        greatest_rival(stand, [&](std::size_t i) { return double(consumption(stand.traits(i), resource)) * stand.fraction(i); });
    const std::string what = resource == Resource::illumination ? "light" : "water";
    const std::string who = rival < 0 ? "others take" : stand.name(std::size_t(rival)) + " takes";
    return "Out-competed: " + who + " the " + what + " first, " + fault_text(plant, left, now.limiting);
  }
  if (ground_left(stand) < int(unit_of(plant))) return "Out-competed: " + ground_text(stand, left, now.value);
  if (is_used_up(plant, left)) return "Out-competed: others have used up the light or the water";
  return "Absent, though it could grow here: its share is met elsewhere, or it was painted away";
}

/// Why a plant that grows somewhere does not cover more of it.
std::string bound_text(const Stand& stand, const CellEnvironment& left) {
  const PlantTraits& plant = stand.traits(stand.asked);
  const double cover = stand.fraction(stand.asked);
  if (stand.cover[stand.asked] + int(unit_of(plant)) > full_cover) return "It covers the whole place.";
  if (ground_left(stand) < int(unit_of(plant))) {
    return "No more because " + ground_text(stand, left, plant_fitness(plant, left).value) + ".";
  }
  const CellEnvironment own = without(left, float(plant.light_consumption * cover), float(plant.water_consumption * cover));
  const Fitness more = plant_fitness(plant, own);
  if (more.value < least_fitness) {
    return "No more because with its own shade and thirst the place is " + fault_text(plant, own, more.limiting) + ".";
  }
  if (is_used_up(plant, own)) return "No more because the light or the water is used up.";
  return "More would fit: its share is met elsewhere, or its cover was painted.";
}

}  // namespace

Explanation explain_plant(const FoodWeb& web, const PlantEnvironment& environment, int plant,
                          std::span<const std::shared_ptr<const CoverMap>> covers, int x, int y, const PaintLayer* loss) {
  const Stand stand = stand_at(web, plant, covers, x, y);
  const PlantTraits& traits = stand.traits(stand.asked);
  const CellEnvironment cell = environment.cell(x, y);
  const CellEnvironment left = after_rivals(stand, cell);
  const Fitness before = plant_fitness(traits, cell);
  const Fitness now = plant_fitness(traits, left);

  Explanation explanation;
  explanation.fitness = before.value;
  explanation.limiting = before.limiting;
  if (stand.cover[stand.asked] == 0) {
    explanation.headline = absent_headline(stand, cell, left, before, now);
  } else if (before.value < least_fitness && now.value < least_fitness) {
    explanation.headline = "Painted: cover " + percent_text(stand.fraction(stand.asked)) + " where it would not grow, " +
                           fault_text(traits, cell, before.limiting);
  } else {
    explanation.headline =
        "Present: cover " + percent_text(stand.fraction(stand.asked)) + ", fitness " + number_text(double(before.value), 2);
    if (is_monthly(before.limiting)) explanation.headline += ", " + fault_text(traits, cell, before.limiting);
    explanation.details.push_back(bound_text(stand, left));
  }
  for (std::string& detail : resource_details(traits, cell)) explanation.details.push_back(std::move(detail));
  add_rival_details(stand, cell, explanation.details);
  const float kept = loss != nullptr ? share_kept(loss_steps((*loss)(x, y))) : 1.0F;
  if (kept < 1 && stand.cover[stand.asked] > 0) {
    const double grams = 1000 * double(traits.growth) * stand.fraction(stand.asked);
    explanation.details.push_back("An external event takes " + percent_text(1 - double(kept)) + " of its yearly growth here: " +
                                  number_text(grams * (1 - double(kept)), 0) + " of " + number_text(grams, 0) + " g per m2.");
  }
  if (explanation.details.empty()) explanation.details.push_back("Every resource is within its range all year.");
  return explanation;
}

}  // namespace biotope

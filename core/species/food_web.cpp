#include <algorithm>
#include <cassert>
#include <map>
#include <numeric>
#include <optional>
#include <utility>

#include "core/climate/json_reader.hpp"
#include "core/species/species_library.hpp"
#include "core/species/species_words.hpp"

namespace biotope {
namespace {

bool is_plant_group(std::string_view name) { return name == "herbs" || name == "shrubs" || name == "trees" || name == "plants"; }

bool is_group(std::string_view name) { return std::ranges::find(group_words(), name) != group_words().end(); }

int position(const std::vector<Species>& species, std::string_view name) {
  const auto found = std::ranges::find(species, name, &Species::name);
  return found == species.end() ? -1 : int(found - species.begin());
}

/// An animal whose every food is a plant or a group of plants. Decided by what its diet names, so that groups never depend on
/// each other.
bool is_herbivore(const std::vector<Species>& species, const Species& one) {
  if (one.is_plant()) return false;
  for (const Need& need : one.animal().diet) {
    for (const Food& food : need.foods) {
      const int eaten = position(species, food.name);
      if (eaten >= 0 ? !species[std::size_t(eaten)].is_plant() : !is_plant_group(food.name)) return false;
    }
  }
  return true;
}

bool belongs(const std::vector<Species>& species, const Species& one, std::string_view group) {
  if (one.is_plant()) {
    const Stratum stratum = one.plant().stratum;
    return group == "plants" || (group == "herbs" && stratum == Stratum::herb) ||
           (group == "shrubs" && stratum == Stratum::shrub) || (group == "trees" && stratum == Stratum::tree);
  }
  if (group == "animals") return true;
  if (group == "herbivores") return is_herbivore(species, one);
  return group == "carnivores" && !is_herbivore(species, one);
}

void add_food(FoodWeb::ResolvedNeed& resolved, int number, float preference) {
  if (std::ranges::find(resolved.foods, number) != resolved.foods.end()) return;
  resolved.foods.push_back(number);
  resolved.preferences.push_back(preference);
}

/// Species numbers that meet a need, those it names first. A species that is named keeps its own preference, whatever its group's
/// is.
Result<FoodWeb::ResolvedNeed> resolve(const std::vector<Species>& species, int eater, const Need& need) {
  const std::string where = "species \"" + species[std::size_t(eater)].name + "\", need \"" + need.name + "\": ";
  FoodWeb::ResolvedNeed resolved;
  resolved.amount = need.amount;
  for (const Food& food : need.foods) {
    const int number = position(species, food.name);
    if (number == eater) return fail(where + "it cannot eat its own species");
    if (number < 0 && !is_group(food.name)) {
      std::vector<std::string> known(group_words().begin(), group_words().end());
      for (const Species& one : species) known.push_back(one.name);
      return fail(where + "\"" + food.name + "\" is neither a species of this list nor a group" +
                  nearest_word_hint(food.name, known));
    }
    if (number >= 0) add_food(resolved, number, food.preference);
  }
  for (const Food& food : need.foods) {
    if (position(species, food.name) >= 0) continue;
    for (int number = 0; number < int(species.size()); ++number) {
      if (number == eater || !belongs(species, species[std::size_t(number)], food.name)) continue;
      add_food(resolved, number, food.preference);
    }
  }
  if (resolved.foods.empty()) {
    std::string groups;
    for (const Food& food : need.foods) groups += (groups.empty() ? "\"" : ", \"") + food.name + "\"";
    return fail(where + "no species of this list belongs to " + groups + "; add one, or another food");
  }
  return resolved;
}

using Diets = std::vector<std::vector<FoodWeb::ResolvedNeed>>;

/// The food through which `eater` eats `eaten`: its own name, or its group in brackets.
std::string through(const std::vector<Species>& species, int eater, int eaten) {
  const std::string& name = species[std::size_t(eaten)].name;
  std::string group;
  for (const Need& need : species[std::size_t(eater)].animal().diet) {
    for (const Food& food : need.foods) {
      if (food.name == name) return "\"" + name + "\"";
      if (is_group(food.name) && belongs(species, species[std::size_t(eaten)], food.name)) group = food.name;
    }
  }
  return "\"" + name + "\" (one of \"" + group + "\")";
}

/// Depth-first over diets; fills `level`, or names the first cycle met.
class LevelFinder {
 public:
  LevelFinder(const std::vector<Species>& species, const Diets& diets)
      : species_(species), diets_(diets), level_(species.size(), unknown) {}

  Status visit(int number) {
    int& level = level_[std::size_t(number)];
    if (level == in_progress) return fail(cycle_text(number));
    if (level != unknown) return {};
    level = in_progress;
    path_.push_back(number);
    int highest = -1;
    for (const FoodWeb::ResolvedNeed& need : diets_[std::size_t(number)]) {
      for (const int food : need.foods) {
        if (Status status = visit(food); !status) return status;
        highest = std::max(highest, level_[std::size_t(food)]);
      }
    }
    path_.pop_back();
    level_[std::size_t(number)] = highest + 1;
    return {};
  }

  [[nodiscard]] const std::vector<int>& levels() const { return level_; }

 private:
  static constexpr int unknown = -1;
  static constexpr int in_progress = -2;

  [[nodiscard]] std::string cycle_text(int again) const {
    auto from = std::ranges::find(path_, again);
    std::string text = "a diet cycle: \"" + species_[std::size_t(again)].name + "\"";
    for (; from != path_.end(); ++from) {
      const int eaten = from + 1 == path_.end() ? again : *(from + 1);
      text += " eats " + through(species_, *from, eaten);
      if (from + 1 != path_.end()) text += ", which";
    }
    return text + "; remove one of these foods";
  }

  const std::vector<Species>& species_;
  const Diets& diets_;
  std::vector<int> level_;
  std::vector<int> path_;
};

/// Puts species in the order of their level, keeping the listed order within one, and renumbers diets.
FoodWeb ordered_by_level(std::vector<Species> species, const Diets& diets, const std::vector<int>& level) {
  std::vector<int> order(species.size());
  std::iota(order.begin(), order.end(), 0);
  std::ranges::stable_sort(order, {}, [&](int number) { return level[std::size_t(number)]; });
  std::vector<int> new_number(species.size());
  for (std::size_t i = 0; i < order.size(); ++i) new_number[std::size_t(order[i])] = int(i);

  FoodWeb web;
  for (const int old_number : order) {
    const auto old_index = std::size_t(old_number);
    const int own_level = level[old_index];
    if (web.level_count() <= own_level) web.levels.resize(std::size_t(own_level) + 1);
    web.levels[std::size_t(own_level)].push_back(new_number[old_index]);
    web.level.push_back(own_level);
    web.diets.push_back(diets[old_index]);
    for (FoodWeb::ResolvedNeed& need : web.diets.back()) {
      for (int& food : need.foods) food = new_number[std::size_t(food)];
    }
    web.species.push_back(std::move(species[old_index]));
  }
  return web;
}

Status check_names(const std::vector<Species>& species) {
  for (std::size_t i = 0; i < species.size(); ++i) {
    const std::string& name = species[i].name;
    if (is_group(name)) return fail("species \"" + name + "\": this is the name of a group; choose another");
    if (position(species, name) != int(i)) return fail("two species are named \"" + name + "\"; names must differ");
    if (!species[i].is_plant() && species[i].animal().diet.empty()) {
      return fail("species \"" + name + "\": an animal needs a diet of at least one need");
    }
  }
  return {};
}

}  // namespace

int FoodWeb::find(std::string_view name) const { return position(species, name); }

Result<FoodWeb> build_food_web(std::vector<Species> species) {
  if (Status status = check_names(species); !status) return tl::unexpected(status.error());
  Diets diets(species.size());
  for (std::size_t i = 0; i < species.size(); ++i) {
    if (species[i].is_plant()) continue;
    for (const Need& need : species[i].animal().diet) {
      Result<FoodWeb::ResolvedNeed> resolved = resolve(species, int(i), need);
      if (!resolved) return tl::unexpected(resolved.error());
      diets[i].push_back(std::move(*resolved));
    }
  }
  LevelFinder finder(species, diets);
  for (std::size_t i = 0; i < species.size(); ++i) {
    if (Status status = finder.visit(int(i)); !status) return tl::unexpected(status.error());
  }
  const std::vector<int> level = finder.levels();
  return ordered_by_level(std::move(species), diets, level);
}

namespace {

/// What a species asks for under a climate; none where it asks for nothing at all. Who asks under other climates only asks for 0.
std::optional<double> asked_share(const Species& species, std::string_view climate) {
  if (species.proportions.empty()) return std::nullopt;
  auto found = species.proportions.find(std::string(climate));
  if (found == species.proportions.end()) found = species.proportions.find("default");
  return found == species.proportions.end() ? 0.0 : found->second;
}

/// The share of each species that asks for none, beside `asking` others that ask for `sum` together.
double share_unasked(double sum, int asking, int silent) { return sum <= 1 ? (1 - sum) / silent : sum / asking; }

}  // namespace

std::vector<double> desired_proportions(const FoodWeb& web, int level, std::string_view climate) {
  assert(level >= 0 && level < web.level_count());
  std::vector<std::optional<double>> asked;
  double sum = 0;
  int asking = 0;
  for (const int number : web.levels[std::size_t(level)]) {
    asked.push_back(asked_share(web.species[std::size_t(number)], climate));
    sum += asked.back().value_or(0);
    asking += asked.back() ? 1 : 0;
  }
  if (sum <= 0) return {};
  const int silent = int(asked.size()) - asking;
  const double unasked = silent > 0 ? share_unasked(sum, asking, silent) : 0;
  const double all = sum + silent * unasked;
  std::vector<double> shares;
  for (const std::optional<double>& share : asked) shares.push_back(share.value_or(unasked) / all);
  return shares;
}

}  // namespace biotope

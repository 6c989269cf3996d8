#include "core/exchange/edit_script_parts.hpp"

#include <algorithm>
#include <memory>

#include "core/species/species_library.hpp"

namespace biotope {
namespace {

bool same_inflows(const std::vector<Inflow>& a, const std::vector<Inflow>& b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(), [](const Inflow& one, const Inflow& other) {
    return one.x == other.x && one.y == other.y && one.catchment_area == other.catchment_area;
  });
}

std::vector<std::string> names_of(const std::vector<Species>& species) {
  std::vector<std::string> names;
  for (const Species& one : species) names.push_back(one.name);
  return names;
}

auto named(std::vector<Species>& species, const std::string& name) {
  return std::find_if(species.begin(), species.end(), [&](const Species& one) { return one.name == name; });
}

SpeciesPatch species_between(const std::vector<Species>& before, const std::vector<Species>& after) {
  SpeciesPatch patch;
  const auto find_in = [](const std::vector<Species>& list, const std::string& name) {
    return std::find_if(list.begin(), list.end(), [&](const Species& one) { return one.name == name; });
  };
  std::vector<std::string> order;
  for (const Species& one : before) {
    if (find_in(after, one.name) == after.end()) {
      patch.removed.push_back(one.name);
    } else {
      order.push_back(one.name);
    }
  }
  for (const Species& one : after) {
    const auto old = find_in(before, one.name);
    if (old == before.end()) order.push_back(one.name);
    if (old == before.end() || *old != one) patch.changed.push_back(one);
  }
  if (order != names_of(after)) patch.order = names_of(after);
  return patch;
}

Status put_in_order(std::vector<Species>& species, const std::vector<std::string>& order, const std::string& where) {
  std::vector<Species> ordered;
  for (const std::string& name : order) {
    const auto found = named(species, name);
    if (found == species.end()) return fail(where + ": species.order names \"" + name + "\", which is not among the species.");
    ordered.push_back(std::move(*found));
    species.erase(found);
  }
  if (!species.empty())
    return fail(where + ": species.order leaves out \"" + species.front().name + "\"; it must name every species.");
  species = std::move(ordered);
  return {};
}

Result<std::vector<Species>> patched(std::vector<Species> species, const SpeciesPatch& patch, const std::string& where) {
  for (const std::string& name : patch.removed) {
    const auto found = named(species, name);
    if (found == species.end())
      return fail(where + ": species.removed names \"" + name + "\", but there is no such species here.");
    species.erase(found);
  }
  for (const Species& one : patch.changed) {
    const auto found = named(species, one.name);
    if (found == species.end()) {
      species.push_back(one);
    } else {
      *found = one;
    }
  }
  if (!patch.order.empty()) {
    if (Status ordered = put_in_order(species, patch.order, where); !ordered) return tl::unexpected(ordered.error());
  }
  if (const auto web = build_food_web(species); !web) return fail(where + ": " + web.error().message);
  return species;
}

Status check_inflows(const std::vector<Inflow>& inflows, const Document& document, const std::string& where) {
  for (const Inflow& inflow : inflows) {
    if (document.terrain && document.terrain->height.contains(inflow.x, inflow.y)) continue;
    return fail(where + ": an inflow at " + std::to_string(inflow.x) + ", " + std::to_string(inflow.y) +
                " lies outside the terrain.");
  }
  return {};
}

}  // namespace

bool PartsPatch::empty() const {
  return !title && !seed && !climate && !species && !use_proportions && !inflows && !placements && !layer_states;
}

bool operator==(const PartsPatch& a, const PartsPatch& b) {
  const bool same = a.inflows.has_value() == b.inflows.has_value() && (!a.inflows || same_inflows(*a.inflows, *b.inflows));
  return same && a.name == b.name && a.title == b.title && a.seed == b.seed && a.climate == b.climate && a.species == b.species &&
         a.use_proportions == b.use_proportions && a.placements == b.placements && a.layer_states == b.layer_states;
}

PartsPatch patch_between(const Document& before, const Document& after) {
  PartsPatch patch;
  if (before.title != after.title) patch.title = after.title;
  if (before.seed != after.seed) patch.seed = after.seed;
  if (before.climate != after.climate) patch.climate = after.climate;
  if (before.use_proportions != after.use_proportions) patch.use_proportions = after.use_proportions;
  if (!same_inflows(before.inflows, after.inflows)) patch.inflows = after.inflows;
  if (before.placements != after.placements) patch.placements = after.placements;
  if (before.layer_states != after.layer_states) patch.layer_states = after.layer_states;
  static const std::vector<Species> none;
  const auto& species_before = before.species ? *before.species : none;
  const auto& species_after = after.species ? *after.species : none;
  if (before.species != after.species && species_before != species_after) {
    patch.species = species_between(species_before, species_after);
  }
  return patch;
}

Status apply(const PartsPatch& patch, Document& document, const std::string& where) {
  if (patch.inflows) {
    if (Status inside = check_inflows(*patch.inflows, document, where); !inside) return inside;
  }
  if (patch.species) {
    auto species = patched(document.species ? *document.species : std::vector<Species>{}, *patch.species, where);
    if (!species) return tl::unexpected(species.error());
    document.species = std::make_shared<const std::vector<Species>>(std::move(*species));
  }
  if (patch.title) document.title = *patch.title;
  if (patch.seed) document.seed = *patch.seed;
  if (patch.climate) document.climate = *patch.climate;
  if (patch.use_proportions) document.use_proportions = *patch.use_proportions;
  if (patch.inflows) document.inflows = *patch.inflows;
  if (patch.placements) document.placements = *patch.placements;
  if (patch.layer_states) document.layer_states = *patch.layer_states;
  return {};
}

}  // namespace biotope

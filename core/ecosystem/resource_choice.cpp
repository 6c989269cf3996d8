#include <algorithm>
#include <numeric>

#include "core/ecosystem/animal_needs.hpp"
#include "core/ecosystem/resource_nodes.hpp"

namespace biotope {
namespace {

double kilograms_of(const VegetationPatch& patch, const std::vector<int>& foods) {
  double sum = 0;
  for (const ResourceQuantity& quantity : patch.quantities) {
    if (std::find(foods.begin(), foods.end(), quantity.species) != foods.end()) sum += quantity.kilograms_per_year;
  }
  return sum;
}

double kilograms_of(const VegetationPatch& patch) {
  double sum = 0;
  for (const ResourceQuantity& quantity : patch.quantities) sum += quantity.kilograms_per_year;
  return sum;
}

/// The richest patch of a region for a food, -1 when none has it.
int richest(std::span<const VegetationPatch> patches, const std::vector<std::size_t>& in_region, const std::vector<int>& foods) {
  int best = -1;
  double most = 0;
  for (const std::size_t patch : in_region) {
    const double kilograms = kilograms_of(patches[patch], foods);
    if (kilograms <= most) continue;
    most = kilograms;
    best = int(patch);
  }
  return best;
}

/// Patches of every region of a species, regions in order.
std::vector<std::vector<std::size_t>> patches_by_region(const ResourceSources& sources, std::span<const VegetationPatch> patches,
                                                        std::size_t species_index) {
  std::vector<std::vector<std::size_t>> result;
  for (std::size_t i = 0; i < patches.size(); ++i) {
    const int region = sources.partition.pieces[std::size_t(patches[i].piece)].region[species_index];
    if (region < 0) continue;
    if (result.size() <= std::size_t(region)) result.resize(std::size_t(region) + 1);
    result[std::size_t(region)].push_back(i);
  }
  return result;
}

}  // namespace

std::vector<char> choose_patches(const ResourceSources& sources, std::span<const VegetationPatch> patches) {
  const std::size_t most = node_limits(sources.level).vegetation;
  std::vector<double> kilograms;
  for (const VegetationPatch& patch : patches) kilograms.push_back(kilograms_of(patch));
  // Regions of all species, and what grows in each.
  struct Place {
    std::size_t species_index = 0;
    std::vector<std::size_t> patches;
    double kilograms = 0;
  };
  std::vector<Place> places;
  const auto& species = sources.web.levels[std::size_t(sources.level)];
  for (std::size_t i = 0; i < species.size(); ++i) {
    for (auto& in_region : patches_by_region(sources, patches, i)) {
      Place place{i, std::move(in_region), 0};
      for (const std::size_t patch : place.patches) place.kilograms += kilograms[patch];
      if (place.kilograms > 0) places.push_back(std::move(place));
    }
  }
  std::stable_sort(places.begin(), places.end(), [](const Place& a, const Place& b) { return a.kilograms > b.kilograms; });

  std::vector<char> keep(patches.size());
  std::size_t kept = 0;
  const auto keep_patch = [&](std::size_t patch, std::size_t limit) {
    if (keep[patch] || kept >= limit || kilograms[patch] <= 0) return;
    keep[patch] = 1;
    ++kept;
  };
  for (const Place& place : places) {
    for (const YearlyNeed& need : yearly_needs(sources.web, species[place.species_index])) {
      const int patch = richest(patches, place.patches, need.foods);
      if (patch >= 0) keep_patch(std::size_t(patch), most / 2);
    }
  }
  std::vector<std::size_t> order(patches.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(), [&](auto a, auto b) { return kilograms[a] > kilograms[b]; });
  for (const std::size_t patch : order) keep_patch(patch, most);
  return keep;
}

}  // namespace biotope

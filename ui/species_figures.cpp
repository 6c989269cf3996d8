#include "ui/species_figures.hpp"

#include <limits>
#include <numeric>
#include <set>

#include "core/ecosystem/surplus.hpp"

namespace biotope {
namespace {

constexpr double unknown = std::numeric_limits<double>::quiet_NaN();

double mean_cover(const CoverMap& cover) {
  std::uint64_t sum = 0;
  std::vector<Cover> row(std::size_t(cover.width()));
  for (int y = 0; y < cover.height(); ++y) {
    cover.read_row(y, 0, row);
    sum = std::accumulate(row.begin(), row.end(), sum, [](std::uint64_t s, Cover c) { return s + c; });
  }
  const double cells = double(cover.width()) * double(cover.height());
  return cells > 0 ? double(sum) / full_cover / cells : 0;
}

double entry(const std::vector<double>& values, std::size_t index) { return index < values.size() ? values[index] : unknown; }

void add_totals(const MapsSnapshot& snapshot, int species, const CoverMap* cover, SpeciesFigures& figures) {
  const SurplusTotal total = surplus_total(*snapshot.web, species, cover, snapshot.terrain().cell_area(), snapshot.animals,
                                           snapshot.loss(species).get());
  figures.growth = total.growth;
  figures.eaten = total.eaten;
}

SpeciesFigures animal_figures(const MapsSnapshot& snapshot, const AnimalLevel& level, std::size_t index) {
  SpeciesFigures figures;
  const std::vector<double>& population = level.population[index];
  figures.amount = std::accumulate(population.begin(), population.end(), 0.0);
  figures.desired = entry(level.desired, index);
  figures.achieved = entry(level.achieved, index);
  for (const Herd& herd : level.herds) figures.herds += herd.species == level.species[index] ? 1 : 0;
  figures.regions = int(level.regions[index]->regions.size());
  add_totals(snapshot, level.species[index], nullptr, figures);
  return figures;
}

}  // namespace

std::vector<SpeciesFigures> species_figures(const MapsSnapshot& snapshot) {
  std::vector<SpeciesFigures> all;
  if (!snapshot.web) return all;
  all.assign(snapshot.web->species.size(), {unknown, unknown, unknown, unknown, unknown, 0, 0});
  for (std::size_t i = 0; i < snapshot.cover.size(); ++i) {
    if (!snapshot.cover[i]) continue;
    const int species = snapshot.web->levels[0][i];
    SpeciesFigures& figures = all[std::size_t(species)];
    figures.amount = mean_cover(*snapshot.cover[i]);
    figures.desired = entry(snapshot.plant_desired, i);
    figures.achieved = entry(snapshot.plant_achieved, i);
    if (snapshot.complete) add_totals(snapshot, species, snapshot.cover[i].get(), figures);
  }
  for (const auto& level : snapshot.animals) {
    if (!level) continue;
    for (std::size_t i = 0; i < level->species.size(); ++i) {
      all[std::size_t(level->species[i])] = animal_figures(snapshot, *level, i);
    }
  }
  return all;
}

ShortageMaps shortage_maps(const MapsSnapshot& snapshot) {
  ShortageMaps maps;
  for (const auto& level : snapshot.animals) {
    if (!level) continue;
    for (std::size_t i = 0; i < level->species.size(); ++i) {
      std::set<int> short_regions;
      for (const AnimalLevel::Shortage& shortage : level->shortages) {
        if (shortage.species == level->species[i]) short_regions.insert(shortage.region);
      }
      if (short_regions.empty()) continue;
      const RunMap& label = level->regions[i]->label;
      auto layer = std::make_shared<PaintLayer>(label.width(), label.height());
      for (int y = 0; y < label.height(); ++y) {
        for (int x = 0; x < label.width(); ++x) {
          if (short_regions.contains(label(x, y))) layer->set(x, y, {1, 1});
        }
      }
      maps[level->species[i]] = std::move(layer);
    }
  }
  if (!snapshot.plant_shortages) return maps;
  for (const PlantShortage& shortage : *snapshot.plant_shortages) maps[shortage.species] = shortage.where;
  return maps;
}

}  // namespace biotope

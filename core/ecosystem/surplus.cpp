#include "core/ecosystem/surplus.hpp"

#include <algorithm>
#include <cassert>
#include <numeric>

#include "core/base/parallel.hpp"
#include "core/ecosystem/animal_paint.hpp"
#include "core/ecosystem/eaten_zones.hpp"
#include "core/ecosystem/losses.hpp"

namespace biotope {
namespace {

/// A level that eats a plant, and what share it leaves in each piece.
struct PlantEater {
  const RunMap* piece_of_cell = nullptr;
  std::vector<float> left;
};

std::vector<PlantEater> eaters_of_plant(int plant, std::span<const std::shared_ptr<const AnimalLevel>> levels) {
  std::vector<PlantEater> result;
  for (const auto& level : levels) {
    const std::vector<double> share = eaten_share(*level, plant);
    if (share.empty()) continue;
    PlantEater& eater = result.emplace_back(PlantEater{&level->partition->label, {}});
    for (const double eaten : share) eater.left.push_back(float(1 - eaten));
  }
  return result;
}

/// The level a species belongs to and its place there.
struct Member {
  const AnimalLevel* level = nullptr;
  std::size_t index = 0;
};

Member member_of(int species, std::span<const std::shared_ptr<const AnimalLevel>> levels) {
  for (const auto& level : levels) {
    const auto found = std::find(level->species.begin(), level->species.end(), species);
    if (found != level->species.end()) return {level.get(), std::size_t(found - level->species.begin())};
  }
  return {};
}

/// kg per year that the levels ate of an animal, by its region.
std::vector<double> eaten_by_region(int species, std::size_t regions,
                                    std::span<const std::shared_ptr<const AnimalLevel>> levels) {
  std::vector<double> eaten(regions);
  for (const auto& level : levels) {
    const std::vector<double> share = eaten_share(*level, species);
    if (share.empty()) continue;
    for (const auto& prey : level->prey) {
      if (prey.species == species) eaten[std::size_t(prey.region)] += prey.available * share[std::size_t(prey.piece)];
    }
  }
  return eaten;
}

/// Sum of cover (1/full_cover cells), each cell without the share of its growth that is lost.
double growing_cover(const CoverMap& cover, const PaintLayer* loss) {
  std::vector<std::uint64_t> row_sum(std::size_t(cover.height()));
  std::vector<std::uint64_t> row_lost(row_sum.size());
  parallel_rows(0, cover.height(), [&](int y) {
    std::vector<Cover> row(static_cast<std::size_t>(cover.width()));
    cover.read_row(y, 0, row);
    row_sum[std::size_t(y)] = std::accumulate(row.begin(), row.end(), std::uint64_t{0});
    if (loss == nullptr) return;
    std::vector<Paint> lost(row.size());
    loss->read_row(y, 0, lost);
    for (std::size_t x = 0; x < row.size(); ++x) row_lost[std::size_t(y)] += std::uint64_t(row[x]) * loss_steps(lost[x]);
  });
  const std::uint64_t sum = std::accumulate(row_sum.begin(), row_sum.end(), std::uint64_t{0});
  const std::uint64_t lost = std::accumulate(row_lost.begin(), row_lost.end(), std::uint64_t{0});
  return double(sum) - double(lost) / whole_loss;
}

}  // namespace

Grid<float> plant_surplus(const FoodWeb& web, int plant, const CoverMap& cover,
                          std::span<const std::shared_ptr<const AnimalLevel>> levels, const PaintLayer* loss) {
  const std::vector<PlantEater> eaters = eaters_of_plant(plant, levels);
  const float growth = web.species[std::size_t(plant)].plant().growth;
  Grid<float> surplus(cover.width(), cover.height());
  parallel_rows(0, surplus.height(), [&](int y) {
    const auto row = surplus.row(y);
    std::vector<Cover> covered(row.size());
    cover.read_row(y, 0, covered);
    for (std::size_t x = 0; x < row.size(); ++x) row[x] = growth * cover_fraction(covered[x]);
    if (loss != nullptr) {
      std::vector<Paint> lost(row.size());
      loss->read_row(y, 0, lost);
      for (std::size_t x = 0; x < row.size(); ++x) row[x] *= share_kept(loss_steps(lost[x]));
    }
    for (const PlantEater& eater : eaters) {
      for (const CellRun& run : eater.piece_of_cell->runs().row(y)) {
        const float left = eater.left[std::size_t(run.value)];
        for (auto x = std::size_t(run.x0); x < std::size_t(run.x1); ++x) row[x] *= left;
      }
    }
  });
  return surplus;
}

Grid<float> animal_surplus(const FoodWeb& web, int species, const AnimalLevel& own_level,
                           std::span<const std::shared_ptr<const AnimalLevel>> levels, const PaintLayer* loss) {
  const auto found = std::find(own_level.species.begin(), own_level.species.end(), species);
  assert(found != own_level.species.end());
  const std::size_t index = std::size_t(found - own_level.species.begin());
  const AnimalTraits& animal = web.species[std::size_t(species)].animal();
  const ConfinementRegions& regions = *own_level.regions[index];
  const std::vector<double> eaten = eaten_by_region(species, regions.regions.size(), levels);
  const std::vector<double> lost = mean_losses(regions, loss);
  std::vector<float> surplus_of_region;
  for (std::size_t region = 0; region < eaten.size(); ++region) {
    const double born = own_level.population[index][region] * double(animal.growth_rate) * (1 - lost[region]);
    const double left = std::max(0.0, born - eaten[region] / double(animal.mean_mass()));
    surplus_of_region.push_back(float(uniform_density(regions.regions[region], left)));
  }
  Grid<float> surplus(regions.label.width(), regions.label.height());
  parallel_rows(0, surplus.height(), [&](int y) {
    const auto row = surplus.row(y);
    for (const CellRun& run : regions.label.runs().row(y)) {
      std::fill(row.begin() + run.x0, row.begin() + run.x1, surplus_of_region[std::size_t(run.value)]);
    }
  });
  return surplus;
}

SurplusTotal surplus_total(const FoodWeb& web, int species, const CoverMap* cover, double cell_area,
                           std::span<const std::shared_ptr<const AnimalLevel>> levels, const PaintLayer* loss) {
  SurplusTotal total;
  for (const auto& level : levels) {
    const auto& eaten = level->eaten[std::size_t(species)];
    total.eaten += std::accumulate(eaten.begin(), eaten.end(), 0.0);
  }
  const Species& own = web.species[std::size_t(species)];
  if (own.is_plant()) {
    assert(cover != nullptr);
    total.growth = growing_cover(*cover, loss) / full_cover * cell_area * double(own.plant().growth);
    return total;
  }
  const Member member = member_of(species, levels);
  if (member.level != nullptr) {
    const auto& population = member.level->population[member.index];
    double breeding = 0;
    const std::vector<double> lost = mean_losses(*member.level->regions[member.index], loss);
    for (std::size_t region = 0; region < population.size(); ++region) breeding += population[region] * (1 - lost[region]);
    total.growth = breeding * double(own.animal().growth_rate);
  }
  total.eaten /= double(own.animal().mean_mass());
  return total;
}

}  // namespace biotope

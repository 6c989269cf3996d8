#include <algorithm>

#include "core/ecosystem/eaten_zones.hpp"
#include "core/ecosystem/resource_nodes.hpp"

namespace biotope {

PresentTiles::PresentTiles(std::span<const std::shared_ptr<const CoverMap>> covers,
                           std::span<const std::shared_ptr<const PaintLayer>> losses) {
  for (const auto& cover : covers) {
    if (!cover) continue;
    columns_ = cover->tile_columns();
    rows_ = cover->tile_rows();
  }
  const std::size_t tiles_of_map = std::size_t(columns_) * std::size_t(rows_);
  tiles_.assign(covers.size() * tiles_of_map, nullptr);
  background_.resize(covers.size());
  parallel_each(covers.size(), [&](std::size_t map) {
    if (!covers[map]) return;
    if (covers[map]->background() != 0) {
      auto tile = std::make_shared<CoverMap::Tile>();
      tile->fill(covers[map]->background());
      background_[map] = std::move(tile);
    }
    for (std::size_t i = 0; i < tiles_of_map; ++i) {
      const CoverMap::TilePointer& tile = covers[map]->tile(i) ? covers[map]->tile(i) : background_[map];
      if (tile) tiles_[map * tiles_of_map + i] = tile->data();
    }
  });
  if (std::any_of(losses.begin(), losses.end(), [](const auto& loss) { return loss != nullptr; })) find_losses(losses);
}

void PresentTiles::find_losses(std::span<const std::shared_ptr<const PaintLayer>> losses) {
  lost_.resize(tiles_.size());
  const std::size_t tiles_of_map = std::size_t(columns_) * std::size_t(rows_);
  parallel_each(std::min(losses.size(), background_.size()), [&](std::size_t map) {
    if (!losses[map]) return;
    const Paint background = losses[map]->background();
    for (std::size_t i = 0; i < tiles_of_map; ++i) {
      const PaintLayer::TilePointer& paint = losses[map]->tile(i);
      const std::size_t tile = map * tiles_of_map + i;
      if (tiles_[tile] == nullptr || (!paint && loss_steps(background) == 0)) continue;
      auto lost = std::make_unique<LostTile>();
      unsigned any = 0;
      for (std::size_t cell = 0; cell < lost->size(); ++cell)
        any |= (*lost)[cell] = loss_steps(paint ? (*paint)[cell] : background);
      if (any != 0) lost_[tile] = std::move(lost);
    }
  });
}

std::vector<std::shared_ptr<const PaintLayer>> plant_losses(const FoodWeb& web,
                                                            std::span<const std::shared_ptr<const PaintLayer>> losses) {
  std::vector<std::shared_ptr<const PaintLayer>> result;
  for (const int plant : web.levels[0]) {
    result.push_back(std::size_t(plant) < losses.size() ? losses[std::size_t(plant)] : nullptr);
  }
  return result;
}

double growth_of(const FoodWeb& web, int plant, double cover_sum, double cell_area) {
  return cover_sum / full_cover * cell_area * double(web.species[std::size_t(plant)].plant().growth);
}

std::vector<std::vector<double>> available_supply(const ResourceSources& sources, std::span<const PreySupply> prey) {
  const std::size_t pieces = sources.partition.pieces.size();
  std::vector<std::vector<double>> available(sources.web.species.size(), std::vector<double>(pieces));
  for (const PreySupply& supply : prey) available[std::size_t(supply.species)][std::size_t(supply.piece)] += supply.available;

  const std::vector<char> edible = edible_to_level(sources.web, sources.level);
  std::vector<int> plants;
  std::vector<std::size_t> maps;
  for (std::size_t i = 0; i < sources.plants.size(); ++i) {
    if (!edible[std::size_t(sources.web.levels[0][i])] || !sources.plants[i]) continue;
    plants.push_back(sources.web.levels[0][i]);
    maps.push_back(i);
  }
  if (plants.empty()) return available;
  const EatenZones zones(sources.below, plants);
  RunTable table = zones.refined(sources.pieces);
  const std::vector<std::int64_t> values = number_values(table);
  const TileReuse& reuse = sources.reuse;
  const CoverSums sums = cover_sums(table, values.size(), sources.tiles, maps, reuse.changed,
                                    reuse.before ? &reuse.before->pieces : nullptr, reuse.found ? &reuse.found->pieces : nullptr);
  for (std::size_t group = 0; group < values.size(); ++group) {
    for (std::size_t plant = 0; plant < plants.size(); ++plant) {
      available[std::size_t(plants[plant])][std::size_t(values[group] / zones.count())] +=
          zones.left(values[group] % zones.count(), plant) *
          growth_of(sources.web, plants[plant], sums.growing(group * plants.size() + plant), sources.ground.terrain->cell_area());
    }
  }
  return available;
}

}  // namespace biotope

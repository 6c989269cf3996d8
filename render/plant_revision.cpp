#include "render/plant_revision.hpp"

#include <algorithm>

#include "core/base/parallel.hpp"

namespace biotope {

namespace {

/// What is eaten of a snapshot; of one whose animals are not known yet, what was eaten before it.
std::shared_ptr<const Grazing> grazing_of(const PlantGround& before, const MapsSnapshot& now) {
  const MapsSnapshot* then = before.maps.get();
  const bool known = now.complete || !now.animals.empty() || then == nullptr || !same_plants(*then, now) ||
                     !same_extent(then->terrain(), now.terrain());
  if (!known) return before.grazing;
  auto grazing = std::make_shared<const Grazing>(now);
  return before.grazing && grazing->same_as(*before.grazing) ? before.grazing : grazing;
}

}  // namespace

bool same_plants(const MapsSnapshot& a, const MapsSnapshot& b) {
  if (a.web == b.web) return true;
  if (!a.web || !b.web || a.web->levels.empty() || b.web->levels.empty() || a.web->levels[0] != b.web->levels[0]) return false;
  return std::all_of(a.web->levels[0].begin(), a.web->levels[0].end(),
                     [&](int i) { return a.web->species[std::size_t(i)].traits == b.web->species[std::size_t(i)].traits; });
}

bool plants_stay(const MapsSnapshot& before, const MapsSnapshot& now) {
  return same_extent(before.terrain(), now.terrain()) && before.document.seed == now.document.seed && same_plants(before, now) &&
         before.cover.size() == now.cover.size();
}

PlantRevision plant_revision(const PlantGround& before, std::shared_ptr<const MapsSnapshot> now,
                             const std::shared_ptr<const GroundLines>& lines, const PlantBlockPlaces& places) {
  PlantRevision revision;
  PlantGround ground{std::move(now), nullptr, nullptr, nullptr};
  ground.grazing = grazing_of(before, *ground.maps);
  if (lines && ground.maps->hydrology) ground.shore = lines->shore;
  if (lines && ground.maps->trails) ground.trails = lines->trails;
  revision.placement = PlantPlacement(std::move(ground));
  if (!before.maps) return revision;
  const PlantChanges changes(before, revision.placement.ground());
  if (!changes.any()) return revision;
  for (int s = 0; s < strata; ++s) {
    const double side = PlantPlacement::block_side(Stratum(s));
    const auto& all = places[std::size_t(s)];
    std::vector<char> changed(all.size());
    parallel_each(all.size(), [&](std::size_t i) {
      const auto [row, column] = all[i];
      changed[i] = changes.within(Stratum(s), column * side, row * side, side) ? 1 : 0;
    });
    for (std::size_t i = 0; i < all.size(); ++i) {
      if (changed[i] != 0) revision.stale[std::size_t(s)].push_back(all[i]);
    }
  }
  return revision;
}

}  // namespace biotope

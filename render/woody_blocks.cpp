#include "render/woody_blocks.hpp"

namespace biotope {

void WoodyBlocks::follow(const PlantBlocks& blocks, const PlantArena& arena) {
  for (const Stratum stratum : {Stratum::tree, Stratum::shrub}) {
    List& list = lists_[std::size_t(stratum)];
    if (list.of_blocks == blocks.changes(stratum) && list.of_arena == arena.changes(stratum)) continue;
    list.of_blocks = blocks.changes(stratum);
    list.of_arena = arena.changes(stratum);
    list.blocks.clear();
    const PlantArena::Places& places = arena.places(stratum);
    // Both come by rising place.
    auto there = places.begin();
    for (const auto& [place, block] : blocks.blocks(stratum)) {
      while (there != places.end() && there->first < place) ++there;
      const bool resident = there != places.end() && there->first == place;
      list.blocks.push_back({place.first, place.second, block.low, block.high, std::uint32_t(block.plants.size()), block.version,
                             resident, resident ? there->second : PlantArena::Resident(), &block});
    }
  }
}

}  // namespace biotope

#pragma once

#include <algorithm>
#include <memory>
#include <vector>

#include "core/base/parallel.hpp"
#include "core/base/task_context.hpp"
#include "core/base/tiled_map.hpp"

namespace biotope {

/// Numbers of the tiles of two paint layers (null: blank) that do not share their pointer.
template <class T>
[[nodiscard]] std::vector<std::size_t> differing_tiles(const TiledMap<T>* before, const TiledMap<T>* after,
                                                       std::size_t tile_count) {
  std::vector<std::size_t> tiles;
  for (std::size_t i = 0; i < tile_count; ++i) {
    const auto* a = before ? before->tile(i).get() : nullptr;
    const auto* b = after ? after->tile(i).get() : nullptr;
    if (a != b) tiles.push_back(i);
  }
  return tiles;
}

/// Puts a recomputed tile into a map unless it is equal to the one that is there: equal tiles keep their pointer (backdating), and a tile of
/// nothing but background is kept as none at all. Returns whether the map changed.
template <class T>
bool replace_tile(TiledMap<T>& map, std::size_t index, std::shared_ptr<const typename TiledMap<T>::Tile> made) {
  const auto& old = map.tile(index);
  const auto is_background = [&](const T& cell) { return cell == map.background(); };
  if (std::all_of(made->begin(), made->end(), is_background)) made = nullptr;
  if (old == made || (old && made && *old == *made)) return false;
  map.set_tile(index, std::move(made));
  return true;
}

/// Sorted union of tile numbers.
inline void merge_tiles(std::vector<std::size_t>& into, const std::vector<std::size_t>& more) {
  into.insert(into.end(), more.begin(), more.end());
  std::sort(into.begin(), into.end());
  into.erase(std::unique(into.begin(), into.end()), into.end());
}

}  // namespace biotope

#pragma once

#include <algorithm>
#include <memory>
#include <vector>

#include "core/base/parallel.hpp"
#include "core/base/tiled_map.hpp"
#include "render/mipmaps.hpp"

namespace biotope {

/// A texture's texels, level 0 and its mipmaps, in shared tiles: two pictures hold the same tile where they are alike, so that
/// what must be uploaded is told by comparing pointers.
template <class Texel>
struct TexelPyramid {
  std::vector<TiledMap<Texel>> levels;
};

/// The tiles of `texels`; one that is equal to the tile there in `before` (null or of another size: nothing is) is that tile.
/// Parallel.
template <class Texel>
[[nodiscard]] TiledMap<Texel> shared_tiles(const Grid<Texel>& texels, const TiledMap<Texel>* before) {
  TiledMap<Texel> out(texels.width(), texels.height());
  const bool comparable = before != nullptr && before->rect() == texels.rect();
  parallel_each(out.tile_count(), [&](std::size_t i) {
    auto tile = std::make_shared<typename TiledMap<Texel>::Tile>();
    const Rect rect = out.tile_rect(i);
    for (int y = rect.y0; y < rect.y1; ++y) {
      std::copy_n(texels.row(y).data() + rect.x0, rect.width(), tile->data() + out.offset(rect.x0, y));
    }
    const bool same = comparable && before->tile(i) && *before->tile(i) == *tile;
    out.set_tile(i, same ? before->tile(i) : std::move(tile));
  });
  return out;
}

/// True when both maps hold the same tiles wherever `rect` (cut at the border) meets them.
template <class Texel>
[[nodiscard]] bool same_tiles(const TiledMap<Texel>& a, const TiledMap<Texel>& b, const Rect& rect) {
  const Rect part = intersection(rect, a.rect());
  if (a.rect() != b.rect()) return false;
  for (int y = part.y0 / tile_side; y * tile_side < part.y1; ++y) {
    for (int x = part.x0 / tile_side; x * tile_side < part.x1; ++x) {
      const std::size_t tile = a.tile_index(x * tile_side, y * tile_side);
      if (a.tile(tile) != b.tile(tile)) return false;
    }
  }
  return true;
}

namespace texel_detail {

/// One tile of the level above `fine`: means of two by two texels.
template <class Texel>
[[nodiscard]] std::shared_ptr<typename TiledMap<Texel>::Tile> coarser_tile(const TiledMap<Texel>& fine, const Rect& rect) {
  auto tile = std::make_shared<typename TiledMap<Texel>::Tile>();
  const int columns = std::min(2 * rect.width(), fine.width() - 2 * rect.x0);
  std::vector<Texel> north(std::size_t(columns), Texel{});
  std::vector<Texel> south(std::size_t(columns), Texel{});
  for (int y = rect.y0; y < rect.y1; ++y) {
    fine.read_row(2 * y, 2 * rect.x0, north);
    fine.read_row(std::min(2 * y + 1, fine.height() - 1), 2 * rect.x0, south);
    for (int x = 0; x < rect.width(); ++x) {
      const auto west = std::size_t(2 * x);
      const auto east = std::size_t(std::min(2 * x + 1, columns - 1));
      (*tile)[TiledMap<Texel>::offset(rect.x0 + x, y)] = mean_of(north[west], north[east], south[west], south[east]);
    }
  }
  return tile;
}

}  // namespace texel_detail

/// Adds all mipmaps to a pyramid of one level. Tiles made from the same tiles as those of `before` (may be null) are shared with
/// it. Parallel.
template <class Texel>
void add_mipmaps(TexelPyramid<Texel>& pyramid, const TexelPyramid<Texel>* before) {
  while (pyramid.levels.back().width() > 1 || pyramid.levels.back().height() > 1) {
    const TiledMap<Texel>& fine = pyramid.levels.back();
    const std::size_t level = pyramid.levels.size();
    TiledMap<Texel> coarse(std::max(1, fine.width() / 2), std::max(1, fine.height() / 2));
    const bool comparable = before != nullptr && before->levels.size() > level && before->levels[level].rect() == coarse.rect();
    parallel_each(coarse.tile_count(), [&](std::size_t i) {
      const Rect rect = coarse.tile_rect(i);
      const Rect under{2 * rect.x0, 2 * rect.y0, 2 * rect.x1, 2 * rect.y1};
      const bool same = comparable && same_tiles(fine, before->levels[level - 1], under);
      coarse.set_tile(i, same ? before->levels[level].tile(i) : texel_detail::coarser_tile(fine, rect));
    });
    pyramid.levels.push_back(std::move(coarse));
  }
}

}  // namespace biotope

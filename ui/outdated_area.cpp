#include "ui/outdated_area.hpp"

#include <set>

#include "core/pipeline/tile_operator.hpp"

namespace biotope {
namespace {

std::shared_ptr<const PaintLayer> layer_of(const Document& document, const LayerId& id) {
  const auto found = document.layers.find(id);
  return found == document.layers.end() ? nullptr : found->second;
}

bool same_beside_paint(const Document& a, const Document& b) {
  return a.terrain == b.terrain && a.climate == b.climate && a.species == b.species && a.seed == b.seed &&
         a.use_proportions == b.use_proportions;
}

}  // namespace

Rect outdated_area(const Document& document, const MapsSnapshot& snapshot) {
  if (!document.terrain) return {};
  const Rect whole = document.terrain->height.rect();
  if (!snapshot.complete || !same_beside_paint(document, snapshot.document)) return whole;
  std::set<LayerId> ids;
  for (const auto& [id, layer] : document.layers) ids.insert(id);
  for (const auto& [id, layer] : snapshot.document.layers) ids.insert(id);
  Rect area;
  for (const LayerId& id : ids) {
    const auto now = layer_of(document, id);
    const auto then = layer_of(snapshot.document, id);
    if (now == then) continue;
    const PaintLayer& any = now ? *now : *then;
    for (const std::size_t tile : differing_tiles(then.get(), now.get(), any.tile_count())) {
      area = bounding(area, any.tile_rect(tile));
    }
  }
  return intersection(area, whole);
}

}  // namespace biotope

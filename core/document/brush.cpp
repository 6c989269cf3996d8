#include "core/document/brush.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <utility>

#include "core/base/parallel.hpp"
#include "core/document/brush_paint.hpp"
#include "core/document/brush_shape.hpp"

namespace biotope {

namespace {

/// Where strokes are cut, cells: farther points are taken as lying there.
constexpr float farthest_point = 1e6F;

/// True when nobody else holds the layer, so that it may be changed in place. `ours`: how many of its owners are we.
bool held_by_us_only(const std::shared_ptr<PaintLayer>& layer, long ours) {
  if (layer.use_count() != ours) return false;
  // Taking and leaving a share orders us after the last release of another thread, so that its reads are over.
  [[maybe_unused]] const std::shared_ptr<PaintLayer> share = layer;
  return true;
}

/// Numbers of the tiles that meet a rectangle inside the map.
std::vector<std::size_t> tiles_of(const Grid<float>& map, Rect area) {
  const auto columns = std::size_t((map.width() + tile_side - 1) / tile_side);
  std::vector<std::size_t> tiles;
  for (int ty = area.y0 / tile_side; ty <= (area.y1 - 1) / tile_side; ++ty) {
    for (int tx = area.x0 / tile_side; tx <= (area.x1 - 1) / tile_side; ++tx)
      tiles.push_back(std::size_t(ty) * columns + std::size_t(tx));
  }
  return tiles;
}

Rect rect_of_tile(const Grid<float>& map, std::size_t tile) {
  const auto columns = std::size_t((map.width() + tile_side - 1) / tile_side);
  const int x0 = int(tile % columns) * tile_side;
  const int y0 = int(tile / columns) * tile_side;
  return intersection(map.rect(), {x0, y0, x0 + tile_side, y0 + tile_side});
}

/// Weights of a dab in the tiles it meets; tiles without any are left out.
std::vector<TileWeights> dab_weights(const Grid<float>& map, Rect area, const DabShape& shape, const CellFilter& filter) {
  const std::vector<std::size_t> tiles = tiles_of(map, area);
  std::vector<std::optional<TileWeights>> found(tiles.size());
  parallel_each(tiles.size(), [&](std::size_t i) {
    if (filter.blocks_tile(tiles[i])) return;
    found[i] = tile_weights(tiles[i], intersection(area, rect_of_tile(map, tiles[i])), [&](int x, int y) {
      const float weight = shape(x, y);
      return weight > 0 ? weight * filter(x, y) : 0.0F;
    });
  });
  std::vector<TileWeights> weights;
  for (auto& tile : found) {
    if (tile) weights.push_back(std::move(*tile));
  }
  return weights;
}

std::vector<StrokeTarget> one_target(LayerId layer, const Grid<float>* computed) {
  StrokeTarget target;
  target.layer = std::move(layer);
  target.computed = computed;
  return {std::move(target)};
}

}  // namespace

std::string layer_words(const LayerId& layer) {
  switch (layer.kind) {
    case LayerKind::geology:
      return "geology";
    case LayerKind::loss:
      return "loss of " + layer.name;
    case LayerKind::passage:
      return "passages";
    case LayerKind::ground:
      return "ground";
    case LayerKind::resource:
    case LayerKind::plant_density:
    case LayerKind::animal_density:
      break;
  }
  return layer.name;
}

std::string layer_words(const LayerId& layer, const Document& document) {
  if (!document.species) return layer_words(layer);
  const auto species = std::find_if(document.species->begin(), document.species->end(),
                                    [&](const Species& each) { return each.name == layer.name; });
  if (species == document.species->end() || species->common_name.empty()) return layer_words(layer);
  return layer_words({layer.kind, species->common_name});
}

std::string stroke_name(const std::vector<LayerId>& layers, const Document& document) {
  if (layers.empty()) return "Paint";
  const std::string more = layers.size() > 1 ? " and " + std::to_string(layers.size() - 1) + " more" : "";
  return "Paint " + layer_words(layers.front(), document) + more;
}

Stroke::Stroke(LayerId layer, const Grid<float>* computed) : Stroke(one_target(std::move(layer), computed), nullptr) {}

Stroke::Stroke(std::vector<StrokeTarget> targets, const FilterMaps* maps)
    : targets_(std::move(targets)), maps_(maps), held_(targets_.size()) {}

Rect Stroke::dab(Document& document, const Brush& brush, float x, float y, float pressure) {
  if (targets_.empty()) return {};
  const Grid<float>& map = *targets_.front().computed;
  const DabShape shape(brush, {x, y, pressure});
  const Rect area = intersection(map.rect(), shape.reach());
  if (area.empty()) return {};
  const auto selection = document.selection;
  const auto locked_area = document.locked_area;
  const CellFilter filter(brush.filter, maps_, selection.get(), locked_area.get());
  const std::vector<TileWeights> tiles = dab_weights(map, area, shape, filter);
  Rect changed;
  for (std::size_t i = 0; i < targets_.size(); ++i) {
    assert(targets_[i].computed->rect() == map.rect());
    if (is_locked(document, targets_[i].layer)) continue;
    changed = bounding(changed, paint(document, i, painter_of(brush, targets_[i], pressure), tiles));
  }
  return changed;
}

Rect Stroke::paint(Document& document, std::size_t target, const LayerPainter& painter, const std::vector<TileWeights>& tiles) {
  const auto found = document.layers.find(targets_[target].layer);
  const PaintLayer* before = found == document.layers.end() ? nullptr : found->second.get();
  assert(before == nullptr || before->rect() == painter.computed->rect());
  std::vector<PaintLayer::TilePointer> made(tiles.size());
  parallel_each(tiles.size(), [&](std::size_t i) { made[i] = painted_tile(painter, before, tiles[i]); });
  const auto same = [&](std::size_t i) { return made[i] == (before == nullptr ? nullptr : before->tile(tiles[i].tile)); };
  std::size_t first = 0;
  while (first < made.size() && same(first)) ++first;
  if (first == made.size()) return {};

  Held& held = held_[target];
  auto& slot = document.layers[targets_[target].layer];
  if (slot == nullptr || slot != held.own || !held_by_us_only(held.own, 2)) {
    held.own = slot ? std::make_shared<PaintLayer>(*slot)
                    : std::make_shared<PaintLayer>(painter.computed->width(), painter.computed->height());
    slot = held.own;
  }
  Rect changed;
  bool blank = false;
  for (std::size_t i = first; i < made.size(); ++i) {
    const std::size_t tile = tiles[i].tile;
    if (made[i] == slot->tile(tile)) continue;
    held.before.try_emplace(tile, slot->tile(tile));
    blank = blank || !made[i];
    held.own->set_tile(tile, std::move(made[i]));
    changed = bounding(changed, tiles[i].cells);
  }
  if (blank && slot->bytes() == 0) document.layers.erase(targets_[target].layer);
  return changed;
}

Rect Stroke::move_to(Document& document, const Brush& brush, float x, float y, float pressure) {
  if (!std::isfinite(x) || !std::isfinite(y) || !std::isfinite(pressure)) return {};
  const StrokePoint end{std::clamp(x, -farthest_point, farthest_point), std::clamp(y, -farthest_point, farthest_point), pressure};
  if (!last_) {
    last_ = end;
    return dab(document, brush, end.x, end.y, end.pressure);
  }
  const StrokePoint start = *last_;
  const double dx = double(end.x) - double(start.x);
  const double dy = double(end.y) - double(start.y);
  const double length = std::hypot(dx, dy);
  Rect touched;
  for (double way = dab_spacing(brush, last_->pressure); way <= length; way += dab_spacing(brush, last_->pressure)) {
    const double t = way / length;
    last_ = StrokePoint{float(double(start.x) + t * dx), float(double(start.y) + t * dy),
                        start.pressure + float(t) * (end.pressure - start.pressure)};
    touched = bounding(touched, dab(document, brush, last_->x, last_->y, last_->pressure));
  }
  return touched;
}

std::unique_ptr<Command> Stroke::finish(const Document& document) {
  std::vector<std::unique_ptr<Command>> commands;
  std::vector<LayerId> layers;
  for (std::size_t i = 0; i < targets_.size(); ++i) {
    const LayerId& layer = targets_[i].layer;
    const auto found = document.layers.find(layer);
    std::vector<PaintCommand::TileChange> changes;
    for (const auto& [tile, before] : held_[i].before) {
      auto after = found == document.layers.end() ? nullptr : found->second->tile(tile);
      const bool same = before == after || (before && after && *before == *after);
      if (!same) changes.push_back({tile, before, std::move(after)});
    }
    held_[i] = {};
    if (changes.empty()) continue;
    commands.push_back(std::make_unique<PaintCommand>(stroke_name({layer}, document), layer, std::move(changes)));
    layers.push_back(layer);
  }
  last_.reset();
  if (commands.empty()) return nullptr;
  if (commands.size() == 1) return std::move(commands.front());
  return std::make_unique<GroupCommand>(stroke_name(layers, document), std::move(commands));
}

}  // namespace biotope

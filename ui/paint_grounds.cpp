#include "ui/paint_grounds.hpp"

#include <algorithm>
#include <utility>

#include "core/base/parallel.hpp"
#include "core/pipeline/edit_grounds.hpp"
#include "ui/layer_values.hpp"
#include "ui/paint_session.hpp"

namespace biotope {
namespace {

/// Maps kept beside those that are needed now: going back and forth between a few layers makes nothing again.
constexpr std::size_t most_kept = 4;

std::shared_ptr<const void> quantity_source(const MapsSnapshot& snapshot, FilterQuantity quantity) {
  switch (quantity) {
    case FilterQuantity::slope:
    case FilterQuantity::aspect:
      return snapshot.derivatives;
    case FilterQuantity::altitude:
      return snapshot.land;
    case FilterQuantity::water_distance:
      return snapshot.hydrology;
    case FilterQuantity::map:
      return nullptr;
  }
  return nullptr;
}

}  // namespace

PaintNeeds needs_of_brush(const std::vector<LayerId>& targets, const Brush& brush, const std::optional<LayerId>& clone_from) {
  PaintNeeds needs;
  needs.layers = targets;
  if (clone_from) {
    needs.layers.push_back(*clone_from);
    needs.finals.push_back(*clone_from);
  }
  for (const FilterCondition& condition : brush.filter.conditions) {
    if (condition.quantity == FilterQuantity::map) {
      needs.layers.push_back(condition.map);
      needs.finals.push_back(condition.map);
    } else {
      needs.quantities.push_back(condition.quantity);
    }
  }
  return needs;
}

std::shared_ptr<const Grid<float>> final_map(LayerKind kind, std::shared_ptr<const Grid<float>> computed,
                                             const PaintLayer* paint) {
  if (!computed || paint == nullptr) return computed;
  auto map = std::make_shared<Grid<float>>(*computed);
  parallel_rows(0, int(paint->tile_count()), [&](int tile) {
    if (!paint->tile(std::size_t(tile))) return;
    const Rect rect = paint->tile_rect(std::size_t(tile));
    for (int y = rect.y0; y < rect.y1; ++y) {
      for (int x = rect.x0; x < rect.x1; ++x) (*map)(x, y) = final_value(kind, (*computed)(x, y), (*paint)(x, y));
    }
  });
  return map;
}

void PaintGrounds::take() {
  auto finished = making_.take();
  if (!finished || !*finished) return;
  Finished& made = **finished;
  if (made.layer) replace(computed_[*made.layer], std::move(made.made));
  if (made.final_layer) replace(finals_[*made.final_layer], std::move(made.made));
  if (made.picture_layer) {
    picture_layer_ = made.picture_layer;
    picture_source_ = std::move(made.made.source);
    freeing_.retire(std::exchange(picture_, std::move(made.picture)));
  }
  if (made.quantity) replace(quantities_[*made.quantity], std::move(made.made));
}

void PaintGrounds::replace(Made& old, Made made) {
  std::swap(old, made);
  freeing_.retire(std::move(made.map));
  freeing_.retire(std::move(made.source));
  freeing_.retire(std::move(made.paint));
}

bool PaintGrounds::ready(const MapsSnapshot& snapshot, const LayerId& layer) const {
  const auto found = computed_.find(layer);
  return found != computed_.end() && found->second.map && found->second.source == computed_map_source(snapshot, layer);
}

bool PaintGrounds::ready(const MapsSnapshot& snapshot, const Document& document, const BrushFilter& filter) const {
  return std::all_of(filter.conditions.begin(), filter.conditions.end(), [&](const FilterCondition& condition) {
    if (condition.quantity != FilterQuantity::map) {
      const auto found = quantities_.find(condition.quantity);
      return found != quantities_.end() && found->second.map &&
             found->second.source == quantity_source(snapshot, condition.quantity);
    }
    const auto paint = active_paint(document, condition.map);
    const auto found = finals_.find(condition.map);
    const bool painted_over = found != finals_.end() && found->second.paint == paint &&
                              found->second.source == computed_map_source(snapshot, condition.map);
    return ready(snapshot, condition.map) && (!paint || painted_over);
  });
}

void PaintGrounds::keep_few(const PaintNeeds& needs) {
  const auto drop = [this](auto& maps, const std::vector<LayerId>& wanted) {
    for (auto entry = maps.begin(); entry != maps.end() && maps.size() > wanted.size() + most_kept;) {
      const bool needed = std::find(wanted.begin(), wanted.end(), entry->first) != wanted.end();
      if (!needed) replace(entry->second, {});
      entry = needed ? std::next(entry) : maps.erase(entry);
    }
  };
  drop(computed_, needs.layers);
  drop(finals_, needs.finals);
}

void PaintGrounds::prepare(const std::shared_ptr<const MapsSnapshot>& snapshot, const Document& document,
                           const PaintNeeds& needs) {
  take();
  if (making_.running() || !snapshot) return;
  keep_few(needs);
  for (const LayerId& layer : needs.layers) {
    const auto source = computed_map_source(*snapshot, layer);
    if (!source || ready(*snapshot, layer)) continue;
    making_.start("Preparing", [snapshot, layer, source](const TaskContext&) -> Result<Finished> {
      return Finished{layer, {}, {}, {source, nullptr, computed_map(*snapshot, layer)}, {}, {}};
    });
    return;
  }
  if (needs.picture && ready(*snapshot, *needs.picture)) {
    const auto source = computed_map_source(*snapshot, *needs.picture);
    if (!picture_ || picture_layer_ != needs.picture || picture_source_ != source) {
      making_.start(
          "Preparing",
          [layer = *needs.picture, source, map = computed_.at(*needs.picture).map](const TaskContext&) -> Result<Finished> {
            return Finished{{}, {}, {}, {source, nullptr, nullptr}, layer, bare_picture(layer.kind, *map)};
          });
      return;
    }
  }
  for (const FilterQuantity which : needs.quantities) {
    const auto source = quantity_source(*snapshot, which);
    const auto found = quantities_.find(which);
    if (!source || (found != quantities_.end() && found->second.source == source)) continue;
    making_.start("Preparing", [snapshot, which, source](const TaskContext&) -> Result<Finished> {
      return Finished{{}, {}, which, {source, nullptr, filter_map(*snapshot, which)}, {}, {}};
    });
    return;
  }
  for (const LayerId& layer : needs.finals) {
    const auto source = computed_map_source(*snapshot, layer);
    const auto paint = active_paint(document, layer);
    const auto found = finals_.find(layer);
    if (!source || !paint || !ready(*snapshot, layer)) continue;
    if (found != finals_.end() && found->second.source == source && found->second.paint == paint) continue;
    making_.start("Preparing", [layer, source, paint, map = computed_.at(layer).map](const TaskContext&) -> Result<Finished> {
      return Finished{{}, layer, {}, {source, paint, final_map(layer.kind, map, paint.get())}, {}, {}};
    });
    return;
  }
}

PaintGrounds::Map PaintGrounds::computed(const MapsSnapshot& snapshot, const LayerId& layer) {
  if (!ready(snapshot, layer))
    replace(computed_[layer], {computed_map_source(snapshot, layer), nullptr, computed_map(snapshot, layer)});
  return computed_[layer].map;
}

PaintGrounds::Map PaintGrounds::final_of(const MapsSnapshot& snapshot, const Document& document, const LayerId& layer) {
  const auto paint = active_paint(document, layer);
  Map under = computed(snapshot, layer);
  if (!paint || !under) return under;
  const auto source = computed_map_source(snapshot, layer);
  Made& made = finals_[layer];
  if (made.source != source || made.paint != paint) replace(made, {source, paint, final_map(layer.kind, under, paint.get())});
  return made.map;
}

PaintGrounds::Map PaintGrounds::quantity(const MapsSnapshot& snapshot, FilterQuantity which) {
  const auto source = quantity_source(snapshot, which);
  Made& made = quantities_[which];
  if (!made.map || made.source != source) replace(made, {source, nullptr, filter_map(snapshot, which)});
  return made.map;
}

FilterMaps PaintGrounds::filters(const MapsSnapshot& snapshot, const Document& document, const BrushFilter& filter) {
  FilterMaps maps;
  for (const FilterCondition& condition : filter.conditions) {
    switch (condition.quantity) {
      case FilterQuantity::slope:
        maps.slope = quantity(snapshot, condition.quantity);
        break;
      case FilterQuantity::altitude:
        maps.altitude = quantity(snapshot, condition.quantity);
        break;
      case FilterQuantity::aspect:
        maps.aspect = quantity(snapshot, condition.quantity);
        break;
      case FilterQuantity::water_distance:
        maps.water_distance = quantity(snapshot, condition.quantity);
        break;
      case FilterQuantity::map:
        maps.values[condition.map] = final_of(snapshot, document, condition.map);
        break;
    }
  }
  return maps;
}

std::shared_ptr<Grid<float>> PaintGrounds::take_picture(const MapsSnapshot& snapshot, const LayerId& layer) {
  if (!picture_ || picture_layer_ != layer || picture_source_ != computed_map_source(snapshot, layer)) return nullptr;
  return std::exchange(picture_, nullptr);
}

void PaintGrounds::clear() {
  picture_.reset();
  making_.cancel();
  computed_.clear();
  finals_.clear();
  quantities_.clear();
}

}  // namespace biotope

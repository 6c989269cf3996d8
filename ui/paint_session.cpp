#include "ui/paint_session.hpp"

#include <algorithm>

#include "ui/map_builder.hpp"

namespace biotope {

bool PaintSession::begin(const MapsSnapshot& snapshot, const Document& document, const LayerId& layer) {
  if (!shown_ || layer_ != layer || terrain_ != document.terrain.get()) {
    close();
    computed_ = prepared(snapshot, layer) ? prepared_.computed : computed_under(snapshot, layer);
    if (!computed_) return false;
    layer_ = layer;
    terrain_ = document.terrain.get();
    shown_ = std::make_shared<Grid<float>>(*computed_);
    refresh_painted_tiles(document);
  }
  stroke_.emplace(layer_, computed_.get());
  return true;
}

Rect PaintSession::move_to(Document& document, const Brush& brush, float x, float y) {
  if (!stroke_) return {};
  const Rect rect = intersection(stroke_->move_to(document, brush, x, y), shown_->rect());
  refresh(document, rect);
  return rect;
}

std::unique_ptr<Command> PaintSession::finish(const Document& document) {
  if (!stroke_) return nullptr;
  std::unique_ptr<Command> command = stroke_->finish(document);
  stroke_.reset();
  return command;
}

void PaintSession::close() {
  stroke_.reset();
  computed_.reset();
  shown_.reset();
  changed_ = {};
  greatest_ = 0;
  awaited_ = 0;
}

Rect PaintSession::take_changed() {
  const Rect changed = changed_;
  changed_ = {};
  return changed;
}

bool PaintSession::prepared(const MapsSnapshot& snapshot, const LayerId& layer) const {
  return prepared_.computed && prepared_.layer == layer && prepared_.source == computed_source(snapshot, layer);
}

void PaintSession::refresh_painted_tiles(const Document& document) {
  const auto found = document.layers.find(layer_);
  if (found == document.layers.end()) return;
  for (std::size_t tile = 0; tile < found->second->tile_count(); ++tile) {
    if (found->second->tile(tile)) refresh(document, found->second->tile_rect(tile));
  }
}

void PaintSession::refresh(const Document& document, const Rect& rect) {
  if (rect.empty()) return;
  const auto found = document.layers.find(layer_);
  const PaintLayer* paint = found == document.layers.end() ? nullptr : found->second.get();
  for (int y = rect.y0; y < rect.y1; ++y) {
    for (int x = rect.x0; x < rect.x1; ++x) {
      const float computed = (*computed_)(x, y);
      const float value = paint != nullptr ? painted(computed, (*paint)(x, y)) : computed;
      (*shown_)(x, y) = value;
      greatest_ = std::max(greatest_, value);
    }
  }
  changed_ = bounding(changed_, rect);
}

}  // namespace biotope

#include "ui/paint_session.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/base/parallel.hpp"
#include "ui/layer_values.hpp"

namespace biotope {
namespace {

std::vector<StrokeTarget> stroke_targets(const StrokePlan& plan) {
  std::vector<StrokeTarget> targets;
  for (std::size_t i = 0; i < plan.targets.size(); ++i) {
    const EditTarget& target = plan.targets[i];
    targets.push_back({target.layer, plan.computed[i].get(), target.weight, target.value, target.floor, plan.clone_source.get()});
  }
  return targets;
}

}  // namespace

std::shared_ptr<Grid<float>> bare_picture(LayerKind kind, const Grid<float>& computed) {
  if (kind != LayerKind::ground && kind != LayerKind::passage) return std::make_shared<Grid<float>>(computed);
  return std::make_shared<Grid<float>>(computed.width(), computed.height(), shown_value(kind, 0, {}));
}

bool PaintSession::begin(const Document& document, StrokePlan plan) {
  const bool complete = !plan.targets.empty() && plan.computed.size() == plan.targets.size() &&
                        std::all_of(plan.computed.begin(), plan.computed.end(), [](const auto& map) { return map != nullptr; });
  if (!complete) return false;
  const LayerId& layer = plan.targets.front().layer;
  if (!shows(layer, plan.source)) {
    close();
    layer_ = layer;
    shown_ = plan.picture ? std::move(plan.picture) : bare_picture(layer.kind, *plan.computed.front());
  }
  forget_plan();
  plan_ = std::move(plan);
  follow(document);
  points_.clear();
  paint_.reset();  // a layer that nobody else holds is painted without copying it
  stroke_.emplace(stroke_targets(plan_), &plan_.filters);
  return true;
}

Rect PaintSession::move_to(Document& document, float x, float y, float pressure) {
  if (!stroke_) return {};
  points_.push_back({x, y, pressure});
  const Rect rect = intersection(stroke_->move_to(document, plan_.brush, x, y, pressure), shown_->rect());
  if (!rect.empty()) note(rect, write(rect, active_paint(document, layer_).get()));
  return rect;
}

FinishedStroke PaintSession::finish(const Document& document) {
  FinishedStroke finished;
  if (!stroke_) return finished;
  finished.command = stroke_->finish(document);
  finished.edit = {plan_.targets, plan_.brush, plan_.clone_from, std::move(points_)};
  points_.clear();
  stroke_.reset();
  paint_ = active_paint(document, layer_);
  return finished;
}

void PaintSession::follow(const Document& document) {
  if (!shown_ || stroke_) return;
  auto paint = active_paint(document, layer_);
  if (paint == paint_) return;
  const std::size_t tiles = paint ? paint->tile_count() : paint_->tile_count();
  const std::shared_ptr<const PaintLayer> before = std::exchange(paint_, std::move(paint));
  std::vector<Rect> stale;
  for (std::size_t tile = 0; tile < tiles; ++tile) {
    const auto then = before ? before->tile(tile) : nullptr;
    const auto now = paint_ ? paint_->tile(tile) : nullptr;
    if (then != now) stale.push_back((paint_ ? *paint_ : *before).tile_rect(tile));
  }
  // A fill of a large map changes every tile.
  std::vector<ValueSpan> spans(stale.size());
  parallel_rows(0, int(stale.size()), [&](int i) { spans[std::size_t(i)] = write(stale[std::size_t(i)], paint_.get()); });
  for (std::size_t i = 0; i < stale.size(); ++i) note(stale[i], spans[i]);
}

void PaintSession::close() {
  stroke_.reset();
  forget_plan();
  freeing_.retire(std::exchange(shown_, nullptr));
  paint_.reset();
  points_.clear();
  changed_ = {};
  least_ = greatest_ = 0;
  awaited_ = 0;
}

void PaintSession::forget_plan() {
  for (auto& map : plan_.computed) freeing_.retire(std::move(map));
  freeing_.retire(std::move(plan_.source));
  freeing_.retire(std::move(plan_.clone_source));
  plan_ = {};
}

Rect PaintSession::take_changed(Reader reader) { return std::exchange(changed_[std::size_t(reader)], Rect{}); }

PaintSession::ValueSpan PaintSession::write(const Rect& rect, const PaintLayer* paint) {
  const Grid<float>& computed = *plan_.computed.front();
  ValueSpan span;
  for (int y = rect.y0; y < rect.y1; ++y) {
    for (int x = rect.x0; x < rect.x1; ++x) {
      const float value = shown_value(layer_.kind, computed(x, y), paint != nullptr ? (*paint)(x, y) : Paint{});
      (*shown_)(x, y) = value;
      if (std::isnan(value)) continue;
      span.least = std::min(span.least, value);
      span.greatest = std::max(span.greatest, value);
    }
  }
  return span;
}

void PaintSession::note(const Rect& rect, const ValueSpan& span) {
  least_ = std::min(least_, span.least);
  greatest_ = std::max(greatest_, span.greatest);
  for (Rect& changed : changed_) changed = bounding(changed, rect);
}

}  // namespace biotope

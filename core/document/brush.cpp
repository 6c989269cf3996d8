#include "core/document/brush.hpp"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

namespace biotope {

namespace {

/// Weight of a dab at a distance from its centre: 1 inside the hard core, then a smooth fall to 0 at the radius.
float falloff(const Brush& brush, float distance) {
  const float t = distance / brush.radius;
  if (t >= 1) return 0;
  const float core = std::clamp(brush.hardness, 0.0F, 0.99F);
  if (t <= core) return 1;
  const float u = (t - core) / (1 - core);
  return 1 - u * u * (3 - 2 * u);
}

/// Covers a cell so that its final value becomes `wanted`. Coverage only grows, so that paint stays opaque where it was.
Paint covered_to(Paint old, float computed, float wanted, float weight) {
  const float coverage = std::max(old.coverage, weight);
  if (coverage <= 0) return old;
  return {computed + (wanted - computed) / coverage, coverage};
}

float mean_around(const PaintLayer& layer, const Grid<float>& computed, int x, int y) {
  float sum = 0;
  for (int dy = -1; dy <= 1; ++dy) {
    for (int dx = -1; dx <= 1; ++dx) {
      const int cx = std::clamp(x + dx, 0, computed.width() - 1);
      const int cy = std::clamp(y + dy, 0, computed.height() - 1);
      sum += painted(computed(cx, cy), layer(cx, cy));
    }
  }
  return sum / 9;
}

struct CellContext {
  const PaintLayer& before;
  const Grid<float>& computed;
  int x;
  int y;
};

Paint dabbed(const Brush& brush, const CellContext& at, Paint old, float weight) {
  const float amount = weight * std::clamp(brush.strength, 0.0F, 1.0F);
  const float computed = at.computed(at.x, at.y);
  const float now = painted(computed, old);
  switch (brush.mode) {
    case BrushMode::add:
      return now >= brush.value ? old : covered_to(old, computed, now + (brush.value - now) * amount, 1);
    case BrushMode::subtract:
      return now <= brush.floor ? old : covered_to(old, computed, now + (brush.floor - now) * amount, 1);
    case BrushMode::set:
      return {old.coverage > 0 ? old.value + (brush.value - old.value) * amount : brush.value,
              old.coverage + (1 - old.coverage) * amount};
    case BrushMode::smooth:
      return covered_to(old, computed, now + (mean_around(at.before, at.computed, at.x, at.y) - now) * amount, 1);
    case BrushMode::restore_computed: {
      const float coverage = old.coverage * (1 - amount);
      return coverage < 0.004F ? Paint{} : Paint{old.value, coverage};
    }
  }
  return old;
}

std::string stroke_name(const LayerId& layer) { return "Paint " + layer.name; }

}  // namespace

Stroke::Stroke(LayerId layer, const Grid<float>* computed) : layer_(std::move(layer)), computed_(computed) {}

Rect Stroke::dab(Document& document, const Brush& brush, float x, float y) {
  const int reach = int(std::ceil(brush.radius));
  const Rect touched = intersection(computed_->rect(), {int(std::floor(x)) - reach, int(std::floor(y)) - reach,
                                                        int(std::ceil(x)) + reach + 1, int(std::ceil(y)) + reach + 1});
  if (touched.empty() || brush.radius <= 0) return {};
  auto& slot = document.layers[layer_];
  const PaintLayer before = slot ? *slot : PaintLayer(computed_->width(), computed_->height());
  auto layer = std::make_shared<PaintLayer>(before);
  for (int ty = touched.y0 / tile_side; ty <= (touched.y1 - 1) / tile_side; ++ty) {
    for (int tx = touched.x0 / tile_side; tx <= (touched.x1 - 1) / tile_side; ++tx) {
      const std::size_t index = layer->tile_index(tx * tile_side, ty * tile_side);
      before_.try_emplace(index, before.tile(index));
      auto& tile = layer->edit_tile(index);
      const Rect cells = intersection(touched, layer->tile_rect(index));
      for (int cy = cells.y0; cy < cells.y1; ++cy) {
        for (int cx = cells.x0; cx < cells.x1; ++cx) {
          const float weight = falloff(brush, std::hypot(float(cx) - x, float(cy) - y));
          Paint& cell = tile[PaintLayer::offset(cx, cy)];
          if (weight > 0) cell = dabbed(brush, {before, *computed_, cx, cy}, cell, weight);
        }
      }
    }
  }
  slot = std::move(layer);
  return touched;
}

Rect Stroke::move_to(Document& document, const Brush& brush, float x, float y) {
  if (!last_) {
    last_ = {x, y};
    return dab(document, brush, x, y);
  }
  const float spacing = std::max(0.5F, brush.radius * 0.25F);
  const float dx = x - (*last_)[0];
  const float dy = y - (*last_)[1];
  const int steps = int(std::hypot(dx, dy) / spacing);
  Rect touched;
  for (int step = 1; step <= steps; ++step) {
    const float t = float(step) * spacing / std::hypot(dx, dy);
    touched = bounding(touched, dab(document, brush, (*last_)[0] + t * dx, (*last_)[1] + t * dy));
  }
  if (steps > 0) {
    const float t = float(steps) * spacing / std::hypot(dx, dy);
    last_ = {(*last_)[0] + t * dx, (*last_)[1] + t * dy};
  }
  return touched;
}

std::unique_ptr<Command> Stroke::finish(const Document& document) {
  std::vector<PaintCommand::TileChange> changes;
  const auto found = document.layers.find(layer_);
  for (const auto& [index, before] : before_) {
    auto after = found == document.layers.end() ? nullptr : found->second->tile(index);
    const bool blank = after && std::all_of(after->begin(), after->end(), [](Paint p) { return p == Paint{}; });
    if (blank && !before) continue;
    if (before && after && *before == *after) continue;
    if (before != after) changes.push_back({index, before, std::move(after)});
  }
  before_.clear();
  last_.reset();
  if (changes.empty()) return nullptr;
  return std::make_unique<PaintCommand>(stroke_name(layer_), layer_, std::move(changes));
}

}  // namespace biotope

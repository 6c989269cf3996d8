#include "core/document/brush_paint.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/document/brush_noise.hpp"
#include "core/document/brush_shape.hpp"
#include "core/document/brush_surroundings.hpp"

namespace biotope {
namespace {

constexpr float unlimited = std::numeric_limits<float>::max();

/// What the cells of a rectangle are drawn to (or, for noise, pushed by), row by row.
struct Aims {
  std::vector<float> aim;
  /// Limits of sharpening; empty otherwise.
  std::vector<float> least;
  std::vector<float> greatest;
};

float source_value(const LayerPainter& painter, int x, int y) {
  const double sx = double(x) + double(painter.offset.x);
  const double sy = double(y) + double(painter.offset.y);
  const Grid<float>& source = *painter.source;
  const bool inside = sx > -0.5 && sy > -0.5 && sx < source.width() - 0.5 && sy < source.height() - 0.5;
  if (!inside) return std::numeric_limits<float>::quiet_NaN();
  // Between cells only: a neighbour without a value must not take the cell's own.
  const bool on_cell = sx == std::floor(sx) && sy == std::floor(sy);
  return on_cell || holds_classes(painter.kind) ? source.clamped(int(std::lround(sx)), int(std::lround(sy)))
                                                : sample_bilinear(source, sx, sy);
}

float ramp_value(const LayerPainter& painter, int x, int y) {
  const float t = painter.ramp->position(x, y);
  if (holds_classes(painter.kind)) return t < 0.5F ? painter.ramp->start : painter.ramp->end;
  return painter.ramp->start + (painter.ramp->end - painter.ramp->start) * t;
}

template <class ValueOf>
std::vector<float> values_of(Rect cells, const ValueOf& value_of) {
  std::vector<float> values;
  values.reserve(std::size_t(cells.width()) * std::size_t(cells.height()));
  for (int y = cells.y0; y < cells.y1; ++y) {
    for (int x = cells.x0; x < cells.x1; ++x) values.push_back(value_of(x, y));
  }
  return values;
}

std::vector<float> wanted_values(const LayerPainter& painter, Rect cells) {
  if (painter.mode == BrushMode::set && painter.source != nullptr) {
    return values_of(cells, [&](int x, int y) { return source_value(painter, x, y); });
  }
  if (painter.ramp) return values_of(cells, [&](int x, int y) { return ramp_value(painter, x, y); });
  return std::vector<float>(std::size_t(cells.width()) * std::size_t(cells.height()), painter.value);
}

Aims aims_of(const LayerPainter& painter, const PaintLayer* before, Rect cells) {
  switch (painter.mode) {
    case BrushMode::smooth:
    case BrushMode::sharpen: {
      Surroundings around = surroundings(before, *painter.computed, cells, painter.reach, painter.mode == BrushMode::sharpen);
      return {std::move(around.mean), std::move(around.least), std::move(around.greatest)};
    }
    case BrushMode::noise: {
      const BrushNoise noise(painter.noise_seed, painter.noise_size, cells);
      return {values_of(cells, [&](int x, int y) { return painter.value * noise(x, y); }), {}, {}};
    }
    case BrushMode::clone:
      return {values_of(cells, [&](int x, int y) { return source_value(painter, x, y); }), {}, {}};
    case BrushMode::subtract:
      return {std::vector<float>(std::size_t(cells.width()) * std::size_t(cells.height()), painter.floor), {}, {}};
    case BrushMode::add:
    case BrushMode::set:
    case BrushMode::restore_computed:
    case BrushMode::raise:
    case BrushMode::lower:
      break;
  }
  return {wanted_values(painter, cells), {}, {}};
}

/// The final value that a brush wants of a cell, before limits.
float wanted(BrushMode mode, float now, float aim, float amount) {
  switch (mode) {
    case BrushMode::add:
      return now >= aim ? now : now + (aim - now) * amount;
    case BrushMode::subtract:
      return now <= aim ? now : now + (aim - now) * amount;
    case BrushMode::smooth:
    case BrushMode::clone:
      return now + (aim - now) * amount;
    case BrushMode::sharpen:
      return now + (now - aim) * amount;
    case BrushMode::noise:
    case BrushMode::raise:
      return now + aim * amount;
    case BrushMode::lower:
      return now - aim * amount;
    case BrushMode::set:
    case BrushMode::restore_computed:
      break;
  }
  return now;
}

Paint set_over(Paint old, float value, float amount) {
  return {old.coverage > 0 ? old.value + (value - old.value) * amount : value, old.coverage + (1 - old.coverage) * amount};
}

/// Classes replace each other. The new one wins where the dab's shape is at its strongest half (however faint the brush, what is
/// brushed over takes its class), or where it covers more than what the old one keeps.
Paint class_over(Paint old, float value, float weight, float amount) {
  const float coverage = old.coverage + (1 - old.coverage) * amount;
  if (old.coverage <= 0 || old.value == value) return {value, coverage};
  const bool wins = weight >= 0.5F || amount >= old.coverage * (1 - amount);
  return wins ? Paint{value, coverage} : old;
}

Paint class_dabbed(const LayerPainter& painter, Paint old, float aim, float weight) {
  const float amount = weight * painter.strength;
  if (painter.mode == BrushMode::restore_computed) return thinned(old, 1 - amount);
  if (painter.mode != BrushMode::set && painter.mode != BrushMode::clone) return old;
  const Range legal = legal_range(painter.kind);
  return class_over(old, std::clamp(std::round(aim), legal.low, legal.high), weight, amount);
}

struct CellLimits {
  float least = -unlimited;
  float greatest = unlimited;
};

Paint dabbed(const LayerPainter& painter, Paint old, float computed, float aim, float amount, const CellLimits& around) {
  if (painter.mode == BrushMode::restore_computed) return thinned(old, 1 - amount);
  const Range legal = legal_range(painter.kind);
  if (painter.mode == BrushMode::set) return set_over(old, std::clamp(aim, legal.low, legal.high), amount);
  const float now = painted(computed, old);
  const float aimed = std::clamp(wanted(painter.mode, now, aim, amount), around.least, around.greatest);
  if (aimed == now) return old;
  const float value = std::clamp(aimed, legal.low, legal.high);
  // Paint stays opaque where it was: what is added to is covered as a whole.
  return value == now ? old : Paint{value, 1};
}

}  // namespace

float ValueRamp::position(int x, int y) const {
  const double dx = double(to.x) - double(from.x);
  const double dy = double(to.y) - double(from.y);
  const double squared = dx * dx + dy * dy;
  if (!(squared > 0)) return 0;
  const double along = ((double(x) - double(from.x)) * dx + (double(y) - double(from.y)) * dy) / squared;
  return float(std::clamp(along, 0.0, 1.0));
}

int smoothing_reach(float radius) { return int(std::lround(std::clamp(radius / 8, 1.0F, 64.0F))); }

Range legal_range(LayerKind kind) {
  switch (kind) {
    case LayerKind::resource:
      return {1, 9};
    case LayerKind::plant_density:
    case LayerKind::loss:
      return {0, 1};
    case LayerKind::animal_density:
      return {0, unlimited};
    case LayerKind::geology:
      return {0, geology_classes - 1};
    case LayerKind::passage:
      return {-1, 1};
    case LayerKind::ground:
      break;
  }
  return {-unlimited, unlimited};
}

LayerPainter painter_of(const Brush& brush, const StrokeTarget& target, float pressure) {
  LayerPainter painter;
  painter.mode = brush.mode;
  painter.kind = target.layer.kind;
  painter.strength = std::clamp(pressed_strength(brush, pressure) * target.weight, 0.0F, 1.0F);
  painter.value = target.value.value_or(brush.value);
  painter.floor = target.floor.value_or(brush.floor);
  painter.reach = smoothing_reach(pressed_radius(brush, pressure));
  painter.noise_size = brush.noise_size;
  painter.noise_seed = brush.noise_seed;
  painter.computed = target.computed;
  painter.source = brush.mode == BrushMode::clone ? target.clone_source : nullptr;
  painter.offset = brush.clone_offset;
  return painter;
}

std::shared_ptr<PaintLayer::Tile> tile_copy(const PaintLayer::TilePointer& tile) {
  return tile ? std::make_shared<PaintLayer::Tile>(*tile) : std::make_shared<PaintLayer::Tile>();
}

PaintLayer::TilePointer settled_tile(const PaintLayer::TilePointer& before, std::shared_ptr<PaintLayer::Tile> fresh) {
  if (before && *before == *fresh) return before;
  const bool blank = std::all_of(fresh->begin(), fresh->end(), [](Paint paint) { return paint == Paint{}; });
  return blank ? nullptr : PaintLayer::TilePointer(std::move(fresh));
}

PaintLayer::TilePointer painted_tile(const LayerPainter& painter, const PaintLayer* before, const TileWeights& weights) {
  const PaintLayer::TilePointer old = before == nullptr ? nullptr : before->tile(weights.tile);
  if (!(painter.strength > 0) || (painter.mode == BrushMode::restore_computed && !old)) return old;
  if (painter.mode == BrushMode::clone && painter.source == nullptr) return old;
  const Rect cells = weights.cells;
  const bool classes = holds_classes(painter.kind);
  const Aims aims = aims_of(painter, before, cells);
  auto fresh = tile_copy(old);
  std::size_t i = 0;
  for (int y = cells.y0; y < cells.y1; ++y) {
    Paint* row = fresh->data() + PaintLayer::offset(cells.x0, y);
    const float* computed = &(*painter.computed)(cells.x0, y);
    for (int x = 0; x < cells.width(); ++x, ++i) {
      const float weight = weights.weights[i];
      const float aim = aims.aim[i];
      const float amount = weight * painter.strength;
      if (!(amount > 0) || std::isnan(aim)) continue;
      if (classes) {
        row[x] = class_dabbed(painter, row[x], aim, weight);
      } else {
        const CellLimits around = aims.least.empty() ? CellLimits{} : CellLimits{aims.least[i], aims.greatest[i]};
        row[x] = dabbed(painter, row[x], computed[x], aim, amount, around);
      }
    }
  }
  return settled_tile(old, std::move(fresh));
}

}  // namespace biotope

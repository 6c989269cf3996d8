#pragma once

#include <functional>
#include <optional>
#include <vector>

#include "core/document/brush.hpp"

namespace biotope {

/// A value that changes along a line: `start` at `from`, `end` at `to`, constant beyond and across.
struct ValueRamp {
  PathPoint from;
  PathPoint to;
  float start = 0;
  float end = 0;
  /// How far along a cell lies, 0..1; 0 everywhere when the ends are one.
  [[nodiscard]] float position(int x, int y) const;
};

/// What is done to one layer, wherever there is weight.
struct LayerPainter {
  BrushMode mode = BrushMode::add;
  LayerKind kind = LayerKind::plant_density;
  float strength = 1;  ///< 0..1
  float value = 1;
  float floor = 0;
  int reach = 1;  ///< of smooth and sharpen, cells
  float noise_size = 12;
  std::uint64_t noise_seed = 1;
  const Grid<float>* computed = nullptr;
  /// What 'clone' takes from at `offset`, and what 'set' takes instead of `value` where it is given. Cells without a number or
  /// beyond the map are left alone.
  const Grid<float>* source = nullptr;
  PathPoint offset;
  /// Instead of `value`.
  std::optional<ValueRamp> ramp;
};

/// The painter of a target at a pressure.
[[nodiscard]] LayerPainter painter_of(const Brush& brush, const StrokeTarget& target, float pressure);

/// Weights 0..1 of the cells of one tile that something acts on, row by row.
struct TileWeights {
  std::size_t tile = 0;
  Rect cells;
  std::vector<float> weights;
};

/// Weights of `weight_of(x, y)` over the part of a tile inside `area`; nothing when they are all 0.
template <class WeightOf>
[[nodiscard]] std::optional<TileWeights> tile_weights(std::size_t tile, Rect cells, const WeightOf& weight_of) {
  TileWeights result{tile, cells, {}};
  if (cells.empty()) return std::nullopt;
  result.weights.reserve(std::size_t(cells.width()) * std::size_t(cells.height()));
  bool any = false;
  for (int y = cells.y0; y < cells.y1; ++y) {
    for (int x = cells.x0; x < cells.x1; ++x) {
      result.weights.push_back(weight_of(x, y));
      any = any || result.weights.back() > 0;
    }
  }
  if (!any) return std::nullopt;
  return result;
}

/// A tile after painting: the very tile of `before` when no cell changed, null when no paint is left. `before` may be null:
/// nothing is painted. Reads only `before`, so tiles may be made in any order.
[[nodiscard]] PaintLayer::TilePointer painted_tile(const LayerPainter& painter, const PaintLayer* before,
                                                   const TileWeights& weights);

/// `fresh`, or what stands for the same cells at less cost: `before` when it holds them, null when they are blank.
[[nodiscard]] PaintLayer::TilePointer settled_tile(const PaintLayer::TilePointer& before,
                                                   std::shared_ptr<PaintLayer::Tile> fresh);

/// A copy of a tile's cells for writing; blank for null.
[[nodiscard]] std::shared_ptr<PaintLayer::Tile> tile_copy(const PaintLayer::TilePointer& tile);

/// True when a layer holds class numbers, which are never mixed.
[[nodiscard]] inline bool holds_classes(LayerKind kind) { return kind == LayerKind::geology; }

/// Paint that covers less than this is taken off altogether (our choice: one step of 8-bit opacity).
inline constexpr float least_coverage = 0.004F;
[[nodiscard]] inline Paint thinned(Paint paint, float factor) {
  const float coverage = paint.coverage * factor;
  return coverage < least_coverage ? Paint{} : Paint{paint.value, coverage};
}

}  // namespace biotope

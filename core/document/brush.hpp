#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <vector>

#include "core/document/document.hpp"
#include "core/document/history.hpp"

namespace biotope {

enum class BrushMode : std::uint8_t { add, subtract, set, smooth, restore_computed };

/// How a dab falls on the map.
struct Brush {
  BrushMode mode = BrushMode::add;
  float radius = 40;      ///< cells
  float strength = 0.5F;  ///< 0..1
  float hardness = 0.5F;  ///< 0: falls off from the centre, 1: flat disk
  float value = 1;        ///< in the layer's unit: the most that 'add' reaches, what 'set' sets
  float floor = 0;        ///< the least that 'subtract' reaches
};

/// A stroke in progress over one layer of a document: dabs paint at once into the document's layer, copying each tile at
/// first touch, so that `finish` yields one undo step.
class Stroke {
 public:
  /// `computed` is the map under the layer (what paint is added to); it must outlive the stroke.
  Stroke(LayerId layer, const Grid<float>* computed);

  /// Paints one dab at cell coordinates; returns the cells it may have changed.
  Rect dab(Document& document, const Brush& brush, float x, float y);
  /// Dabs along a line from the last point with a spacing of a quarter radius; the first call paints one dab.
  Rect move_to(Document& document, const Brush& brush, float x, float y);
  /// The undo step of the whole stroke, or null when nothing changed.
  [[nodiscard]] std::unique_ptr<Command> finish(const Document& document);

 private:
  LayerId layer_;
  const Grid<float>* computed_;
  std::map<std::size_t, PaintLayer::TilePointer> before_;
  std::optional<std::array<float, 2>> last_;
};

}  // namespace biotope

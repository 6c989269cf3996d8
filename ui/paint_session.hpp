#pragma once

#include <cstdint>
#include <memory>
#include <optional>

#include "core/document/brush.hpp"
#include "core/pipeline/maps_snapshot.hpp"

namespace biotope {

/// A computed map made ready to be painted on, off the window's thread.
struct PaintGround {
  LayerId layer;
  /// What it was made from (computed_source).
  std::shared_ptr<const void> source;
  std::shared_ptr<const Grid<float>> computed;
};

/// Painting on one layer as the person sees it at once: the computed map with the document's paint over it, kept up to date cell
/// by cell while the brush moves, until the worker's own map answers.
class PaintSession {
 public:
  /// Starts a stroke on a layer over the snapshot's computed map; false when that map is not known yet. What is still shown from
  /// the stroke before is kept when the layer is the same.
  bool begin(const MapsSnapshot& snapshot, const Document& document, const LayerId& layer);
  /// A ground that `begin` may use instead of making its own.
  void prepare(PaintGround ground) { prepared_ = std::move(ground); }
  /// True when `begin` would not have to make the ground of this layer.
  [[nodiscard]] bool prepared(const MapsSnapshot& snapshot, const LayerId& layer) const;
  /// Moves the brush to a cell; changes the document's layer and the shown map. Returns the cells that may have changed.
  Rect move_to(Document& document, const Brush& brush, float x, float y);
  /// Ends the stroke: its undo step, or null when nothing changed.
  [[nodiscard]] std::unique_ptr<Command> finish(const Document& document);
  /// Forgets the shown map (the worker's is there, or another landscape is).
  void close();

  [[nodiscard]] bool stroking() const { return stroke_.has_value(); }
  /// The map to show instead of the worker's for this layer; null when there is none.
  [[nodiscard]] const std::shared_ptr<Grid<float>>& shown() const { return shown_; }
  [[nodiscard]] const LayerId& layer() const { return layer_; }
  /// The greatest value painted since the map was first shown.
  [[nodiscard]] float greatest() const { return greatest_; }
  /// Cells that changed since this was last asked.
  [[nodiscard]] Rect take_changed();
  /// The document revision whose snapshot makes the shown map superfluous.
  void wait_for(std::uint64_t revision) { awaited_ = revision; }
  [[nodiscard]] std::uint64_t awaited() const { return awaited_; }

 private:
  void refresh(const Document& document, const Rect& rect);
  void refresh_painted_tiles(const Document& document);

  LayerId layer_;
  const Terrain* terrain_ = nullptr;
  PaintGround prepared_;
  std::shared_ptr<const Grid<float>> computed_;
  std::shared_ptr<Grid<float>> shown_;
  std::optional<Stroke> stroke_;
  Rect changed_;
  float greatest_ = 0;
  std::uint64_t awaited_ = 0;
};

}  // namespace biotope

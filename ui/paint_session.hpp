#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "core/base/background_thread.hpp"
#include "core/document/edit.hpp"

namespace biotope {

/// Everything a stroke needs, fixed when it begins: what it paints is then a pure function of its points.
struct StrokePlan {
  /// The layers it paints; the first is the one that is looked at.
  std::vector<EditTarget> targets;
  /// The computed map under each target.
  std::vector<std::shared_ptr<const Grid<float>>> computed;
  /// What the first map was made from.
  std::shared_ptr<const void> source;
  Brush brush;
  std::optional<LayerId> clone_from;
  /// The final map that 'clone' takes from.
  std::shared_ptr<const Grid<float>> clone_source;
  FilterMaps filters;
  /// A bare_picture of the first target that nobody else holds; null: made when the stroke begins.
  std::shared_ptr<Grid<float>> picture;
};

/// The map of a layer without paint, as it is shown.
[[nodiscard]] std::shared_ptr<Grid<float>> bare_picture(LayerKind kind, const Grid<float>& computed);

/// A stroke that ended.
struct FinishedStroke {
  /// Its undo step; null when nothing changed.
  std::unique_ptr<Command> command;
  StrokeEdit edit;
};

/// Painting as the person sees it at once: the map of one layer with the document's paint over it (shown_value), kept up to date
/// cell by cell while the brush moves and tile by tile when paint changes otherwise (undo, fills), until the worker's own map
/// answers.
class PaintSession {
 public:
  /// Starts a stroke; false when a computed map is missing. The picture of the stroke before is kept when it is of the same layer
  /// and map.
  bool begin(const Document& document, StrokePlan plan);
  /// Moves the brush to a cell; changes the document's layers and the shown map. Returns the cells that may have changed.
  Rect move_to(Document& document, float x, float y, float pressure = 1);
  /// Ends the stroke.
  [[nodiscard]] FinishedStroke finish(const Document& document);
  /// Brings the shown map up to date with the paint of a document; only tiles that differ are looked at.
  void follow(const Document& document);
  /// Forgets the shown map (the worker's is there, or another landscape is).
  void close();

  [[nodiscard]] bool stroking() const { return stroke_.has_value(); }
  /// The brush of the stroke in progress.
  [[nodiscard]] const Brush& brush() const { return plan_.brush; }
  /// The map to show instead of the worker's for this layer; null when there is none.
  [[nodiscard]] const std::shared_ptr<Grid<float>>& shown() const { return shown_; }
  [[nodiscard]] const LayerId& layer() const { return layer_; }
  /// True when a stroke on this layer over a map made from `source` would keep the picture.
  [[nodiscard]] bool shows(const LayerId& layer, const std::shared_ptr<const void>& source) const {
    return shown_ && layer_ == layer && source && plan_.source == source;
  }
  /// What the computed map under the shown one was made from.
  [[nodiscard]] const std::shared_ptr<const void>& source() const { return plan_.source; }
  /// The least and the greatest value painted since the map was first shown.
  [[nodiscard]] float least() const { return least_; }
  [[nodiscard]] float greatest() const { return greatest_; }
  /// Cells that changed since this view last asked.
  enum class Reader : std::uint8_t { map, landscape };
  [[nodiscard]] Rect take_changed(Reader reader = Reader::map);
  /// The document revision whose snapshot makes the shown map superfluous.
  void wait_for(std::uint64_t revision) { awaited_ = revision; }
  [[nodiscard]] std::uint64_t awaited() const { return awaited_; }

 private:
  /// Least and greatest of some cells.
  struct ValueSpan {
    float least = 0;
    float greatest = 0;
  };
  /// Makes cells of the shown map again.
  ValueSpan write(const Rect& rect, const PaintLayer* paint);
  void note(const Rect& rect, const ValueSpan& span);

  /// Has another thread free the plan's maps: that takes long, large as they are.
  void forget_plan();

  LayerId layer_;
  StrokePlan plan_;
  std::shared_ptr<Grid<float>> shown_;
  std::shared_ptr<const PaintLayer> paint_;  ///< what the shown map holds, between strokes
  std::optional<Stroke> stroke_;
  std::vector<StrokePoint> points_;
  std::array<Rect, 2> changed_;
  float least_ = 0;
  float greatest_ = 0;
  std::uint64_t awaited_ = 0;
  BackgroundThread freeing_;
};

}  // namespace biotope

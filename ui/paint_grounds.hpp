#pragma once

#include <map>
#include <memory>
#include <optional>
#include <set>
#include <vector>

#include "core/base/background_thread.hpp"
#include "core/document/brush.hpp"
#include "core/pipeline/maps_snapshot.hpp"
#include "ui/background_task.hpp"

namespace biotope {

/// Maps that strokes read.
struct PaintNeeds {
  std::vector<LayerId> layers;             ///< computed maps, the most urgent first
  std::vector<FilterQuantity> quantities;  ///< of filters; FilterQuantity::map is left out
  std::vector<LayerId> finals;             ///< computed maps with the document's paint over them
  std::optional<LayerId> picture;          ///< whose picture the next stroke begins with
};

/// Everything one brush reads: its targets, what it clones, the maps of its filter.
[[nodiscard]] PaintNeeds needs_of_brush(const std::vector<LayerId>& targets, const Brush& brush,
                                        const std::optional<LayerId>& clone_from);

/// A computed map with a document's paint over it (paint may be null).
[[nodiscard]] std::shared_ptr<const Grid<float>> final_map(LayerKind kind, std::shared_ptr<const Grid<float>> computed,
                                                           const PaintLayer* paint);

/// Maps under the brush, made off the window's thread while a tool is in the hand and kept while they are of the landscape shown,
/// so that the first dab does not wait for them.
class PaintGrounds {
 public:
  using Map = std::shared_ptr<const Grid<float>>;

  /// Takes what has been made and starts making the next missing map. Once a frame.
  void prepare(const std::shared_ptr<const MapsSnapshot>& snapshot, const Document& document, const PaintNeeds& needs);
  /// True while a map is being made.
  [[nodiscard]] bool busy() const { return making_.running(); }
  /// True when a layer's map is there.
  [[nodiscard]] bool ready(const MapsSnapshot& snapshot, const LayerId& layer) const;
  /// True when everything a filter reads is there.
  [[nodiscard]] bool ready(const MapsSnapshot& snapshot, const Document& document, const BrushFilter& filter) const;
  /// The computed map under a layer; made now if it is not there. Null when the snapshot does not know it.
  [[nodiscard]] Map computed(const MapsSnapshot& snapshot, const LayerId& layer);
  /// The map with paint as it counts in the document.
  [[nodiscard]] Map final_of(const MapsSnapshot& snapshot, const Document& document, const LayerId& layer);
  /// The picture that was made for a stroke over this layer, to be kept by the caller; null when there is none.
  [[nodiscard]] std::shared_ptr<Grid<float>> take_picture(const MapsSnapshot& snapshot, const LayerId& layer);
  /// What a filter reads; made now as far as it is not there.
  [[nodiscard]] FilterMaps filters(const MapsSnapshot& snapshot, const Document& document, const BrushFilter& filter);
  void clear();

 private:
  /// A map and what it was made from.
  struct Made {
    std::shared_ptr<const void> source;
    std::shared_ptr<const PaintLayer> paint;
    Map map;
  };
  struct Finished {
    std::optional<LayerId> layer;
    std::optional<LayerId> final_layer;
    std::optional<FilterQuantity> quantity;
    Made made;
    std::optional<LayerId> picture_layer;
    std::shared_ptr<Grid<float>> picture;
  };
  void take();
  /// Puts a map in the place of another, which is freed on another thread: that takes long, the map being large.
  void replace(Made& old, Made made);
  void keep_few(const PaintNeeds& needs);
  [[nodiscard]] Map quantity(const MapsSnapshot& snapshot, FilterQuantity which);

  std::map<LayerId, Made> computed_;
  std::map<LayerId, Made> finals_;
  std::map<FilterQuantity, Made> quantities_;
  std::optional<LayerId> picture_layer_;
  std::shared_ptr<const void> picture_source_;
  std::shared_ptr<Grid<float>> picture_;
  BackgroundTask<Finished> making_;
  BackgroundThread freeing_;
};

}  // namespace biotope

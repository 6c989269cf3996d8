#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "core/base/status.hpp"
#include "core/document/brush.hpp"
#include "core/document/history.hpp"

namespace biotope {

// Edits are what a person does, as plain values: they can be recorded, saved, shared and played again. Every edit becomes one
// Command.

/// One layer that an edit changes, and how strongly.
struct EditTarget {
  LayerId layer{};
  float weight = 1;
  std::optional<float> value{};
  std::optional<float> floor{};
  bool operator==(const EditTarget&) const = default;
};

/// A brush stroke. Brush::stamp travels as an image beside the script.
struct StrokeEdit {
  std::vector<EditTarget> targets{};
  Brush brush{};
  std::optional<LayerId> clone_from{};
  std::vector<StrokePoint> points{};
};

/// Every cell that filter and selection let pass, as one dab of full weight; with a gradient the value goes from `brush.value` at
/// `from` to `end_value` at `to` (constant beyond), across the line.
struct FillEdit {
  std::vector<EditTarget> targets{};
  Brush brush{};
  std::optional<LayerId> clone_from{};
  struct Gradient {
    PathPoint from{};
    PathPoint to{};
    float end_value = 0;
    bool operator==(const Gradient&) const = default;
  };
  std::optional<Gradient> gradient{};
};

/// Changes what is selected. `inverse` turns the whole selection round, whatever the mode; 'nothing' is a selection without any
/// cell, in which no edit changes anything ('everything' lets every cell be edited again). 'painted' is where the layer
/// `range.map` holds paint, as far as it covers.
struct SelectEdit {
  enum class Shape : std::uint8_t { everything, nothing, rectangle, lasso, range, inverse, painted };
  Shape shape = Shape::everything;
  SelectionMode mode = SelectionMode::replace;
  std::vector<PathPoint> points{};  ///< two corners, or the lasso's line
  FilterCondition range{};          ///< of Shape::range; its `map` of Shape::painted
  bool operator==(const SelectEdit&) const = default;
};

/// Changes where no edit changes paint, from what is selected (without a selection: everything).
struct LockEdit {
  enum class How : std::uint8_t {
    replace,   ///< what is selected is locked, the rest is free
    add,       ///< what is selected is locked too
    subtract,  ///< what is selected is free again
    nothing    ///< everything is free
  };
  How how = How::add;
  bool operator==(const LockEdit&) const = default;
};

/// Takes all paint off a layer, whatever is selected (the computed map is back), but not off the locked area.
struct ClearEdit {
  LayerId layer{};
  bool operator==(const ClearEdit&) const = default;
};

/// Lays a map over a layer as paint, within filter, selection and what is not locked. `values` has the terrain's size; NaN cells
/// are left alone.
struct ImageEdit {
  LayerId layer{};
  std::shared_ptr<const Grid<float>> values = nullptr;
  /// Where the values came from, for the script: a file path.
  std::string source{};
  float opacity = 1;  ///< 0..1
  BrushFilter filter{};
};

/// How one layer's paint is mixed into another's.
enum class LayerMix : std::uint8_t {
  replace,    ///< the other paint instead of one's own
  over,       ///< the other paint on top of one's own
  under,      ///< the other paint beneath one's own: it shows where one's own does not cover
  subtract,   ///< one's own paint is taken off where the other covers
  intersect,  ///< one's own paint stays only where the other covers
  maximum     ///< where both cover, the one of the greater final value; elsewhere the one there is. Not for classes.
};

/// Mixes paint into a layer, within the selection and what is not locked, from another layer of this document or from `paint`
/// (another scene's, a copied one). Values are cut to what the layer may hold; classes mix with classes only.
struct MixEdit {
  LayerId into{};
  LayerId from{};
  std::shared_ptr<const PaintLayer> paint = nullptr;  ///< null: the document's own layer `from`
  LayerMix mix = LayerMix::over;
};

/// Any change of the document's parts that are no raster: what `change` makes of a copy. Scripts hold the parts themselves.
struct PartsEdit {
  std::string name{};
  std::function<void(Document&)> change{};
};

using Edit = std::variant<StrokeEdit, FillEdit, SelectEdit, ClearEdit, ImageEdit, MixEdit, PartsEdit, LockEdit>;

/// The maps that edits read beside the document.
struct EditGrounds {
  /// The computed map under a layer; null when it is not known.
  std::function<std::shared_ptr<const Grid<float>>(const LayerId&)> computed;
  /// Slope, altitude, aspect and distance to water; layer values are added as needed.
  FilterMaps filters;
};

/// What a stroke over a document needs, with the maps it keeps alive: `Stroke(ground.targets, &ground.maps)`.
struct StrokeGround {
  std::vector<StrokeTarget> targets;
  FilterMaps maps;
  std::vector<std::shared_ptr<const Grid<float>>> kept;
};

/// The ground of a stroke, painted live or played again. Locked layers are left out; fails when all are, or when something is
/// missing.
[[nodiscard]] Result<StrokeGround> stroke_ground(const Document& document, const std::vector<EditTarget>& targets,
                                                 const Brush& brush, const std::optional<LayerId>& clone_from,
                                                 const EditGrounds& grounds);

/// A layer's map as it counts: `computed` with the document's paint over it, if it is not hidden. `computed` itself where nothing
/// counts.
[[nodiscard]] std::shared_ptr<const Grid<float>> final_map(const Document& document, const LayerId& layer,
                                                           std::shared_ptr<const Grid<float>> computed);

/// What a person reads in the history: "Paint oak", "Fill moisture", "Select".
[[nodiscard]] std::string edit_name(const Edit& edit, const Document& document);

/// The undo step that an edit makes of the document, not yet applied; null when it changes nothing. Fails with what is missing:
/// an unknown layer or species, a locked layer, a map of another size. The document is not changed. A stroke gives the same as
/// one painted live with the same grounds.
[[nodiscard]] Result<std::unique_ptr<Command>> make_command(const Document& document, const Edit& edit,
                                                            const EditGrounds& grounds);

}  // namespace biotope

#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/document/brush_filter.hpp"
#include "core/document/document.hpp"
#include "core/document/history.hpp"

namespace biotope {

struct LayerPainter;
struct TileWeights;

enum class BrushMode : std::uint8_t {
  add,
  subtract,
  set,
  smooth,            ///< towards the mean of the cells around (smoothing_reach cells to each side)
  sharpen,           ///< away from that mean, but never beyond the least and the greatest value around: hardens an edge
  noise,             ///< up and down by at most `value` a dab, by coherent noise of `noise_size`
  clone,             ///< towards the values of another map
  restore_computed,  ///< takes paint off
  raise,             ///< up by at most `value` a dab (ground heights)
  lower              ///< down by at most `value` a dab
};

/// How far smoothing and sharpening look to each side, cells: an eighth of the brush's radius, 1..64 (our choice).
[[nodiscard]] int smoothing_reach(float radius);

/// How a dab's weight falls from its hard core to its rim.
enum class Falloff : std::uint8_t { smooth, linear, sphere, sharp };

/// How a dab falls on the map. Values stay in the legal range of the layer they are painted on (legal_range). Geology holds class
/// numbers, which are never mixed: only set, clone and restore_computed change it.
struct Brush {
  BrushMode mode = BrushMode::add;
  float radius = 40;      ///< cells
  float strength = 0.5F;  ///< 0..1
  float hardness = 0.5F;  ///< 0: falls off from the centre, 1: flat disk
  float value = 1;        ///< in the layer's unit: the most that 'add' reaches, what 'set' sets, the amplitude of noise
  float floor = 0;        ///< the least that 'subtract' reaches
  Falloff falloff = Falloff::smooth;
  float spacing = 0.25F;             ///< between dabs, in radii (of the size that pressure gives); at least half a cell
  bool pressure_sizes = false;       ///< radius x pressure
  bool pressure_strengthens = true;  ///< strength x pressure
  float noise_size = 12;             ///< of noise, cells
  std::uint64_t noise_seed = 1;
  /// Shape of the dab instead of a disk: weight 0..1, stretched over the dab's square; null: a disk.
  std::shared_ptr<const Grid<float>> stamp = nullptr;
  float stamp_turn = 0;  ///< degrees clockwise
  /// Each dab turns by a chance that depends on `noise_seed` and where it falls, and on nothing else.
  bool stamp_turns_by_chance = false;
  /// 'clone' takes its values this far from the cell it paints, in cells.
  PathPoint clone_offset{};
  BrushFilter filter{};
};

/// One map that a stroke paints.
struct StrokeTarget {
  LayerId layer{};
  /// The map under the layer (what paint is added to); it must outlive the stroke.
  const Grid<float>* computed = nullptr;
  /// Multiplies the brush's strength.
  float weight = 1;
  /// Replace the brush's value and floor where the layers of one stroke have other limits.
  std::optional<float> value{};
  std::optional<float> floor{};
  /// The final map 'clone' takes from; null: nothing is cloned.
  const Grid<float>* clone_source = nullptr;
};

/// A point of a stroke.
struct StrokePoint {
  float x = 0;  ///< cells
  float y = 0;
  float pressure = 1;  ///< 0..1
  bool operator==(const StrokePoint&) const = default;
};

/// Values that paint of a kind may hold, in its unit.
[[nodiscard]] Range legal_range(LayerKind kind);
/// A layer in a sentence, its species as files name it: "quercus-ilex", "moisture", "loss of quercus-ilex", "ground".
[[nodiscard]] std::string layer_words(const LayerId& layer);
/// The same as people call its species: "Holm oak", "loss of Holm oak". By the file's name where a species has no other.
[[nodiscard]] std::string layer_words(const LayerId& layer, const Document& document);
/// Name of the step that a stroke over these layers makes: "Paint Holm oak", "Paint Holm oak and 2 more".
[[nodiscard]] std::string stroke_name(const std::vector<LayerId>& layers, const Document& document);

/// A stroke in progress over layers of a document: dabs paint at once into the document's layers and `finish` yields one undo
/// step. Tiles are never changed in place: a dab makes new ones where something changed, so copies of the document stay as they
/// are. Locked layers stay as they are. Every dab is a pure function of (document, brush, position, pressure), so a stroke of the
/// same points gives the same paint, however they were batched. A dab that changes no value leaves no paint.
class Stroke {
 public:
  Stroke(LayerId layer, const Grid<float>* computed);
  /// `maps` is what the brush's filter reads; it must outlive the stroke and may be null when the filter has no conditions.
  Stroke(std::vector<StrokeTarget> targets, const FilterMaps* maps);

  /// Paints one dab at cell coordinates; returns a rectangle around the cells it changed, empty when there are none.
  Rect dab(Document& document, const Brush& brush, float x, float y, float pressure = 1);
  /// Dabs along a line from the last point, `spacing` radii apart; the first call paints one dab. Pressure goes linearly along.
  Rect move_to(Document& document, const Brush& brush, float x, float y, float pressure = 1);
  /// The undo step of the whole stroke, or null when nothing changed.
  [[nodiscard]] std::unique_ptr<Command> finish(const Document& document);
  [[nodiscard]] const std::vector<StrokeTarget>& targets() const { return targets_; }

 private:
  /// What the stroke holds of one target's layer.
  struct Held {
    /// Tiles it changed, as they were before.
    std::map<std::size_t, PaintLayer::TilePointer> before;
    /// The layer in the document as long as this stroke made it: it may be changed in place while nobody else holds it.
    std::shared_ptr<PaintLayer> own;
  };
  Rect paint(Document& document, std::size_t target, const LayerPainter& painter, const std::vector<TileWeights>& tiles);

  std::vector<StrokeTarget> targets_;
  const FilterMaps* maps_ = nullptr;
  std::vector<Held> held_;
  std::optional<StrokePoint> last_;
};

}  // namespace biotope

#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "core/base/path_point.hpp"
#include "core/document/brush.hpp"
#include "ui/tools.hpp"

namespace biotope {

/// What a value that a person chose for a brush means.
enum class ValueUse : std::uint8_t {
  reach,      ///< what 'add' reaches, what 'set' and 'fill' set
  amplitude,  ///< of noise
  pass,       ///< metres that one pass raises or lowers
  depth       ///< metres of a carved trench
};

/// What a person set up for painting beside the brush's shape.
struct PaintSetup {
  /// Values that replace the built-in ones.
  std::map<std::pair<LayerId, ValueUse>, float> values;
  /// Of species that are painted together, by name; missing: 1.
  std::map<std::string, float> weights;
  BrushMode fill_mode = BrushMode::set;
  float fill_strength = 1;  ///< of fills and gradients, 0..1
  /// Where a gradient ends, in the layer's unit; missing: the least the layer holds.
  std::optional<float> gradient_end;
  /// The layer 'clone' takes from; missing: the painted one.
  std::optional<LayerId> clone_from;
  /// Where 'clone' takes from, of the next stroke; the distance to its first point then stays.
  std::optional<PathPoint> clone_at;
  PathPoint clone_offset;
  /// Paint ways open to all instead of obstacles.
  bool opens_passages = false;
  /// The 2D map shows where the brush may act.
  bool show_filter = false;
  /// Where the last stroke ended: Shift draws a straight line from there.
  std::optional<PathPoint> last_point;
  /// Strokes begun, so that each has noise of its own.
  std::uint64_t strokes = 0;
  std::string stamp;           ///< name of the stamp in use; empty: a disk
  std::string preset;          ///< name of the preset chosen last
  bool wants_presets = false;  ///< the list of presets is to open
  std::string new_preset;      ///< name being typed
  /// The tool used last of each place on the toolbar.
  std::map<std::string, std::string> last_of_group;
  bool layers_open = false;  ///< the compact list of layers is open
  /// Condition of 'select by value'.
  FilterCondition range;
  SelectionMode range_mode = SelectionMode::replace;
};

/// The left button held for a tool that acts when it is let go.
struct ToolGesture {
  Tool tool = Tool::select;
  SelectionMode mode = SelectionMode::replace;
  std::vector<PathPoint> points;
};

/// Paint that was copied; it survives opening another scene.
struct CopiedPaint {
  LayerId from;
  std::shared_ptr<const PaintLayer> paint;
  std::string title;  ///< what it was called
};

}  // namespace biotope

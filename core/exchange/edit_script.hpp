#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "core/base/status.hpp"
#include "core/document/edit.hpp"
#include "core/exchange/dem_import.hpp"
#include "core/exchange/edit_script_parts.hpp"

namespace biotope {

// An edit script is an editing session as text (docs/edit-scripts.md): what a person did, in order, so that it can be played
// again.

/// Version of the format that is written; older ones are read.
inline constexpr int edit_script_version = 1;

/// A stroke. Its stamp is a file beside the script; `edit.brush.stamp` is null here.
struct StrokeEntry {
  StrokeEdit edit;
  std::string stamp;
};

struct FillEntry {
  FillEdit edit;
  std::string stamp;
};

/// An image laid over a layer as paint, stretched over the terrain. Grey 0..1 becomes low..high in the layer's unit; without them
/// numbers of a floating-point raster are taken as they are, and pictures go over the layer's usual range.
struct ImageEntry {
  LayerId layer;
  std::string file;
  std::optional<float> low;
  std::optional<float> high;
  float opacity = 1;
  BrushFilter filter;
  bool operator==(const ImageEntry&) const = default;
};

/// Paint mixed into a layer, from a file of paint (value and coverage) beside the script or, without one, from the document's
/// layer `from`.
struct MixEntry {
  LayerId into;
  LayerId from;
  LayerMix mix = LayerMix::over;
  std::string file;
  bool operator==(const MixEntry&) const = default;
};

/// What is selected becomes what a file of one band of bytes beside the script says (255: all of a cell); without a file,
/// everything.
struct MaskEntry {
  std::string file;
  bool operator==(const MaskEntry&) const = default;
};

/// What no edit changes: from what is selected or, where `file` is named, what a file of one band of bytes beside the script says
/// (255: all of a cell).
struct LockEntry {
  LockEdit edit;
  std::string file;
  bool operator==(const LockEntry&) const = default;
};

/// Another landscape in place of the one there is: a built-in one (`sample`), or a scene or DEM in a file beside the script. The
/// history begins anew. While a script is recorded `file` is where the file lies; saving brings it beside the script.
struct OpenEntry {
  std::string sample;
  std::string file;
  DemImportOptions options;
};

struct UndoEntry {
  int steps = 1;
  bool operator==(const UndoEntry&) const = default;
};

struct RedoEntry {
  int steps = 1;
  bool operator==(const RedoEntry&) const = default;
};

struct ScriptEntry;

/// Several entries that are one step of the history; no groups, undo, redo or open among them.
struct GroupEntry {
  std::string name;
  std::vector<ScriptEntry> entries;
};

/// One step of a script.
struct ScriptEntry {
  std::variant<StrokeEntry, FillEntry, SelectEdit, ClearEdit, ImageEntry, MixEntry, PartsPatch, MaskEntry, LockEntry, GroupEntry,
               UndoEntry, RedoEntry, OpenEntry>
      what;
};

struct EditScript {
  /// Cells of the terrain it begins on; 0: any. Positions are in cells, so that it only plays on a terrain of this size.
  int width = 0;
  int height = 0;
  std::vector<ScriptEntry> entries;
};

/// Reads a script's text. An Error names `label` (a file), the entry by its number from 1, the key and what was expected. Files
/// that the script names are not looked at, but a name that leads out of the script's folder is an Error.
[[nodiscard]] Result<EditScript> parse_edit_script(std::string_view text, const std::string& label);

/// The way back, one entry a line. Every number is written so that it reads back as the same number.
[[nodiscard]] std::string edit_script_to_json(const EditScript& script);

/// What an entry is called in messages: "stroke", "fill", ...
[[nodiscard]] std::string entry_kind(const ScriptEntry& entry);

/// A layer as text: "plant-density:quercus", "resource:moisture", "ground:height".
[[nodiscard]] std::string layer_to_text(const LayerId& layer);
/// The way back; nothing for a text that names no layer. Whether a species exists is not asked.
[[nodiscard]] std::optional<LayerId> layer_from_text(std::string_view text);

}  // namespace biotope

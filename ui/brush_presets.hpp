#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/status.hpp"
#include "core/document/brush.hpp"
#include "ui/tools.hpp"

namespace biotope {

struct EditorState;

/// A brush with a name.
struct BrushPreset {
  std::string name;
  Tool tool = Tool::add;
  /// Radius on the ground, m: a preset is as large on every terrain.
  float size = 100;
  /// Everything else of the shape, and the filter; its radius, mode, value and stamp's picture are not used.
  Brush brush;
  /// A stamp's name (BrushStamp); empty: a disk.
  std::string stamp;
  /// What it paints; missing: whatever one looks at. A loss without a name is of the selected species.
  std::optional<LayerId> target;
  /// In the target's unit; missing: as it is.
  std::optional<float> value;
  /// Paints every plant at once.
  bool all_plants = false;
};

/// What there is to start with.
[[nodiscard]] const std::vector<BrushPreset>& built_in_presets();

/// The person's own presets as text and back. What is odd keeps its default or is left out, so that a damaged file costs no more
/// than what is damaged.
[[nodiscard]] std::string presets_to_json(const std::vector<BrushPreset>& presets);
[[nodiscard]] std::vector<BrushPreset> presets_from_json(std::string_view json);
/// None when there is no file.
[[nodiscard]] std::vector<BrushPreset> load_presets(const std::filesystem::path& file);
/// Atomic: written beside and renamed.
[[nodiscard]] Status save_presets(const std::filesystem::path& file, const std::vector<BrushPreset>& presets);

// With the editor.

/// The person's presets are read once, from beside the settings.
[[nodiscard]] const std::vector<BrushPreset>& own_presets(EditorState& state);
/// Takes a preset into the hand.
void use_preset(EditorState& state, const BrushPreset& preset);
/// The brush in the hand under a name; one of the same name is replaced. Saved at once.
void keep_preset(EditorState& state, const std::string& name);
/// Throws one of the person's own away; it can be taken back until another one is.
void remove_preset(EditorState& state, const std::string& name);
void take_back_preset(EditorState& state);

}  // namespace biotope

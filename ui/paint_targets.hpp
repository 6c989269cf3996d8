#pragma once

#include <optional>
#include <string>
#include <vector>

#include "ui/editor_state.hpp"

namespace biotope {

// What a tool works on now, and with which values.

/// Least and greatest value a layer sensibly holds, and its unit ("%" for fractions).
struct LayerLimits {
  float low = 0;
  float high = 1;
  std::string unit;
};
[[nodiscard]] LayerLimits limits_of(const EditorState& state, const LayerId& layer);

/// Whether no brush may change a layer: its own lock, or the species' in the list.
[[nodiscard]] bool layer_locked(const EditorState& state, const LayerId& layer);
/// The layers one movement paints, the one that is looked at first: the target and, of species, the others that are selected and
/// not locked.
[[nodiscard]] std::vector<LayerId> painted_layers(const EditorState& state);

/// What the chosen value of the tool in the hand means for a layer; nothing when the tool needs none there.
[[nodiscard]] std::optional<ValueUse> value_use(const EditorState& state, const LayerId& layer);
/// The value that was chosen, else the built-in one.
[[nodiscard]] float chosen_value(const EditorState& state, const LayerId& layer, ValueUse use);
void choose_value(EditorState& state, const LayerId& layer, ValueUse use, float value);

/// The layers of a stroke or fill with their weights and values. Species of one movement share the ground by their weights.
[[nodiscard]] std::vector<EditTarget> edit_targets(const EditorState& state, const Brush& brush);

/// What `raise`, `lower` and `carve` do a dab so that one pass along a line changes the ground by `metres`.
[[nodiscard]] float metres_a_dab(const Brush& brush, float metres);

/// Shows the map of a layer in its tab, so that one sees what one paints.
void show_layer(EditorState& state, const LayerId& layer);

}  // namespace biotope

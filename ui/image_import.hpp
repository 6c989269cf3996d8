#pragma once

#include <filesystem>
#include <optional>

#include "core/exchange/layer_image.hpp"

namespace biotope {

struct EditorState;

/// An image that is to become paint, and how; asked for before it is read.
struct ImageImport {
  LayerId layer;
  std::filesystem::path file;
  ImageFacts facts;
  /// What black and white become, in the layer's unit.
  ValueRange range;
  /// Numbers are taken as the file holds them, whatever the range.
  bool as_they_are = false;
  float opacity = 1;
  /// Only where the brush's filter lets it.
  bool filtered = false;
};

/// How an image is offered at first: over the layer's usual range, numbers that are no picture as they are.
[[nodiscard]] ImageImport offered_import(const EditorState& state, const LayerId& layer, const std::filesystem::path& file,
                                         const ImageFacts& facts);
/// The range that reading takes; nothing: numbers as they are, or classes.
[[nodiscard]] std::optional<ValueRange> reading_range(const ImageImport& import);
/// Reads it in the background; it becomes a step of the history when it is there.
void start_import(EditorState& state, const ImageImport& import);

}  // namespace biotope

#include "ui/image_import.hpp"

#include "ui/editor_actions.hpp"
#include "ui/layer_values.hpp"
#include "ui/paint_targets.hpp"

namespace biotope {

ImageImport offered_import(const EditorState& state, const LayerId& layer, const std::filesystem::path& file,
                           const ImageFacts& facts) {
  ImageImport import;
  import.layer = layer;
  import.file = file;
  import.facts = facts;
  const LayerLimits limits = limits_of(state, layer);
  import.range = usual_range(layer).value_or(ValueRange{limits.low, limits.high});
  import.as_they_are = !facts.picture;
  import.filtered = is_painting(state.tool) && !state.brush.filter.conditions.empty();
  return import;
}

std::optional<ValueRange> reading_range(const ImageImport& import) {
  if (import.layer.kind == LayerKind::geology) return std::nullopt;
  if (!import.as_they_are) return import.range;
  // Shades of a picture are read as 0..1: white is the number that it is in the file.
  if (import.facts.picture) return ValueRange{0, import.facts.white};
  return std::nullopt;
}

void start_import(EditorState& state, const ImageImport& import) {
  if (!state.has_document) return;
  BrushFilter filter;
  if (import.filtered) filter = state.brush.filter;
  state.importing.start("Reading " + import.file.filename().string(),
                        [import, filter, terrain = state.document.terrain](const TaskContext&) -> Result<ImageEdit> {
                          auto values = read_layer_image(import.file, import.layer, *terrain, reading_range(import));
                          if (!values) return tl::unexpected(values.error());
                          ImageEdit edit;
                          edit.layer = import.layer;
                          edit.values = std::make_shared<const Grid<float>>(std::move(*values));
                          edit.source = import.file.string();
                          edit.opacity = import.opacity;
                          edit.filter = filter;
                          return edit;
                        });
}

}  // namespace biotope

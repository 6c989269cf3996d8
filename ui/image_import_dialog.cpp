#include <algorithm>
#include <cmath>

#include "ui/dialogs.hpp"
#include "ui/editor_actions.hpp"
#include "ui/format.hpp"
#include "ui/layer_values.hpp"
#include "ui/paint_targets.hpp"

namespace biotope {
namespace {

std::string extent_text(const Terrain& terrain) {
  return std::to_string(terrain.height.width()) + " x " + std::to_string(terrain.height.height()) + " cells, " +
         format_length(terrain.width_metres()) + " x " + format_length(terrain.height_metres());
}

/// Where the image's own shape is another one than the landscape's, it is told how much it is pulled.
void draw_extent(const UiContext& ui, const ImageImport& import) {
  const Terrain& terrain = *ui.state.document.terrain;
  readout(ui.theme, "Image", std::to_string(import.facts.width) + " x " + std::to_string(import.facts.height) + " pixels");
  readout(ui.theme, "Laid over", extent_text(terrain));
  const double own = double(import.facts.width) / std::max(import.facts.height, 1);
  const double pull = terrain.width_metres() / terrain.height_metres() / own;
  if (std::abs(pull - 1) > 0.01) {
    wrapped(ui.theme.attention, "It has another shape than the landscape and is stretched to fit: " +
                                    format_percent(std::abs(pull - 1)) + (pull > 1 ? " wider" : " narrower"));
  } else {
    hint(ui.theme, "It fits the whole landscape, edge to edge.");
  }
}

void draw_value(const UiContext& ui, const char* name, const char* id, float& value, const std::string& unit) {
  ImGui::AlignTextToFramePadding();
  ImGui::TextDisabled("%s", name);
  ImGui::SameLine(ui.theme.px(130));
  ImGui::SetNextItemWidth(ui.theme.px(140));
  const bool percent = unit == "%";
  float shown = percent ? value * 100 : value;
  if (ImGui::InputFloat(id, &shown, 0, 0, "%.4g") && std::isfinite(shown)) value = percent ? shown / 100 : shown;
  ImGui::SameLine();
  ImGui::TextDisabled("%s", unit.c_str());
}

void draw_values(const UiContext& ui, ImageImport& import) {
  if (import.layer.kind == LayerKind::geology) {
    hint(ui.theme, import.facts.grey ? "Grey numbers are read as rock classes 0 to 4."
                                     : "Colours are read as rock classes, the nearest one; white is left alone.");
    return;
  }
  ImGui::Checkbox("Numbers as they are", &import.as_they_are);
  tooltip(ui.theme, import.facts.picture ? "A shade is its number in the file, 0 to " + format_count(double(import.facts.white))
                                         : "The file's numbers are values in the layer's unit");
  if (import.as_they_are) return;
  const std::string unit = limits_of(ui.state, import.layer).unit;
  draw_value(ui, import.facts.picture ? "Black becomes" : "0 becomes", "##low", import.range.low, unit);
  draw_value(ui, import.facts.picture ? "White becomes" : "1 becomes", "##high", import.range.high, unit);
}

}  // namespace

void draw_image_import(const UiContext& ui) {
  EditorState& state = ui.state;
  if (!state.document.terrain) state.dialogs.import_image = false;
  if (!begin_modal(ui, "Import an image as paint", state.dialogs.import_image, 460)) return;
  ImageImport& import = state.image_import;
  readout(ui.theme, "File", import.file.filename().string());
  readout(ui.theme, "Onto", layer_title(import.layer, state.web()));
  draw_extent(ui, import);
  ImGui::Separator();
  draw_values(ui, import);
  labelled_slider(ui.theme, "Opacity", import.opacity, 0, 1, format_percent(import.opacity));
  if (!state.brush.filter.conditions.empty()) ImGui::Checkbox("Only where the brush's filter lets it", &import.filtered);
  if (state.document.selection) hint(ui.theme, "Only inside the selection.");
  if (state.document.locked_area) hint(ui.theme, "Not where the ground is locked.");
  ImGui::Dummy(ImVec2(0, ui.theme.px(6)));
  align_buttons(ui.theme, 2, 110);
  const bool cancelled = ImGui::Button("Cancel", ImVec2(ui.theme.px(110), 0)) || take_key(state, DialogKey::escape);
  ImGui::SameLine();
  const bool accepted = primary_button(ui.theme, "Import", ui.theme.px(110)) || take_key(state, DialogKey::enter);
  if (accepted || cancelled) {
    state.dialogs.import_image = false;
    ImGui::CloseCurrentPopup();
  }
  ImGui::EndPopup();
  if (accepted) start_import(state, import);
}

}  // namespace biotope

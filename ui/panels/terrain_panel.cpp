#include "ui/editor_actions.hpp"
#include "ui/format.hpp"
#include "ui/panels/panels.hpp"
#include "ui/panels/placing_panel.hpp"

namespace biotope {
namespace {

std::string crs_name(const Georeference& georeference) {
  if (georeference.wkt.empty()) return "none (local metres)";
  const std::size_t first = georeference.wkt.find('"');
  const std::size_t second = georeference.wkt.find('"', first + 1);
  return second == std::string::npos ? "unnamed" : georeference.wkt.substr(first + 1, second - first - 1);
}

void draw_water(const UiContext& ui, const Hydrology& hydrology) {
  const WaterFigures& water = ui.state.water;
  heading(ui.theme, "Water");
  readout(ui.theme, "River reaches", format_count(double(hydrology.reaches.size())));
  readout(ui.theme, "Greatest mean discharge", hydrology.reaches.empty() ? "no river" : format_value(water.discharge, "m³/s"));
  readout(ui.theme, "Lakes", format_value(water.lake_area / 1e6, "km²"));
  if (water.sea_area > 0) readout(ui.theme, "Sea", format_value(water.sea_area / 1e6, "km²"));
  readout(ui.theme, "Fords", format_count(double(hydrology.fords.size())));
}

}  // namespace

void draw_terrain_panel(const UiContext& ui) {
  EditorState& state = ui.state;
  const Terrain& terrain = *state.document.terrain;
  heading(ui.theme, terrain.name.empty() ? "Terrain" : terrain.name);
  readout(ui.theme, "Size", format_length(terrain.width_metres()) + " x " + format_length(terrain.height_metres()));
  readout(ui.theme, "Cells", std::to_string(terrain.height.width()) + " x " + std::to_string(terrain.height.height()));
  readout(ui.theme, "Cell size", format_value(terrain.cell_size, "m"));
  const auto [low, high] = state.ground.height_range;
  readout(ui.theme, "Heights", format_value(low, "m") + " to " + format_value(high, "m"));
  readout(ui.theme, "Latitude", format_value(terrain.latitude, "°"));
  readout(ui.theme, "Reference", fitted_text(crs_name(terrain.georeference), ui.theme.px(170)));
  readout(ui.theme, "Filled voids", terrain.voids.empty() ? "none" : format_percent(state.ground.void_share));
  if (state.shown && state.shown->hydrology) {
    draw_water(ui, *state.shown->hydrology);
  } else {
    heading(ui.theme, "Water");
    hint(ui.theme, "Rivers and lakes are being found");
  }
  draw_water_things(ui);
  ImGui::Dummy(ImVec2(0, ui.theme.px(8)));
  if (ImGui::Button("Open another terrain ...", ImVec2(-1, 0))) state.dialogs.open_file = true;
  tooltip(ui.theme, "GeoTIFF, ASC, HGT, PNG 16 and whatever else GDAL reads; or drop a file on the window",
          ui.commands.keys("file.open"));
}

}  // namespace biotope

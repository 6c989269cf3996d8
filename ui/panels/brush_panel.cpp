#include <algorithm>
#include <cmath>

#include "ui/editor_actions.hpp"
#include "ui/format.hpp"
#include "ui/paint_targets.hpp"
#include "ui/paint_widgets.hpp"
#include "ui/panels/brush_shape_panel.hpp"
#include "ui/panels/filter_panel.hpp"
#include "ui/panels/panels.hpp"
#include "ui/panels/preset_panel.hpp"
#include "ui/panels/selection_panel.hpp"

namespace biotope {
namespace {

bool of_species(LayerKind kind) {
  return kind == LayerKind::plant_density || kind == LayerKind::animal_density || kind == LayerKind::loss;
}

std::string target_title(const EditorState& state, const std::optional<LayerId>& target) {
  if (!target) return "nothing chosen";
  const std::size_t others = painted_layers(state).size() - 1;
  const std::string name = layer_title(*target, state.web());
  return others == 0 ? name : name + " and " + std::to_string(others) + " more";
}

const char* verb(Tool tool) {
  switch (tool) {
    case Tool::set:
      return "Set";
    case Tool::erase:
      return "Erase";
    case Tool::smooth:
      return "Smooth";
    case Tool::sharpen:
      return "Sharpen";
    case Tool::noise:
      return "Roughen";
    case Tool::clone:
      return "Clone into";
    case Tool::restore:
      return "Restore";
    case Tool::raise:
      return "Raise";
    case Tool::lower:
      return "Lower";
    case Tool::flatten:
      return "Flatten";
    case Tool::carve:
      return "Carve";
    case Tool::fill:
      return "Fill";
    case Tool::gradient:
      return "Gradient";
    default:
      return "Paint";
  }
}

void draw_title(const UiContext& ui, const std::optional<LayerId>& target) {
  const Theme& theme = ui.theme;
  ImGui::PushFont(theme.bold);
  ImGui::TextUnformatted((std::string(verb(ui.state.tool)) + ": ").c_str());
  ImGui::SameLine(0, 0);
  ImGui::TextColored(theme.accent, "%s", fitted_text(target_title(ui.state, target), ImGui::GetContentRegionAvail().x).c_str());
  ImGui::PopFont();
  const std::string hindrance = paint_hindrance(ui.state);
  if (hindrance.empty()) return;
  wrapped(theme.attention, hindrance);
}

/// Of a species one paints how many there are, or what an event takes from it.
void draw_density_or_event(const UiContext& ui, const LayerId& target) {
  EditorState& state = ui.state;
  const FoodWeb* web = state.web();
  if (web == nullptr || !of_species(target.kind) || state.view.tab == Tab::project || state.view.tab == Tab::trails) return;
  int chosen = target.kind == LayerKind::loss ? 1 : 0;
  const bool changed =
      segmented(ui.theme, "density or event", {"How many", "External event"}, chosen, ImGui::GetContentRegionAvail().x);
  ImGui::Dummy(ImVec2(0, ui.theme.px(1)));
  if (!changed) return;
  const int species = web->find(target.name);
  if (species < 0) return;
  const bool plant = web->species[std::size_t(species)].is_plant();
  const MapKind kind = chosen == 1 ? MapKind::loss : plant ? MapKind::plant_cover : MapKind::animal_density;
  state.view.shown[std::size_t(state.view.tab)] = {kind, species};
}

void draw_class_value(const UiContext& ui, const LayerId& target, float value) {
  EditorState& state = ui.state;
  if (target.kind == LayerKind::passage) {
    int chosen = value < 0 ? 1 : 0;
    if (segmented(ui.theme, "passage", {"Obstacle", "Open to all"}, chosen, ImGui::GetContentRegionAvail().x)) {
      choose_value(state, target, ValueUse::reach, chosen == 1 ? -1.0F : 1.0F);
    }
    ImGui::Dummy(ImVec2(0, ui.theme.px(1)));
    return;
  }
  const std::vector<std::string>& names = geology_names();
  const auto now = std::size_t(std::clamp(int(std::lround(value)), 0, geology_classes - 1));
  ImGui::SetNextItemWidth(-1);
  if (!ImGui::BeginCombo("##class", names[now].c_str())) return;
  for (std::size_t i = 0; i < names.size(); ++i) {
    if (ImGui::Selectable(names[i].c_str(), i == now)) choose_value(state, target, ValueUse::reach, float(i));
  }
  ImGui::EndCombo();
}

/// Name and ends of the slider of a value.
struct ValueSlider {
  const char* name;
  float low, high;
  std::string unit;
  bool logarithmic = false;
};

ValueSlider slider_of(const EditorState& state, const LayerId& target, ValueUse use) {
  const LayerLimits limits = limits_of(state, target);
  switch (use) {
    case ValueUse::pass:
      return {"Metres in one pass", 0.1F, 100, "m", true};
    case ValueUse::depth:
      return {"Depth", 0.2F, 30, "m", true};
    case ValueUse::amplitude:
      return {"Roughness", 0, target.kind == LayerKind::ground ? 50 : 0.5F * (limits.high - limits.low), limits.unit};
    case ValueUse::reach:
      break;
  }
  const bool adds = state.tool == Tool::add || (state.tool == Tool::fill && state.paint.fill_mode == BrushMode::add);
  return {adds ? "Up to" : "Value", limits.low, limits.high, limits.unit};
}

void draw_value(const UiContext& ui, const LayerId& target) {
  EditorState& state = ui.state;
  const std::optional<ValueUse> use = value_use(state, target);
  if (!use) return;
  float value = chosen_value(state, target, *use);
  if (target.kind == LayerKind::passage || target.kind == LayerKind::geology) {
    draw_class_value(ui, target, value);
    return;
  }
  const ValueSlider slider = slider_of(state, target, *use);
  if (labelled_slider(ui.theme, slider.name, value, slider.low, slider.high, format_value(value, slider.unit),
                      slider.logarithmic)) {
    choose_value(state, target, *use, value);
  }
  if (*use == ValueUse::reach) tooltip(ui.theme, "Ctrl+click on the map takes the value that is there");
  if (state.tool == Tool::gradient) {
    float end = state.paint.gradient_end.value_or(slider.low);
    end = std::clamp(end, slider.low, slider.high);
    if (labelled_slider(ui.theme, "Ends at", end, slider.low, slider.high, format_value(end, slider.unit)))
      state.paint.gradient_end = end;
  }
}

/// A weight for every species that is painted together.
void draw_weights(const UiContext& ui, const std::vector<LayerId>& layers) {
  EditorState& state = ui.state;
  if (layers.size() < 2) return;
  if (!section(ui.theme, "Shares of the species", std::to_string(layers.size()) + " together", layers.size() <= 4)) return;
  float sum = 0;
  const auto weight_of = [&](const LayerId& layer) {
    const auto found = state.paint.weights.find(layer.name);
    return found == state.paint.weights.end() ? 1.0F : found->second;
  };
  for (const LayerId& layer : layers) sum += weight_of(layer);
  for (const LayerId& layer : layers) {
    float weight = weight_of(layer);
    const float share = layer.kind == LayerKind::loss ? weight : sum > 0 ? weight / sum : 0;
    ImGui::PushID(layer.name.c_str());
    if (labelled_slider(ui.theme, layer_title(layer, state.web()).c_str(), weight, 0, 1, format_percent(share))) {
      state.paint.weights[layer.name] = weight;
    }
    ImGui::PopID();
  }
}

void draw_clone(const UiContext& ui) {
  EditorState& state = ui.state;
  const std::string source =
      state.paint.clone_from ? layer_title(*state.paint.clone_from, state.web()) : std::string("the same map");
  if (ImGui::Button(("From " + source + " ...").c_str(), ImVec2(-1, 0))) ImGui::OpenPopup("clone from");
  tooltip(ui.theme, "The map whose values are copied");
  if (ImGui::BeginPopup("clone from")) {
    if (ImGui::MenuItem("The same map", nullptr, !state.paint.clone_from)) state.paint.clone_from.reset();
    ImGui::Separator();
    if (const auto layer = layer_menu(state)) state.paint.clone_from = layer;
    ImGui::EndPopup();
  }
  if (state.tool != Tool::clone) return;
  hint(ui.theme, state.paint.clone_at || !(state.paint.clone_offset == PathPoint{})
                     ? "The cross shows where from; Ctrl+click moves it"
                     : "Ctrl+click on the map says where from; without, it is the same place");
}

void draw_fill_mode(const UiContext& ui) {
  EditorState& state = ui.state;
  struct Row {
    const char* name;
    BrushMode mode;
  };
  static constexpr Row rows[] = {{"Set the value", BrushMode::set}, {"Add up to it", BrushMode::add},
                                 {"Subtract", BrushMode::subtract}, {"Clone another map", BrushMode::clone},
                                 {"Noise", BrushMode::noise},       {"Smooth", BrushMode::smooth},
                                 {"Sharpen", BrushMode::sharpen},   {"Restore computed", BrushMode::restore_computed}};
  const auto now =
      std::find_if(std::begin(rows), std::end(rows), [&](const Row& row) { return row.mode == state.paint.fill_mode; });
  ImGui::SetNextItemWidth(-1);
  if (!ImGui::BeginCombo("##fill", now == std::end(rows) ? "Set the value" : now->name)) return;
  for (const Row& row : rows) {
    if (ImGui::Selectable(row.name, row.mode == state.paint.fill_mode)) state.paint.fill_mode = row.mode;
  }
  ImGui::EndCombo();
}

/// What fills have to choose besides their value.
void draw_fill(const UiContext& ui) {
  draw_fill_mode(ui);
  if (ui.state.paint.fill_mode == BrushMode::clone) draw_clone(ui);
}

void draw_size(const UiContext& ui) {
  EditorState& state = ui.state;
  Brush& brush = state.brush;
  const double metres = state.document.terrain ? state.document.terrain->cell_size * double(brush.radius) : 0;
  const std::string size = format_length(metres) + "  (" + format_count(std::round(double(brush.radius))) + " cells)";
  labelled_slider(ui.theme, "Size", brush.radius, 1, 400, size, true);
  tooltip(ui.theme, "Radius of the brush", ui.commands.keys("brush.smaller") + "  " + ui.commands.keys("brush.larger"));
}

/// How much a dab or a fill does; of raising and lowering the metres say it.
void draw_strength(const UiContext& ui, const std::optional<LayerId>& target) {
  EditorState& state = ui.state;
  if (state.tool == Tool::fill || state.tool == Tool::gradient) {
    labelled_slider(ui.theme, "Opacity", state.paint.fill_strength, 0.01F, 1, format_percent(state.paint.fill_strength));
    return;
  }
  const std::optional<ValueUse> use = target ? value_use(state, *target) : std::nullopt;
  if (use == ValueUse::pass || use == ValueUse::depth) return;
  labelled_slider(ui.theme, "Strength", state.brush.strength, 0.01F, 1, format_percent(state.brush.strength));
  tooltip(ui.theme, "How much one dab does", ui.commands.keys("brush.weaker") + "  " + ui.commands.keys("brush.stronger"));
}

}  // namespace

void draw_brush_panel(const UiContext& ui) {
  EditorState& state = ui.state;
  const Theme& theme = ui.theme;
  ImGui::Dummy(ImVec2(0, theme.px(2)));
  if (is_selecting(state.tool)) {
    draw_selection_panel(ui);
    return;
  }
  const std::optional<LayerId> target = paint_target(state);
  draw_title(ui, target);
  if (is_brush(state.tool)) draw_preset_choice(ui);
  if (target && !is_ground_tool(state.tool)) draw_density_or_event(ui, *target);
  if (state.tool == Tool::fill) draw_fill(ui);
  if (is_brush(state.tool)) draw_size(ui);
  draw_strength(ui, target);
  if (target) draw_value(ui, *target);
  const bool noise = state.tool == Tool::noise || (state.tool == Tool::fill && state.paint.fill_mode == BrushMode::noise);
  if (noise && state.document.terrain) {
    labelled_slider(theme, "Size of the patches", state.brush.noise_size, 2, 200,
                    format_length(double(state.brush.noise_size) * state.document.terrain->cell_size), true);
  }
  if (state.tool == Tool::clone) draw_clone(ui);
  if (target) draw_weights(ui, painted_layers(state));
  if (is_brush(state.tool) && state.tool != Tool::carve) draw_shape_section(ui);
  draw_filter_section(ui);
}

}  // namespace biotope

#include "ui/weather_control.hpp"

#include <algorithm>
#include <cmath>

#include "ui/format.hpp"
#include "ui/icons.hpp"

namespace biotope {
namespace {

void draw_presets(const UiContext& ui, float width) {
  const Weather& weather = ui.state.settings.weather;
  const NamedWeather* now = name_of_weather(weather);
  const float gap = ui.theme.px(4);
  const float each = (width - 2 * gap) / 3;
  int column = 0;
  for (const NamedWeather& named : named_weathers()) {
    if (column++ % 3 != 0) ImGui::SameLine(0, gap);
    const bool lit = now == &named;
    ImGui::PushStyleColor(ImGuiCol_Button, lit ? with_alpha(ui.theme.accent, 0.30F) : ui.theme.raised);
    const std::string label = (ui.theme.has_icons ? std::string(named.icon) + "  " : std::string()) + std::string(named.title);
    if (ImGui::Button(label.c_str(), ImVec2(each, ui.theme.px(30)))) choose_weather(ui.state, named.name);
    ImGui::PopStyleColor();
  }
}

std::string wind_text(const Weather& weather) {
  static constexpr std::array<const char*, 8> from{"north", "north-east", "east", "south-east",
                                                   "south", "south-west", "west", "north-west"};
  const int sector = int(weather.wind_direction / 45 + 0.5F) % 8;
  return format_round_number(std::round(double(weather.wind) * 2) / 2) + " m/s" +
         (weather.wind < 0.2F ? "" : std::string(" from ") + from[std::size_t(sector)]);
}

void draw_weather_popup(const UiContext& ui) {
  Weather& weather = ui.state.settings.weather;
  const float width = ui.theme.px(312);
  heading(ui.theme, "Weather in the 3D view");
  draw_presets(ui, width);
  ImGui::Dummy(ImVec2(width, ui.theme.px(2)));
  labelled_slider(ui.theme, "Clouds", weather.cloud, 0, 1, format_percent(double(weather.cloud)));
  labelled_slider(ui.theme, "Rain or snow", weather.precipitation, 0, 1,
                  weather.precipitation == 0 ? "dry" : format_percent(double(weather.precipitation)));
  labelled_slider(ui.theme, "Fog", weather.fog, 0, 1, weather.fog == 0 ? "clear air" : format_percent(double(weather.fog)));
  labelled_slider(ui.theme, "Wind", weather.wind, 0, 25, wind_text(weather));
  labelled_slider(ui.theme, "Wind comes from", weather.wind_direction, 0, 360,
                  std::to_string(int(weather.wind_direction)) + " degrees");
  ImGui::Checkbox("Snow lies where month and height let it", &weather.snow_cover);
  tooltip(ui.theme, "Off: the ground stays bare in winter and on high peaks too");
  bool moves = moves_by_itself(ui.state);
  if (ImGui::Checkbox("Leaves, water and rain move", &moves)) ui.state.settings.animate = moves;
  tooltip(ui.theme, "Off: the picture stands still and is drawn as finely as it can be", ui.commands.keys("explore.animate"));
}

}  // namespace

const std::array<NamedWeather, 6>& named_weathers() {
  static constexpr std::array<NamedWeather, 6> weathers{{{"clear", "Clear", icons::sun},
                                                         {"fair", "Fair", icons::fair},
                                                         {"overcast", "Overcast", icons::cloud},
                                                         {"rain", "Rain", icons::rain},
                                                         {"fog", "Fog", icons::fog},
                                                         {"storm", "Storm", icons::storm}}};
  return weathers;
}

const NamedWeather* name_of_weather(const Weather& weather) {
  for (const NamedWeather& named : named_weathers()) {
    auto other = weather_named(named.name);
    if (!other) continue;
    other->snow_cover = weather.snow_cover;
    other->wind_direction = weather.wind_direction;
    if (*other == weather) return &named;
  }
  return nullptr;
}

void choose_weather(EditorState& state, std::string_view name) {
  const auto weather = weather_named(name);
  if (!weather) return;
  const Weather before = state.settings.weather;
  state.settings.weather = *weather;
  state.settings.weather.snow_cover = before.snow_cover;
  state.settings.weather.wind_direction = before.wind_direction;
}

bool moves_by_itself(const EditorState& state) { return state.settings.animate.value_or(!state.view.software); }

void draw_weather_control(const UiContext& ui, float width) {
  const Theme& theme = ui.theme;
  const NamedWeather* named = name_of_weather(ui.state.settings.weather);
  const std::string icon = theme.has_icons ? std::string(named != nullptr ? named->icon : icons::cloud) + "  " : std::string();
  const std::string label = icon + (named != nullptr ? std::string(named->title) : "Own weather") + "##weather";
  ImGui::BeginGroup();
  if (ImGui::Button(label.c_str(), ImVec2(width, 0))) ImGui::OpenPopup("weather");
  tooltip(theme, "Weather of the 3D view: clouds, rain, fog, wind, snow");
  const ImVec2 below = ImGui::GetItemRectMin();
  bool moves = moves_by_itself(ui.state);
  if (ImGui::Checkbox("Moves", &moves)) ui.state.settings.animate = moves;
  tooltip(theme,
          "Leaves, water and rain move. Off: the picture stands still and is drawn as finely as it can be, which suits a machine "
          "without a graphics processor",
          ui.commands.keys("explore.animate"));
  ImGui::EndGroup();
  ImGui::SetNextWindowPos(ImVec2(below.x, below.y - theme.px(8)), ImGuiCond_Always, ImVec2(0, 1));
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, ImVec2(theme.px(12), theme.px(8)));
  if (ImGui::BeginPopup("weather")) {
    draw_weather_popup(ui);
    ImGui::EndPopup();
  }
  ImGui::PopStyleVar();
}

}  // namespace biotope

#pragma once

#include <array>
#include <string_view>

#include "render/weather.hpp"
#include "ui/widgets.hpp"

namespace biotope {

/// A weather that has a name.
struct NamedWeather {
  std::string_view name;   ///< of weather_named
  std::string_view title;  ///< "Overcast"
  const char* icon;
};
[[nodiscard]] const std::array<NamedWeather, 6>& named_weathers();
/// The named weather that a weather is, whatever the snow on the ground and the wind's direction; null for one of its own.
[[nodiscard]] const NamedWeather* name_of_weather(const Weather& weather);
/// Takes a named weather; snow cover and the wind's direction stay.
void choose_weather(EditorState& state, std::string_view name);

/// Whether leaves, water and rain move: what the person chose, else where a graphics processor draws.
[[nodiscard]] bool moves_by_itself(const EditorState& state);

/// The weather of the 3D view: its name as a button that opens everything about it, and whether it moves.
void draw_weather_control(const UiContext& ui, float width);

}  // namespace biotope

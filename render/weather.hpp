#pragma once

#include <optional>
#include <string_view>

namespace biotope {

/// The weather of the moment in the 3D view. What falls is rain above freezing and snow below it, by the climate's temperature
/// at the height.
struct Weather {
  float cloud = 0.35F;          ///< share of the sky that clouds cover, 0..1
  float precipitation = 0;      ///< 0 dry .. 1 a downpour
  float fog = 0;                ///< 0 clear air .. 1 sight of about 60 m
  float wind = 3;               ///< m/s, 0..25
  float wind_direction = 250;   ///< degrees clockwise from north that the wind comes from
  bool snow_cover = true;       ///< snow lies where season and height let it

  bool operator==(const Weather&) const = default;
};

/// A weather by name: clear, fair, overcast, rain, fog, storm. Nothing for another name.
[[nodiscard]] std::optional<Weather> weather_named(std::string_view name);

}  // namespace biotope

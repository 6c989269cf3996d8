#include "render/weather.hpp"

#include <array>
#include <utility>

namespace biotope {

std::optional<Weather> weather_named(std::string_view name) {
  static constexpr std::array<std::pair<std::string_view, Weather>, 6> weathers{{{"clear", {0.05F, 0, 0, 2}},
                                                                                 {"fair", {}},
                                                                                 {"overcast", {0.95F, 0, 0.05F, 4}},
                                                                                 {"rain", {1, 0.55F, 0.15F, 6}},
                                                                                 {"fog", {0.8F, 0, 0.7F, 1}},
                                                                                 {"storm", {1, 1, 0.25F, 15}}}};
  for (const auto& [known, weather] : weathers) {
    if (known == name) return weather;
  }
  return std::nullopt;
}

}  // namespace biotope

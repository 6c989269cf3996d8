#pragma once

#include <array>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/status.hpp"

namespace biotope {

inline constexpr int months = 12;
using MonthlyValues = std::array<double, months>;

/// Twelve months of weather at a reference height.
struct Climate {
  /// Short name used in files and on the command line, e.g. "mild-humid".
  std::string name;
  std::string title;
  std::string description;
  /// Where the numbers come from.
  std::string source;
  /// Monthly mean, minimum and maximum temperature at `reference_height`, deg C, January first.
  MonthlyValues temperature_mean{};
  MonthlyValues temperature_min{};
  MonthlyValues temperature_max{};
  /// Precipitation, mm per month.
  MonthlyValues precipitation{};
  /// Cloud cover fraction by month; dims direct sun where given, 0 otherwise.
  MonthlyValues cloud{};
  /// Height the temperatures belong to, m.
  double reference_height = 0;
  /// Cooling with height, deg C per km.
  double lapse_rate = 6.5;

  bool operator==(const Climate&) const = default;
};

/// Reads and validates a climate from JSON text; messages name `origin` (a file name), the key and what was expected.
[[nodiscard]] Result<Climate> parse_climate(std::string_view json, std::string_view origin);
[[nodiscard]] std::string climate_to_json(const Climate& climate);

/// The climates of a folder of *.json files, ordered by name.
[[nodiscard]] Result<std::vector<Climate>> load_climates(const std::filesystem::path& folder);

/// Yearly potential evapotranspiration by Thornthwaite at `height` m, mm.
[[nodiscard]] double potential_evapotranspiration(const Climate& climate, double latitude, double height);

/// Water that runs off in a year at `height`, m: precipitation less actual evapotranspiration by a monthly bucket
/// (never less than 5 % of precipitation: storms run off even in deserts, our choice).
[[nodiscard]] double yearly_runoff(const Climate& climate, double latitude, double height);

}  // namespace biotope

#include <algorithm>
#include <cmath>

#include "core/climate/climate.hpp"
#include "core/terrain/sun.hpp"

namespace biotope {
namespace {

constexpr std::array<double, months> days_in_month{31, 28.25, 31, 30, 31, 30, 31, 31, 30, 31, 30, 31};

/// Water the soil can hold for plants, mm. Our choice within the usual 50..300.
constexpr double soil_capacity = 150;
/// Smallest share of precipitation that runs off. Our choice.
constexpr double least_runoff_share = 0.05;
/// Years until the bucket repeats itself.
constexpr int spin_up_years = 3;

MonthlyValues temperature_at(const Climate& climate, double height) {
  MonthlyValues temperature = climate.temperature_mean;
  for (double& value : temperature) value -= climate.lapse_rate * (height - climate.reference_height) / 1000;
  return temperature;
}

/// Thornthwaite 1948, with Willmott's quadratic above 26 deg C, mm per month.
MonthlyValues monthly_evapotranspiration(const Climate& climate, double latitude, double height) {
  const MonthlyValues temperature = temperature_at(climate, height);
  double heat_index = 0;
  for (const double value : temperature) heat_index += std::pow(std::max(0.0, value) / 5, 1.514);
  MonthlyValues result{};
  if (heat_index <= 0) return result;
  const double i = heat_index;
  const double exponent = 6.75e-7 * i * i * i - 7.71e-5 * i * i + 1.79e-2 * i + 0.492;
  for (int month = 0; month < months; ++month) {
    const double value = temperature[std::size_t(month)];
    if (value <= 0) continue;
    const double unadjusted =
        value > 26 ? -415.85 + 32.24 * value - 0.43 * value * value : 16 * std::pow(10 * value / heat_index, exponent);
    const double day = day_length(latitude, middle_day(month));
    result[std::size_t(month)] = std::max(0.0, unadjusted) * day / 12 * days_in_month[std::size_t(month)] / 30;
  }
  return result;
}

}  // namespace

double potential_evapotranspiration(const Climate& climate, double latitude, double height) {
  double sum = 0;
  for (const double value : monthly_evapotranspiration(climate, latitude, height)) sum += value;
  return sum;
}

double yearly_runoff(const Climate& climate, double latitude, double height) {
  const MonthlyValues demand = monthly_evapotranspiration(climate, latitude, height);
  double soil = soil_capacity;
  double runoff = 0;
  double precipitation = 0;
  for (int year = 0; year <= spin_up_years; ++year) {
    runoff = 0;
    precipitation = 0;
    for (std::size_t month = 0; month < demand.size(); ++month) {
      const double excess = climate.precipitation[month] - demand[month];
      precipitation += climate.precipitation[month];
      if (excess < 0) {
        soil *= std::exp(excess / soil_capacity);
        continue;
      }
      const double filled = std::min(soil_capacity, soil + excess);
      runoff += soil + excess - filled;
      soil = filled;
    }
  }
  return std::max(runoff, least_runoff_share * precipitation) / 1000;
}

}  // namespace biotope

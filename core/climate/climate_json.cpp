#include <algorithm>
#include <cmath>
#include <string>
#include <system_error>
#include <vector>

#include "core/climate/climate.hpp"
#include "core/climate/json_reader.hpp"

namespace biotope {
namespace {

constexpr Limits temperature_limits{-90, 60};
/// Distance of the monthly minimum and maximum from the mean where a file gives none, deg C. Our choice.
constexpr double default_half_range = 5;

constexpr Limits precipitation_limits{0, 5000};
constexpr Limits cloud_limits{0, 1};

double within(double value, Limits limits) { return std::isfinite(value) ? std::clamp(value, limits.low, limits.high) : limits.low; }

/// The climate as it can be read again: where editing has pushed a value over its limit or the minimum over the mean, the nearest that fits.
Climate readable(Climate climate) {
  for (std::size_t month = 0; month < climate.temperature_mean.size(); ++month) {
    double& mean = climate.temperature_mean[month];
    mean = within(mean, temperature_limits);
    climate.temperature_min[month] = std::min(within(climate.temperature_min[month], temperature_limits), mean);
    climate.temperature_max[month] = std::max(within(climate.temperature_max[month], temperature_limits), mean);
    climate.precipitation[month] = within(climate.precipitation[month], precipitation_limits);
    climate.cloud[month] = within(climate.cloud[month], cloud_limits);
  }
  return climate;
}

Json tidy(const MonthlyValues& values) {
  Json array = Json::array();
  for (const double value : values) array.push_back(value);
  return array;
}

/// The first month in which low is above high, or -1.
int first_above(const MonthlyValues& low, const MonthlyValues& high) {
  for (std::size_t month = 0; month < low.size(); ++month) {
    if (low[month] > high[month]) return int(month);
  }
  return -1;
}

Status check_order(const Climate& climate, const std::string& where) {
  const auto refuse = [&](int month, const char* low, const char* high) {
    return fail(where + ": \"" + low + "\" must not be above \"" + high + "\", but it is in month " + std::to_string(month + 1));
  };
  if (const int month = first_above(climate.temperature_min, climate.temperature_mean); month >= 0) {
    return refuse(month, "temperature_min", "temperature_mean");
  }
  if (const int month = first_above(climate.temperature_mean, climate.temperature_max); month >= 0) {
    return refuse(month, "temperature_mean", "temperature_max");
  }
  return {};
}

}  // namespace

Result<Climate> parse_climate(std::string_view text, std::string_view origin) {
  const Result<Json> json = parse_json(text, origin);
  if (!json) return tl::unexpected(json.error());
  const std::string where(origin);
  std::string problem;
  JsonReader reader(*json, where, problem);
  Climate climate;
  reader.text("name", climate.name, Presence::required);
  const auto allowed = [](char c) { return (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9') || c == '-'; };
  if (!std::ranges::all_of(climate.name, allowed)) reader.refuse("name", "lower-case letters, digits and '-'", climate.name);
  climate.title = climate.name;
  reader.text("title", climate.title);
  reader.text("description", climate.description);
  reader.text("source", climate.source);
  reader.numbers("temperature_mean", climate.temperature_mean, temperature_limits, Presence::required);
  for (std::size_t month = 0; month < climate.temperature_mean.size(); ++month) {
    const double mean = climate.temperature_mean[month];
    climate.temperature_min[month] = std::max(mean - default_half_range, temperature_limits.low);
    climate.temperature_max[month] = std::min(mean + default_half_range, temperature_limits.high);
  }
  reader.numbers("temperature_min", climate.temperature_min, temperature_limits);
  reader.numbers("temperature_max", climate.temperature_max, temperature_limits);
  reader.numbers("precipitation", climate.precipitation, precipitation_limits, Presence::required);
  reader.numbers("cloud", climate.cloud, cloud_limits);
  reader.number("reference_height", climate.reference_height, {-500, 9000}, Presence::required);
  reader.number("lapse_rate", climate.lapse_rate, {-20, 20});
  reader.finish();
  if (!problem.empty()) return fail(problem);
  if (Status order = check_order(climate, where); !order) return tl::unexpected(order.error());
  return climate;
}

std::string climate_to_json(const Climate& edited) {
  const Climate climate = readable(edited);
  Json json;
  json["name"] = climate.name;
  if (!climate.title.empty()) json["title"] = climate.title;
  if (!climate.description.empty()) json["description"] = climate.description;
  if (!climate.source.empty()) json["source"] = climate.source;
  json["temperature_mean"] = tidy(climate.temperature_mean);
  json["temperature_min"] = tidy(climate.temperature_min);
  json["temperature_max"] = tidy(climate.temperature_max);
  json["precipitation"] = tidy(climate.precipitation);
  json["cloud"] = tidy(climate.cloud);
  json["reference_height"] = climate.reference_height;
  json["lapse_rate"] = climate.lapse_rate;
  return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

Result<std::vector<Climate>> load_climates(const std::filesystem::path& folder) {
  std::error_code problem;
  std::vector<std::filesystem::path> files;
  for (const auto& entry : std::filesystem::directory_iterator(folder, problem)) {
    if (entry.path().extension() == ".json") files.push_back(entry.path());
  }
  if (problem) return fail(folder.string() + ": this folder of climates cannot be read: " + problem.message());
  std::ranges::sort(files);
  std::vector<Climate> climates;
  for (const std::filesystem::path& file : files) {
    const Result<std::string> text = read_text_file(file);
    if (!text) return tl::unexpected(text.error());
    Result<Climate> climate = parse_climate(*text, file.filename().string());
    if (!climate) return tl::unexpected(climate.error());
    const auto same = std::ranges::find(climates, climate->name, &Climate::name);
    if (same != climates.end()) {
      return fail(file.filename().string() + ": another climate of this folder is named \"" + climate->name + "\"; names must differ");
    }
    climates.push_back(std::move(*climate));
  }
  if (climates.empty()) return fail(folder.string() + ": holds no climate (*.json)");
  std::ranges::sort(climates, {}, &Climate::name);
  return climates;
}

}  // namespace biotope

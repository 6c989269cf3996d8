#include "ui/settings.hpp"

#include <algorithm>
#include <array>
#include <cstdlib>
#include <fstream>
#include <nlohmann/json.hpp>
#include <sstream>

namespace biotope {
namespace {

using nlohmann::json;

template <class T>
void read(const json& object, const char* key, T& value) {
  const auto found = object.find(key);
  if (found == object.end()) return;
  if constexpr (std::is_same_v<T, bool>) {
    if (found->is_boolean()) value = found->get<bool>();
  } else if constexpr (std::is_arithmetic_v<T>) {
    if (found->is_number()) value = found->get<T>();
  } else {
    if (found->is_string()) value = found->get<std::string>();
  }
}

constexpr std::array<std::pair<std::string_view, float>, 5> quality_levels{
    {{"automatic", 0.5F}, {"low", 0.5F}, {"medium", 1.0F}, {"high", 2.0F}, {"ultra", 4.0F}}};

json weather_to_json(const Weather& weather) {
  return {{"cloud", weather.cloud}, {"precipitation", weather.precipitation},   {"fog", weather.fog},
          {"wind", weather.wind},   {"wind_direction", weather.wind_direction}, {"snow_cover", weather.snow_cover}};
}

Weather weather_of(const json& object) {
  Weather weather;
  read(object, "cloud", weather.cloud);
  read(object, "precipitation", weather.precipitation);
  read(object, "fog", weather.fog);
  read(object, "wind", weather.wind);
  read(object, "wind_direction", weather.wind_direction);
  read(object, "snow_cover", weather.snow_cover);
  weather.cloud = std::clamp(weather.cloud, 0.0F, 1.0F);
  weather.precipitation = std::clamp(weather.precipitation, 0.0F, 1.0F);
  weather.fog = std::clamp(weather.fog, 0.0F, 1.0F);
  weather.wind = std::clamp(weather.wind, 0.0F, 25.0F);
  weather.wind_direction = std::clamp(weather.wind_direction, 0.0F, 360.0F);
  return weather;
}

std::filesystem::path folder_of(const char* variable, const char* under_home) {
  const char* set = std::getenv(variable);
  if (set != nullptr && *set != '\0') return std::filesystem::path(set) / "biotope";
  const char* home = std::getenv("HOME");
  return std::filesystem::path(home != nullptr ? home : ".") / under_home / "biotope";
}

}  // namespace

float quality_factor(QualityLevel level) { return quality_levels[std::size_t(level)].second; }
std::string_view quality_name(QualityLevel level) { return quality_levels[std::size_t(level)].first; }

std::string settings_to_json(const Settings& settings) {
  json object;
  object["theme"] = settings.dark ? "dark" : "light";
  object["scale"] = settings.scale;
  object["window"] = {{"width", settings.window_width}, {"height", settings.window_height}, {"maximized", settings.maximized}};
  object["recent"] = settings.recent;
  object["last_folder"] = settings.last_folder;
  object["brush"] = {
      {"radius", settings.brush.radius}, {"strength", settings.brush.strength}, {"hardness", settings.brush.hardness}};
  object["first_steps_closed"] = settings.first_steps_closed;
  object["contours"] = settings.contours;
  object["overlay_opacity"] = settings.overlay_opacity;
  object["quality_level"] = quality_name(settings.quality_level);
  object["weather"] = weather_to_json(settings.weather);
  if (settings.animate) object["animate"] = *settings.animate;
  object["mini_map"] = settings.mini_map;
  object["history_megabytes"] = settings.history_megabytes;
  object["autosave_seconds"] = settings.autosave_seconds;
  object["shortcuts"] = settings.shortcuts;
  return object.dump(2);
}

namespace {

/// Calls `take` with a member that is an object; anything else is passed over.
template <class Take>
void read_object(const json& object, const char* key, const Take& take) {
  const auto found = object.find(key);
  if (found != object.end() && found->is_object()) take(*found);
}

void read_window(const json& object, Settings& settings) {
  read_object(object, "window", [&](const json& window) {
    read(window, "width", settings.window_width);
    read(window, "height", settings.window_height);
    read(window, "maximized", settings.maximized);
  });
  settings.window_width = std::clamp(settings.window_width, 640, 16384);
  settings.window_height = std::clamp(settings.window_height, 480, 16384);
  read(object, "scale", settings.scale);
  if (settings.scale != 0) settings.scale = std::clamp(settings.scale, 0.75F, 4.0F);
}

void read_recent(const json& object, Settings& settings) {
  const auto recent = object.find("recent");
  if (recent == object.end() || !recent->is_array()) return;
  for (const json& file : *recent) {
    if (file.is_string() && settings.recent.size() < most_recent_files) settings.recent.push_back(file.get<std::string>());
  }
}

void read_brush(const json& object, Brush& brush) {
  read_object(object, "brush", [&](const json& own) {
    read(own, "radius", brush.radius);
    read(own, "strength", brush.strength);
    read(own, "hardness", brush.hardness);
  });
  brush.radius = std::clamp(brush.radius, 1.0F, 1000.0F);
  brush.strength = std::clamp(brush.strength, 0.01F, 1.0F);
  brush.hardness = std::clamp(brush.hardness, 0.0F, 1.0F);
}

/// How the landscape is shown.
void read_look(const json& object, Settings& settings) {
  std::string theme = "dark";
  read(object, "theme", theme);
  settings.dark = theme != "light";
  read(object, "contours", settings.contours);
  read(object, "overlay_opacity", settings.overlay_opacity);
  settings.overlay_opacity = std::clamp(settings.overlay_opacity, 0.0F, 1.0F);
  std::string level;
  read(object, "quality_level", level);
  for (std::size_t i = 0; i < quality_levels.size(); ++i) {
    if (quality_levels[i].first == level) settings.quality_level = QualityLevel(i);
  }
  read_object(object, "weather", [&](const json& weather) { settings.weather = weather_of(weather); });
  if (const auto animate = object.find("animate"); animate != object.end() && animate->is_boolean())
    settings.animate = animate->get<bool>();
  read(object, "mini_map", settings.mini_map);
}

}  // namespace

Settings settings_from_json(std::string_view text) {
  Settings settings;
  const json object = json::parse(text, nullptr, false);
  if (!object.is_object()) return settings;
  read_window(object, settings);
  read_recent(object, settings);
  read_brush(object, settings.brush);
  read_look(object, settings);
  read(object, "last_folder", settings.last_folder);
  read(object, "first_steps_closed", settings.first_steps_closed);
  read(object, "history_megabytes", settings.history_megabytes);
  settings.history_megabytes = std::clamp(settings.history_megabytes, 64, 65536);
  read(object, "autosave_seconds", settings.autosave_seconds);
  settings.autosave_seconds = std::clamp(settings.autosave_seconds, 1.0F, 600.0F);
  read_object(object, "shortcuts", [&](const json& shortcuts) {
    for (const auto& [id, keys] : shortcuts.items()) {
      if (keys.is_string()) settings.shortcuts[id] = keys.get<std::string>();
    }
  });
  return settings;
}

std::filesystem::path config_folder() { return folder_of("XDG_CONFIG_HOME", ".config"); }
std::filesystem::path state_folder() { return folder_of("XDG_STATE_HOME", ".local/state"); }

Settings load_settings(const std::filesystem::path& file) {
  std::ifstream in(file);
  if (!in) return {};
  std::ostringstream text;
  text << in.rdbuf();
  return settings_from_json(text.str());
}

Status save_settings(const std::filesystem::path& file, const Settings& settings) {
  std::error_code error;
  std::filesystem::create_directories(file.parent_path(), error);
  const std::filesystem::path beside = file.string() + ".new";
  {
    std::ofstream out(beside);
    out << settings_to_json(settings) << '\n';
    if (!out.flush()) return fail("The settings could not be written to " + file.string() + ": is the disk full or read-only?");
  }
  std::filesystem::rename(beside, file, error);
  if (error) return fail("The settings could not be written to " + file.string() + ": " + error.message());
  return {};
}

void remember_recent(Settings& settings, const std::string& file) {
  std::erase(settings.recent, file);
  settings.recent.insert(settings.recent.begin(), file);
  if (settings.recent.size() > most_recent_files) settings.recent.resize(most_recent_files);
}

}  // namespace biotope

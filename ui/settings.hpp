#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/status.hpp"
#include "core/document/brush.hpp"
#include "render/weather.hpp"

namespace biotope {

inline constexpr std::size_t most_recent_files = 12;

/// How much of the 3D view is drawn. `automatic` is measured at start; none is less than `low`.
enum class QualityLevel : std::uint8_t { automatic, low, medium, high, ultra };
/// What multiplies distances and counts of plants at a level (LandscapeOptions::quality); `automatic` as low.
[[nodiscard]] float quality_factor(QualityLevel level);
/// "automatic", "low" ...
[[nodiscard]] std::string_view quality_name(QualityLevel level);

/// What the editor remembers from one run to the next.
struct Settings {
  bool dark = true;
  /// Size of text and controls; 0 follows the monitor.
  float scale = 0;
  int window_width = 1280;
  int window_height = 720;
  bool maximized = false;
  /// Files and samples, the newest first.
  std::vector<std::string> recent;
  std::string last_folder;
  Brush brush;
  bool first_steps_closed = false;
  bool contours = true;
  float overlay_opacity = 0.85F;
  QualityLevel quality_level = QualityLevel::automatic;  ///< of the 3D view
  Weather weather;
  /// Leaves, water and rain move; absent: where a graphics processor draws.
  std::optional<bool> animate;
  bool mini_map = true;
  int history_megabytes = 1024;  ///< memory that undo may take
  float autosave_seconds = 20;   ///< after which unsaved work is copied; with the time to write it, a crash costs little more
  /// Shortcuts that replace a command's own, by the command's id.
  std::map<std::string, std::string> shortcuts;
};

[[nodiscard]] std::string settings_to_json(const Settings& settings);
/// Reads what is there; a missing or odd value keeps its default, so that an old or damaged file never keeps the editor from
/// starting.
[[nodiscard]] Settings settings_from_json(std::string_view json);

/// $XDG_CONFIG_HOME/biotope (or ~/.config/biotope) and $XDG_STATE_HOME/biotope (or ~/.local/state/biotope).
[[nodiscard]] std::filesystem::path config_folder();
[[nodiscard]] std::filesystem::path state_folder();

/// Defaults when there is no file.
[[nodiscard]] Settings load_settings(const std::filesystem::path& file);
/// Atomic: written beside and renamed.
[[nodiscard]] Status save_settings(const std::filesystem::path& file, const Settings& settings);

/// Puts a file at the head of the recent ones, without doubles.
void remember_recent(Settings& settings, const std::string& file);

}  // namespace biotope

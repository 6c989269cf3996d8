#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/status.hpp"
#include "render/camera.hpp"

namespace biotope {

/// A view the camera has at a moment of its path.
struct CameraKey {
  double seconds = 0;
  Camera camera;
};

/// A way of the camera through the landscape, with the day passing or standing still.
struct CameraPath {
  /// Seconds ascending.
  std::vector<CameraKey> keys;
  /// Hour at the first and at the last key, 0..24 (the last may be smaller: the day then runs over midnight); absent: the clock
  /// stands.
  std::optional<std::array<double, 2>> hours;
};

/// Longest path, s, and most keys that a file may have. Our choice.
inline constexpr double longest_path = 3600;
inline constexpr std::size_t most_path_keys = 1000;

/// From the first key to the last, s; 0 with fewer than two keys.
[[nodiscard]] double path_seconds(const CameraPath& path);
/// The camera at a moment counted from the first key: through every key's view, smoothly (cubic through the keys, whose speed at
/// a key is that between its neighbours), turning the shorter way. Still before the first and after the last.
[[nodiscard]] Camera camera_on_path(const CameraPath& path, double seconds);
/// Hour of the day at a moment; `standing` where the clock stands.
[[nodiscard]] double hour_on_path(const CameraPath& path, double seconds, double standing);
/// Pictures of the whole path at a rate, both ends included; 0 with fewer than two keys.
[[nodiscard]] int frame_count(const CameraPath& path, double frames_a_second);

/// Adds a key in its order; one at the same moment (to a hundredth of a second) is replaced.
void set_key(CameraPath& path, const CameraKey& key);

/// {"keys": [{"seconds": 0, "x": ..., "y": ..., "z": ..., "heading": ..., "pitch": ..., "field": 50}, ...], "hours": [6, 20]}:
/// metres from the south-west corner and above the sea, degrees.
[[nodiscard]] std::string path_to_text(const CameraPath& path);
/// Reads and checks a path of at least two keys; messages begin with `origin`.
[[nodiscard]] Result<CameraPath> parse_path_text(std::string_view text, const std::string& origin);

}  // namespace biotope

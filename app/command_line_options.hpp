#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "core/base/status.hpp"
#include "core/exchange/dem_import.hpp"
#include "render/camera.hpp"
#include "render/weather.hpp"

namespace biotope {

/// Side of a cell that --cell-size may give, metres (our choice: beyond these no terrain is meant).
inline constexpr double smallest_cell = 0.001;
inline constexpr double largest_cell = 100000;

/// What every command that computes may be given. Empty members: not asked for.
struct LandscapeRequest {
  /// A scene, a DEM or "sample:NAME".
  std::string input = "sample:valley";
  DemImportOptions import;
  std::string climate;
  std::string species_file;
  std::string environment_folder;
  std::optional<std::uint64_t> seed;
  int threads = 0;  ///< 0: as many as the machine has
  bool quiet = false;
};

/// `WxH:TYPE[:big][:header=BYTES]`, for example `1024x1024:uint16`.
[[nodiscard]] Result<RawLayout> parse_raw_layout(std::string_view text);

/// A seed: a whole number from 0 to 18446744073709551615, in decimal.
[[nodiscard]] Result<std::uint64_t> parse_seed(std::string_view text);

/// A whole number in `lowest..highest`.
[[nodiscard]] Result<int> parse_whole_number(std::string_view text, int lowest, int highest);

/// A finite number in `lowest..highest`.
[[nodiscard]] Result<double> parse_number(std::string_view text, double lowest, double highest);

/// `X,Y,WIDTH,HEIGHT` in cells of the file.
[[nodiscard]] Result<Rect> parse_crop(std::string_view text);

struct PictureSize {
  int width = 1280;
  int height = 720;
};
/// `WIDTHxHEIGHT` in pixels, 16 to 16384 each.
[[nodiscard]] Result<PictureSize> parse_picture_size(std::string_view text);

/// A point of view as it is asked for.
struct ViewRequest {
  Camera camera;
  /// The camera's height is metres above the ground instead of above the sea.
  bool above_ground = false;
};
/// `x,y,z,heading,pitch`: metres from the south-west corner, z above sea level or with a + before it above the ground, degrees
/// clockwise from north and above the horizon.
[[nodiscard]] Result<ViewRequest> parse_camera(std::string_view text);
/// The name of a weather.
[[nodiscard]] Result<Weather> parse_weather(std::string_view text);

}  // namespace biotope

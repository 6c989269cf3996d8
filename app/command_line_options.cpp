#include "app/command_line_options.hpp"

#include <charconv>
#include <cmath>
#include <cstdio>
#include <vector>

namespace biotope {
namespace {

std::vector<std::string_view> split(std::string_view text, char separator) {
  std::vector<std::string_view> parts;
  while (true) {
    const std::size_t at = text.find(separator);
    parts.push_back(text.substr(0, at));
    if (at == std::string_view::npos) return parts;
    text.remove_prefix(at + 1);
  }
}

template <class T>
std::optional<T> number(std::string_view text) {
  T value{};
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || end != text.data() + text.size()) return std::nullopt;
  return value;
}

std::optional<PictureSize> two_sides(std::string_view text) {
  const auto sides = split(text, 'x');
  if (sides.size() != 2) return std::nullopt;
  const auto width = number<int>(sides[0]);
  const auto height = number<int>(sides[1]);
  if (!width || !height) return std::nullopt;
  return PictureSize{*width, *height};
}

tl::unexpected<Error> wrong(std::string_view text, const std::string& expected) {
  return fail("'" + std::string(text) + "': expected " + expected + ".");
}

}  // namespace

Result<RawLayout> parse_raw_layout(std::string_view text) {
  const std::string expected = "WIDTHxHEIGHT:TYPE[:big][:header=BYTES], for example 1024x1024:uint16";
  const auto parts = split(text, ':');
  const auto sides = two_sides(parts[0]);
  if (parts.size() < 2 || !sides) return wrong(text, expected);
  RawLayout layout;
  layout.width = sides->width;
  layout.height = sides->height;
  layout.sample_type = parts[1];
  for (std::size_t i = 2; i < parts.size(); ++i) {
    constexpr std::string_view header = "header=";
    if (parts[i] == "big") {
      layout.big_endian = true;
    } else if (parts[i] == "little") {
      layout.big_endian = false;
    } else if (parts[i].starts_with(header)) {
      const auto bytes = number<std::size_t>(parts[i].substr(header.size()));
      if (!bytes) return wrong(text, expected);
      layout.header_bytes = *bytes;
    } else {
      return wrong(text, expected);
    }
  }
  return layout;
}

Result<std::uint64_t> parse_seed(std::string_view text) {
  if (const auto seed = number<std::uint64_t>(text)) return *seed;
  return wrong(text, "a whole number from 0 to 18446744073709551615");
}

Result<int> parse_whole_number(std::string_view text, int lowest, int highest) {
  const auto value = number<int>(text);
  if (value && *value >= lowest && *value <= highest) return *value;
  return wrong(text, "a whole number from " + std::to_string(lowest) + " to " + std::to_string(highest));
}

Result<double> parse_number(std::string_view text, double lowest, double highest) {
  const auto value = number<double>(text);
  if (value && std::isfinite(*value) && *value >= lowest && *value <= highest) return *value;
  char range[64];
  std::snprintf(range, sizeof range, "a number from %g to %g", lowest, highest);
  return wrong(text, range);
}

Result<Rect> parse_crop(std::string_view text) {
  const auto parts = split(text, ',');
  std::vector<int> values;
  for (const std::string_view part : parts) {
    if (const auto value = number<int>(part)) values.push_back(*value);
  }
  const bool sound = parts.size() == 4 && values.size() == 4 && values[0] >= 0 && values[1] >= 0 && values[2] >= 2 &&
                     values[3] >= 2 && values[0] <= (1 << 28) && values[1] <= (1 << 28) && values[2] <= (1 << 28) &&
                     values[3] <= (1 << 28);
  if (!sound) return wrong(text, "X,Y,WIDTH,HEIGHT in cells of the file, at least 2 x 2");
  return Rect{values[0], values[1], values[0] + values[2], values[1] + values[3]};
}

Result<PictureSize> parse_picture_size(std::string_view text) {
  const auto size = two_sides(text);
  const auto sound = [](int side) { return side >= 16 && side <= 16384; };
  if (!size || !sound(size->width) || !sound(size->height)) {
    return wrong(text, "WIDTHxHEIGHT in pixels, 16 to 16384 each, for example 1280x720");
  }
  return *size;
}

Result<ViewRequest> parse_camera(std::string_view text) {
  const auto parts = split(text, ',');
  const bool above_ground = parts.size() > 2 && parts[2].starts_with('+');
  std::vector<double> values;
  for (const std::string_view part : parts) {
    const auto value = number<double>(above_ground && values.size() == 2 ? part.substr(1) : part);
    if (value && std::isfinite(*value)) values.push_back(*value);
  }
  if (parts.size() != 5 || values.size() != 5) {
    return wrong(text, "x,y,z,heading,pitch: metres from the south-west corner and above the sea (+z: above the ground), degrees");
  }
  Camera camera;
  camera.position = {values[0], values[1], values[2]};
  camera.heading = float(values[3]);
  camera.pitch = float(values[4]);
  return ViewRequest{camera, above_ground};
}

Result<Weather> parse_weather(std::string_view text) {
  if (const auto weather = weather_named(text)) return *weather;
  return wrong(text, "clear, fair, overcast, rain, fog or storm");
}

}  // namespace biotope

#pragma once

#include <cstdint>
#include <filesystem>
#include <vector>

#include "core/base/status.hpp"

namespace biotope {

/// Pixels as RGBA bytes, top row first.
struct Image {
  int width = 0;
  int height = 0;
  std::vector<std::uint8_t> rgba;
};

/// Writes a PNG atomically.
[[nodiscard]] Status write_png(const std::filesystem::path& file, const Image& image);
[[nodiscard]] Result<Image> read_png(const std::filesystem::path& file);

}  // namespace biotope

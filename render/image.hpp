#pragma once

#include <cstdint>
#include <filesystem>
#include <vector>

#include "core/base/status.hpp"
#include "core/base/task_context.hpp"

namespace biotope {

/// Pixels as RGBA bytes, top row first.
struct Image {
  int width = 0;
  int height = 0;
  std::vector<std::uint8_t> rgba;
};

/// Writes a PNG atomically; nothing of it where `task` is stopped while the picture is encoded.
[[nodiscard]] Status write_png(const std::filesystem::path& file, const Image& image, const TaskContext& task = {});
[[nodiscard]] Result<Image> read_png(const std::filesystem::path& file);

}  // namespace biotope

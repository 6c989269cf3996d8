#pragma once

#include <filesystem>

#include "core/base/status.hpp"
#include "core/base/task_context.hpp"

namespace biotope {

/// Where the pictures of a video lie while it is made: beside it.
[[nodiscard]] std::filesystem::path frames_folder(const std::filesystem::path& video);

/// Makes an H.264 video of frame-00001.png ... in a folder by ffmpeg; the file is there whole or not at all. Stops ffmpeg when
/// asked to stop. A failure names what ffmpeg said last.
[[nodiscard]] Status encode_video(const std::filesystem::path& frames, double frames_a_second, const std::filesystem::path& video,
                                  const TaskContext& context = {});

}  // namespace biotope

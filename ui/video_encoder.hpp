#pragma once

#include <filesystem>
#include <memory>
#include <utility>

#include "core/base/status.hpp"
#include "core/base/task_context.hpp"

namespace biotope {

/// A fresh folder beside a video, where its pictures lie while it is made; it goes with all that is in it when its last owner
/// does.
class FramesFolder {
 public:
  [[nodiscard]] static Result<std::shared_ptr<const FramesFolder>> make(const std::filesystem::path& video);
  ~FramesFolder();
  FramesFolder(const FramesFolder&) = delete;
  FramesFolder& operator=(const FramesFolder&) = delete;
  [[nodiscard]] const std::filesystem::path& path() const { return path_; }

 private:
  explicit FramesFolder(std::filesystem::path path) : path_(std::move(path)) {}
  std::filesystem::path path_;
};

/// Makes an H.264 video of frame-00001.png ... in a folder by ffmpeg; the file is there whole or not at all. Stops ffmpeg when
/// asked to stop. A failure names what ffmpeg said last.
[[nodiscard]] Status encode_video(const std::filesystem::path& frames, double frames_a_second, const std::filesystem::path& video,
                                  const TaskContext& context = {});

}  // namespace biotope

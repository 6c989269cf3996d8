#pragma once

#include <filesystem>
#include <optional>

#include "ui/editor_state.hpp"

namespace biotope {

inline constexpr double autosave_seconds = 30;

/// Writes unsaved work beside the person's own files, in the background, and takes the copy away once it is saved or given up.
class Autosave {
 public:
  /// Copies go to `folder` as recovery-<process>.biotope.
  explicit Autosave(const std::filesystem::path& folder);
  ~Autosave();
  Autosave(const Autosave&) = delete;
  Autosave& operator=(const Autosave&) = delete;

  /// Called every frame with the time in seconds.
  void tick(EditorState& state, double now);
  [[nodiscard]] const std::filesystem::path& file() const { return file_; }

 private:
  void drop();
  std::filesystem::path file_;
  BackgroundTask<bool> writing_;
  std::uint64_t written_edits_ = 0;
  double last_ = 0;
  bool told_ = false;
};

/// The newest recovery file in `folder` whose process no longer runs; nothing when all is well.
[[nodiscard]] std::optional<std::filesystem::path> find_abandoned(const std::filesystem::path& folder);

}  // namespace biotope

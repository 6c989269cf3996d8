#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <vector>

#include "core/exchange/scene_file.hpp"
#include "ui/editor_state.hpp"

namespace biotope {

/// Writes unsaved work beside the person's own files, in the background and in the middle of strokes too, and takes the copy away
/// once the work is saved or given up: Settings::autosave_seconds after it began to differ from the last copy. Offers what
/// earlier sessions left.
class Autosave {
 public:
  /// Copies go to `folder` as recovery-<process>-<its start>.biotope.
  explicit Autosave(const std::filesystem::path& folder);
  ~Autosave();
  Autosave(const Autosave&) = delete;
  Autosave& operator=(const Autosave&) = delete;

  /// Called every frame with the time in seconds.
  void tick(EditorState& state, double now);
  [[nodiscard]] const std::filesystem::path& file() const { return file_; }

 private:
  void finish_writing(EditorState& state);
  void retire_rescued(EditorState& state) const;
  void start_writing(const EditorState& state);
  void drop();

  std::filesystem::path file_;
  BackgroundTask<bool> writing_;
  /// Packed rasters of the last copy: what did not change is not packed again. Used by the writing thread alone.
  std::shared_ptr<SceneCache> cache_ = std::make_shared<SceneCache>();
  std::uint64_t written_edits_ = 0;
  /// The last copy is of the middle of a stroke.
  bool written_stroking_ = false;
  bool there_ = false;
  std::optional<double> due_;
  bool told_ = false;
};

/// Recovery files in `folder` whose process no longer runs, the newest first.
[[nodiscard]] std::vector<std::filesystem::path> abandoned_files(const std::filesystem::path& folder);
/// The newest of them; nothing when all is well.
[[nodiscard]] std::optional<std::filesystem::path> find_abandoned(const std::filesystem::path& folder);

}  // namespace biotope

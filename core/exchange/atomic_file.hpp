#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "core/base/status.hpp"

namespace biotope {

/// A name beside `file` that nothing else uses; removed again unless `commit` has moved it into place. So a file is there
/// whole or not at all, whatever happens while it is written.
class AtomicFile {
 public:
  explicit AtomicFile(std::filesystem::path file);
  ~AtomicFile();
  AtomicFile(const AtomicFile&) = delete;
  AtomicFile& operator=(const AtomicFile&) = delete;

  /// Where to write.
  [[nodiscard]] const std::filesystem::path& temporary() const { return temporary_; }
  /// Moves the finished temporary file over the real name; with `flush`, after the disk has it.
  [[nodiscard]] Status commit(bool flush = false);

 private:
  std::filesystem::path file_;
  std::filesystem::path temporary_;
  bool committed_ = false;
};

/// Writes text atomically.
[[nodiscard]] Status write_text(const std::filesystem::path& file, std::string_view text);

/// Reads a whole text file of at most `most_bytes`.
[[nodiscard]] Result<std::string> read_text(const std::filesystem::path& file, std::size_t most_bytes);

}  // namespace biotope

#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <memory>
#include <string>
#include <string_view>

#include "core/base/status.hpp"

namespace biotope {

/// Files of an archive by their name in it.
using ArchiveEntries = std::map<std::string, std::string>;
/// The same without owning the bytes.
using ArchiveViews = std::map<std::string, std::string_view>;

/// Writes a ZIP atomically and flushed to the disk; the same entries give the same bytes. `*.tif` are stored (they are compressed
/// already).
[[nodiscard]] Status write_archive_views(const std::filesystem::path& file, const ArchiveViews& entries);
[[nodiscard]] Status write_archive(const std::filesystem::path& file, const ArchiveEntries& entries);

/// A ZIP open for reading. Nothing is ever unpacked onto the disk.
class ArchiveReader {
 public:
  /// An Error unless the file is a whole ZIP whose names are UTF-8, stay inside it and differ, and which does not claim to unpack
  /// to much more than a scene of its size can.
  [[nodiscard]] static Result<ArchiveReader> open(const std::filesystem::path& file);
  ArchiveReader(ArchiveReader&&) noexcept;
  ArchiveReader& operator=(ArchiveReader&&) noexcept;
  ~ArchiveReader();

  /// An entry's bytes, checked against the ZIP's checksum; an Error when it is not there, damaged, or unpacks to more than
  /// `most_bytes`.
  [[nodiscard]] Result<std::string> read(const std::string& name, std::uint64_t most_bytes) const;
  /// The same of an entry that is not worth less for being damaged: what of it could be unpacked, and whether that is all of it
  /// and as it was written.
  struct Part {
    std::string bytes;
    bool whole = false;
  };
  [[nodiscard]] Result<Part> read_part(const std::string& name, std::uint64_t most_bytes) const;

 private:
  struct State;
  explicit ArchiveReader(std::unique_ptr<State> state);
  std::unique_ptr<State> state_;
};

/// FNV-1a over the bytes, 16 hexadecimal digits: tells whether entries of a scene belong together.
[[nodiscard]] std::string checksum(std::string_view bytes);

}  // namespace biotope

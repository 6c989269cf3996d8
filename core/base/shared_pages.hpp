#pragma once

#include <cstddef>
#include <memory>
#include <utility>

namespace biotope {

/// A block of zeroed memory that can be forked: a fork shows what the block held and shares its pages with it until they are
/// written to, so that versions of a large raster that differ here and there take memory, and time to make, only for where they
/// differ.
///
/// What a fork of a fork shows is the first block, without what was written to the fork between: whoever forks knows where that
/// was and copies it. A block must not be written to any more once it was forked.
class SharedPages {
 public:
  SharedPages() = default;
  ~SharedPages();
  SharedPages(SharedPages&& other) noexcept;
  SharedPages& operator=(SharedPages&& other) noexcept;

  /// A new block; an empty one where the system cannot do this (then ordinary memory has to serve).
  [[nodiscard]] static SharedPages zeroed(std::size_t bytes);
  /// A block that shows the first block; empty where the system has no room for it.
  [[nodiscard]] SharedPages fork() const;

  [[nodiscard]] explicit operator bool() const { return data_ != nullptr; }
  [[nodiscard]] void* data() const { return data_; }

 private:
  struct File;
  SharedPages(std::shared_ptr<const File> file, void* data) : file_(std::move(file)), data_(data) {}

  std::shared_ptr<const File> file_;
  void* data_ = nullptr;
};

}  // namespace biotope

#include "core/base/shared_pages.hpp"

#include <utility>

#if defined(__linux__)
#include <sys/mman.h>
#include <unistd.h>
#endif

namespace biotope {

#if defined(__linux__)

/// Memory without a name in any folder. It lives as long as something maps it or holds its number.
struct SharedPages::File {
  int number;
  std::size_t bytes;
  File(int own_number, std::size_t own_bytes) : number(own_number), bytes(own_bytes) {}
  File(const File&) = delete;
  File& operator=(const File&) = delete;
  ~File() { close(number); }
};

SharedPages::~SharedPages() {
  if (data_ != nullptr) munmap(data_, file_->bytes);
}

SharedPages SharedPages::zeroed(std::size_t bytes) {
  if (bytes == 0) return {};
  const int number = memfd_create("raster", MFD_CLOEXEC);
  if (number < 0) return {};
  auto file = std::make_shared<const File>(number, bytes);
  if (ftruncate(number, off_t(bytes)) != 0) return {};
  void* data = mmap(nullptr, bytes, PROT_READ | PROT_WRITE, MAP_SHARED, number, 0);
  if (data == MAP_FAILED) return {};
  return {std::move(file), data};
}

SharedPages SharedPages::fork() const {
  if (data_ == nullptr) return {};
  void* data = mmap(nullptr, file_->bytes, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_NORESERVE, file_->number, 0);
  if (data == MAP_FAILED) return {};
  return {file_, data};
}

#else

struct SharedPages::File {};
SharedPages::~SharedPages() = default;
SharedPages SharedPages::zeroed(std::size_t) { return {}; }
SharedPages SharedPages::fork() const { return {}; }

#endif

SharedPages::SharedPages(SharedPages&& other) noexcept
    : file_(std::move(other.file_)), data_(std::exchange(other.data_, nullptr)) {}

SharedPages& SharedPages::operator=(SharedPages&& other) noexcept {
  std::swap(file_, other.file_);
  std::swap(data_, other.data_);
  return *this;
}

}  // namespace biotope

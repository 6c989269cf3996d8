#include "core/exchange/atomic_file.hpp"

#include <fcntl.h>
#include <unistd.h>

#include <atomic>
#include <cerrno>
#include <cstring>
#include <fstream>

namespace biotope {
namespace {

std::filesystem::path temporary_beside(const std::filesystem::path& file) {
  static std::atomic<unsigned> count{0};
  const std::string suffix = std::to_string(::getpid()) + "-" + std::to_string(count.fetch_add(1));
  return file.parent_path() / ("." + file.stem().string() + "-" + suffix + ".tmp" + file.extension().string());
}

Status flush_to_disk(const std::filesystem::path& path) {
  const int descriptor = ::open(path.c_str(), O_RDONLY | O_CLOEXEC);
  if (descriptor < 0) return fail(path.string() + ": cannot be opened again (" + std::strerror(errno) + ").");
  const bool flushed = ::fsync(descriptor) == 0;
  const int error = errno;
  ::close(descriptor);
  if (!flushed) return fail(path.string() + ": cannot be written to the disk (" + std::strerror(error) + ").");
  return {};
}

/// What the name stands for: a link stays, the file behind it is replaced.
std::filesystem::path behind_links(std::filesystem::path file) {
  std::error_code error;
  if (!std::filesystem::is_symlink(file, error)) return file;
  auto target = std::filesystem::weakly_canonical(file, error);
  return error ? file : target;
}

}  // namespace

AtomicFile::AtomicFile(std::filesystem::path file) : file_(behind_links(std::move(file))), temporary_(temporary_beside(file_)) {}

AtomicFile::~AtomicFile() {
  if (committed_) return;
  std::error_code ignored;
  std::filesystem::remove(temporary_, ignored);
}

Status AtomicFile::commit(bool flush) {
  if (flush) {
    if (const Status flushed = flush_to_disk(temporary_); !flushed) return flushed;
  }
  std::error_code error;
  // Who may read and write the file stays as it was; where that cannot be kept, the work is worth more.
  if (const auto old = std::filesystem::status(file_, error); !error && std::filesystem::is_regular_file(old)) {
    std::filesystem::permissions(temporary_, old.permissions(), error);
  }
  std::filesystem::rename(temporary_, file_, error);
  if (error) return fail(file_.string() + ": cannot be put in place (" + error.message() + ").");
  committed_ = true;
  if (!flush) return {};
  const auto folder = file_.parent_path();
  return flush_to_disk(folder.empty() ? std::filesystem::path(".") : folder);
}

Status write_text(const std::filesystem::path& file, std::string_view text) {
  AtomicFile target(file);
  std::ofstream stream(target.temporary(), std::ios::binary);
  stream.write(text.data(), std::streamsize(text.size()));
  stream.close();
  if (!stream) {
    return fail(file.string() + ": cannot be written. Is the folder there and writable, and is there space on the disk?");
  }
  return target.commit();
}

Result<std::string> read_text(const std::filesystem::path& file, std::size_t most_bytes) {
  std::ifstream stream(file, std::ios::binary);
  if (!stream) return fail(file.string() + ": cannot be read.");
  std::error_code error;
  const auto bytes = std::filesystem::file_size(file, error);
  if (error || bytes > most_bytes) return fail(file.string() + ": is too large for what it should be.");
  std::string text(std::size_t(bytes), '\0');
  if (!stream.read(text.data(), std::streamsize(text.size()))) return fail(file.string() + ": cannot be read to its end.");
  return text;
}

}  // namespace biotope

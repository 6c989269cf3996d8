#include "core/exchange/scene_archive.hpp"

#include <zip.h>

#include <cstdio>

#include "core/exchange/atomic_file.hpp"
#include "core/exchange/height_source.hpp"

namespace biotope {
namespace {

/// More entries than any scene has: one for each of thousands of layers.
constexpr zip_int64_t most_entries = 10000;
/// 1 January 1980, the first day a ZIP knows: a scene's bytes do not tell when it was saved.
constexpr zip_uint16_t first_date = 0x21;

std::string message_of(int code) {
  zip_error_t error;
  zip_error_init_with_code(&error, code);
  std::string text = zip_error_strerror(&error);
  zip_error_fini(&error);
  return text;
}

bool stays_inside(const std::string& name) {
  if (name.empty() || name.front() == '/') return false;
  if (name.find('\\') != std::string::npos || name.find(':') != std::string::npos) return false;
  for (std::size_t at = 0; at <= name.size();) {
    const std::size_t end = std::min(name.find('/', at), name.size());
    if (name.compare(at, end - at, "..") == 0) return false;
    at = end + 1;
  }
  return true;
}

Status add_entry(zip_t* archive, const std::string& name, const std::string& bytes) {
  zip_source_t* source = zip_source_buffer(archive, bytes.data(), bytes.size(), 0);
  const zip_int64_t index = source == nullptr ? -1 : zip_file_add(archive, name.c_str(), source, ZIP_FL_ENC_UTF_8);
  if (index < 0) {
    if (source != nullptr) zip_source_free(source);
    return fail(name + " cannot be added: " + zip_strerror(archive));
  }
  const bool packed = name.ends_with(".tif");
  zip_set_file_compression(archive, zip_uint64_t(index), packed ? ZIP_CM_STORE : ZIP_CM_DEFLATE, 0);
  zip_file_set_dostime(archive, zip_uint64_t(index), 0, first_date, 0);
  return {};
}

}  // namespace

Status write_archive(const std::filesystem::path& file, const ArchiveEntries& entries) {
  AtomicFile target(file);
  int code = 0;
  zip_t* archive = zip_open(target.temporary().c_str(), ZIP_CREATE | ZIP_TRUNCATE, &code);
  if (archive == nullptr) return fail(file.string() + ": cannot be written (" + message_of(code) + ").");
  for (const auto& [name, bytes] : entries) {
    if (const Status added = add_entry(archive, name, bytes); !added) {
      zip_discard(archive);
      return fail(file.string() + ": cannot be written (" + added.error().message + ").");
    }
  }
  if (zip_close(archive) != 0) {
    const std::string why = zip_strerror(archive);
    zip_discard(archive);
    return fail(file.string() + ": cannot be written (" + why + "). Is the folder there and writable, and is there "
                "space on the disk?");
  }
  return target.commit(true);
}

struct ArchiveReader::State {
  std::filesystem::path file;
  zip_t* archive = nullptr;
  ~State() {
    if (archive != nullptr) zip_discard(archive);
  }
};

ArchiveReader::ArchiveReader(std::unique_ptr<State> state) : state_(std::move(state)) {}
ArchiveReader::ArchiveReader(ArchiveReader&&) noexcept = default;
ArchiveReader& ArchiveReader::operator=(ArchiveReader&&) noexcept = default;
ArchiveReader::~ArchiveReader() = default;

Result<ArchiveReader> ArchiveReader::open(const std::filesystem::path& file) {
  if (const Status readable = check_readable(file); !readable) return tl::unexpected(readable.error());
  auto state = std::make_unique<State>();
  state->file = file;
  int code = 0;
  state->archive = zip_open(file.c_str(), ZIP_RDONLY | ZIP_CHECKCONS, &code);
  if (state->archive == nullptr) {
    return fail(file.string() + ": is no scene, or is damaged or cut short (" + message_of(code) + ").");
  }
  const zip_int64_t count = zip_get_num_entries(state->archive, 0);
  if (count > most_entries) return fail(file.string() + ": has more entries than a scene can have.");
  for (zip_int64_t i = 0; i < count; ++i) {
    const char* name = zip_get_name(state->archive, zip_uint64_t(i), 0);
    if (name == nullptr || !stays_inside(name)) {
      return fail(file.string() + ": holds the path '" + (name == nullptr ? "" : name) +
                  "', which leads out of the scene; it is not opened.");
    }
  }
  return ArchiveReader(std::move(state));
}

Result<std::string> ArchiveReader::read(const std::string& name, std::uint64_t most_bytes) const {
  const std::string what = state_->file.string() + ": " + name;
  zip_stat_t stat;
  zip_stat_init(&stat);
  if (zip_stat(state_->archive, name.c_str(), 0, &stat) != 0 || (stat.valid & ZIP_STAT_SIZE) == 0) {
    return fail(what + " is missing from the scene.");
  }
  if (stat.size > most_bytes) {
    return fail(what + " says it unpacks to " + std::to_string(stat.size) + " bytes, more than it can have (" +
                std::to_string(most_bytes) + ").");
  }
  zip_file_t* entry = zip_fopen_index(state_->archive, stat.index, 0);
  if (entry == nullptr) return fail(what + " cannot be opened (" + zip_strerror(state_->archive) + ").");
  std::string bytes(std::size_t(stat.size), '\0');
  zip_uint64_t done = 0;
  zip_int64_t read = 1;
  while (done < stat.size && read > 0) {
    read = zip_fread(entry, bytes.data() + done, stat.size - done);
    if (read > 0) done += zip_uint64_t(read);
  }
  // Reading past the end is what makes libzip compare the checksum.
  char beyond = 0;
  const bool whole = done == stat.size && zip_fread(entry, &beyond, 1) == 0;
  const bool closed = zip_fclose(entry) == 0;
  if (!whole || !closed) return fail(what + " is damaged: its checksum is wrong or bytes are missing.");
  return bytes;
}

std::string checksum(const std::string& bytes) {
  std::uint64_t hash = 0xcbf29ce484222325ULL;
  for (const char byte : bytes) hash = (hash ^ std::uint64_t(static_cast<unsigned char>(byte))) * 0x100000001b3ULL;
  char text[17];
  std::snprintf(text, sizeof text, "%016llx", static_cast<unsigned long long>(hash));
  return text;
}

}  // namespace biotope

#include "core/exchange/scene_archive.hpp"

#include <zip.h>

#include <algorithm>
#include <cstdio>
#include <set>

#include "core/exchange/atomic_file.hpp"
#include "core/exchange/height_source.hpp"

namespace biotope {
namespace {

/// More entries than any scene has: one for each of thousands of layers.
constexpr zip_int64_t most_entries = 10000;
/// 1 January 1980, the first day a ZIP knows: a scene's bytes do not tell when it was saved.
constexpr zip_uint16_t first_date = 0x21;
/// Taken for an entry before its first byte has arrived.
constexpr std::size_t first_bytes = std::size_t(1) << 20;

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

/// Well-formed UTF-8 without control characters (RFC 3629: no overlong forms, no surrogates).
bool is_plain_text(std::string_view name) {
  const auto byte = [&](std::size_t at) { return at < name.size() ? unsigned(static_cast<unsigned char>(name[at])) : 0U; };
  for (std::size_t at = 0; at < name.size();) {
    const unsigned first = byte(at);
    const int more = first < 0x80                    ? 0
                     : first >= 0xc2 && first < 0xe0 ? 1
                     : first >= 0xe0 && first < 0xf0 ? 2
                     : first >= 0xf0 && first < 0xf5 ? 3
                                                     : -1;
    if (more < 0 || first < 0x20 || first == 0x7f) return false;
    for (int i = 1; i <= more; ++i) {
      if ((byte(at + std::size_t(i)) & 0xc0) != 0x80) return false;
    }
    const unsigned second = byte(at + 1);
    const bool overlong = (first == 0xe0 && second < 0xa0) || (first == 0xf0 && second < 0x90);
    const bool surrogate_or_beyond = (first == 0xed && second >= 0xa0) || (first == 0xf4 && second >= 0x90);
    if (overlong || surrogate_or_beyond) return false;
    at += std::size_t(more) + 1;
  }
  return true;
}

/// Unpacks to more than this for its size: no scene, whose rasters are stored and whose JSON packs at most about 1 : 20. Our
/// choice.
constexpr std::uint64_t most_unpacked = std::uint64_t(64) << 20;
constexpr std::uint64_t most_unpacked_for_each_byte = 50;

/// Whether the archive's list of contents is one that a scene can have.
Status check_contents(zip_t* archive, const std::filesystem::path& file) {
  const zip_int64_t count = zip_get_num_entries(archive, 0);
  if (count > most_entries) return fail(file.string() + ": has more entries than a scene can have.");
  std::error_code ignored;
  const std::uint64_t most = most_unpacked + most_unpacked_for_each_byte * std::filesystem::file_size(file, ignored);
  std::uint64_t unpacked = 0;
  std::set<std::string> names;
  for (zip_int64_t i = 0; i < count; ++i) {
    const char* name = zip_get_name(archive, zip_uint64_t(i), ZIP_FL_ENC_RAW);
    if (name == nullptr || !is_plain_text(name)) return fail(file.string() + ": an entry's name is not UTF-8; it is not opened.");
    if (!stays_inside(name)) {
      return fail(file.string() + ": holds the path '" + name + "', which leads out of the scene; it is not opened.");
    }
    if (!names.insert(name).second) return fail(file.string() + ": holds '" + name + "' twice; it is not opened.");
    zip_stat_t stat;
    zip_stat_init(&stat);
    if (zip_stat_index(archive, zip_uint64_t(i), 0, &stat) != 0 || (stat.valid & ZIP_STAT_SIZE) == 0) {
      return fail(file.string() + ": " + name + " has no size; the file is damaged.");
    }
    unpacked += std::min<std::uint64_t>(stat.size, most + 1);
    if (unpacked > most) {
      return fail(file.string() + ": says it unpacks to more than " + std::to_string(most) +
                  " bytes, more than a scene of its size can; it is not opened.");
    }
  }
  return {};
}

Status add_entry(zip_t* archive, const std::string& name, std::string_view bytes) {
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

/// Text of a scene packs to a tenth or so; what is repeated without end to a thousandth. Our choice.
constexpr zip_uint64_t most_ratio = 250;
constexpr zip_uint64_t least_bomb_bytes = zip_uint64_t(1) << 20;

}  // namespace

Status write_archive(const std::filesystem::path& file, const ArchiveEntries& entries) {
  return write_archive_views(file, ArchiveViews(entries.begin(), entries.end()));
}

Status write_archive_views(const std::filesystem::path& file, const ArchiveViews& entries) {
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
    return fail(file.string() + ": cannot be written (" + why +
                "). Is the folder there and writable, and is there "
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
  if (state->archive == nullptr && code == ZIP_ER_EXISTS)
    return fail(file.string() + ": holds one name twice; it is not opened.");
  if (state->archive == nullptr) {
    return fail(file.string() + ": is no scene, or is damaged or cut short (" + message_of(code) + ").");
  }
  if (const Status contents = check_contents(state->archive, file); !contents) return tl::unexpected(contents.error());
  return ArchiveReader(std::move(state));
}

Result<std::string> ArchiveReader::read(const std::string& name, std::uint64_t most_bytes) const {
  auto part = read_part(name, most_bytes);
  if (!part) return tl::unexpected(part.error());
  if (!part->whole) {
    return fail(state_->file.string() + ": " + name + " is damaged: its checksum is wrong or bytes are missing.");
  }
  return std::move(part->bytes);
}

Result<ArchiveReader::Part> ArchiveReader::read_part(const std::string& name, std::uint64_t most_bytes) const {
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
  const bool knows_packed = (stat.valid & ZIP_STAT_COMP_SIZE) != 0;
  if (knows_packed && stat.size > least_bomb_bytes && stat.size / most_ratio > stat.comp_size) {
    return fail(what + " unpacks to " + std::to_string(stat.size / std::max<zip_uint64_t>(stat.comp_size, 1)) +
                " times its size (" + std::to_string(stat.size) +
                " bytes), which no scene does: it looks like a ZIP bomb and "
                "is not opened.");
  }
  zip_file_t* entry = zip_fopen_index(state_->archive, stat.index, 0);
  if (entry == nullptr) return fail(what + " cannot be opened (" + zip_strerror(state_->archive) + ").");
  // Memory is taken as bytes arrive, not as the list of contents claims.
  std::string bytes;
  std::size_t done = 0;
  zip_int64_t read = 1;
  while (done < stat.size && read > 0) {
    if (done == bytes.size()) bytes.resize(std::min<std::size_t>(stat.size, std::max(first_bytes, 2 * done)));
    read = zip_fread(entry, bytes.data() + done, bytes.size() - done);
    if (read > 0) done += std::size_t(read);
  }
  bytes.resize(done);
  // Reading past the end is what makes libzip compare the checksum.
  char beyond = 0;
  const bool whole = bytes.size() == stat.size && zip_fread(entry, &beyond, 1) == 0;
  const bool closed = zip_fclose(entry) == 0;
  return Part{std::move(bytes), whole && closed};
}

std::string checksum(std::string_view bytes) {
  std::uint64_t hash = 0xcbf29ce484222325ULL;
  for (const char byte : bytes) hash = (hash ^ std::uint64_t(static_cast<unsigned char>(byte))) * 0x100000001b3ULL;
  char text[17];
  std::snprintf(text, sizeof text, "%016llx", static_cast<unsigned long long>(hash));
  return text;
}

}  // namespace biotope

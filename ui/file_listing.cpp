#include "ui/file_listing.hpp"

#include <algorithm>
#include <array>
#include <cctype>

namespace biotope {
namespace {

std::string lower(std::string_view text) {
  std::string result(text);
  std::transform(result.begin(), result.end(), result.begin(), [](unsigned char c) { return char(std::tolower(c)); });
  return result;
}

}  // namespace

bool looks_openable(std::string_view name) {
  static constexpr std::array<std::string_view, 18> endings{".biotope", ".tif", ".tiff", ".asc", ".hgt", ".dem",
                                                            ".png",     ".exr", ".img",  ".vrt", ".bil", ".flt",
                                                            ".dt0",     ".dt1", ".dt2",  ".raw", ".r16", ".grd"};
  const std::string small = lower(name);
  return std::any_of(endings.begin(), endings.end(), [&](std::string_view ending) { return small.ends_with(ending); });
}

std::vector<FileEntry> list_folder(const std::filesystem::path& folder, bool scenes_only, std::string& problem) {
  if (scenes_only)
    return list_wanted(
        folder, [](std::string_view name) { return lower(name).ends_with(".biotope"); }, problem);
  return list_wanted(folder, looks_openable, problem);
}

std::vector<FileEntry> list_wanted(const std::filesystem::path& folder, const std::function<bool(std::string_view)>& wanted,
                                   std::string& problem) {
  std::vector<FileEntry> entries;
  problem.clear();
  std::error_code error;
  for (std::filesystem::directory_iterator it(folder, error), end; !error && it != end; it.increment(error)) {
    const std::string name = it->path().filename().string();
    std::error_code ignored;
    const bool is_folder = it->is_directory(ignored);
    if (name.starts_with('.')) continue;
    if (!is_folder && !wanted(name)) continue;
    const std::uintmax_t bytes = is_folder ? 0 : it->file_size(ignored);
    entries.push_back({name, is_folder, ignored ? 0 : bytes});
  }
  if (error) problem = "This folder cannot be read: " + error.message();
  std::sort(entries.begin(), entries.end(), [](const FileEntry& a, const FileEntry& b) {
    if (a.folder != b.folder) return a.folder;
    return lower(a.name) < lower(b.name);
  });
  return entries;
}

void FileBrowser::go_to(const std::filesystem::path& where) {
  std::error_code error;
  const std::filesystem::path absolute = std::filesystem::absolute(where, error).lexically_normal();
  folder = error ? where : absolute;
  if (folder.filename().empty() && folder.has_parent_path() && folder != folder.root_path()) folder = folder.parent_path();
  path_text = folder.string();
  if (endings.empty()) {
    entries = list_folder(folder, scenes_only, problem);
    return;
  }
  const auto wanted = [this](std::string_view file) {
    const std::string small = lower(file);
    return std::any_of(endings.begin(), endings.end(), [&](const std::string& ending) { return small.ends_with(ending); });
  };
  entries = list_wanted(folder, wanted, problem);
}

}  // namespace biotope

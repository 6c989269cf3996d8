#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

namespace biotope {

/// A line of a folder's listing.
struct FileEntry {
  std::string name;
  bool folder = false;
  std::uintmax_t bytes = 0;
};

/// Folders first, then files that the editor can open, each by name without regard to case; hidden ones are left out. A folder
/// that cannot be read is empty and told in `problem`.
[[nodiscard]] std::vector<FileEntry> list_folder(const std::filesystem::path& folder, bool scenes_only, std::string& problem);

/// The same with a test of the files' names.
[[nodiscard]] std::vector<FileEntry> list_wanted(const std::filesystem::path& folder,
                                                 const std::function<bool(std::string_view)>& wanted, std::string& problem);

/// True for scenes and for the endings of terrain files that are common; any other file can still be typed by name.
[[nodiscard]] bool looks_openable(std::string_view name);

/// What the file dialogs know.
struct FileBrowser {
  std::filesystem::path folder;
  std::string path_text;  ///< the typed folder
  std::string name;       ///< the typed or chosen file
  std::vector<FileEntry> entries;
  std::string problem;
  bool scenes_only = false;
  /// Lower-case endings of the files to list instead; empty: what the editor opens.
  std::vector<std::string> endings;
  bool confirm_overwrite = false;

  /// Goes to a folder and reads it.
  void go_to(const std::filesystem::path& where);
};

}  // namespace biotope

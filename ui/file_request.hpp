#pragma once

#include <filesystem>
#include <functional>
#include <string>

#include "ui/file_listing.hpp"

namespace biotope {

struct EditorState;

/// A file that something asks the person for: what the dialog says, and what happens with the file.
struct FileRequest {
  std::string title;
  std::string action;  ///< "Import": the button
  bool saving = false;
  FileBrowser browser;  ///< with the endings to list and the name to start from
  std::function<void(EditorState&, const std::filesystem::path&)> then;
};

/// Opens the dialog for a request; lists files with these endings (lower case, with the dot).
void ask_for_file(EditorState& state, FileRequest request);

}  // namespace biotope

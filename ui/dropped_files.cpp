#include "ui/dropped_files.hpp"

#include <algorithm>
#include <filesystem>

#include "ui/editor_actions.hpp"

namespace biotope {

void drop_files(EditorState& state, const std::vector<std::string>& files) {
  if (files.empty()) return;
  const auto scene = std::find_if(files.begin(), files.end(),
                                  [](const std::string& file) { return std::filesystem::path(file).extension() == ".biotope"; });
  const std::string& taken = scene == files.end() ? files.front() : *scene;
  if (files.size() > 1) {
    const std::size_t left = files.size() - 1;
    announce(state, "Only " + std::filesystem::path(taken).filename().string() + " is opened: one landscape at a time. " +
                        std::to_string(left) + (left == 1 ? " other file was" : " other files were") + " left");
  }
  open_or_import(state, taken);
}

}  // namespace biotope

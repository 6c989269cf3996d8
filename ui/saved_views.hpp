#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "ui/camera_path.hpp"

namespace biotope {

/// A view that somebody wants to come back to.
struct Bookmark {
  std::string name;
  Camera camera;
  double hour = 10.5;
  int month = 5;  ///< 0 is January
};

inline constexpr std::size_t most_bookmarks = 500;

/// What of a scene is about looking at it: saved with it, beside the document.
struct SavedViews {
  std::vector<Bookmark> bookmarks;
  CameraPath path;
  [[nodiscard]] bool empty() const { return bookmarks.empty() && path.keys.empty(); }
};

/// Text of the scene's entry; empty for no views.
[[nodiscard]] std::string saved_views_to_json(const SavedViews& views);
/// Reads and checks; an empty text is no views. Messages begin with `origin`.
[[nodiscard]] Result<SavedViews> parse_saved_views(std::string_view text, const std::string& origin);

/// "View 3": a name that no bookmark has.
[[nodiscard]] std::string free_bookmark_name(const std::vector<Bookmark>& bookmarks);

}  // namespace biotope

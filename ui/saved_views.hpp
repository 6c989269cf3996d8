#pragma once

#include <string>
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

/// Most bookmarks of a scene, and most bytes of a name. Our choice.
inline constexpr std::size_t most_bookmarks = 500;
inline constexpr std::size_t most_name_bytes = 200;

/// What of a scene is about looking at it: saved with it, beside the document.
struct SavedViews {
  std::vector<Bookmark> bookmarks;
  CameraPath path;
  /// The text they were read from, where not all of it could be read: it is saved as it is until somebody changes a view.
  std::string unread;
  [[nodiscard]] bool empty() const { return bookmarks.empty() && path.keys.empty() && unread.empty(); }
};

/// Text of the scene's entry: `unread` where there is any, else the views; empty for none.
[[nodiscard]] std::string saved_views_to_json(const SavedViews& views);
/// Reads what makes sense, view by view; an empty text is no views. What is wrong, or of a newer version, is left out and told in
/// `problems`, whose messages begin with `origin`; the text is then kept in `unread`.
[[nodiscard]] SavedViews read_saved_views(const std::string& text, const std::string& origin, std::vector<std::string>& problems);

/// A name cut to `most_name_bytes`, between two characters.
[[nodiscard]] std::string clipped_name(const std::string& name);

/// "View 3": a name that no bookmark has.
[[nodiscard]] std::string free_bookmark_name(const std::vector<Bookmark>& bookmarks);

}  // namespace biotope

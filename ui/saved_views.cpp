#include "ui/saved_views.hpp"

#include <algorithm>
#include <cmath>

#include "ui/camera_path_json.hpp"

namespace biotope {
namespace {

Json bookmark_to_json(const Bookmark& bookmark) {
  Json json = Json::object();
  json["name"] = bookmark.name;
  write_camera(json, bookmark.camera);
  json["hour"] = std::round(bookmark.hour * 1000) / 1000;
  json["month"] = bookmark.month + 1;
  return json;
}

void read_bookmarks(JsonReader& reader, const std::string& origin, std::string& problem, std::vector<Bookmark>& bookmarks) {
  const Json* list = reader.value("bookmarks", Presence::optional, "a list of views");
  if (list == nullptr) return;
  if (!list->is_array() || list->size() > most_bookmarks) {
    return reader.refuse("bookmarks", "a list of at most " + std::to_string(most_bookmarks) + " views", *list);
  }
  for (std::size_t i = 0; i < list->size() && problem.empty(); ++i) {
    JsonReader one((*list)[i], origin + ": bookmark " + std::to_string(i + 1), problem);
    Bookmark bookmark;
    one.text("name", bookmark.name, Presence::required);
    read_camera(one, bookmark.camera);
    one.number("hour", bookmark.hour, {0, 24});
    int month = bookmark.month + 1;
    one.number("month", month, {1, 12});
    bookmark.month = month - 1;
    one.finish();
    bookmarks.push_back(std::move(bookmark));
  }
}

}  // namespace

std::string saved_views_to_json(const SavedViews& views) {
  if (views.empty()) return {};
  Json json = Json::object();
  Json bookmarks = Json::array();
  for (const Bookmark& bookmark : views.bookmarks) bookmarks.push_back(bookmark_to_json(bookmark));
  if (!bookmarks.empty()) json["bookmarks"] = std::move(bookmarks);
  if (!views.path.keys.empty()) json["path"] = path_to_json(views.path);
  return json.dump(1) + "\n";
}

Result<SavedViews> parse_saved_views(std::string_view text, const std::string& origin) {
  SavedViews views;
  if (text.empty()) return views;
  const Result<Json> json = parse_json(text, origin);
  if (!json) return tl::unexpected(json.error());
  std::string problem;
  JsonReader reader(*json, origin, problem);
  read_bookmarks(reader, origin, problem, views.bookmarks);
  if (const Json* path = reader.value("path", Presence::optional, "a camera path"); path != nullptr && problem.empty()) {
    auto read = parse_path(*path, origin + ": path", false);
    if (!read) return tl::unexpected(read.error());
    views.path = std::move(*read);
  }
  reader.finish();
  if (!problem.empty()) return fail(problem + ".");
  return views;
}

std::string free_bookmark_name(const std::vector<Bookmark>& bookmarks) {
  for (int number = int(bookmarks.size()) + 1;; ++number) {
    const std::string name = "View " + std::to_string(number);
    const auto same = [&](const Bookmark& bookmark) { return bookmark.name == name; };
    if (std::none_of(bookmarks.begin(), bookmarks.end(), same)) return name;
  }
}

}  // namespace biotope

#include "ui/saved_views.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

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

/// Reads one bookmark; nothing where it makes no sense. Members of unknown names, of a newer version, are left out and noted.
std::optional<Bookmark> read_bookmark(const Json& json, const std::string& origin, std::vector<std::string>& problems) {
  std::string problem;
  JsonReader reader(json, origin, problem);
  Bookmark bookmark;
  reader.text("name", bookmark.name, Presence::required);
  read_camera(reader, bookmark.camera);
  reader.number("hour", bookmark.hour, {0, 24});
  int month = bookmark.month + 1;
  reader.number("month", month, {1, 12});
  bookmark.month = month - 1;
  bookmark.name = clipped_name(bookmark.name);
  const bool sound = reader.ok();
  reader.finish();
  if (!problem.empty()) problems.push_back(std::move(problem));
  return sound ? std::optional(std::move(bookmark)) : std::nullopt;
}

void read_bookmarks(const Json& list, const std::string& origin, SavedViews& views, std::vector<std::string>& problems) {
  if (!list.is_array()) {
    problems.push_back(origin + ": \"bookmarks\" must be a list of views, got " + JsonReader::shown(list));
    return;
  }
  if (list.size() > most_bookmarks) {
    problems.push_back(origin + ": \"bookmarks\" has more than " + std::to_string(most_bookmarks) + " views");
  }
  for (std::size_t i = 0; i < std::min(list.size(), most_bookmarks); ++i) {
    auto bookmark = read_bookmark(list[i], origin + ": bookmark " + std::to_string(i + 1), problems);
    if (bookmark) views.bookmarks.push_back(std::move(*bookmark));
  }
}

void read_path(const Json& json, const std::string& origin, SavedViews& views, std::vector<std::string>& problems) {
  std::string unknown;
  auto path = parse_path(json, origin + ": path", false, &unknown);
  if (path) {
    views.path = std::move(*path);
  } else {
    problems.push_back(path.error().message);
  }
  if (!unknown.empty()) problems.push_back(std::move(unknown));
}

}  // namespace

std::string saved_views_to_json(const SavedViews& views) {
  if (!views.unread.empty()) return views.unread;
  if (views.empty()) return {};
  Json json = Json::object();
  Json bookmarks = Json::array();
  for (const Bookmark& bookmark : views.bookmarks) bookmarks.push_back(bookmark_to_json(bookmark));
  if (!bookmarks.empty()) json["bookmarks"] = std::move(bookmarks);
  if (!views.path.keys.empty()) json["path"] = path_to_json(views.path);
  return json.dump(1, ' ', false, Json::error_handler_t::replace) + "\n";
}

SavedViews read_saved_views(const std::string& text, const std::string& origin, std::vector<std::string>& problems) {
  SavedViews views;
  if (text.empty()) return views;
  const std::size_t problems_before = problems.size();
  const Result<Json> json = parse_json(text, origin);
  if (json) {
    std::string problem;
    JsonReader reader(*json, origin, problem);
    const Json* bookmarks = reader.value("bookmarks", Presence::optional, "a list of views");
    const Json* path = reader.value("path", Presence::optional, "a camera path");
    reader.finish();
    if (!problem.empty()) problems.push_back(std::move(problem));
    if (bookmarks != nullptr) read_bookmarks(*bookmarks, origin, views, problems);
    if (path != nullptr) read_path(*path, origin, views, problems);
  } else {
    problems.push_back(json.error().message);
  }
  if (problems.size() > problems_before) views.unread = text;
  return views;
}

std::string clipped_name(const std::string& name) {
  if (name.size() <= most_name_bytes) return name;
  std::size_t end = most_name_bytes;
  // A byte 10xxxxxx goes on with a character of UTF-8.
  while (end > 0 && (static_cast<unsigned char>(name[end]) & 0xc0U) == 0x80U) --end;
  return name.substr(0, end);
}

std::string free_bookmark_name(const std::vector<Bookmark>& bookmarks) {
  for (int number = int(bookmarks.size()) + 1;; ++number) {
    const std::string name = "View " + std::to_string(number);
    const auto same = [&](const Bookmark& bookmark) { return bookmark.name == name; };
    if (std::none_of(bookmarks.begin(), bookmarks.end(), same)) return name;
  }
}

}  // namespace biotope

#include "ui/view_actions.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/exchange/atomic_file.hpp"
#include "core/exchange/scene_file.hpp"
#include "ui/camera_motion.hpp"
#include "ui/editor_actions.hpp"
#include "ui/picture_export.hpp"

namespace biotope {
namespace {

constexpr float picture_quality = 2;  // a picture to keep takes its time

bool has_bookmark(const EditorState& state, std::size_t index) { return index < state.views.bookmarks.size(); }
bool has_key(const EditorState& state, std::size_t index) { return index < state.views.path.keys.size(); }

/// Views are no step of the history, but are saved with the scene: those there are now instead of what could not be read.
void touched(EditorState& state) {
  state.views.unread.clear();
  ++state.edits;
}

void order(EditorState& state, PictureOrder wanted) {
  if (Status possible = check_order(wanted); !possible) {
    complain(state, "The picture cannot be made", possible.error());
    return;
  }
  state.pictures.order = std::make_shared<PictureOrder>(std::move(wanted));
}

void ask(EditorState& state, const char* title, std::string ending, std::string name,
         std::function<void(EditorState&, const std::filesystem::path&)> then) {
  FileRequest request;
  request.title = title;
  request.action = "Save";
  request.saving = true;
  if (!ending.empty()) request.browser.endings = {std::move(ending)};
  request.browser.name = std::move(name);
  request.then = std::move(then);
  ask_for_file(state, std::move(request));
}

std::string file_stem(const EditorState& state) {
  std::string name = document_name(state);
  std::replace_if(
      name.begin(), name.end(), [](unsigned char c) { return std::isalnum(c) == 0 && c != '-' && c < 128; }, '-');
  std::transform(name.begin(), name.end(), name.begin(), [](unsigned char c) { return char(std::tolower(c)); });
  return name.empty() ? "landscape" : name;
}

}  // namespace

void add_bookmark(EditorState& state) {
  if (!state.has_document || state.views.bookmarks.size() >= most_bookmarks) return;
  const std::string name = free_bookmark_name(state.views.bookmarks);
  state.views.bookmarks.push_back({name, state.view.camera, state.clock.hour, state.clock.month});
  touched(state);
  announce(state, "Bookmarked as " + name);
}

void go_to_bookmark(EditorState& state, std::size_t index) {
  if (!has_bookmark(state, index)) return;
  const Bookmark& bookmark = state.views.bookmarks[index];
  state.clock.hour = bookmark.hour;
  state.clock.month = bookmark.month;
  set_following(state, false);
  state.exploring.walking = false;
  fly_to(state, bookmark.camera);
}

void update_bookmark(EditorState& state, std::size_t index) {
  if (!has_bookmark(state, index)) return;
  Bookmark& bookmark = state.views.bookmarks[index];
  bookmark = {bookmark.name, state.view.camera, state.clock.hour, state.clock.month};
  touched(state);
  announce(state, bookmark.name + " is the view of now");
}

void rename_bookmark(EditorState& state, std::size_t index, const std::string& name) {
  if (!has_bookmark(state, index)) return;
  std::string fitting = clipped_name(name);
  if (fitting.empty() || state.views.bookmarks[index].name == fitting) return;
  state.views.bookmarks[index].name = std::move(fitting);
  touched(state);
}

void delete_bookmark(EditorState& state, std::size_t index) {
  if (!has_bookmark(state, index)) return;
  state.views.bookmarks.erase(state.views.bookmarks.begin() + std::ptrdiff_t(index));
  touched(state);
}

void add_path_key(EditorState& state) {
  CameraPath& path = state.views.path;
  if (!state.has_document || path.keys.size() >= most_path_keys) return;
  const double seconds = path.keys.empty() ? 0 : std::min(path.keys.back().seconds + seconds_between_keys, longest_path);
  set_key(path, {seconds, state.view.camera});
  touched(state);
  announce(state, "View " + std::to_string(path.keys.size()) + " of the path, at " + std::to_string(int(seconds)) + " s");
}

void set_path_key_view(EditorState& state, std::size_t index) {
  if (!has_key(state, index)) return;
  state.views.path.keys[index].camera = state.view.camera;
  touched(state);
}

void set_path_key_seconds(EditorState& state, std::size_t index, double seconds) {
  if (!has_key(state, index)) return;
  auto& keys = state.views.path.keys;
  // Keys stay in their order, a tenth of a second apart.
  const double least = index == 0 ? 0 : keys[index - 1].seconds + 0.1;
  const double most = index + 1 < keys.size() ? keys[index + 1].seconds - 0.1 : longest_path;
  // Between neighbours that are closer there is no other moment for it.
  if (!(most >= least) || !std::isfinite(seconds)) return;
  keys[index].seconds = std::clamp(seconds, least, most);
  touched(state);
}

void delete_path_key(EditorState& state, std::size_t index) {
  if (!has_key(state, index)) return;
  state.views.path.keys.erase(state.views.path.keys.begin() + std::ptrdiff_t(index));
  touched(state);
}

void clear_path(EditorState& state) {
  state.views.path = {};
  state.pictures.playing = -1;
  touched(state);
}

void set_path_day(EditorState& state) {
  state.views.path.hours.reset();
  if (state.pictures.day_passes)
    state.views.path.hours = std::array<double, 2>{double(state.pictures.hours[0]), double(state.pictures.hours[1])};
  touched(state);
}

void play_path(EditorState& state) {
  if (state.pictures.playing >= 0) {
    state.pictures.playing = -1;
    return;
  }
  if (path_seconds(state.views.path) <= 0) return;
  set_following(state, false);
  state.exploring.walking = false;
  state.exploring.flight.reset();
  state.clock.playing = false;
  state.pictures.playing = 0;
  state.view.camera_untouched = false;
  if (state.view.mode == ViewMode::map) state.view.mode = ViewMode::split;
}

bool advance_path(EditorState& state, double seconds) {
  if (state.pictures.playing < 0) return false;
  const CameraPath& path = state.views.path;
  state.pictures.playing += seconds;
  if (path.keys.size() < 2 || state.pictures.playing > path_seconds(path)) {
    state.pictures.playing = -1;
    return false;
  }
  state.view.camera = kept_over_ground(camera_on_path(path, state.pictures.playing), ground_of(state), 1.5, water_of(state));
  state.clock.hour = hour_on_path(path, state.pictures.playing, state.clock.hour);
  return true;
}

void ask_to_save_path(EditorState& state) {
  if (state.views.path.keys.size() < 2) return;
  ask(state, "Save the camera's path", ".json", file_stem(state) + "-path.json",
      [](EditorState& later, const std::filesystem::path& file) {
        const Status written = write_text(file, path_to_text(later.views.path));
        if (!written) return complain(later, "The path was not saved", written.error());
        announce(later, "Saved " + file.filename().string());
      });
}

void ask_to_open_path(EditorState& state) {
  FileRequest request;
  request.title = "Open a camera's path";
  request.action = "Open";
  request.browser.endings = {".json"};
  request.then = [](EditorState& later, const std::filesystem::path& file) {
    const auto text = read_text(file, most_view_bytes);
    if (!text) return complain(later, "The path could not be opened", text.error());
    auto path = parse_path_text(*text, file.string());
    if (!path) return complain(later, "The path could not be opened", path.error());
    later.views.path = std::move(*path);
    later.pictures.day_passes = later.views.path.hours.has_value();
    touched(later);
  };
  ask_for_file(state, std::move(request));
}

PictureOrder picture_order(const EditorState& state) {
  PictureOrder order;
  order.snapshot = state.shown;
  order.camera = state.view.camera;
  order.width = state.pictures.width;
  order.height = state.pictures.height;
  order.frames_a_second = state.pictures.frames_a_second;
  order.options.hour = state.clock.hour;
  order.options.month = state.clock.month;
  order.options.weather = state.settings.weather;
  order.options.seconds = state.view.seconds;
  order.options.plants = state.view.plants;
  order.options.animals = state.view.herds;
  order.options.trails = state.view.trails;
  order.options.water = state.view.water;
  order.options.visible_species = state.view.visible_species;
  order.options.quality = std::max(state.view.quality, picture_quality);
  return order;
}

void ask_to_save_picture(EditorState& state) {
  if (!state.shown) return;
  // The view of now, whatever happens until the file has a name.
  const PictureOrder wanted = picture_order(state);
  ask(state, "Save the picture", ".png", file_stem(state) + ".png",
      [wanted](EditorState& later, const std::filesystem::path& file) {
        PictureOrder named = wanted;
        named.out = file;
        order(later, std::move(named));
      });
}

void ask_to_render_path(EditorState& state) {
  if (!state.shown || state.views.path.keys.size() < 2) return;
  ask(state, "Folder for the path's pictures", {}, file_stem(state) + "-frames",
      [](EditorState& later, const std::filesystem::path& folder) {
        PictureOrder wanted = picture_order(later);
        wanted.path = later.views.path;
        wanted.out = folder;
        order(later, std::move(wanted));
      });
}

void ask_to_render_video(EditorState& state) {
  if (!state.shown || state.views.path.keys.size() < 2) return;
  if (!find_ffmpeg()) {
    complain(
        state, "No video without ffmpeg",
        {"A video is made by ffmpeg, which is not installed. Pictures ... draws the path into a folder of PNG files instead."});
    return;
  }
  ask(state, "Save the path as a video", ".mp4", file_stem(state) + ".mp4",
      [](EditorState& later, const std::filesystem::path& file) {
        PictureOrder wanted = picture_order(later);
        wanted.path = later.views.path;
        wanted.out = file;
        order(later, std::move(wanted));
      });
}

}  // namespace biotope

#pragma once

#include <array>
#include <cstddef>
#include <filesystem>
#include <memory>
#include <string>

#include "core/base/status.hpp"

namespace biotope {

struct EditorState;
struct PictureOrder;

/// What is being asked and done about pictures and paths.
struct PictureSession {
  /// Size of pictures and videos, pixels, and pictures a second of a path.
  int width = 3840;
  int height = 2160;
  int frames_a_second = 25;
  /// Waits to be begun by who owns the graphics.
  std::shared_ptr<PictureOrder> order;
  bool wants_cancel = false;
  /// Of the order under way.
  bool running = false;
  double fraction = 0;
  std::string stage;
  /// The path being played, s from its first key; below 0: it is not played.
  double playing = -1;
  /// Hours of a path whose day passes, as they are set before the first key is there.
  bool day_passes = false;
  std::array<float, 2> hours{6, 20};
};

// Views somebody wants to come back to. They are saved with the scene: every change makes it unsaved.

void add_bookmark(EditorState& state);
/// Flies there, at its hour and month.
void go_to_bookmark(EditorState& state, std::size_t index);
/// Takes the view of now for a bookmark.
void update_bookmark(EditorState& state, std::size_t index);
void rename_bookmark(EditorState& state, std::size_t index, const std::string& name);
void delete_bookmark(EditorState& state, std::size_t index);

// The camera's path.

inline constexpr double seconds_between_keys = 4;  ///< of keys that are added one after the other; our choice

/// Adds the view of now after the last key.
void add_path_key(EditorState& state);
void set_path_key_view(EditorState& state, std::size_t index);
void set_path_key_seconds(EditorState& state, std::size_t index, double seconds);
void delete_path_key(EditorState& state, std::size_t index);
void clear_path(EditorState& state);
/// Takes hours and day from the session into the path.
void set_path_day(EditorState& state);
/// Plays from the beginning, or stops.
void play_path(EditorState& state);
/// Once a frame: the camera and the clock on the path that is played. True while one is.
bool advance_path(EditorState& state, double seconds);
void ask_to_save_path(EditorState& state);
void ask_to_open_path(EditorState& state);

// Pictures of the 3D view.

/// Asks for a file and has the view of now drawn into it at the session's size.
void ask_to_save_picture(EditorState& state);
/// Asks for a folder's name and has the path drawn into it.
void ask_to_render_path(EditorState& state);
/// The same into a video.
void ask_to_render_video(EditorState& state);
/// What a view of now asks for: snapshot, camera, light, weather, what is shown; quality high at least.
[[nodiscard]] PictureOrder picture_order(const EditorState& state);

}  // namespace biotope

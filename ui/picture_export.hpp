#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>

#include "render/image.hpp"
#include "render/landscape_renderer.hpp"
#include "render/offscreen_context.hpp"
#include "ui/background_task.hpp"
#include "ui/camera_path.hpp"

namespace biotope {

/// Largest side of a picture, pixels.
inline constexpr int largest_picture_side = 16384;
/// Most pixels of each picture of a path (16384 x 8192): one is encoded while the next is drawn.
inline constexpr std::int64_t largest_path_picture = std::int64_t(1) << 27;

class FramesFolder;

/// Pictures to be made of a landscape: one, or one after the other along a path.
struct PictureOrder {
  std::shared_ptr<const MapsSnapshot> snapshot;
  LandscapeOptions options;
  Camera camera;
  int width = 1920;
  int height = 1080;
  /// Along it when it has at least two keys; `camera` and the options' hour then only stand for what it does not say.
  CameraPath path;
  double frames_a_second = 25;
  /// PNG of one picture; folder of a path's pictures; or, where it ends in ".mp4", the video made of them (needs ffmpeg).
  std::filesystem::path out;

  [[nodiscard]] bool along_path() const { return path.keys.size() >= 2; }
  [[nodiscard]] bool video() const { return along_path() && out.extension() == ".mp4"; }
};

/// Pictures of an order.
[[nodiscard]] int picture_count(const PictureOrder& order);
/// Camera and options of its picture `number`, from 0. Cameras of a path stay over the ground.
struct PictureView {
  Camera camera;
  LandscapeOptions options;
};
[[nodiscard]] PictureView picture_view(const PictureOrder& order, int number);
/// "frame-00001.png" for picture 0.
[[nodiscard]] std::string frame_name(int number);
/// Why an order cannot be carried out (no folder, no ffmpeg), found before the work; success where it can.
[[nodiscard]] Status check_order(const PictureOrder& order);
/// ffmpeg's place in PATH; nothing when it is not installed.
[[nodiscard]] std::optional<std::filesystem::path> find_ffmpeg();

/// The part of a picture that one draw makes, pixels from the lower left corner.
struct PictureTile {
  int x = 0;
  int y = 0;
  int width = 0;
  int height = 0;
};
/// Tile `number` of a picture cut into tiles of at most `side` pixels a side, row by row; and how many there are.
[[nodiscard]] PictureTile picture_tile(int width, int height, int side, int number);
[[nodiscard]] int tile_count(int width, int height, int side);
/// A tile with `margin` pixels more on each side, as far as the picture goes: what must be drawn for the tile to be a part of it.
[[nodiscard]] PictureTile with_margin(const PictureTile& tile, int margin, int width, int height);
/// Puts a tile where it belongs in the whole, out of the pixels (top row first) of what was `drawn` for it.
void place_tile(Image& whole, const Image& pixels, const PictureTile& tile, const PictureTile& drawn);

/// Carries out orders in slices, so that the window goes on: a tile at a time, files written on a thread of their own. Needs the
/// same current OpenGL context in every call and when it is destroyed.
class PictureExporter {
 public:
  PictureExporter() = default;
  /// Gives up what is under way; waits for a file that is being written.
  ~PictureExporter();
  PictureExporter(const PictureExporter&) = delete;
  PictureExporter& operator=(const PictureExporter&) = delete;

  /// What was under way is given up.
  void start(PictureOrder order);
  /// Works for about `seconds` (at least one slice); call until it is no longer running.
  void advance(double seconds);
  /// Gives up; what is half-made is removed, whole pictures of a path stay. Does not wait for a picture that is being encoded.
  void cancel();

  [[nodiscard]] bool running() const { return order_.has_value(); }
  /// Success once all is written; an Error when something failed. Once, when it is over; nothing before, or after a cancel.
  [[nodiscard]] std::optional<Status> take_result();
  [[nodiscard]] double fraction() const;
  /// "Picture 3 of 125", "Making the video".
  [[nodiscard]] std::string stage() const;
  /// Of the order that is under way or was last.
  [[nodiscard]] const std::filesystem::path& out() const { return out_; }

 private:
  /// False when nothing more can be done now (a file is being written).
  bool slice();
  bool prepare();
  /// The folder of a path's pictures.
  Status make_folder();
  void draw_tile();
  /// Whether no file is being written any more; where that failed, the order ends.
  bool written();
  bool finish_picture();
  bool finish_all();
  void end(Status status);
  [[nodiscard]] std::filesystem::path file_of(int number) const;

  std::optional<PictureOrder> order_;
  std::filesystem::path out_;
  std::unique_ptr<LandscapeRenderer> renderer_;
  std::unique_ptr<RenderTarget> target_;
  Image whole_;
  int picture_ = 0;
  int tile_ = 0;
  int tile_side_ = 1024;
  bool ground_there_ = false;  ///< the ground of the first picture is made
  bool loaded_ = false;        ///< everything of the picture under way is there
  bool video_begun_ = false;
  /// Pictures of a video, until they are in it.
  std::shared_ptr<const FramesFolder> frames_;
  BackgroundTask<bool> writing_;
  /// Ends by itself; nothing of it is wanted.
  BackgroundTask<bool> given_up_;
  std::optional<Status> result_;
};

}  // namespace biotope

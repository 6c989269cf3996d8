#include "ui/picture_export.hpp"

#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <cstdint>
#include <cstdio>
#include <utility>

#include "ui/camera_motion.hpp"
#include "ui/video_encoder.hpp"

namespace biotope {
namespace {

constexpr int software_tile = 640;  // pixels a side: a slice of a third of a second or so
constexpr int hardware_tile = 4096;
constexpr double path_clearance = 1.2;  // m over the ground, of cameras on a path

Status check_folder(const std::filesystem::path& folder) {
  std::error_code error;
  if (!std::filesystem::is_directory(folder, error)) return fail(folder.string() + ": there is no such folder.");
  if (::access(folder.c_str(), W_OK) != 0) return fail(folder.string() + ": is not writable.");
  return {};
}

std::filesystem::path parent_of(const std::filesystem::path& file) {
  return file.has_parent_path() ? file.parent_path() : std::filesystem::path(".");
}

}  // namespace

int picture_count(const PictureOrder& order) { return order.along_path() ? frame_count(order.path, order.frames_a_second) : 1; }

PictureView picture_view(const PictureOrder& order, int number) {
  PictureView view{order.camera, order.options};
  view.options.brush.reset();
  if (!order.along_path()) return view;
  const double seconds = number / order.frames_a_second;
  view.camera = kept_over_ground(camera_on_path(order.path, seconds), order.snapshot->terrain(), path_clearance,
                                 order.snapshot->hydrology.get());
  view.options.hour = hour_on_path(order.path, seconds, order.options.hour);
  view.options.seconds = order.options.seconds + seconds;
  return view;
}

std::string frame_name(int number) {
  char name[32];
  std::snprintf(name, sizeof name, "frame-%05d.png", number + 1);
  return name;
}

Status check_order(const PictureOrder& order) {
  if (!order.snapshot) return fail("There is no landscape yet.");
  if (order.width < 16 || order.height < 16 || order.width > largest_picture_side || order.height > largest_picture_side) {
    return fail("A picture has 16 to " + std::to_string(largest_picture_side) + " pixels a side.");
  }
  if (order.along_path() && std::int64_t(order.width) * order.height > largest_path_picture) {
    return fail("Pictures of a path have at most " + std::to_string(largest_path_picture / 1'000'000) + " million pixels each.");
  }
  std::error_code error;
  if (!order.along_path() || order.video()) {
    if (std::filesystem::is_directory(order.out, error)) return fail(order.out.string() + ": is a folder; give a file's name.");
    if (Status folder = check_folder(parent_of(order.out)); !folder) return folder;
    if (order.video() && !find_ffmpeg())
      return fail("A video needs ffmpeg, which is not installed; give a folder for the pictures instead.");
    return {};
  }
  if (std::filesystem::is_directory(order.out, error)) return check_folder(order.out);
  if (std::filesystem::exists(order.out, error)) return fail(order.out.string() + ": is a file; give a folder for the pictures.");
  return check_folder(parent_of(order.out));
}

PictureTile picture_tile(int width, int height, int side, int number) {
  const int columns = (width + side - 1) / side;
  const int x = number % columns * side;
  const int y = number / columns * side;
  return {x, y, std::min(side, width - x), std::min(side, height - y)};
}

int tile_count(int width, int height, int side) { return (width + side - 1) / side * ((height + side - 1) / side); }

PictureTile with_margin(const PictureTile& tile, int margin, int width, int height) {
  const int x = std::max(0, tile.x - margin);
  const int y = std::max(0, tile.y - margin);
  return {x, y, std::min(width, tile.x + tile.width + margin) - x, std::min(height, tile.y + tile.height + margin) - y};
}

void place_tile(Image& whole, const Image& pixels, const PictureTile& tile, const PictureTile& drawn) {
  for (int row = 0; row < tile.height; ++row) {
    // Tiles count rows from below, images from above.
    const int whole_row = whole.height - tile.y - tile.height + row;
    const int drawn_row = whole_row - (whole.height - drawn.y - drawn.height);
    const auto from = pixels.rgba.begin() + (std::ptrdiff_t(drawn_row) * pixels.width + tile.x - drawn.x) * 4;
    std::copy(from, from + std::ptrdiff_t(tile.width) * 4,
              whole.rgba.begin() + (std::ptrdiff_t(whole_row) * whole.width + tile.x) * 4);
  }
}

void PictureExporter::start(PictureOrder order) {
  cancel();
  out_ = order.out;
  result_.reset();
  if (Status possible = check_order(order); !possible) {
    result_ = std::move(possible);
    return;
  }
  order_ = std::move(order);
  picture_ = tile_ = 0;
  loaded_ = video_begun_ = ground_there_ = false;
  tile_side_ = drawn_by_processor() ? software_tile : hardware_tile;
}

std::filesystem::path PictureExporter::file_of(int number) const {
  if (!order_->along_path()) return order_->out;
  return (frames_ ? frames_->path() : order_->out) / frame_name(number);
}

void PictureExporter::end(Status status) {
  order_.reset();
  frames_.reset();
  renderer_.reset();
  target_.reset();
  whole_ = {};
  result_ = std::move(status);
}

PictureExporter::~PictureExporter() { cancel(); }

void PictureExporter::cancel() {
  if (!order_) return;
  if (writing_.running()) {
    // Encoding a large picture takes seconds: it ends behind the window, and nothing of it is kept.
    writing_.ask_to_stop();
    given_up_ = std::exchange(writing_, {});
  }
  end({});
  result_.reset();
}

Status PictureExporter::make_folder() {
  if (!order_->along_path()) return {};
  if (order_->video()) {
    auto made = FramesFolder::make(order_->out);
    if (!made) return tl::unexpected(made.error());
    frames_ = std::move(*made);
    return {};
  }
  std::error_code error;
  if (!std::filesystem::is_directory(order_->out, error) && !std::filesystem::create_directory(order_->out, error)) {
    return fail(order_->out.string() + ": cannot be made: " + error.message() + ".");
  }
  return {};
}

bool PictureExporter::prepare() {
  // What was given up may still hold a large picture.
  if (given_up_.running() && !given_up_.take()) return false;
  if (!renderer_) {
    auto made = LandscapeRenderer::create();
    if (!made) {
      end(tl::unexpected(made.error()));
      return true;
    }
    renderer_ = std::move(*made);
    renderer_->set_snapshot(order_->snapshot);
    target_ = std::make_unique<RenderTarget>(32, 32);
    if (Status made_folder = make_folder(); !made_folder) {
      end(std::move(made_folder));
      return true;
    }
  }
  const PictureView view = picture_view(*order_, picture_);
  if (!ground_there_) {
    // The ground is made on a thread of its own: the window goes on meanwhile.
    renderer_->bring_in(view.options);
    ground_there_ = renderer_->complete();
    if (!ground_there_) return false;
  }
  // The plants of the first picture take the longest; later ones only add what comes into sight.
  renderer_->finish_loading(view.camera, view.options);
  loaded_ = true;
  tile_ = 0;
  whole_.width = order_->width;
  whole_.height = order_->height;
  whole_.rgba.assign(std::size_t(order_->width) * std::size_t(order_->height) * 4, 0);
  return true;
}

void PictureExporter::draw_tile() {
  const PictureTile tile = picture_tile(order_->width, order_->height, tile_side_, tile_);
  PictureView view = picture_view(*order_, picture_);
  const PictureTile drawn = with_margin(tile, tile_margin(view.options, order_->height), order_->width, order_->height);
  view.options.corner = {drawn.x, drawn.y};
  target_->resize(drawn.width, drawn.height);
  target_->bind();
  renderer_->draw(view.camera, view.options, order_->width, order_->height);
  place_tile(whole_, target_->read(), tile, drawn);
  ++tile_;
}

bool PictureExporter::written() {
  if (!writing_.running()) return true;
  const auto result = writing_.take();
  if (!result) return false;
  if (!*result) end(tl::unexpected(result->error()));
  return true;
}

bool PictureExporter::finish_picture() {
  if (!written()) return false;
  if (!order_) return true;
  auto image = std::make_shared<Image>(std::move(whole_));
  writing_.start("Writing", [image, file = file_of(picture_), frames = frames_](const TaskContext& context) -> Result<bool> {
    if (Status written = write_png(file, *image, context); !written) return tl::unexpected(written.error());
    return true;
  });
  ++picture_;
  loaded_ = false;
  return true;
}

bool PictureExporter::finish_all() {
  if (!written()) return false;
  if (!order_) return true;
  if (order_->video() && !video_begun_) {
    video_begun_ = true;
    renderer_.reset();
    writing_.start(
        "Making the video",
        [frames = frames_, out = order_->out, rate = order_->frames_a_second](const TaskContext& context) -> Result<bool> {
          if (Status made = encode_video(frames->path(), rate, out, context); !made) return tl::unexpected(made.error());
          return true;
        });
    return true;
  }
  end({});
  return true;
}

bool PictureExporter::slice() {
  if (picture_ >= picture_count(*order_)) return finish_all();
  if (!loaded_) return prepare();
  if (tile_ < tile_count(order_->width, order_->height, tile_side_)) {
    draw_tile();
    return true;
  }
  return finish_picture();
}

void PictureExporter::advance(double seconds) {
  const auto begin = std::chrono::steady_clock::now();
  while (order_) {
    if (!slice()) return;
    if (std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count() > seconds) return;
  }
}

std::optional<Status> PictureExporter::take_result() {
  std::optional<Status> result = std::move(result_);
  result_.reset();
  return result;
}

double PictureExporter::fraction() const {
  if (!order_) return 0;
  const int tiles = tile_count(order_->width, order_->height, tile_side_);
  const double pictures = picture_ + (loaded_ ? double(tile_) / tiles : 0);
  return std::clamp(pictures / std::max(picture_count(*order_), 1), 0.0, 1.0);
}

std::string PictureExporter::stage() const {
  if (!order_) return {};
  const int count = picture_count(*order_);
  if (picture_ >= count) return video_begun_ ? "Making the video" : "Writing the picture";
  if (count == 1) return loaded_ ? "Drawing the picture" : "Preparing the picture";
  return "Picture " + std::to_string(picture_ + 1) + " of " + std::to_string(count);
}

}  // namespace biotope

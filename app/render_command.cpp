#include "app/render_command.hpp"

#include <unistd.h>

#include <algorithm>
#include <filesystem>
#include <ostream>

#include "app/command_line_progress.hpp"
#include "app/command_line_signals.hpp"
#include "app/solve_command.hpp"
#include "core/exchange/atomic_file.hpp"
#include "core/pipeline/solve.hpp"
#include "render/image.hpp"
#include "render/landscape_renderer.hpp"
#include "render/offscreen_context.hpp"
#include "ui/picture_export.hpp"

namespace biotope {
namespace {

Camera camera_of(const MapsSnapshot& snapshot, const RenderRequest& request) {
  if (!request.view) return first_view(snapshot);
  Camera camera = request.view->camera;
  if (request.view->above_ground)
    camera.position.z += double(ground_height(snapshot.terrain(), camera.position.x, camera.position.y));
  return camera;
}

Result<Image> picture_of(const std::shared_ptr<const MapsSnapshot>& snapshot, const RenderRequest& request) {
  auto renderer = LandscapeRenderer::create();
  if (!renderer) return tl::unexpected(renderer.error());
  (*renderer)->set_snapshot(snapshot);
  LandscapeOptions options;
  options.hour = request.hour;
  options.month = request.month - 1;
  options.weather = request.weather;
  options.seconds = request.seconds;
  options.quality = float(request.quality);
  const Camera camera = camera_of(*snapshot, request);
  (*renderer)->finish_loading(camera, options);
  const RenderTarget target(request.size.width, request.size.height);
  target.bind();
  (*renderer)->draw(camera, options, request.size.width, request.size.height);
  return target.read();
}

/// A GL framebuffer has this many pixels a side at least; larger pictures are made in tiles.
constexpr int largest_at_once = 4096;

PictureOrder order_of(const std::shared_ptr<const MapsSnapshot>& snapshot, const RenderRequest& request, CameraPath path) {
  PictureOrder order;
  order.snapshot = snapshot;
  order.options.hour = request.hour;
  order.options.month = request.month - 1;
  order.options.weather = request.weather;
  order.options.seconds = request.seconds;
  order.options.quality = float(request.quality);
  order.camera = camera_of(*snapshot, request);
  order.width = request.size.width;
  order.height = request.size.height;
  order.path = std::move(path);
  order.frames_a_second = request.frames_a_second;
  order.out = request.picture;
  return order;
}

/// More than the longest path takes as text.
constexpr std::size_t most_path_bytes = std::size_t(1) << 20;

/// Carries out an order to its end.
Status make_pictures(PictureOrder order, const TaskContext& task) {
  PictureExporter exporter;
  exporter.start(std::move(order));
  while (exporter.running()) {
    if (task.stopped()) {
      exporter.cancel();
      return fail("stopped");
    }
    task.report("drawing", exporter.fraction());
    exporter.advance(0.25);
    // Nothing to do while a file is written.
    ::usleep(500);
  }
  return exporter.take_result().value_or(Status());
}

Result<CameraPath> path_of(const RenderRequest& request) {
  if (request.path_file.empty()) return CameraPath();
  const auto text = read_text(request.path_file, most_path_bytes);
  if (!text) return tl::unexpected(text.error());
  return parse_path_text(*text, request.path_file);
}

/// An Error when the picture could not be written, found before a long computation.
Status check_picture(const std::filesystem::path& picture) {
  std::error_code error;
  const std::filesystem::path folder = picture.has_parent_path() ? picture.parent_path() : ".";
  if (std::filesystem::is_directory(picture, error)) return fail(picture.string() + ": is a folder; give the name of a picture.");
  if (!std::filesystem::is_directory(folder, error)) {
    return fail(picture.string() + ": cannot be written; there is no folder " + folder.string() + ".");
  }
  if (::access(folder.c_str(), W_OK) != 0) {
    return fail(picture.string() + ": cannot be written; the folder " + folder.string() + " is not writable.");
  }
  return {};
}

}  // namespace

Status write_picture(const std::shared_ptr<const MapsSnapshot>& snapshot, const RenderRequest& request, const TaskContext& task) {
  if (std::max(request.size.width, request.size.height) > largest_at_once) {
    return make_pictures(order_of(snapshot, request, {}), task);
  }
  const auto picture = picture_of(snapshot, request);
  if (!picture) return tl::unexpected(picture.error());
  return write_png(request.picture, *picture, task);
}

Status run_render(const RenderRequest& request, std::ostream& out, std::ostream& err) {
  auto path = path_of(request);
  if (!path) return tl::unexpected(path.error());
  const bool along_path = !request.path_file.empty();
  if (along_path) {
    // As far as it can be checked without a landscape.
    PictureOrder order;
    order.snapshot = std::make_shared<const MapsSnapshot>();
    order.path = *path;
    order.width = request.size.width;
    order.height = request.size.height;
    order.out = request.picture;
    if (const Status possible = check_order(order); !possible) return possible;
  } else if (const Status writable = check_picture(request.picture); !writable) {
    return writable;
  }
  // Before the computation, so that a machine that cannot draw says so at once.
  const auto context = OffscreenContext::create();
  if (!context) return tl::unexpected(context.error());
  const StopOnSignal signals;
  ProgressLine progress(err, standard_error_is_terminal(), request.landscape.quiet);
  const TaskContext task = progress.context(signals.token());

  auto document = open_requested(request.landscape, task);
  if (!document) return tl::unexpected(document.error());
  const auto snapshot = solve(*document, nullptr, task);
  if (!snapshot) return tl::unexpected(snapshot.error());
  task.report("drawing", 0);
  Status written =
      along_path ? make_pictures(order_of(*snapshot, request, std::move(*path)), task) : write_picture(*snapshot, request, task);
  if (!written) return written;
  progress.clear();
  if (!request.landscape.quiet) out << "Written to " << request.picture << std::endl;
  return {};
}

}  // namespace biotope

#include "app/render_command.hpp"

#include <ostream>

#include "app/command_line_progress.hpp"
#include "app/command_line_signals.hpp"
#include "app/solve_command.hpp"
#include "core/pipeline/solve.hpp"
#include "render/image.hpp"
#include "render/landscape_renderer.hpp"
#include "render/offscreen_context.hpp"

namespace biotope {
namespace {

Result<Image> picture_of(const std::shared_ptr<const MapsSnapshot>& snapshot, const RenderRequest& request) {
  auto renderer = LandscapeRenderer::create();
  if (!renderer) return tl::unexpected(renderer.error());
  (*renderer)->set_snapshot(snapshot);
  LandscapeOptions options;
  options.hour = request.hour;
  options.month = request.month - 1;
  options.quality = 2;
  const RenderTarget target(request.size.width, request.size.height);
  target.bind();
  (*renderer)->draw(request.camera.value_or(first_view(*snapshot)), options, request.size.width, request.size.height);
  return target.read();
}

}  // namespace

Status run_render(const RenderRequest& request, std::ostream& out, std::ostream& err) {
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
  const auto picture = picture_of(*snapshot, request);
  if (!picture) return tl::unexpected(picture.error());
  if (Status written = write_png(request.picture, *picture); !written) return written;
  progress.clear();
  if (!request.landscape.quiet) out << "Written to " << request.picture << '\n';
  return {};
}

}  // namespace biotope

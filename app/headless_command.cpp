#include "app/headless_command.hpp"

#include <filesystem>
#include <ostream>

#include "app/command_line_progress.hpp"
#include "app/command_line_signals.hpp"
#include "app/render_command.hpp"
#include "app/solve_command.hpp"
#include "render/offscreen_context.hpp"

namespace biotope {

Status run_without_display(const LandscapeRequest& request, const std::string& folder, std::ostream& out, std::ostream& err) {
  std::error_code error;
  if (!request.input.starts_with("sample:") && !std::filesystem::exists(request.input, error))
    return fail(request.input + ": no such file.");
  const StopOnSignal signals;
  ProgressLine progress(err, standard_error_is_terminal(), request.quiet);
  const TaskContext task = progress.context(signals.token());
  err << "biotope: there is no display to open a window on; computing " << request.input << " and writing its maps and "
      << "a picture of the 3D view into " << folder << "/ instead." << std::endl;

  const auto snapshot = solve_into({request, folder, false}, task);
  if (!snapshot) return tl::unexpected(snapshot.error());
  progress.clear();
  out << "Written to " << folder << std::endl;

  RenderRequest picture;
  picture.picture = (std::filesystem::path(folder) / "landscape.png").string();
  const auto context = OffscreenContext::create();
  if (!context) return fail("The maps are written, but no picture can be drawn: " + context.error().message);
  task.report("drawing", 0);
  if (Status drawn = write_picture(*snapshot, picture, task); !drawn) return drawn;
  progress.clear();
  out << "Written to " << picture.picture << std::endl;
  return {};
}

}  // namespace biotope

#include "app/edit_command.hpp"

#include <chrono>
#include <filesystem>
#include <memory>
#include <ostream>

#include "app/command_line_progress.hpp"
#include "app/command_line_signals.hpp"
#include "app/solve_command.hpp"
#include "core/exchange/edit_script_files.hpp"
#include "core/exchange/edit_script_play.hpp"
#include "core/exchange/open_input.hpp"
#include "core/exchange/scene_file.hpp"
#include "core/exchange/solve_output.hpp"
#include "core/pipeline/snapshot_difference.hpp"
#include "core/pipeline/solve.hpp"

namespace biotope {
namespace {

using Snapshot = std::shared_ptr<const MapsSnapshot>;

/// Where results go, looked at before anything is computed.
Status check_outputs(const EditRequest& request) {
  if (!is_scene_file(request.scene)) return fail(request.scene + ": a scene's name ends in .biotope.");
  const auto folder = std::filesystem::path(request.scene).parent_path();
  std::error_code error;
  if (!folder.empty() && !std::filesystem::is_directory(folder, error)) {
    return fail(request.scene + ": cannot be written, there is no folder " + folder.string() + ".");
  }
  return request.maps_folder.empty() ? Status{} : check_solve_folder(request.maps_folder);
}

/// Compares what was kept up to date from edit to edit with what comes of the document alone.
Status verify(const Document& document, const MapsSnapshot& kept, const TaskContext& context) {
  const auto fresh = solve(document, nullptr, context);
  if (!fresh) return tl::unexpected(fresh.error());
  const std::string difference = snapshot_difference(kept, **fresh);
  if (difference.empty()) return {};
  return fail("The maps kept up to date from edit to edit differ from those computed from scratch, first in: " + difference +
              ". This is an error of the program; please report it with the scene and the script.");
}

Status write_maps(const EditRequest& request, const MapsSnapshot& maps, double total_ms, const TaskContext& context) {
  SolveOutputOptions options;
  options.program_version = BIOTOPE_VERSION;
  options.total_ms = total_ms;
  return write_solve_output(request.maps_folder, maps, options, context);
}

}  // namespace

Status run_edit(const EditRequest& request, std::ostream& out, std::ostream& err) {
  const auto start = std::chrono::steady_clock::now();
  const StopOnSignal signals;
  ProgressLine progress(err, standard_error_is_terminal(), request.landscape.quiet);
  const TaskContext context = progress.context(signals.token());
  if (Status outputs = check_outputs(request); !outputs) return outputs;
  const auto script = load_edit_script(request.script);
  if (!script) return tl::unexpected(script.error());
  auto opened = open_requested(request.landscape, context);
  if (!opened) return tl::unexpected(opened.error());

  const std::filesystem::path file = request.script;
  SolveCache cache;
  const auto document = play(std::move(*opened), *script, {file.filename().string(), file.parent_path()}, cache, context);
  if (!document) return tl::unexpected(document.error());

  Snapshot maps;
  if (request.verify || !request.maps_folder.empty()) {
    auto solved = solve(*document, &cache, context);
    if (!solved) return tl::unexpected(solved.error());
    maps = std::move(*solved);
  }
  if (request.verify) {
    if (Status same = verify(*document, *maps, context); !same) return same;
  }
  context.report("saving", 0);
  if (Status saved = save_scene(request.scene, *document); !saved) return saved;
  if (!request.maps_folder.empty()) {
    const std::chrono::duration<double, std::milli> elapsed = std::chrono::steady_clock::now() - start;
    if (Status written = write_maps(request, *maps, elapsed.count(), context); !written) return written;
  }
  progress.clear();
  if (request.landscape.quiet) return {};
  if (request.verify)
    out << "The maps kept up to date from edit to edit equal those computed from scratch, to the bit" << std::endl;
  out << "Played " << script->entries.size() << " edits; written to " << request.scene;
  if (!request.maps_folder.empty()) out << " and " << request.maps_folder;
  out << std::endl;
  return {};
}

}  // namespace biotope

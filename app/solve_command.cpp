#include "app/solve_command.hpp"

#include <chrono>
#include <filesystem>
#include <ostream>

#include "app/command_line_progress.hpp"
#include "app/command_line_signals.hpp"
#include "core/exchange/open_input.hpp"
#include "core/exchange/solve_output.hpp"
#include "core/pipeline/solve.hpp"
#include "core/species/species_library.hpp"

namespace biotope {

Result<Document> open_requested(const LandscapeRequest& request, const TaskContext& context) {
  auto document = open_input(request.input, request.import, context);
  if (!document) return document;
  if (!request.climate.empty()) {
    auto climate = climate_named(request.climate);
    if (!climate) return tl::unexpected(climate.error());
    document->climate = std::move(*climate);
  }
  if (!request.species_file.empty()) {
    std::error_code error;
    if (std::filesystem::is_directory(request.species_file, error))
      return fail(request.species_file + ": is a folder; give a species file.");
    auto species = load_species(request.species_file);
    if (!species) return tl::unexpected(species.error());
    document->species = std::make_shared<const std::vector<Species>>(std::move(*species));
  }
  if (request.seed) document->seed = *request.seed;
  if (!request.environment_folder.empty()) {
    const auto& height = document->terrain->height;
    auto given = load_given_environment(request.environment_folder, height.width(), height.height());
    if (!given) return tl::unexpected(given.error());
    document->given_environment = std::move(*given);
  }
  return document;
}

Result<std::shared_ptr<const MapsSnapshot>> solve_into(const SolveRequest& request, const TaskContext& context) {
  const auto start = std::chrono::steady_clock::now();
  if (const Status writable = check_solve_folder(request.folder); !writable) return tl::unexpected(writable.error());
  auto document = open_requested(request.landscape, context);
  if (!document) return tl::unexpected(document.error());
  auto snapshot = solve(*document, nullptr, context);
  if (!snapshot) return snapshot;
  SolveOutputOptions options;
  options.all_maps = request.all_maps;
  options.program_version = BIOTOPE_VERSION;
  options.total_ms = std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count();
  if (const Status written = write_solve_output(request.folder, **snapshot, options, context); !written) {
    return tl::unexpected(written.error());
  }
  return snapshot;
}

Status run_solve(const SolveRequest& request, std::ostream& out, std::ostream& err) {
  const StopOnSignal signals;
  ProgressLine progress(err, standard_error_is_terminal(), request.landscape.quiet);
  const auto snapshot = solve_into(request, progress.context(signals.token()));
  if (!snapshot) return tl::unexpected(snapshot.error());
  progress.clear();
  if (!request.landscape.quiet) out << "Written to " << request.folder << std::endl;
  return {};
}

}  // namespace biotope

#pragma once

#include <iosfwd>
#include <memory>
#include <string>

#include "app/command_line_options.hpp"
#include "core/base/status.hpp"
#include "core/base/task_context.hpp"
#include "core/document/document.hpp"
#include "core/pipeline/maps_snapshot.hpp"

namespace biotope {

struct SolveRequest {
  LandscapeRequest landscape;
  std::string folder;
  bool all_maps = false;
};

/// The document a request describes: input opened, then climate, species, seed and given maps in place of its own.
[[nodiscard]] Result<Document> open_requested(const LandscapeRequest& request, const TaskContext& context);

/// Computes a request's landscape, writes everything into its folder and hands out the maps. A folder that cannot be written is
/// found before the computation begins.
[[nodiscard]] Result<std::shared_ptr<const MapsSnapshot>> solve_into(const SolveRequest& request, const TaskContext& context);

/// The command: computes a request's landscape and writes everything into its folder.
[[nodiscard]] Status run_solve(const SolveRequest& request, std::ostream& out, std::ostream& err);

}  // namespace biotope

#pragma once

#include <filesystem>

#include "core/base/status.hpp"
#include "core/base/task_context.hpp"
#include "core/pipeline/maps_snapshot.hpp"

namespace biotope {

struct SolveOutputOptions {
  /// Also fitness maps and monthly environment maps.
  bool all_maps = false;
  double total_ms = 0;
};

/// Writes summary.json, maps/*.tif, trails.geojson, plans.json and graph.json into `folder` (made when missing).
[[nodiscard]] Status write_solve_output(const std::filesystem::path& folder, const MapsSnapshot& snapshot,
                                        const SolveOutputOptions& options, const TaskContext& context = {});

}  // namespace biotope

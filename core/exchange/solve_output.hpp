#pragma once

#include <filesystem>
#include <string>

#include "core/base/status.hpp"
#include "core/base/task_context.hpp"
#include "core/pipeline/maps_snapshot.hpp"

namespace biotope {

/// What summary.json says of a species: `cover` is the mean covered fraction of the map (plants; 0 for animals); `individuals` of a plant
/// is the covered area over the area of one grown crown (a circle of the shape's crown diameter), a count to compare and not a census;
/// `surplus` is what is left of the yearly growth, kg / year for plants and individuals / year for animals; `desired` is null when no
/// shares were asked for.
struct SolveOutputOptions {
  /// Also fitness maps and monthly environment maps.
  bool all_maps = false;
  /// Milliseconds from the start of the run until now; writing is added to it.
  double total_ms = 0;
  /// "version" of summary.json.
  std::string program_version;
};

/// An Error when `folder` cannot be written into (or cannot be made); leaves nothing behind. For before a long computation.
[[nodiscard]] Status check_solve_folder(const std::filesystem::path& folder);

/// Writes summary.json, maps/*.tif, trails.geojson, plans.json and graph.json into `folder` (made when missing). Everything is first written
/// into a folder beside it and then moved in, so a failure leaves nothing half written. Other files of `folder` and of `maps` stay; maps that an
/// earlier run wrote are removed.
/// Only timings and memory in summary.json differ between two runs on the same input.
[[nodiscard]] Status write_solve_output(const std::filesystem::path& folder, const MapsSnapshot& snapshot,
                                        const SolveOutputOptions& options, const TaskContext& context = {});

}  // namespace biotope

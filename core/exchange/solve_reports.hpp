#pragma once

#include <string>

#include "core/exchange/solve_output.hpp"
#include "core/pipeline/maps_snapshot.hpp"

namespace biotope {

/// The text of summary.json.
[[nodiscard]] std::string summary_json(const MapsSnapshot& snapshot, const SolveOutputOptions& options, double writing_ms);

/// Trails as lines in the terrain's CRS: the text of trails.geojson.
[[nodiscard]] std::string trails_geojson(const MapsSnapshot& snapshot);

/// Every herd's day: the text of plans.json.
[[nodiscard]] std::string plans_json(const MapsSnapshot& snapshot);

/// Nodes and edges of the Resource Access Graph: the text of graph.json.
[[nodiscard]] std::string graph_json(const MapsSnapshot& snapshot);

/// Writes every map of a snapshot as a GeoTIFF into `folder`, several at a time.
[[nodiscard]] Status write_maps(const std::filesystem::path& folder, const MapsSnapshot& snapshot, bool all_maps,
                                const TaskContext& context);

}  // namespace biotope

#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/status.hpp"
#include "core/document/placements.hpp"

namespace biotope {

/// Placements as a JSON object of lists, with points as [x, y] in cells:
/// {"rivers": [{"course": [[x, y], ...], "discharge_m3_s": 1}], "lakes": [{"shore": ..., "depth_m": 3}],
///  "fords": [{"at": [x, y], "radius_m": 12}], "exits": [{"at", "radius_m"}], "waypoints": [{"at", "attraction"}],
///  "pinned_trails": [{"points", "weight"}], "forbidden_trails": [{"points", "radius_m"}],
///  "plans": [{"species", "home", "number", "stops": [{"at", "arrive", "leave"}]}]}.
/// Empty lists are left out, and so are lines of too few points to be anything (fewer than 2; for a shore, 3).
[[nodiscard]] nlohmann::ordered_json placements_to_json(const Placements& placements);

/// The way back. Missing lists are empty, missing numbers have their defaults; unknown keys, values out of range and points
/// further than a million cells from the map's corner are Errors that begin with `where` and name the item and the key.
[[nodiscard]] Result<Placements> parse_placements(const nlohmann::ordered_json& json, const std::string& where);

/// The same from text.
[[nodiscard]] Result<Placements> parse_placements_text(std::string_view text, std::string_view origin);

/// A list of points, [[x, y], ...], as it stands in placements and in edit scripts.
[[nodiscard]] nlohmann::ordered_json points_to_json(const std::vector<PathPoint>& points);

}  // namespace biotope

#pragma once

#include <iosfwd>

#include "app/command_line_options.hpp"
#include "core/base/status.hpp"

namespace biotope {

/// Says what a DEM, scene or sample holds, a line a fact, without computing anything.
[[nodiscard]] Status run_info(const LandscapeRequest& request, std::ostream& out);

}  // namespace biotope

#pragma once

#include <iosfwd>
#include <string>

#include "app/command_line_options.hpp"
#include "core/base/status.hpp"

namespace biotope {

/// Where the editor cannot open: computes the landscape once and writes its maps and reports into `folder` and a picture of the
/// 3D view beside them, so that the command is never useless.
[[nodiscard]] Status run_without_display(const LandscapeRequest& request, const std::string& folder, std::ostream& out,
                                         std::ostream& err);

}  // namespace biotope

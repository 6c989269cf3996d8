#pragma once

#include <iosfwd>
#include <string>

#include "core/base/status.hpp"

namespace biotope {

/// Saves a built-in landscape with the default climate and species as a scene.
[[nodiscard]] Status run_sample(const std::string& name, const std::string& file, bool quiet, std::ostream& out,
                                std::ostream& err);

}  // namespace biotope

#pragma once

#include <iosfwd>
#include <string>

#include "app/command_line_options.hpp"
#include "core/base/status.hpp"

namespace biotope {

struct EditRequest {
  LandscapeRequest landscape;
  /// Edit script to play.
  std::string script;
  /// Scene to write.
  std::string scene;
  /// Folder for the maps and reports of the result; empty: none are written.
  std::string maps_folder;
  /// Solve the result from scratch too and compare.
  bool verify = false;
};

/// The command: plays an edit script on a landscape and saves what became of it as a scene. With `verify`, fails unless the maps
/// that were kept up to date from edit to edit equal those of the result computed from scratch, to the bit; nothing is written
/// then.
[[nodiscard]] Status run_edit(const EditRequest& request, std::ostream& out, std::ostream& err);

}  // namespace biotope

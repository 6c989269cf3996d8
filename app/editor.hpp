#pragma once

#include <string>

#include "core/base/status.hpp"
#include "core/exchange/dem_import.hpp"

namespace biotope {

/// How the editor starts.
struct EditorOptions {
  /// A scene, a DEM or "sample:NAME".
  std::string input = "sample:valley";
  DemImportOptions import;
};

/// True when a window can be opened (a display answers).
[[nodiscard]] bool display_available();

/// Opens the editor's window and runs until it is closed. Errors: no display, no OpenGL 4.5.
[[nodiscard]] Status run_editor(const EditorOptions& options);

}  // namespace biotope

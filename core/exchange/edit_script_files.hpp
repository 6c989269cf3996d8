#pragma once

#include <filesystem>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "core/base/grid.hpp"
#include "core/base/paint.hpp"
#include "core/base/status.hpp"
#include "core/exchange/edit_script.hpp"

namespace biotope {

/// What a script's files hold, by the names its entries use.
struct ScriptAttachments {
  /// Stamps (weights 0..1, any size) and images (values in the layer's unit, NaN: left alone).
  std::map<std::string, std::shared_ptr<const Grid<float>>> rasters;
  /// Paint of "mix" entries.
  std::map<std::string, std::shared_ptr<const PaintLayer>> paints;
  /// Selections of "mask" entries.
  std::map<std::string, std::shared_ptr<const SelectionMask>> masks;

  [[nodiscard]] bool empty() const { return rasters.empty() && paints.empty() && masks.empty(); }
  [[nodiscard]] bool contains(const std::string& name) const {
    return rasters.contains(name) || paints.contains(name) || masks.contains(name);
  }
};

/// Writes a script and, in the folder `<script's stem>-files` beside it, those attachments that its entries name; they get that
/// folder before the name, as do landscapes that "open" entries take from elsewhere: they are copied. Each file is written
/// atomically, the script last.
[[nodiscard]] Status save_edit_script(const std::filesystem::path& file, EditScript script,
                                      const ScriptAttachments& attachments = {});

/// Reads a script of a file and looks whether the files it names are there.
[[nodiscard]] Result<EditScript> load_edit_script(const std::filesystem::path& file);

/// Where a file that a script in `folder` names lies. An Error when it is not there, or lies elsewhere (a link that leads out).
[[nodiscard]] Result<std::filesystem::path> script_file(const std::filesystem::path& folder, const std::string& name);

/// Files that an entry names, groups included.
[[nodiscard]] std::vector<std::string> files_of(const ScriptEntry& entry);

}  // namespace biotope

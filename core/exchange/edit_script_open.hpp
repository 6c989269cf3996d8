#pragma once

#include <filesystem>
#include <string>

#include "core/base/status.hpp"
#include "core/exchange/edit_script.hpp"
#include "core/exchange/edit_script_json.hpp"

// "open" entries of edit scripts: another landscape takes the place of the one there is.

namespace biotope {

namespace script_json {

/// The keys of an "open" entry.
void write_open(Json& json, const OpenEntry& entry);
[[nodiscard]] OpenEntry read_open(JsonReader& reader, const EntryReading& at);

}  // namespace script_json

/// What the entry of a script in `folder` opens. Errors name the file.
[[nodiscard]] Result<Document> open_entry(const OpenEntry& entry, const std::filesystem::path& folder,
                                          const TaskContext& context);

/// Makes a file that lies anywhere one of a script in `folder`: the name of a file that lies in there already, relative to it;
/// else a copy, with the files that belong to it (a world file, a projection ...), in the folder `inside` of it.
[[nodiscard]] Result<std::string> bring_beside(const std::filesystem::path& file, const std::filesystem::path& folder,
                                               const std::string& inside);

}  // namespace biotope

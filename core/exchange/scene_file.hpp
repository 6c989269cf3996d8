#pragma once

#include <filesystem>

#include "core/base/status.hpp"
#include "core/document/document.hpp"

namespace biotope {

/// Version of the `.biotope` format this program writes and the newest it reads.
inline constexpr int scene_format_version = 1;

/// Saves a scene: a ZIP with scene.json, climate.json, species.json, terrain.tif and layers/*.tif, that any archive tool opens. Atomic.
[[nodiscard]] Status save_scene(const std::filesystem::path& file, const Document& document);

/// Opens a scene. A newer version, a truncated or corrupt file, a path that climbs out, an absurd size are Errors; nothing is changed.
[[nodiscard]] Result<Document> load_scene(const std::filesystem::path& file);

}  // namespace biotope

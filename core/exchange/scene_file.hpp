#pragma once

#include <filesystem>
#include <map>
#include <memory>
#include <string>

#include "core/base/status.hpp"
#include "core/document/document.hpp"

namespace biotope {

/// Version of the `.biotope` format this program writes and the newest it reads.
inline constexpr int scene_format_version = 2;

/// Packed rasters of the last save, so that one whose source is the same is not packed again. One save at a time may use it. It keeps the
/// sources alive.
struct SceneCache {
  struct Packed {
    std::shared_ptr<const void> source;
    std::shared_ptr<const std::string> bytes;
    std::string checksum;
  };
  /// By entry.
  std::map<std::string, Packed> entries;
};

/// Saves a scene: a ZIP with scene.json, climate.json, species.json, placements.json, terrain.tif, selection.tif and layers/*.tif, that any
/// archive tool opens. Atomic, and on the disk when it returns.
[[nodiscard]] Status save_scene(const std::filesystem::path& file, const Document& document, SceneCache* cache = nullptr);

/// Opens a scene. A newer version, a truncated or corrupt file, a path that climbs out, an absurd size are Errors; nothing is changed.
[[nodiscard]] Result<Document> load_scene(const std::filesystem::path& file);

}  // namespace biotope

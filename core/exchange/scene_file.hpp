#pragma once

#include <filesystem>
#include <map>
#include <memory>
#include <string>

#include "core/base/status.hpp"
#include "core/document/document.hpp"

namespace biotope {

/// Version of the `.biotope` format this program writes and the newest it reads.
inline constexpr int scene_format_version = 3;

/// Packed rasters of the last save, so that one whose source is the same is not packed again. One save at a time may use it. It
/// keeps the sources alive.
struct SceneCache {
  struct Packed {
    std::shared_ptr<const void> source;
    std::shared_ptr<const std::string> bytes;
    std::string checksum;
  };
  /// By entry.
  std::map<std::string, Packed> entries;
};

/// What is saved beside the document and read back as it is, such as views somebody wants to come back to (JSON); at most this
/// long.
inline constexpr std::size_t most_view_bytes = std::size_t(4) << 20;

/// Saves a scene: a ZIP with scene.json, climate.json, species.json, placements.json, terrain.tif, selection.tif and
/// layers/*.tif, that any archive tool opens. Atomic, and on the disk when it returns. `views`, where not empty, becomes the
/// entry views.json; longer than `most_view_bytes` it is an Error.
[[nodiscard]] Status save_scene(const std::filesystem::path& file, const Document& document, SceneCache* cache = nullptr,
                                const std::string& views = {});

/// Opens a scene. A newer version, a truncated or corrupt file, a path that climbs out, an absurd size are Errors; nothing is
/// changed.
[[nodiscard]] Result<Document> load_scene(const std::filesystem::path& file);
/// Views saved with a scene: their text, empty when there are none, and what is wrong with the entry, empty when nothing is. Text
/// that was changed or damaged is given all the same, as far as it could be read: who reads it keeps what of it makes sense.
struct SceneViews {
  std::string text;
  std::string damage;
};
[[nodiscard]] Result<SceneViews> load_scene_views(const std::filesystem::path& file);

}  // namespace biotope

#pragma once

#include <array>
#include <map>
#include <span>
#include <string>
#include <vector>

#include "core/base/status.hpp"
#include "core/document/document.hpp"

namespace biotope {

/// The table of contents of a scene: everything of a Document that is no raster, and which entries hold the rasters.
struct SceneManifest {
  std::string title;
  std::uint64_t seed = 1;
  std::map<int, bool> use_proportions;
  std::vector<Inflow> inflows;

  int width = 0;
  int height = 0;
  double cell_size = 1;
  double latitude = 0;
  Georeference georeference;
  std::string terrain_name;
  bool has_voids = false;

  struct Layer {
    LayerId id;
    std::string file;
  };
  std::vector<Layer> layers;
  std::map<LayerId, LayerState> layer_states;
  bool has_selection = false;
  bool has_locked_area = false;
  bool has_placements = false;
  /// Resources whose twelve months are given, and whether geology is.
  std::array<bool, monthly_resources> given_months{};
  bool given_geology = false;

  /// Of every other entry, by name.
  std::map<std::string, std::string> checksums;
};

/// What scenes and edit scripts call the kinds of layers, in the order of LayerKind.
[[nodiscard]] std::span<const std::string> layer_kind_names();
/// Names that layers of a kind may have; nothing for kinds that are named after species.
[[nodiscard]] std::span<const std::string> layer_names(LayerKind kind);

/// What a document says of itself; layers get their file names, checksums are left empty.
[[nodiscard]] SceneManifest manifest_of(const Document& document);

[[nodiscard]] std::string manifest_to_json(const SceneManifest& manifest);
/// Reads and validates; messages begin with `origin`. A newer format version is an Error that says so.
[[nodiscard]] Result<SceneManifest> parse_manifest(const std::string& json, const std::string& origin);

/// Name of a given monthly map in a scene (month 0 is January).
[[nodiscard]] std::string given_month_entry(int resource, int month);
inline constexpr const char* given_geology_entry = "environment/geology.tif";

}  // namespace biotope

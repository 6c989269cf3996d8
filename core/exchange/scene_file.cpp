#include "core/exchange/scene_file.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <nlohmann/json.hpp>
#include <optional>

#include "core/base/parallel.hpp"
#include "core/exchange/placements_json.hpp"
#include "core/exchange/scene_archive.hpp"
#include "core/exchange/scene_json.hpp"
#include "core/exchange/scene_raster.hpp"
#include "core/species/species_library.hpp"

namespace biotope {
namespace {

constexpr std::uint64_t most_json_bytes = std::uint64_t(32) << 20;
constexpr const char* manifest_entry = "scene.json";
constexpr const char* climate_entry = "climate.json";
constexpr const char* species_entry = "species.json";
constexpr const char* terrain_entry = "terrain.tif";
constexpr const char* voids_entry = "voids.tif";
constexpr const char* selection_entry = "selection.tif";
constexpr const char* locked_area_entry = "locked-area.tif";
constexpr const char* placements_entry = "placements.json";
constexpr const char* views_entry = "views.json";

/// A raster of the scene, what it is made from and how it is packed.
struct Packing {
  std::string entry;
  std::shared_ptr<const void> source;
  std::function<Result<std::string>()> pack;
};

Grid<std::uint8_t> as_bytes(const Grid<Geology>& geology) {
  Grid<std::uint8_t> bytes(geology.width(), geology.height());
  std::transform(geology.cells().begin(), geology.cells().end(), bytes.cells().begin(),
                 [](Geology rock) { return std::uint8_t(rock); });
  return bytes;
}

/// The classes that paint of a kind may hold; geology may lie between two where a soft brush mixed them.
std::optional<Range> legal_values(LayerKind kind) {
  if (kind == LayerKind::geology) return Range{0, float(geology_classes - 1)};
  return std::nullopt;
}

bool lies_within(const PaintLayer& layer, const Range& range) {
  const auto legal = [&](const Paint& paint) { return paint.value >= range.low && paint.value <= range.high; };
  for (std::size_t i = 0; i < layer.tile_count(); ++i) {
    const auto& tile = layer.tile(i);
    if (tile && !std::all_of(tile->begin(), tile->end(), legal)) return false;
  }
  return true;
}

/// Paint as it can be read again: values out of range are brought to the nearest legal one.
std::shared_ptr<const PaintLayer> legal_paint(std::shared_ptr<const PaintLayer> layer, LayerKind kind) {
  const auto range = legal_values(kind);
  if (!range || lies_within(*layer, *range)) return layer;
  auto legal = std::make_shared<PaintLayer>(*layer);
  for (std::size_t i = 0; i < legal->tile_count(); ++i) {
    if (!legal->tile(i)) continue;
    for (Paint& paint : legal->edit_tile(i)) paint.value = std::clamp(paint.value, range->low, range->high);
  }
  return legal;
}

std::vector<Packing> packings(const Document& document, const SceneManifest& manifest) {
  const Terrain& terrain = *document.terrain;
  std::vector<Packing> list;
  list.push_back({terrain_entry, document.terrain, [&terrain] { return encode_floats(terrain.height, terrain.georeference); }});
  if (manifest.has_voids) list.push_back({voids_entry, document.terrain, [&terrain] { return encode_bytes(terrain.voids); }});
  for (const auto& layer : manifest.layers) {
    const auto& paint = document.layers.at(layer.id);
    list.push_back({layer.file, paint, [paint, kind = layer.id.kind] { return encode_paint(*legal_paint(paint, kind)); }});
  }
  if (const auto& mask = document.selection) list.push_back({selection_entry, mask, [mask] { return encode_selection(*mask); }});
  if (const auto& mask = document.locked_area)
    list.push_back({locked_area_entry, mask, [mask] { return encode_selection(*mask); }});
  for (int resource = 0; resource < monthly_resources; ++resource) {
    const auto& maps = document.given_environment.monthly[std::size_t(resource)];
    for (int month = 0; month < int(maps.size()); ++month) {
      const auto& map = maps[std::size_t(month)];
      list.push_back(
          {given_month_entry(resource, month), map, [map, &terrain] { return encode_floats(*map, terrain.georeference); }});
    }
  }
  if (const auto& geology = document.given_environment.geology) {
    list.push_back({given_geology_entry, geology, [geology] { return encode_bytes(as_bytes(*geology)); }});
  }
  return list;
}

/// The packed raster, from the cache when it is of the same source.
Result<SceneCache::Packed> pack(const Packing& raster, const SceneCache* cache) {
  if (cache != nullptr) {
    const auto kept = cache->entries.find(raster.entry);
    if (kept != cache->entries.end() && kept->second.source == raster.source) return kept->second;
  }
  auto bytes = raster.pack();
  if (!bytes) return tl::unexpected(bytes.error());
  SceneCache::Packed packed{raster.source, nullptr, checksum(*bytes)};
  packed.bytes = std::make_shared<const std::string>(std::move(*bytes));
  return packed;
}

/// Reads entries of one scene and checks each against the manifest's checksum.
class SceneReader {
 public:
  SceneReader(const ArchiveReader& archive, const SceneManifest& manifest, std::string file)
      : archive_(archive), manifest_(manifest), file_(std::move(file)) {}

  [[nodiscard]] Result<std::string> entry(const std::string& name, std::uint64_t most_bytes) const {
    auto bytes = archive_.read(name, most_bytes);
    if (!bytes) return bytes;
    const auto sum = manifest_.checksums.find(name);
    if (sum == manifest_.checksums.end() || sum->second != checksum(*bytes)) {
      return fail(label(name) + " is damaged or was changed outside Biotope: its checksum is wrong.");
    }
    return bytes;
  }
  [[nodiscard]] Result<Grid<float>> floats(const std::string& name) const {
    const auto bytes = entry(name, most_raster_bytes(4));
    if (!bytes) return tl::unexpected(bytes.error());
    auto cells = decode_floats(*bytes, manifest_.width, manifest_.height, label(name));
    if (!cells) return cells;
    const auto finite = [](float value) { return std::isfinite(value); };
    if (!std::all_of(cells->cells().begin(), cells->cells().end(), finite)) {
      return fail(label(name) + " is damaged: a cell is no number.");
    }
    return cells;
  }
  [[nodiscard]] Result<Grid<std::uint8_t>> bytes(const std::string& name, int most) const {
    const auto packed = entry(name, most_raster_bytes(1));
    if (!packed) return tl::unexpected(packed.error());
    auto cells = decode_bytes(*packed, manifest_.width, manifest_.height, label(name));
    if (!cells) return cells;
    const auto fits = [&](std::uint8_t value) { return value <= most; };
    if (!std::all_of(cells->cells().begin(), cells->cells().end(), fits)) {
      return fail(label(name) + " is damaged: a cell is more than " + std::to_string(most) + ".");
    }
    return cells;
  }
  [[nodiscard]] Result<PaintLayer> paint(const std::string& name) const {
    const auto packed = entry(name, most_raster_bytes(8));
    if (!packed) return tl::unexpected(packed.error());
    return decode_paint(*packed, manifest_.width, manifest_.height, label(name));
  }
  [[nodiscard]] Result<SelectionMask> selection(const std::string& name) const {
    const auto packed = entry(name, most_raster_bytes(1));
    if (!packed) return tl::unexpected(packed.error());
    return decode_selection(*packed, manifest_.width, manifest_.height, label(name));
  }
  [[nodiscard]] std::string label(const std::string& name) const { return file_ + ": " + name; }

 private:
  /// Incompressible cells grow a little in DEFLATE, and a TIFF lists its blocks.
  [[nodiscard]] std::uint64_t most_raster_bytes(std::uint64_t bytes_a_cell) const {
    const std::uint64_t cells = (std::uint64_t(manifest_.width) + 256) * (std::uint64_t(manifest_.height) + 256);
    return cells * bytes_a_cell * 5 / 4 + (std::uint64_t(1) << 20);
  }

  const ArchiveReader& archive_;
  const SceneManifest& manifest_;
  std::string file_;
};

Status read_biology(const SceneReader& reader, Document& document) {
  const auto climate_text = reader.entry(climate_entry, most_json_bytes);
  if (!climate_text) return tl::unexpected(climate_text.error());
  auto climate = parse_climate(*climate_text, reader.label(climate_entry));
  if (!climate) return tl::unexpected(climate.error());
  document.climate = std::move(*climate);
  const auto species_text = reader.entry(species_entry, most_json_bytes);
  if (!species_text) return tl::unexpected(species_text.error());
  auto species = parse_species(*species_text, reader.label(species_entry));
  if (!species) return tl::unexpected(species.error());
  document.species = std::make_shared<const std::vector<Species>>(std::move(*species));
  return {};
}

Status read_terrain(const SceneReader& reader, const SceneManifest& manifest, Document& document) {
  Terrain terrain;
  auto height = reader.floats(terrain_entry);
  if (!height) return tl::unexpected(height.error());
  terrain.height = std::move(*height);
  if (manifest.has_voids) {
    auto voids = reader.bytes(voids_entry, 1);
    if (!voids) return tl::unexpected(voids.error());
    terrain.voids = std::move(*voids);
  }
  terrain.cell_size = manifest.cell_size;
  terrain.latitude = manifest.latitude;
  terrain.georeference = manifest.georeference;
  terrain.name = manifest.terrain_name;
  document.terrain = std::make_shared<const Terrain>(std::move(terrain));
  return {};
}

Status read_paint(const SceneReader& reader, const SceneManifest& manifest, Document& document) {
  for (const auto& layer : manifest.layers) {
    auto paint = reader.paint(layer.file);
    if (!paint) return tl::unexpected(paint.error());
    if (const auto range = legal_values(layer.id.kind); range && !lies_within(*paint, *range)) {
      return fail(reader.label(layer.file) + " is damaged: paint out of range for a layer of " +
                  layer_kind_names()[std::size_t(layer.id.kind)] + ".");
    }
    document.layers[layer.id] = std::make_shared<const PaintLayer>(std::move(*paint));
  }
  document.layer_states = manifest.layer_states;
  return {};
}

Status read_masks(const SceneReader& reader, const SceneManifest& manifest, Document& document) {
  const auto read = [&](bool is_there, const char* entry, std::shared_ptr<const SelectionMask>& target) -> Status {
    if (!is_there) return {};
    auto mask = reader.selection(entry);
    if (!mask) return tl::unexpected(mask.error());
    target = std::make_shared<const SelectionMask>(std::move(*mask));
    return {};
  };
  if (const Status done = read(manifest.has_selection, selection_entry, document.selection); !done) return done;
  return read(manifest.has_locked_area, locked_area_entry, document.locked_area);
}

Status read_placements(const SceneReader& reader, const SceneManifest& manifest, Document& document) {
  if (!manifest.has_placements) return {};
  const auto text = reader.entry(placements_entry, most_json_bytes);
  if (!text) return tl::unexpected(text.error());
  auto placements = parse_placements_text(*text, reader.label(placements_entry));
  if (!placements) return tl::unexpected(placements.error());
  document.placements = std::move(*placements);
  return {};
}

Status read_given_environment(const SceneReader& reader, const SceneManifest& manifest, Document& document) {
  for (int resource = 0; resource < monthly_resources; ++resource) {
    if (!manifest.given_months[std::size_t(resource)]) continue;
    for (int month = 0; month < months; ++month) {
      auto map = reader.floats(given_month_entry(resource, month));
      if (!map) return tl::unexpected(map.error());
      document.given_environment.monthly[std::size_t(resource)].push_back(std::make_shared<const Grid<float>>(std::move(*map)));
    }
  }
  if (!manifest.given_geology) return {};
  const auto classes = reader.bytes(given_geology_entry, geology_classes - 1);
  if (!classes) return tl::unexpected(classes.error());
  auto geology = std::make_shared<Grid<Geology>>(classes->width(), classes->height());
  std::transform(classes->cells().begin(), classes->cells().end(), geology->cells().begin(),
                 [](std::uint8_t value) { return Geology(value); });
  document.given_environment.geology = std::move(geology);
  return {};
}

/// Nothing is saved that cannot be opened: the file that is there stays, and a person can put right what the message names.
Status check_readable_again(const ArchiveEntries& texts) {
  if (const auto manifest = parse_manifest(texts.at(manifest_entry), manifest_entry); !manifest)
    return tl::unexpected(manifest.error());
  if (const auto climate = parse_climate(texts.at(climate_entry), climate_entry); !climate)
    return tl::unexpected(climate.error());
  if (const auto species = parse_species(texts.at(species_entry), species_entry); !species)
    return tl::unexpected(species.error());
  const auto text = texts.find(placements_entry);
  if (text == texts.end()) return {};
  if (const auto placements = parse_placements_text(text->second, placements_entry); !placements)
    return tl::unexpected(placements.error());
  return {};
}

}  // namespace

Status save_scene(const std::filesystem::path& file, const Document& document, SceneCache* cache, const std::string& views) {
  assert(document.terrain && document.species);
  if (views.size() > most_view_bytes) {
    return fail(file.string() + ": is not saved, because its bookmarks and camera path take more than " +
                std::to_string(most_view_bytes >> 20) + " MiB.");
  }
  SceneManifest manifest = manifest_of(document);
  const auto list = packings(document, manifest);
  std::vector<Result<SceneCache::Packed>> packed(list.size(), SceneCache::Packed());
  parallel_each(list.size(), [&](std::size_t i) { packed[i] = pack(list[i], cache); });

  ArchiveViews entries;
  SceneCache kept;
  for (std::size_t i = 0; i < list.size(); ++i) {
    if (!packed[i]) return fail(file.string() + ": " + packed[i].error().message);
    entries[list[i].entry] = *packed[i]->bytes;
    manifest.checksums[list[i].entry] = packed[i]->checksum;
    kept.entries[list[i].entry] = *packed[i];
  }
  ArchiveEntries texts{{climate_entry, climate_to_json(document.climate)}, {species_entry, species_to_json(*document.species)}};
  if (manifest.has_placements) texts[placements_entry] = placements_to_json(document.placements).dump(1) + "\n";
  if (!views.empty()) texts[views_entry] = views;
  for (const auto& [name, text] : texts) manifest.checksums[name] = checksum(text);
  texts[manifest_entry] = manifest_to_json(manifest);
  entries.insert(texts.begin(), texts.end());
  if (const Status readable = check_readable_again(texts); !readable) {
    return fail(file.string() + ": is not saved, because it could not be opened again: " + readable.error().message);
  }
  if (cache != nullptr) *cache = std::move(kept);
  return write_archive_views(file, entries);
}

Result<Document> load_scene(const std::filesystem::path& file) {
  const auto archive = ArchiveReader::open(file);
  if (!archive) return tl::unexpected(archive.error());
  const auto text = archive->read(manifest_entry, most_json_bytes);
  if (!text) return tl::unexpected(text.error());
  const auto manifest = parse_manifest(*text, file.string() + ": " + manifest_entry);
  if (!manifest) return tl::unexpected(manifest.error());

  Document document;
  document.title = manifest->title;
  document.seed = manifest->seed;
  document.use_proportions = manifest->use_proportions;
  document.inflows = manifest->inflows;
  const SceneReader reader(*archive, *manifest, file.string());
  if (const Status biology = read_biology(reader, document); !biology) return tl::unexpected(biology.error());
  for (const auto& read_part : {read_terrain, read_paint, read_masks, read_placements, read_given_environment}) {
    if (const Status part = read_part(reader, *manifest, document); !part) return tl::unexpected(part.error());
  }
  return document;
}

Result<SceneViews> load_scene_views(const std::filesystem::path& file) {
  const auto archive = ArchiveReader::open(file);
  if (!archive) return tl::unexpected(archive.error());
  const auto text = archive->read(manifest_entry, most_json_bytes);
  if (!text) return tl::unexpected(text.error());
  const auto manifest = parse_manifest(*text, file.string() + ": " + manifest_entry);
  if (!manifest) return tl::unexpected(manifest.error());
  const auto sum = manifest->checksums.find(views_entry);
  if (sum == manifest->checksums.end()) return SceneViews();
  auto part = archive->read_part(views_entry, most_view_bytes);
  if (!part) return tl::unexpected(part.error());
  SceneViews views{std::move(part->bytes), {}};
  if (!part->whole) {
    views.damage = file.string() + ": " + views_entry + " is damaged: its checksum is wrong or bytes are missing";
  } else if (sum->second != checksum(views.text)) {
    views.damage = file.string() + ": " + views_entry + " was changed outside Biotope: its checksum is wrong";
  }
  return views;
}

}  // namespace biotope

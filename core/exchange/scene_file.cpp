#include "core/exchange/scene_file.hpp"

#include <algorithm>
#include <cmath>
#include <functional>

#include "core/base/parallel.hpp"
#include "core/exchange/scene_archive.hpp"
#include "core/exchange/scene_json.hpp"
#include "core/exchange/scene_raster.hpp"
#include "core/species/species_library.hpp"

namespace biotope {
namespace {

constexpr std::uint64_t most_json_bytes = std::uint64_t(64) << 20;
constexpr const char* manifest_entry = "scene.json";
constexpr const char* climate_entry = "climate.json";
constexpr const char* species_entry = "species.json";
constexpr const char* terrain_entry = "terrain.tif";
constexpr const char* voids_entry = "voids.tif";

/// A raster of the scene and how it is packed.
struct Packing {
  std::string entry;
  std::function<Result<std::string>()> pack;
};

Grid<std::uint8_t> as_bytes(const Grid<Geology>& geology) {
  Grid<std::uint8_t> bytes(geology.width(), geology.height());
  std::transform(geology.cells().begin(), geology.cells().end(), bytes.cells().begin(),
                 [](Geology rock) { return std::uint8_t(rock); });
  return bytes;
}

std::vector<Packing> packings(const Document& document, const SceneManifest& manifest) {
  const Terrain& terrain = *document.terrain;
  std::vector<Packing> list;
  list.push_back({terrain_entry, [&terrain] { return encode_floats(terrain.height, terrain.georeference); }});
  if (manifest.has_voids) list.push_back({voids_entry, [&terrain] { return encode_bytes(terrain.voids); }});
  for (const auto& layer : manifest.layers) {
    const PaintLayer* paint = document.layers.at(layer.id).get();
    list.push_back({layer.file, [paint] { return encode_paint(*paint); }});
  }
  for (int resource = 0; resource < monthly_resources; ++resource) {
    const auto& maps = document.given_environment.monthly[std::size_t(resource)];
    for (int month = 0; month < int(maps.size()); ++month) {
      const Grid<float>* map = maps[std::size_t(month)].get();
      list.push_back({given_month_entry(resource, month),
                      [map, &terrain] { return encode_floats(*map, terrain.georeference); }});
    }
  }
  if (const auto* geology = document.given_environment.geology.get()) {
    list.push_back({given_geology_entry, [geology] { return encode_bytes(as_bytes(*geology)); }});
  }
  return list;
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
    document.layers[layer.id] = std::make_shared<const PaintLayer>(std::move(*paint));
  }
  return {};
}

Status read_given_environment(const SceneReader& reader, const SceneManifest& manifest, Document& document) {
  for (int resource = 0; resource < monthly_resources; ++resource) {
    if (!manifest.given_months[std::size_t(resource)]) continue;
    for (int month = 0; month < months; ++month) {
      auto map = reader.floats(given_month_entry(resource, month));
      if (!map) return tl::unexpected(map.error());
      document.given_environment.monthly[std::size_t(resource)].push_back(
          std::make_shared<const Grid<float>>(std::move(*map)));
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

}  // namespace

Status save_scene(const std::filesystem::path& file, const Document& document) {
  assert(document.terrain && document.species);
  SceneManifest manifest = manifest_of(document);
  const auto list = packings(document, manifest);
  std::vector<Result<std::string>> packed(list.size(), std::string());
  parallel_each(list.size(), [&](std::size_t i) { packed[i] = list[i].pack(); });

  ArchiveEntries entries;
  for (std::size_t i = 0; i < list.size(); ++i) {
    if (!packed[i]) return fail(file.string() + ": " + packed[i].error().message);
    entries[list[i].entry] = std::move(*packed[i]);
  }
  entries[climate_entry] = climate_to_json(document.climate);
  entries[species_entry] = species_to_json(*document.species);
  for (const auto& [name, bytes] : entries) manifest.checksums[name] = checksum(bytes);
  entries[manifest_entry] = manifest_to_json(manifest);
  return write_archive(file, entries);
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
  for (const Status& part : {read_biology(reader, document), read_terrain(reader, *manifest, document),
                             read_paint(reader, *manifest, document),
                             read_given_environment(reader, *manifest, document)}) {
    if (!part) return tl::unexpected(part.error());
  }
  return document;
}

}  // namespace biotope

#include "app/info_command.hpp"

#include <algorithm>
#include <ostream>

#include "app/solve_command.hpp"
#include "core/exchange/open_input.hpp"

namespace biotope {
namespace {

const char* kind_name(LayerKind kind) {
  switch (kind) {
    case LayerKind::resource:
      return "resource";
    case LayerKind::plant_density:
      return "plant density";
    case LayerKind::animal_density:
      return "animal density";
    case LayerKind::geology:
      return "geology";
    case LayerKind::loss:
      return "growth lost";
    case LayerKind::passage:
      return "obstacles and passages";
    case LayerKind::ground:
      return "ground height";
  }
  return "";
}

void print_voids(std::ostream& out, std::size_t voids, std::size_t cells) {
  out << "voids: " << voids << " of " << cells << " cells (" << 100.0 * double(voids) / double(cells) << " %)\n";
}

Status print_dem(const LandscapeRequest& request, std::ostream& out) {
  const auto preview = preview_dem(request.input, request.import);
  if (!preview) return tl::unexpected(preview.error());
  out << "file: " << preview->file.string() << '\n'
      << "format: " << preview->format << ", " << preview->sample_type << ", bands: " << preview->bands << '\n'
      << "size: " << preview->width << " x " << preview->height << " cells\n";
  if (preview->cell_size) {
    out << "cell size: " << *preview->cell_size << " m\n";
  } else {
    out << "cell size: unknown; give --cell-size M\n";
  }
  out << "range: " << preview->lowest << " to " << preview->highest << " m\n";
  print_voids(out, preview->void_cells, preview->total_cells);
  out << "crs: " << (preview->crs_name.empty() ? "none" : preview->crs_name) << (preview->geographic ? " (degrees)" : "") << '\n';
  for (const std::string& note : preview->notes) out << "note: " << note << '\n';
  return {};
}

/// The name at the beginning of a WKT: its first quoted text.
std::string crs_name(const std::string& wkt) {
  const std::size_t from = wkt.find('"');
  const std::size_t to = wkt.find('"', from + 1);
  return from == std::string::npos || to == std::string::npos ? "none" : wkt.substr(from + 1, to - from - 1);
}

void print_terrain(const Terrain& terrain, std::ostream& out) {
  const auto cells = terrain.height.cells();
  const auto [lowest, highest] = std::minmax_element(cells.begin(), cells.end());
  out << "size: " << terrain.height.width() << " x " << terrain.height.height() << " cells\n"
      << "cell size: " << terrain.cell_size << " m\n"
      << "range: " << *lowest << " to " << *highest << " m\n";
  print_voids(out, std::size_t(std::count(terrain.voids.cells().begin(), terrain.voids.cells().end(), 1)), cells.size());
  out << "crs: " << crs_name(terrain.georeference.wkt) << '\n' << "latitude: " << terrain.latitude << '\n';
}

void print_document(const Document& document, std::ostream& out) {
  out << "title: " << document.title << '\n';
  print_terrain(*document.terrain, out);
  out << "seed: " << document.seed << '\n'
      << "climate: " << document.climate.name << " (" << document.climate.title << ")\n"
      << "inflows: " << document.inflows.size() << '\n'
      << "species: " << document.species->size() << '\n';
  for (const Species& species : *document.species) {
    out << "  " << species.name << (species.is_plant() ? " (plant)" : " (animal)") << '\n';
  }
  out << "layers: " << document.layers.size() << '\n';
  for (const auto& [id, layer] : document.layers) out << "  " << kind_name(id.kind) << ": " << id.name << '\n';
}

}  // namespace

Status run_info(const LandscapeRequest& request, std::ostream& out) {
  if (!request.input.starts_with("sample:") && !is_scene_file(request.input)) return print_dem(request, out);
  const auto document = open_requested(request, {});
  if (!document) return tl::unexpected(document.error());
  print_document(*document, out);
  return {};
}

}  // namespace biotope

#include "ui/layer_actions.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/exchange/geotiff.hpp"
#include "core/exchange/layer_image.hpp"
#include "ui/edit_actions.hpp"
#include "ui/editor_actions.hpp"
#include "ui/paint_targets.hpp"
#include "ui/widgets.hpp"

namespace biotope {
namespace {

bool holds_paint(const PaintLayer& layer) {
  for (std::size_t tile = 0; tile < layer.tile_count(); ++tile) {
    if (layer.tile(tile)) return true;
  }
  return false;
}

/// Changes a layer's state; the default one is not kept.
void change_state(Document& document, const LayerId& layer, const std::function<void(LayerState&)>& change) {
  LayerState changed = document.layer_states[layer];
  change(changed);
  if (changed == LayerState{}) {
    document.layer_states.erase(layer);
  } else {
    document.layer_states[layer] = changed;
  }
}

void set_locked(Document& document, const LayerId& layer, bool locked) {
  change_state(document, layer, [locked](LayerState& changed) { changed.locked = locked; });
}

void change_state(EditorState& state, const std::string& name, const LayerId& layer,
                  const std::function<void(LayerState&)>& change) {
  perform_edit(state, PartsEdit{name, [layer, change](Document& document) { change_state(document, layer, change); }});
}

/// Paint with its values brought from one range to another.
PaintLayer rescaled_paint(PaintLayer paint, const LayerLimits& from, const LayerLimits& to) {
  const float factor = (to.high - to.low) / std::max(from.high - from.low, 1e-6F);
  for (std::size_t tile = 0; tile < paint.tile_count(); ++tile) {
    if (!paint.tile(tile)) continue;
    for (Paint& cell : paint.edit_tile(tile)) {
      if (cell.coverage > 0) cell.value = to.low + (cell.value - from.low) * factor;
    }
  }
  return paint;
}

bool has_ending(const std::filesystem::path& file, const char* ending) { return file.extension() == ending; }

Status write_map(const std::filesystem::path& file, const LayerId& layer, const Grid<float>& map, const Terrain& terrain) {
  if (!has_ending(file, ".png")) return write_geotiff(file, map, terrain);
  if (layer.kind == LayerKind::geology) return write_geology_png(file, map, terrain);
  const auto written = write_map_png(file, map, terrain, usual_range(layer));
  return written ? Status{} : Status{tl::unexpected(written.error())};
}

Status write_paint(const std::filesystem::path& file, const LayerId& layer, const PaintLayer& paint, const Terrain& terrain) {
  if (!has_ending(file, ".png")) return write_paint_geotiff(file, paint, terrain);
  const auto written = write_paint_png(file, paint, terrain, usual_range(layer));
  return written ? Status{} : Status{tl::unexpected(written.error())};
}

FileRequest export_request(const EditorState& state, const LayerId& layer, const std::string& what) {
  FileRequest request;
  request.title = "Export " + what + ": " + layer_title(layer, state.web());
  request.action = "Export";
  request.saving = true;
  request.browser.endings = {".tif", ".tiff", ".png"};
  request.browser.name = layer.name + ".tif";
  return request;
}

}  // namespace

std::vector<LayerId> listed_layers(const Document& document) {
  std::vector<LayerId> layers;
  for (const auto& [id, paint] : document.layers) {
    if (paint && holds_paint(*paint)) layers.push_back(id);
  }
  for (const auto& [id, layer_state] : document.layer_states) {
    if (std::find(layers.begin(), layers.end(), id) == layers.end()) layers.push_back(id);
  }
  std::sort(layers.begin(), layers.end());
  return layers;
}

void choose_layer(EditorState& state, const LayerId& layer) {
  const FoodWeb* web = state.web();
  if (web == nullptr) return;
  const bool of_species =
      layer.kind == LayerKind::plant_density || layer.kind == LayerKind::animal_density || layer.kind == LayerKind::loss;
  if (of_species) {
    const int species = web->find(layer.name);
    if (species < 0) return;
    select_species(state, species);
  }
  show_layer(state, layer);
}

void set_layer_hidden(EditorState& state, const LayerId& layer, bool hidden) {
  const std::string name = (hidden ? "Hide " : "Show ") + layer_title(layer, state.web());
  change_state(state, name, layer, [hidden](LayerState& changed) { changed.hidden = hidden; });
}

void set_layer_locked(EditorState& state, const LayerId& layer, bool locked) {
  const std::string name = (locked ? "Lock " : "Unlock ") + layer_title(layer, state.web());
  change_state(state, name, layer, [locked](LayerState& changed) { changed.locked = locked; });
}

namespace {

LayerId density_layer(const Species& species) {
  return {species.is_plant() ? LayerKind::plant_density : LayerKind::animal_density, species.name};
}

}  // namespace

bool species_locked(const Document& document, const Species& species) { return is_locked(document, density_layer(species)); }

void set_species_locked(EditorState& state, const Species& species, bool locked) {
  const std::string name = (locked ? "Lock " : "Unlock ") + display_name(species);
  const std::array<LayerId, 2> layers{density_layer(species), LayerId{LayerKind::loss, species.name}};
  perform_edit(state, PartsEdit{name, [layers, locked](Document& document) {
                                  for (const LayerId& layer : layers) set_locked(document, layer, locked);
                                }});
}

void copy_layer(EditorState& state, const LayerId& layer) {
  const auto found = state.document.layers.find(layer);
  if (found == state.document.layers.end()) return;
  state.copied = CopiedPaint{layer, found->second, layer_title(layer, state.web())};
  announce(state, "Copied the paint of " + state.copied->title);
}

PaintLayer resampled_paint(const PaintLayer& paint, int width, int height) {
  PaintLayer result(width, height);
  for (int y = 0; y < height; ++y) {
    const int from_y = std::min(int((double(y) + 0.5) * paint.height() / height), paint.height() - 1);
    for (int x = 0; x < width; ++x) {
      const int from_x = std::min(int((double(x) + 0.5) * paint.width() / width), paint.width() - 1);
      const Paint cell = paint(from_x, from_y);
      if (cell.coverage > 0) result.set(x, y, cell);
    }
  }
  return result;
}

void paste_layer(EditorState& state, const LayerId& into, LayerMix mix) {
  if (!state.copied || !state.has_document) return;
  std::shared_ptr<const PaintLayer> paint = state.copied->paint;
  const Grid<float>& height = state.document.terrain->height;
  if (paint->rect() != height.rect())
    paint = std::make_shared<PaintLayer>(resampled_paint(*paint, height.width(), height.height()));
  if (state.copied->from.kind != into.kind) {
    paint = std::make_shared<PaintLayer>(rescaled_paint(*paint, limits_of(state, state.copied->from), limits_of(state, into)));
  }
  perform_edit(state, MixEdit{into, state.copied->from, std::move(paint), mix});
}

void mix_layers(EditorState& state, const LayerId& into, const LayerId& from, LayerMix mix) {
  const auto found = state.document.layers.find(from);
  const bool scaled = into.kind != from.kind && found != state.document.layers.end();
  std::shared_ptr<const PaintLayer> paint;
  if (scaled)
    paint = std::make_shared<PaintLayer>(rescaled_paint(*found->second, limits_of(state, from), limits_of(state, into)));
  perform_edit(state, MixEdit{into, from, std::move(paint), mix});
}

void offer_image(EditorState& state, const LayerId& layer, const std::filesystem::path& file) {
  if (!state.has_document) return;
  const auto facts = look_at_image(file);
  if (!facts) {
    complain(state, "The image was not imported", facts.error());
    return;
  }
  // The Enter that chose the file is not the one that imports it.
  (void)take_key(state, DialogKey::enter);
  state.image_import = offered_import(state, layer, file, *facts);
  state.dialogs.import_image = true;
}

void import_layer_image(EditorState& state, const LayerId& layer) {
  FileRequest request;
  request.title = "Import an image as " + layer_title(layer, state.web());
  request.action = "Import";
  request.browser.endings = {".png", ".jpg", ".jpeg", ".tif", ".tiff", ".bmp", ".exr", ".asc"};
  request.then = [layer](EditorState& later, const std::filesystem::path& file) { offer_image(later, layer, file); };
  ask_for_file(state, std::move(request));
}

void export_layer_paint(EditorState& state, const LayerId& layer) {
  FileRequest request = export_request(state, layer, "paint");
  request.then = [layer](EditorState& later, const std::filesystem::path& file) {
    const auto found = later.document.layers.find(layer);
    if (!later.has_document || found == later.document.layers.end()) return;
    later.exporting.start(
        file.filename().string(),
        [file, layer, paint = found->second, terrain = later.document.terrain](const TaskContext&) -> Result<bool> {
          const Status written = write_paint(file, layer, *paint, *terrain);
          if (!written) return tl::unexpected(written.error());
          return true;
        });
  };
  ask_for_file(state, std::move(request));
}

void export_layer_map(EditorState& state, const LayerId& layer) {
  FileRequest request = export_request(state, layer, "map");
  request.then = [layer](EditorState& later, const std::filesystem::path& file) {
    if (!later.has_document || !later.shown) return;
    later.exporting.start(
        file.filename().string(),
        [file, layer, paint = active_paint(later.document, layer), snapshot = later.shown](const TaskContext&) -> Result<bool> {
          const auto map = final_map(layer.kind, computed_under(*snapshot, layer), paint.get());
          if (!map) return fail("The map is still being computed. Export it a little later.");
          const Status written = write_map(file, layer, *map, *snapshot->document.terrain);
          if (!written) return tl::unexpected(written.error());
          return true;
        });
  };
  ask_for_file(state, std::move(request));
}

void advance_layer_files(EditorState& state) {
  if (auto read = state.importing.take()) {
    if (!*read) {
      complain(state, "The image was not imported", read->error());
    } else {
      choose_layer(state, (*read)->layer);
      perform_edit(state, std::move(**read));
    }
  }
  const std::string file = state.exporting.what();
  if (auto written = state.exporting.take()) {
    if (!*written) {
      complain(state, "The layer was not exported", written->error());
    } else {
      announce(state, "Exported " + file);
    }
  }
}

}  // namespace biotope

#pragma once

#include "ui/editor_state.hpp"

namespace biotope {

// What can be done with layers of paint as a whole. Every change is one step of the history.

/// The layers a list shows: those that hold paint or have a state of their own.
[[nodiscard]] std::vector<LayerId> listed_layers(const Document& document);
/// Looks at a layer, so that brushes work on it.
void choose_layer(EditorState& state, const LayerId& layer);
void set_layer_hidden(EditorState& state, const LayerId& layer, bool hidden);
void set_layer_locked(EditorState& state, const LayerId& layer, bool locked);

/// The padlock of the species list: locks the layers of its density and of its losses, as one step.
void set_species_locked(EditorState& state, const Species& species, bool locked);
[[nodiscard]] bool species_locked(const Document& document, const Species& species);

void copy_layer(EditorState& state, const LayerId& layer);
/// Mixes the copied paint into a layer: stretched where its map has another size, its values brought to the layer's range where
/// it is of another kind.
void paste_layer(EditorState& state, const LayerId& into, LayerMix mix);
void mix_layers(EditorState& state, const LayerId& into, const LayerId& from, LayerMix mix);
/// Cells of the nearest ones of another size.
[[nodiscard]] PaintLayer resampled_paint(const PaintLayer& paint, int width, int height);

/// Asks how an image is to be laid over a layer as paint.
void offer_image(EditorState& state, const LayerId& layer, const std::filesystem::path& file);
/// Asks for an image and lays it over a layer as paint, within selection and filter.
void import_layer_image(EditorState& state, const LayerId& layer);
/// Asks for a file and writes a layer's paint, or the final map with it: GeoTIFF or PNG by the ending.
void export_layer_paint(EditorState& state, const LayerId& layer);
void export_layer_map(EditorState& state, const LayerId& layer);
/// Once a frame: takes what was read and written in the background.
void advance_layer_files(EditorState& state);

}  // namespace biotope

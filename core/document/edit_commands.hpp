#pragma once

#include <functional>
#include <memory>
#include <string>

#include "core/document/edit.hpp"

namespace biotope {

using CommandResult = Result<std::unique_ptr<Command>>;

// One function for each kind of Edit; see make_command.
[[nodiscard]] CommandResult stroke_command(const Document& document, const StrokeEdit& edit, const EditGrounds& grounds);
[[nodiscard]] CommandResult fill_command(const Document& document, const FillEdit& edit, const EditGrounds& grounds);
[[nodiscard]] CommandResult select_command(const Document& document, const SelectEdit& edit, const EditGrounds& grounds);
[[nodiscard]] CommandResult lock_command(const Document& document, const LockEdit& edit);
[[nodiscard]] CommandResult clear_command(const Document& document, const ClearEdit& edit);
[[nodiscard]] CommandResult image_command(const Document& document, const ImageEdit& edit, const EditGrounds& grounds);
[[nodiscard]] CommandResult mix_command(const Document& document, const MixEdit& edit, const EditGrounds& grounds);
[[nodiscard]] CommandResult parts_command(const Document& document, const PartsEdit& edit);

/// The same parts of a document, layers included.
[[nodiscard]] bool same_document(const Document& a, const Document& b);

/// The layer exists: a resource of the model, a species of the document, or one of the single layers.
[[nodiscard]] Status check_layer(const Document& document, const LayerId& layer);
/// It exists and may be changed.
[[nodiscard]] Status check_editable(const Document& document, const LayerId& layer);
/// Every number of the brush is one, and its radius can be painted with.
[[nodiscard]] Status check_brush(const Brush& brush);
/// The point is one of numbers, and near enough to the map to be meant.
[[nodiscard]] Status check_point(PathPoint point);
/// A map has the terrain's size.
[[nodiscard]] Status check_size(const Document& document, Rect rect, const std::string& what);

/// The computed map under a layer, of the terrain's size. Losses and passages are 0 and the ground is the terrain's where
/// `grounds` does not know them.
[[nodiscard]] Result<std::shared_ptr<const Grid<float>>> computed_under(const Document& document, const LayerId& layer,
                                                                        const EditGrounds& grounds);

/// The maps that a filter's conditions look at; fails when one is missing.
[[nodiscard]] Result<FilterMaps> maps_for(const Document& document, const std::vector<FilterCondition>& conditions,
                                          const EditGrounds& grounds);

/// The change of one layer whose tiles become `tile_of(index, layer)`, where `layer` is null when nothing is painted; null when
/// no tile changes. Tiles are made in parallel.
using TileOf = std::function<PaintLayer::TilePointer(std::size_t tile, const PaintLayer* layer)>;
[[nodiscard]] std::unique_ptr<Command> layer_command(const Document& document, const LayerId& layer, std::string name,
                                                     const TileOf& tile_of);

}  // namespace biotope

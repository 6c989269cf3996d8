#include <algorithm>
#include <cmath>

#include "core/base/parallel.hpp"
#include "core/document/brush_paint.hpp"
#include "core/document/edit_commands.hpp"

namespace biotope {
namespace {

const PaintLayer* paint_on(const Document& document, const LayerId& layer) {
  const auto found = document.layers.find(layer);
  return found == document.layers.end() ? nullptr : found->second.get();
}

/// One paint on top of another; classes are not mixed: the one that covers more of the cell gives the class.
Paint laid_over(Paint lower, Paint upper, bool classes) {
  const float left = lower.coverage * (1 - upper.coverage);
  const float coverage = upper.coverage + left;
  if (coverage <= 0) return {};
  if (upper.coverage <= 0) return lower;
  if (left <= 0) return upper;
  if (classes) return {upper.coverage >= left ? upper.value : lower.value, coverage};
  return {(upper.value * upper.coverage + lower.value * left) / coverage, coverage};
}

Paint greater(Paint own, Paint other, float computed) {
  if (own.coverage <= 0) return other;
  if (other.coverage <= 0) return own;
  return painted(computed, other) > painted(computed, own) ? other : own;
}

Paint mixed(LayerMix mix, Paint own, Paint other, float computed, bool classes) {
  switch (mix) {
    case LayerMix::replace:
      return other.coverage > 0 ? other : Paint{};
    case LayerMix::over:
      return laid_over(own, other, classes);
    case LayerMix::under:
      return laid_over(other, own, classes);
    case LayerMix::subtract:
      return other.coverage > 0 ? thinned(own, 1 - other.coverage) : own;
    case LayerMix::intersect:
      return other.coverage < 1 ? thinned(own, other.coverage) : own;
    case LayerMix::maximum:
      return greater(own, other, computed);
  }
  return own;
}

/// From one paint towards another; classes go over at half way.
Paint between(Paint from, Paint to, float share, bool classes) {
  if (share <= 0) return from;
  if (share >= 1) return to;
  if (classes) return share >= 0.5F ? to : from;
  const float coverage = from.coverage + (to.coverage - from.coverage) * share;
  if (coverage <= 0) return {};
  return {(from.value * from.coverage * (1 - share) + to.value * to.coverage * share) / coverage, coverage};
}

Paint made_legal(Paint paint, LayerKind kind) {
  if (paint.coverage <= 0) return {};
  const Range legal = legal_range(kind);
  const float value = holds_classes(kind) ? std::round(paint.value) : paint.value;
  return {std::clamp(value, legal.low, legal.high), std::min(paint.coverage, 1.0F)};
}

struct Mixer {
  LayerMix mix;
  LayerKind kind;
  const PaintLayer* other;
  const Grid<float>* computed;
  const SelectionMask* selection;
  const SelectionMask* locked_area;

  PaintLayer::TilePointer operator()(std::size_t tile, const PaintLayer* own) const {
    const PaintLayer::TilePointer before = own == nullptr ? nullptr : own->tile(tile);
    const PaintLayer::TilePointer with = other == nullptr ? nullptr : other->tile(tile);
    if (!before && !with) return nullptr;
    auto fresh = tile_copy(before);
    const PaintLayer map(computed->width(), computed->height());
    const Rect cells = map.tile_rect(tile);
    const bool classes = holds_classes(kind);
    for (int y = cells.y0; y < cells.y1; ++y) {
      for (int x = cells.x0; x < cells.x1; ++x) {
        Paint& cell = (*fresh)[PaintLayer::offset(x, y)];
        const Paint theirs = with ? made_legal((*with)[PaintLayer::offset(x, y)], kind) : Paint{};
        const float share = selected(selection, x, y) * (1 - locked_share(locked_area, x, y));
        cell = between(cell, mixed(mix, cell, theirs, (*computed)(x, y), classes), share, classes);
      }
    }
    return settled_tile(before, std::move(fresh));
  }
};

Status check_mix(const Document& document, const MixEdit& edit) {
  if (const Status editable = check_editable(document, edit.into); !editable) return editable;
  if (edit.paint) {
    if (const Status size = check_size(document, edit.paint->rect(), "The paint to mix in"); !size) return size;
  } else if (const Status known = check_layer(document, edit.from); !known) {
    return known;
  }
  if (document.selection) {
    if (const Status size = check_size(document, document.selection->rect(), "The selection"); !size) return size;
  }
  if (document.locked_area) {
    if (const Status size = check_size(document, document.locked_area->rect(), "The locked area"); !size) return size;
  }
  if (holds_classes(edit.into.kind) != holds_classes(edit.from.kind)) {
    return fail("Geology holds classes, which cannot be mixed with the values of " +
                layer_words(holds_classes(edit.into.kind) ? edit.from : edit.into) + ".");
  }
  if (holds_classes(edit.into.kind) && edit.mix == LayerMix::maximum)
    return fail("No class of geology is greater than another. Choose another way to mix.");
  return {};
}

}  // namespace

std::unique_ptr<Command> layer_command(const Document& document, const LayerId& layer, std::string name, const TileOf& tile_of) {
  const PaintLayer* before = paint_on(document, layer);
  const PaintLayer blank(document.terrain->height.width(), document.terrain->height.height());
  std::vector<PaintLayer::TilePointer> tiles(blank.tile_count());
  parallel_each(tiles.size(), [&](std::size_t tile) { tiles[tile] = tile_of(tile, before); });
  std::vector<PaintCommand::TileChange> changes;
  for (std::size_t tile = 0; tile < tiles.size(); ++tile) {
    const auto old = before == nullptr ? nullptr : before->tile(tile);
    if (tiles[tile] != old) changes.push_back({tile, old, std::move(tiles[tile])});
  }
  if (changes.empty()) return nullptr;
  return std::make_unique<PaintCommand>(std::move(name), layer, std::move(changes));
}

CommandResult clear_command(const Document& document, const ClearEdit& edit) {
  if (const Status editable = check_editable(document, edit.layer); !editable) return tl::unexpected(editable.error());
  if (!document.locked_area) {
    return layer_command(document, edit.layer, edit_name(edit, document),
                         [](std::size_t, const PaintLayer*) { return PaintLayer::TilePointer{}; });
  }
  if (const Status size = check_size(document, document.locked_area->rect(), "The locked area"); !size) {
    return tl::unexpected(size.error());
  }
  // Paint goes where it would give way to paint of no coverage.
  const Grid<float>& height = document.terrain->height;
  return layer_command(document, edit.layer, edit_name(edit, document),
                       Mixer{LayerMix::replace, edit.layer.kind, nullptr, &height, nullptr, document.locked_area.get()});
}

CommandResult image_command(const Document& document, const ImageEdit& edit, const EditGrounds& grounds) {
  if (!edit.values) return fail("There is no image to lay over " + layer_words(edit.layer) + ". Choose one first.");
  if (!std::isfinite(edit.opacity)) return fail("The image's opacity is not a number. Enter one from 0 to 1.");
  if (const Status editable = check_editable(document, edit.layer); !editable) return tl::unexpected(editable.error());
  if (const Status size = check_size(document, edit.values->rect(), "The image"); !size) return tl::unexpected(size.error());
  // An image is a fill whose value is another one in every cell.
  Brush brush;
  brush.mode = BrushMode::set;
  brush.strength = edit.opacity;
  brush.filter = edit.filter;
  const auto ground = stroke_ground(document, {EditTarget{edit.layer, 1, {}, {}}}, brush, std::nullopt, grounds);
  if (!ground) return tl::unexpected(ground.error());
  LayerPainter painter = painter_of(brush, ground->targets.front(), 1);
  painter.source = edit.values.get();
  const CellFilter filter(brush.filter, &ground->maps, document.selection.get(), document.locked_area.get());
  const PaintLayer map(edit.values->width(), edit.values->height());
  return layer_command(document, edit.layer, edit_name(edit, document), [&](std::size_t tile, const PaintLayer* before) {
    const auto weights = filter.blocks_tile(tile) ? std::nullopt : tile_weights(tile, map.tile_rect(tile), filter);
    if (!weights) return before == nullptr ? PaintLayer::TilePointer{} : before->tile(tile);
    return painted_tile(painter, before, *weights);
  });
}

CommandResult mix_command(const Document& document, const MixEdit& edit, const EditGrounds& grounds) {
  if (const Status good = check_mix(document, edit); !good) return tl::unexpected(good.error());
  // Only the comparison of final values looks at what is computed.
  std::shared_ptr<const Grid<float>> computed(document.terrain, &document.terrain->height);
  if (edit.mix == LayerMix::maximum) {
    auto known = computed_under(document, edit.into, grounds);
    if (!known) return tl::unexpected(known.error());
    computed = std::move(*known);
  }
  const PaintLayer* other = edit.paint ? edit.paint.get() : paint_on(document, edit.from);
  return layer_command(
      document, edit.into, edit_name(edit, document),
      Mixer{edit.mix, edit.into.kind, other, computed.get(), document.selection.get(), document.locked_area.get()});
}

}  // namespace biotope

#include "core/document/edit_commands.hpp"
#include "core/document/selection.hpp"

namespace biotope {
namespace {

using SelectionPointer = std::shared_ptr<const SelectionMask>;

Result<SelectionMask> range_mask(const Document& document, const FilterCondition& condition, const EditGrounds& grounds) {
  const auto maps = maps_for(document, {condition}, grounds);
  if (!maps) return tl::unexpected(maps.error());
  const Grid<float>& values = *filter_map(condition, *maps);
  return selection_of(values.width(), values.height(), [&](int x, int y) { return condition_weight(condition, values(x, y)); });
}

Result<SelectionMask> painted_mask(const Document& document, const LayerId& layer) {
  if (const Status known = check_layer(document, layer); !known) return tl::unexpected(known.error());
  const auto found = document.layers.find(layer);
  if (found == document.layers.end() || !found->second) {
    return fail("Nothing is painted on " + layer_words(layer) + ". Paint something first.");
  }
  const PaintLayer& paint = *found->second;
  return selection_of(paint.width(), paint.height(), [&](int x, int y) { return paint(x, y).coverage; });
}

Result<SelectionMask> shape_mask(const Document& document, const SelectEdit& edit, const EditGrounds& grounds) {
  const int width = document.terrain->height.width();
  const int height = document.terrain->height.height();
  switch (edit.shape) {
    case SelectEdit::Shape::everything:
      return inverted(SelectionMask(width, height));
    case SelectEdit::Shape::rectangle:
      if (edit.points.size() != 2) return fail("A rectangle has two corners. Draw it from one to the other.");
      return rectangle_selection(width, height, edit.points[0], edit.points[1]);
    case SelectEdit::Shape::lasso:
      if (edit.points.size() < 3) return fail("A lasso needs at least three points. Draw around what you want to select.");
      return lasso_selection(width, height, edit.points);
    case SelectEdit::Shape::range:
      return range_mask(document, edit.range, grounds);
    case SelectEdit::Shape::painted:
      return painted_mask(document, edit.range.map);
    case SelectEdit::Shape::nothing:
    case SelectEdit::Shape::inverse:
      break;
  }
  return SelectionMask(width, height);
}

}  // namespace

CommandResult select_command(const Document& document, const SelectEdit& edit, const EditGrounds& grounds) {
  if (!document.terrain) return fail("There is no terrain to select from. Open a landscape first.");
  for (const PathPoint point : edit.points) {
    if (const Status near = check_point(point); !near) return tl::unexpected(near.error());
  }
  const auto& before = document.selection;
  if (before) {
    if (const Status size = check_size(document, before->rect(), "The selection"); !size) return tl::unexpected(size.error());
  }
  SelectionPointer after;
  if (edit.shape == SelectEdit::Shape::inverse) {
    const SelectionMask everything = inverted(SelectionMask(document.terrain->height.width(), document.terrain->height.height()));
    after = combined(nullptr, inverted(before ? *before : everything), SelectionMode::replace);
  } else {
    auto mask = shape_mask(document, edit, grounds);
    if (!mask) return tl::unexpected(mask.error());
    after = combined(before, std::move(*mask), edit.mode);
  }
  const bool same = before == after || (before && after && *before == *after);
  if (same) return std::unique_ptr<Command>{};
  Document selected = document;
  selected.selection = std::move(after);
  return std::make_unique<DocumentCommand>(edit_name(edit, document), document, std::move(selected));
}

}  // namespace biotope

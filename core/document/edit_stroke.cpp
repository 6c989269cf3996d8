#include <algorithm>
#include <cmath>

#include "core/document/brush_paint.hpp"
#include "core/document/edit_commands.hpp"

namespace biotope {
namespace {

Status check_selection(const Document& document) {
  if (document.selection) {
    if (const Status size = check_size(document, document.selection->rect(), "The selection"); !size) return size;
  }
  return document.locked_area ? check_size(document, document.locked_area->rect(), "The locked area") : Status{};
}

Status check_target(const Document& document, const EditTarget& target) {
  if (const Status known = check_layer(document, target.layer); !known) return known;
  const bool numbers =
      std::isfinite(target.weight) && std::isfinite(target.value.value_or(0)) && std::isfinite(target.floor.value_or(0));
  return numbers ? Status{} : fail("The weight or value of " + layer_words(target.layer) + " is not a number. Enter a number.");
}

Status check_stroke(const Document& document, const std::vector<EditTarget>& targets, const Brush& brush,
                    const std::optional<LayerId>& clone_from) {
  if (targets.empty()) return fail("No layer is chosen to paint on. Choose one first.");
  for (const EditTarget& target : targets) {
    if (const Status good = check_target(document, target); !good) return good;
  }
  const auto locked = [&](const EditTarget& target) { return is_locked(document, target.layer); };
  if (std::all_of(targets.begin(), targets.end(), locked)) return check_editable(document, targets.front().layer);
  if (brush.mode == BrushMode::clone) {
    if (!clone_from) return fail("The clone brush has no map to take values from. Choose one first.");
    if (const Status known = check_layer(document, *clone_from); !known) return known;
  }
  if (const Status selection = check_selection(document); !selection) return selection;
  return check_brush(brush);
}

}  // namespace

Result<StrokeGround> stroke_ground(const Document& document, const std::vector<EditTarget>& targets, const Brush& brush,
                                   const std::optional<LayerId>& clone_from, const EditGrounds& grounds) {
  if (const Status good = check_stroke(document, targets, brush, clone_from); !good) return tl::unexpected(good.error());
  StrokeGround ground;
  auto maps = maps_for(document, brush.filter.conditions, grounds);
  if (!maps) return tl::unexpected(maps.error());
  ground.maps = std::move(*maps);
  const Grid<float>* source = nullptr;
  if (brush.mode == BrushMode::clone) {
    auto computed = computed_under(document, *clone_from, grounds);
    if (!computed) return tl::unexpected(computed.error());
    ground.kept.push_back(final_map(document, *clone_from, std::move(*computed)));
    source = ground.kept.back().get();
  }
  for (const EditTarget& target : targets) {
    if (is_locked(document, target.layer)) continue;
    auto computed = computed_under(document, target.layer, grounds);
    if (!computed) return tl::unexpected(computed.error());
    ground.kept.push_back(std::move(*computed));
    ground.targets.push_back({target.layer, ground.kept.back().get(), target.weight, target.value, target.floor, source});
  }
  return ground;
}

CommandResult stroke_command(const Document& document, const StrokeEdit& edit, const EditGrounds& grounds) {
  for (const StrokePoint point : edit.points) {
    if (const Status near = check_point({point.x, point.y}); !near) return tl::unexpected(near.error());
    if (!std::isfinite(point.pressure)) return fail("A point of the stroke has a pressure that is not a number.");
  }
  const auto ground = stroke_ground(document, edit.targets, edit.brush, edit.clone_from, grounds);
  if (!ground) return tl::unexpected(ground.error());
  Document painted = document;
  Stroke stroke(ground->targets, &ground->maps);
  for (const StrokePoint point : edit.points) stroke.move_to(painted, edit.brush, point.x, point.y, point.pressure);
  return stroke.finish(painted);
}

CommandResult fill_command(const Document& document, const FillEdit& edit, const EditGrounds& grounds) {
  if (edit.gradient) {
    for (const PathPoint point : {edit.gradient->from, edit.gradient->to}) {
      if (const Status near = check_point(point); !near) return tl::unexpected(near.error());
    }
    if (!std::isfinite(edit.gradient->end_value)) return fail("The gradient's end is not a number. Enter a number.");
  }
  const auto ground = stroke_ground(document, edit.targets, edit.brush, edit.clone_from, grounds);
  if (!ground) return tl::unexpected(ground.error());
  const CellFilter filter(edit.brush.filter, &ground->maps, document.selection.get(), document.locked_area.get());
  const PaintLayer map(document.terrain->height.width(), document.terrain->height.height());
  std::vector<std::unique_ptr<Command>> commands;
  const std::string name = edit_name(edit, document);
  // One after the other, so that a layer named twice is filled twice.
  Document filled = document;
  for (const StrokeTarget& target : ground->targets) {
    LayerPainter painter = painter_of(edit.brush, target, 1);
    if (edit.gradient) painter.ramp = ValueRamp{edit.gradient->from, edit.gradient->to, painter.value, edit.gradient->end_value};
    auto command = layer_command(filled, target.layer, name, [&](std::size_t tile, const PaintLayer* before) {
      const auto weights = filter.blocks_tile(tile) ? std::nullopt : tile_weights(tile, map.tile_rect(tile), filter);
      if (!weights) return before == nullptr ? PaintLayer::TilePointer{} : before->tile(tile);
      return painted_tile(painter, before, *weights);
    });
    if (!command) continue;
    command->apply(filled);
    commands.push_back(std::move(command));
  }
  if (commands.empty()) return std::unique_ptr<Command>{};
  if (commands.size() == 1) return std::move(commands.front());
  return std::make_unique<GroupCommand>(name, std::move(commands));
}

}  // namespace biotope

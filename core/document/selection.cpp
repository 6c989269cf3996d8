#include "core/document/selection.hpp"

#include <cassert>
#include <cmath>

#include "core/document/selection_rows.hpp"

namespace biotope {
namespace {

std::uint8_t met(std::uint8_t before, std::uint8_t with, SelectionMode mode) {
  switch (mode) {
    case SelectionMode::replace:
      return with;
    case SelectionMode::add:
      return std::uint8_t(std::min(255, int(before) + int(with)));
    case SelectionMode::subtract:
      return std::uint8_t(std::max(0, int(before) - int(with)));
    case SelectionMode::intersect:
      return std::min(before, with);
  }
  return with;
}

/// The mask that `cell(x, y, value)` makes of each cell of `mask`, tile by tile.
template <class Cell>
SelectionMask mapped(const SelectionMask& mask, const Cell& cell) {
  SelectionMask result(mask.width(), mask.height());
  const SelectionMask::TilePointer full = full_selection_tile();
  parallel_each(mask.tile_count(), [&](std::size_t i) {
    const Rect rect = mask.tile_rect(i);
    const SelectionMask::TilePointer& old = mask.tile(i);
    auto tile = std::make_shared<SelectionMask::Tile>();
    for (int y = rect.y0; y < rect.y1; ++y) {
      for (int x = rect.x0; x < rect.x1; ++x) {
        const std::size_t at = SelectionMask::offset(x, y);
        (*tile)[at] = cell(x, y, old ? (*old)[at] : mask.background());
      }
    }
    result.set_tile(i, settled_selection(std::move(tile), full));
  });
  return result;
}

bool is_full(const SelectionMask& mask) {
  for (std::size_t i = 0; i < mask.tile_count(); ++i) {
    const Rect rect = mask.tile_rect(i);
    for (int y = rect.y0; y < rect.y1; ++y) {
      for (int x = rect.x0; x < rect.x1; ++x) {
        if (mask(x, y) != 255) return false;
      }
    }
  }
  return true;
}

/// Column or row of a corner, at most one cell beyond the map.
int cell_of(float coordinate, int size) { return int(std::lround(std::clamp(coordinate, -1.0F, float(size)))); }

}  // namespace

SelectionMask selection_of(int width, int height, const std::function<float(int x, int y)>& share) {
  return selection_of_rows(width, height, [&](int y, std::span<std::uint8_t> row) {
    for (int x = 0; x < width; ++x) row[std::size_t(x)] = selection_step(share(x, y));
  });
}

SelectionMask rectangle_selection(int width, int height, PathPoint corner, PathPoint opposite) {
  const bool anywhere = !std::isnan(corner.x + corner.y + opposite.x + opposite.y);
  if (!anywhere) return {width, height};
  const Rect wanted{cell_of(std::min(corner.x, opposite.x), width), cell_of(std::min(corner.y, opposite.y), height),
                    cell_of(std::max(corner.x, opposite.x), width) + 1, cell_of(std::max(corner.y, opposite.y), height) + 1};
  const Rect cells = intersection(wanted, {0, 0, width, height});
  return selection_of_rows(width, height, [&](int y, std::span<std::uint8_t> row) {
    if (cells.empty() || y < cells.y0 || y >= cells.y1) return;
    std::fill(row.begin() + cells.x0, row.begin() + cells.x1, std::uint8_t(255));
  });
}

SelectionMask range_selection(const Grid<float>& values, float low, float high, float softness) {
  const float least = std::min(low, high);
  const float greatest = std::max(low, high);
  return selection_of_rows(values.width(), values.height(), [&](int y, std::span<std::uint8_t> row) {
    for (int x = 0; x < values.width(); ++x) {
      const float value = values(x, y);
      if (std::isnan(value)) continue;
      const float outside = std::max({0.0F, least - value, value - greatest});
      row[std::size_t(x)] = outside <= 0 ? 255 : softness > 0 ? selection_step(1 - outside / softness) : 0;
    }
  });
}

SelectionMask inverted(const SelectionMask& mask) {
  return mapped(mask, [](int, int, std::uint8_t value) { return std::uint8_t(255 - value); });
}

std::shared_ptr<const SelectionMask> combined(const std::shared_ptr<const SelectionMask>& before, SelectionMask with,
                                              SelectionMode mode) {
  assert(!before || before->rect() == with.rect());
  if (mode != SelectionMode::replace) {
    with = mapped(
        with, [&](int x, int y, std::uint8_t value) { return met(before ? (*before)(x, y) : std::uint8_t(255), value, mode); });
  }
  if (is_full(with)) return nullptr;
  return std::make_shared<const SelectionMask>(std::move(with));
}

}  // namespace biotope

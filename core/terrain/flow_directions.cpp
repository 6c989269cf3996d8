#include <algorithm>
#include <vector>

#include "core/base/parallel.hpp"
#include "core/terrain/flow_routing.hpp"
#include "core/terrain/flow_updates.hpp"
#include "core/terrain/neighbours.hpp"
#include "core/terrain/tile_changes.hpp"

namespace biotope {
namespace {

constexpr std::uint8_t undecided = 255;

/// Steepest fall of a cell with eight neighbours, or undecided on a flat.
inline std::uint8_t steepest_inside(const float* cell, const std::array<std::ptrdiff_t, 8>& offsets) {
  float best = 0;
  std::uint8_t direction = undecided;
  for (std::size_t d = 0; d < 8; ++d) {
    const float fall = (*cell - cell[offsets[d]]) * neighbour_inverse_distance[d];
    if (fall > best) {
      best = fall;
      direction = std::uint8_t(d);
    }
  }
  return direction;
}

/// The same on the border, where the ground is taken to go on beyond as it goes inside; water does not leave through an inlet.
std::uint8_t steepest_on_border(const Grid<float>& filled, int x, int y, bool inlet) {
  const float here = filled(x, y);
  float best = 0;
  std::uint8_t direction = inlet ? undecided : leaves_map;
  for (std::size_t d = 0; d < 8; ++d) {
    const int nx = x + neighbour_dx[d];
    const int ny = y + neighbour_dy[d];
    float fall = 0;
    if (filled.contains(nx, ny)) {
      fall = (here - filled(nx, ny)) * neighbour_inverse_distance[d];
      if (fall > best) direction = std::uint8_t(d);
    } else if (!inlet && d % 2 == 0 && filled.contains(x - neighbour_dx[d], y - neighbour_dy[d])) {
      fall = filled(x - neighbour_dx[d], y - neighbour_dy[d]) - here;
      if (fall > best) direction = leaves_map;
    }
    best = std::max(best, fall);
  }
  return direction;
}

/// A filled ground, its sea and inlets (empty: none).
struct FilledGround {
  const Grid<float>& filled;
  const Grid<std::uint8_t>& sea;
  const Grid<std::uint8_t>& inlets;
  std::array<std::ptrdiff_t, 8> offsets = neighbour_offsets(filled.width());

  /// What a cell's own surroundings say, or undecided on a flat.
  [[nodiscard]] std::uint8_t steepest(int x, int y) const {
    if (!sea.empty() && sea(x, y) != 0) return leaves_map;
    const bool border = x == 0 || y == 0 || x == filled.width() - 1 || y == filled.height() - 1;
    if (border) return steepest_on_border(filled, x, y, !inlets.empty() && inlets(x, y) != 0);
    return steepest_inside(&filled(x, y), offsets);
  }
};

/// Leads flats to where they empty: breadth first from the cells that already know their way. `undecided_cells` ascend, so that
/// the result does not depend on anything but the ground.
void resolve_flats(const Grid<float>& filled, const std::vector<std::uint32_t>& undecided_cells, Grid<std::uint8_t>& receiver) {
  const auto width = std::uint32_t(filled.width());
  std::vector<std::uint32_t> queue;
  const auto spread = [&](std::uint32_t cell) {
    const int x = int(cell % width);
    const int y = int(cell / width);
    for (std::size_t d = 0; d < 8; ++d) {
      const int nx = x + neighbour_dx[d];
      const int ny = y + neighbour_dy[d];
      if (!filled.contains(nx, ny) || receiver(nx, ny) != undecided || filled(nx, ny) != filled[cell]) continue;
      receiver(nx, ny) = std::uint8_t(opposite_direction(int(d)));
      queue.push_back(std::uint32_t(filled.index(nx, ny)));
    }
  };
  std::vector<std::uint32_t> rim;
  for (const std::uint32_t cell : undecided_cells) {
    const int x = int(cell % width);
    const int y = int(cell / width);
    for (std::size_t d = 0; d < 8; ++d) {
      const int nx = x + neighbour_dx[d];
      const int ny = y + neighbour_dy[d];
      if (filled.contains(nx, ny) && filled(nx, ny) == filled[cell] && receiver(nx, ny) != undecided) {
        rim.push_back(std::uint32_t(filled.index(nx, ny)));
      }
    }
  }
  for (const std::uint32_t cell : rim) spread(cell);
  for (std::size_t next = 0; next < queue.size(); ++next) spread(queue[next]);
}

/// Undecided cells of all flats that reach into the cells asked about. Flats that share a cell of their rims belong together, for
/// its water's way into one follows from that into the other. Marks them all undecided in `receiver`.
class FlatGathering {
 public:
  FlatGathering(const FilledGround& ground, Grid<std::uint8_t>& receiver)
      : ground_(ground), filled_(ground.filled), receiver_(receiver) {}

  /// Cells that are undecided already.
  void start(std::vector<std::uint32_t> cells) { found_ = std::move(cells); }

  std::vector<std::uint32_t> gather() {
    for (std::size_t next = 0; next < found_.size(); ++next) {
      each_level_neighbour(found_[next], [&](int x, int y) {
        if (receiver_(x, y) == undecided) return;
        if (flat(x, y)) {
          take(x, y);
        } else {
          each_level_neighbour(std::uint32_t(filled_.index(x, y)), [&](int bx, int by) {
            if (receiver_(bx, by) != undecided && flat(bx, by)) take(bx, by);
          });
        }
      });
    }
    std::sort(found_.begin(), found_.end());
    return std::move(found_);
  }

 private:
  [[nodiscard]] bool flat(int x, int y) const { return ground_.steepest(x, y) == undecided; }
  void take(int x, int y) {
    receiver_(x, y) = undecided;
    found_.push_back(std::uint32_t(filled_.index(x, y)));
  }
  template <class Body>
  void each_level_neighbour(std::uint32_t cell, const Body& body) const {
    const int x = int(cell % std::uint32_t(filled_.width()));
    const int y = int(cell / std::uint32_t(filled_.width()));
    for (std::size_t d = 0; d < 8; ++d) {
      const int nx = x + neighbour_dx[d];
      const int ny = y + neighbour_dy[d];
      if (filled_.contains(nx, ny) && filled_(nx, ny) == filled_[cell]) body(nx, ny);
    }
  }

  const FilledGround& ground_;
  const Grid<float>& filled_;
  Grid<std::uint8_t>& receiver_;
  std::vector<std::uint32_t> found_;
};

}  // namespace

Grid<std::uint8_t> flow_directions(const Grid<float>& filled, const Grid<std::uint8_t>& sea, const Grid<std::uint8_t>& inlets) {
  const int width = filled.width();
  const int height = filled.height();
  auto receiver = Grid<std::uint8_t>::shareable(width, height);
  const FilledGround ground{filled, sea, inlets};
  parallel_rows(0, height, [&](int y) {
    const auto out = receiver.row(y);
    for (int x = 0; x < width; ++x) out[std::size_t(x)] = ground.steepest(x, y);
  });
  std::vector<std::uint32_t> flats;
  for (std::size_t cell = 0; cell < receiver.size(); ++cell) {
    if (receiver[cell] == undecided) flats.push_back(std::uint32_t(cell));
  }
  resolve_flats(filled, flats, receiver);
  return receiver;
}

TileSet update_flow_directions(const Grid<float>& filled, const Grid<std::uint8_t>& sea, const Grid<std::uint8_t>& inlets,
                               const TileSet& changed, const Grid<std::uint8_t>& before, Grid<std::uint8_t>& receiver) {
  const TileSet asked = changed.grown(1);
  const FilledGround ground{filled, sea, inlets};
  const auto list = asked.list();
  parallel_each(list.size(), [&](std::size_t i) {
    const Rect cells = asked.rect(list[i]);
    for (int y = cells.y0; y < cells.y1; ++y) {
      for (int x = cells.x0; x < cells.x1; ++x) receiver(x, y) = ground.steepest(x, y);
    }
  });
  std::vector<std::uint32_t> flats;
  for (const std::size_t tile : list) {
    const Rect cells = asked.rect(tile);
    for (int y = cells.y0; y < cells.y1; ++y) {
      for (int x = cells.x0; x < cells.x1; ++x) {
        if (receiver(x, y) == undecided) flats.push_back(std::uint32_t(receiver.index(x, y)));
      }
    }
  }
  FlatGathering gathering(ground, receiver);
  gathering.start(std::move(flats));
  const std::vector<std::uint32_t> cells = gathering.gather();
  resolve_flats(filled, cells, receiver);
  TileSet touched = asked;
  for (const std::uint32_t cell : cells) {
    const int x = int(cell % std::uint32_t(filled.width()));
    const int y = int(cell / std::uint32_t(filled.width()));
    touched.insert({x, y, x + 1, y + 1});
  }
  return changed_tiles(touched, [&](const Rect& rect) { return !same_cells(receiver, before, rect); });
}

}  // namespace biotope

#include "render/terrain_mesh.hpp"

#include <algorithm>
#include <cmath>

#include "core/base/parallel.hpp"

namespace biotope {

HeightBounds::HeightBounds(const Grid<float>& surface, double cell_size, int patch_cells)
    : unit_(patch_cells * cell_size), height_(surface.height() * cell_size) {
  // Squares are counted from the south-west, one cell of overlap on each side for interpolation across borders.
  Grid<glm::vec2> base((surface.width() + patch_cells - 1) / patch_cells, (surface.height() + patch_cells - 1) / patch_cells,
                       glm::vec2(1e9F, -1e9F));
  parallel_rows(0, base.height(), [&](int row) {
    for (int column = 0; column < base.width(); ++column) {
      glm::vec2& bounds = base(column, row);
      for (int y = row * patch_cells - 1; y <= (row + 1) * patch_cells; ++y) {
        for (int x = column * patch_cells - 1; x <= (column + 1) * patch_cells; ++x) {
          const float z = surface.clamped(x, surface.height() - 1 - y);
          bounds = {std::min(bounds.x, z), std::max(bounds.y, z)};
        }
      }
    }
  });
  levels_.push_back(std::move(base));
  while (levels_.back().width() > 1 || levels_.back().height() > 1) {
    const Grid<glm::vec2>& fine = levels_.back();
    Grid<glm::vec2> coarse((fine.width() + 1) / 2, (fine.height() + 1) / 2, glm::vec2(1e9F, -1e9F));
    for (int y = 0; y < fine.height(); ++y) {
      for (int x = 0; x < fine.width(); ++x) {
        glm::vec2& bounds = coarse(x / 2, y / 2);
        bounds = {std::min(bounds.x, fine(x, y).x), std::max(bounds.y, fine(x, y).y)};
      }
    }
    levels_.push_back(std::move(coarse));
  }
  whole_ = levels_.back()(0, 0);
}

glm::vec2 HeightBounds::of(double west, double south, double side) const {
  const int level = int(std::lround(std::log2(side / unit_)));
  if (level < 0 || level >= int(levels_.size())) return whole_;
  const Grid<glm::vec2>& grid = levels_[std::size_t(level)];
  const int x = int(std::floor(west / side + 0.5));
  const int y = int(std::floor(south / side + 0.5));
  return grid.contains(x, y) ? grid(x, y) : whole_;
}

namespace {

class PatchSelection {
 public:
  PatchSelection(const PatchSettings& settings, const HeightBounds& bounds, const glm::dvec3& eye, const Frustum& frustum)
      : settings_(settings), bounds_(bounds), eye_(eye), frustum_(frustum) {}

  void visit(double west, double south, double side) {
    const glm::vec2 heights = bounds_.of(west, south, side);
    const glm::vec3 low = glm::vec3(glm::dvec3(west, south, heights.x) - eye_);
    const glm::vec3 high = glm::vec3(glm::dvec3(west + side, south + side, heights.y) - eye_);
    if (!frustum_.meets_box(low, high)) return;
    const double half = side / 2;
    const bool finest = side <= settings_.finest_side * 1.001;
    if (!finest && nearest(low, high) < reach(half)) {
      for (const double north : {0.0, half}) {
        for (const double east : {0.0, half}) visit(west + east, south + north, half);
      }
      return;
    }
    patches_.push_back({float(west), float(south), float(side), reach(side)});
  }

  std::vector<GroundPatch> take() { return std::move(patches_); }

 private:
  float reach(double side) const { return float(side) * settings_.range_factor; }
  static float nearest(const glm::vec3& low, const glm::vec3& high) {
    return glm::length(glm::max(glm::max(low, -high), glm::vec3(0)));
  }

  const PatchSettings& settings_;
  const HeightBounds& bounds_;
  const glm::dvec3 eye_;
  const Frustum& frustum_;
  std::vector<GroundPatch> patches_;
};

}  // namespace

std::vector<GroundPatch> select_patches(const PatchSettings& settings, const HeightBounds& bounds, const glm::dvec3& eye,
                                        const Frustum& frustum) {
  PatchSelection selection(settings, bounds, eye, frustum);
  double root = settings.finest_side;
  while (root < std::max(settings.width, settings.height)) root *= 2;
  const auto squares = [&](double extent) {
    return std::pair(int(std::floor(-extent / root)), int(std::ceil(2 * extent / root)));
  };
  const auto [x0, x1] = squares(settings.width);
  const auto [y0, y1] = squares(settings.height);
  for (int y = y0; y < y1; ++y) {
    for (int x = x0; x < x1; ++x) selection.visit(x * root, y * root, root);
  }
  return selection.take();
}

}  // namespace biotope

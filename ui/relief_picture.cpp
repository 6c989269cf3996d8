#include "ui/relief_picture.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/glm.hpp>

namespace biotope {
namespace {

constexpr float seen_water = 0.25F;  // m; less is wet ground at this scale

/// Muted greens in the valleys, ochre on the slopes, pale grey on the heights.
glm::vec3 height_tint(float share) {
  static constexpr std::array<glm::vec3, 4> tints{
      {{0.42F, 0.50F, 0.36F}, {0.60F, 0.59F, 0.42F}, {0.66F, 0.59F, 0.48F}, {0.86F, 0.85F, 0.83F}}};
  const float at = std::clamp(share, 0.0F, 1.0F) * 3;
  const int below = std::min(int(at), 2);
  return glm::mix(tints[std::size_t(below)], tints[std::size_t(below) + 1], at - float(below));
}

/// Light from the north-west on a slope, 0.45 .. 1.15.
float shade(float east_rise, float north_rise) {
  const glm::vec3 normal = glm::normalize(glm::vec3(-east_rise, -north_rise, 1));
  const glm::vec3 light = glm::normalize(glm::vec3(-0.6F, 0.6F, 0.75F));
  return 0.4F + 0.85F * std::max(glm::dot(normal, light), 0.0F);
}

/// A picture of fewer pixels than there are cells.
class Sampling {
 public:
  Sampling(const Grid<float>& height, int side) : height_(height), longer_(std::max(height.width(), height.height())) {
    width = std::max(1, int(std::lround(double(side) * height.width() / longer_)));
    rows = std::max(1, int(std::lround(double(side) * height.height() / longer_)));
    step = std::max(1, longer_ / std::max(side, 1));
  }
  /// The cell in the middle of a pixel.
  [[nodiscard]] int column(int pixel) const { return cell(pixel, width, height_.width()); }
  [[nodiscard]] int row(int pixel) const { return cell(pixel, rows, height_.height()); }
  /// Lowest and highest of the cells that are seen.
  [[nodiscard]] glm::vec2 range() const {
    glm::vec2 range(height_(0, 0));
    for (int y = 0; y < rows; ++y) {
      for (int x = 0; x < width; ++x) {
        const float here = height_(column(x), row(y));
        range = {std::min(range.x, here), std::max(range.y, here)};
      }
    }
    return range;
  }

  int width = 1;
  int rows = 1;
  int step = 1;  ///< cells from one pixel to the next

 private:
  static int cell(int pixel, int pixels, int cells) { return std::min(int((pixel + 0.5) * cells / pixels), cells - 1); }
  const Grid<float>& height_;
  int longer_;
};

/// Light on the ground around a cell, looked at `step` cells away.
float shade_at(const Terrain& terrain, int x, int y, int step) {
  const Grid<float>& height = terrain.height;
  const int west = std::max(x - step, 0);
  const int east = std::min(x + step, height.width() - 1);
  const int north = std::max(y - step, 0);
  const int south = std::min(y + step, height.height() - 1);
  const auto metres = float(terrain.cell_size);
  return shade((height(east, y) - height(west, y)) / (metres * float(std::max(east - west, 1))),
               (height(x, north) - height(x, south)) / (metres * float(std::max(south - north, 1))));
}

/// What covers the ground at a cell, lit.
glm::vec3 colour_at(const MapsSnapshot& maps, int x, int y, const glm::vec2& range, int step) {
  const Grid<float>& height = maps.terrain().height;
  const bool has_water = maps.hydrology && maps.hydrology->water_depth.width() == height.width();
  if (has_water && maps.hydrology->water_depth(x, y) > seen_water) return {0.27F, 0.42F, 0.54F};
  glm::vec3 colour = height_tint((height(x, y) - range.x) / std::max(range.y - range.x, 1.0F));
  if (maps.tree_cover && maps.tree_cover->width() == height.width())
    colour = glm::mix(colour, glm::vec3(0.24F, 0.33F, 0.20F), 0.75F * float(cover_fraction((*maps.tree_cover)(x, y))));
  return colour * shade_at(maps.terrain(), x, y, step);
}

}  // namespace

ReliefPicture make_relief_picture(const MapsSnapshot& maps, int side) {
  const Sampling sampling(maps.terrain().height, side);
  const glm::vec2 range = sampling.range();
  ReliefPicture picture;
  picture.width = sampling.width;
  picture.height = sampling.rows;
  picture.rgba.reserve(std::size_t(picture.width) * std::size_t(picture.height) * 4);
  for (int y = 0; y < picture.height; ++y) {
    for (int x = 0; x < picture.width; ++x) {
      const glm::vec3 colour = colour_at(maps, sampling.column(x), sampling.row(y), range, sampling.step);
      for (int i = 0; i < 3; ++i) picture.rgba.push_back(std::uint8_t(std::clamp(colour[i], 0.0F, 1.0F) * 255 + 0.5F));
      picture.rgba.push_back(255);
    }
  }
  return picture;
}

}  // namespace biotope

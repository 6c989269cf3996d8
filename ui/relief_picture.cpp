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

}  // namespace

ReliefPicture make_relief_picture(const MapsSnapshot& maps, int side) {
  const Grid<float>& height = maps.terrain().height;
  const int longer = std::max(height.width(), height.height());
  ReliefPicture picture;
  picture.width = std::max(1, int(std::lround(double(side) * height.width() / longer)));
  picture.height = std::max(1, int(std::lround(double(side) * height.height() / longer)));
  picture.rgba.resize(std::size_t(picture.width) * std::size_t(picture.height) * 4);
  const auto cell = [&](int pixel, int pixels, int cells) { return std::min(int((pixel + 0.5) * cells / pixels), cells - 1); };
  float low = height(0, 0);
  float high = low;
  for (int y = 0; y < picture.height; ++y) {
    for (int x = 0; x < picture.width; ++x) {
      const float here = height(cell(x, picture.width, height.width()), cell(y, picture.height, height.height()));
      low = std::min(low, here);
      high = std::max(high, here);
    }
  }
  const int step = std::max(1, longer / std::max(side, 1));
  const bool has_water = maps.hydrology && maps.hydrology->water_depth.width() == height.width();
  const bool has_trees = maps.tree_cover && maps.tree_cover->width() == height.width();
  for (int y = 0; y < picture.height; ++y) {
    for (int x = 0; x < picture.width; ++x) {
      const int cx = cell(x, picture.width, height.width());
      const int cy = cell(y, picture.height, height.height());
      const int west = std::max(cx - step, 0);
      const int east = std::min(cx + step, height.width() - 1);
      const int north = std::max(cy - step, 0);
      const int south = std::min(cy + step, height.height() - 1);
      const auto metres = float(maps.terrain().cell_size);
      const float east_rise = (height(east, cy) - height(west, cy)) / (metres * float(std::max(east - west, 1)));
      const float north_rise = (height(cx, north) - height(cx, south)) / (metres * float(std::max(south - north, 1)));
      glm::vec3 colour = height_tint((height(cx, cy) - low) / std::max(high - low, 1.0F));
      if (has_trees)
        colour = glm::mix(colour, glm::vec3(0.24F, 0.33F, 0.20F), 0.75F * float(cover_fraction((*maps.tree_cover)(cx, cy))));
      colour *= shade(east_rise, north_rise);
      if (has_water && maps.hydrology->water_depth(cx, cy) > seen_water) colour = {0.27F, 0.42F, 0.54F};
      std::uint8_t* pixel = &picture.rgba[(std::size_t(y) * std::size_t(picture.width) + std::size_t(x)) * 4];
      for (int i = 0; i < 3; ++i) pixel[i] = std::uint8_t(std::clamp(colour[i], 0.0F, 1.0F) * 255 + 0.5F);
      pixel[3] = 255;
    }
  }
  return picture;
}

}  // namespace biotope

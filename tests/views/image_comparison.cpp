#include "tests/views/image_comparison.hpp"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>

namespace biotope::test {
namespace {

constexpr int block = 8;
constexpr double far_apart = 24;

std::array<double, 3> mean_colour(const Image& image, int left, int top, int side) {
  std::array<double, 3> sum{};
  int count = 0;
  for (int y = top; y < std::min(top + side, image.height); ++y) {
    for (int x = left; x < std::min(left + side, image.width); ++x) {
      for (std::size_t c = 0; c < 3; ++c)
        sum[c] += image.rgba[(std::size_t(y) * std::size_t(image.width) + std::size_t(x)) * 4 + c];
      ++count;
    }
  }
  for (double& channel : sum) channel /= std::max(count, 1);
  return sum;
}

}  // namespace

ImageDifference difference(const Image& a, const Image& b) {
  assert(a.width == b.width && a.height == b.height);
  ImageDifference all;
  int blocks = 0;
  for (int y = 0; y < a.height; y += block) {
    for (int x = 0; x < a.width; x += block) {
      const auto one = mean_colour(a, x, y, block);
      const auto other = mean_colour(b, x, y, block);
      double apart = 0;
      for (std::size_t c = 0; c < 3; ++c) apart = std::max(apart, std::abs(one[c] - other[c]));
      all.mean += apart;
      all.worst = std::max(all.worst, apart);
      all.unlike += apart > far_apart ? 1 : 0;
      ++blocks;
    }
  }
  all.mean /= std::max(blocks, 1);
  all.unlike /= std::max(blocks, 1);
  return all;
}

Image halved(const Image& image) {
  Image half{image.width / 2, image.height / 2, {}};
  half.rgba.reserve(std::size_t(half.width) * std::size_t(half.height) * 4);
  for (int y = 0; y < half.height; ++y) {
    for (int x = 0; x < half.width; ++x) {
      for (const double channel : mean_colour(image, 2 * x, 2 * y, 2)) half.rgba.push_back(std::uint8_t(std::lround(channel)));
      half.rgba.push_back(255);
    }
  }
  return half;
}

}  // namespace biotope::test

#include "ui/brush_stamps.hpp"

#include <algorithm>
#include <cmath>
#include <filesystem>

#include "core/base/random.hpp"
#include "core/exchange/layer_image.hpp"

namespace biotope {
namespace {

constexpr int side = 96;

/// Falls to 0 towards the rim of the round dab.
float round_fall(int x, int y) {
  const float half = 0.5F * float(side - 1);
  const float away = std::hypot(float(x) - half, float(y) - half) / half;
  const float t = std::clamp((1 - away) / 0.35F, 0.0F, 1.0F);
  return t * t * (3 - 2 * t);
}

/// Value noise 0..1 with lattice points `size` cells apart.
float noise(std::uint64_t what, float x, float y, float size) {
  const float u = x / size;
  const float v = y / size;
  const auto at = [&](int ix, int iy) {
    return float(random_unit({what, std::uint64_t(std::int64_t(ix)), std::uint64_t(std::int64_t(iy))}));
  };
  const int ix = int(std::floor(u));
  const int iy = int(std::floor(v));
  const auto ease = [](float t) { return t * t * (3 - 2 * t); };
  const float fx = ease(u - float(ix));
  const float fy = ease(v - float(iy));
  const float north = at(ix, iy) * (1 - fx) + at(ix + 1, iy) * fx;
  const float south = at(ix, iy + 1) * (1 - fx) + at(ix + 1, iy + 1) * fx;
  return north * (1 - fy) + south * fy;
}

template <class Weight>
BrushStamp made(const char* name, const Weight& weight) {
  auto grid = std::make_shared<Grid<float>>(side, side);
  for (int y = 0; y < side; ++y) {
    for (int x = 0; x < side; ++x) (*grid)(x, y) = std::clamp(weight(x, y), 0.0F, 1.0F);
  }
  return {name, std::move(grid)};
}

std::vector<BrushStamp> make_built_in() {
  return {
      made("Square", [](int, int) { return 1.0F; }),
      made("Speckle", [](int x, int y) { return round_fall(x, y) * (noise(1, float(x), float(y), 4) > 0.68F ? 1.0F : 0.0F); }),
      made("Patches",
           [](int x, int y) {
             const float shape = 0.7F * noise(2, float(x), float(y), 18) + 0.3F * noise(3, float(x), float(y), 7);
             return round_fall(x, y) * (shape - 0.45F) * 6;
           }),
      made("Streaks", [](int x, int y) { return round_fall(x, y) * (noise(4, 0.25F * float(x), float(y), 5) - 0.4F) * 5; })};
}

}  // namespace

const std::vector<BrushStamp>& built_in_stamps() {
  static const std::vector<BrushStamp> stamps = make_built_in();
  return stamps;
}

Result<BrushStamp> load_stamp(const std::string& name) {
  for (const BrushStamp& stamp : built_in_stamps()) {
    if (stamp.name == name) return stamp;
  }
  auto image = read_stamp(name);
  if (!image) return tl::unexpected(image.error());
  return BrushStamp{name, std::make_shared<const Grid<float>>(std::move(*image))};
}

std::string stamp_title(std::string_view name) {
  return name.empty() ? std::string("Disk") : std::filesystem::path(name).stem().string();
}

}  // namespace biotope

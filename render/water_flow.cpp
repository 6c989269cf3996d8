#include "render/water_flow.hpp"

#include <algorithm>
#include <cmath>
#include <glm/glm.hpp>

#include "core/base/parallel.hpp"

namespace biotope {

namespace {

constexpr float manning_roughness = 0.045F;
/// Cells up and down a reach over which its direction and fall are taken.
constexpr int direction_cells = 3;
constexpr int fall_cells = 5;
/// Falls between which a stream turns from smooth to white. Our choice.
constexpr float smooth_fall = 0.008F;
constexpr float white_fall = 0.14F;

/// Flow summed over the points of reaches near a texel.
struct FlowSum {
  glm::vec2 speed{0};
  float depth = 0;
  float roughness = 0;
  float weight = 0;
};

class FlowBaker {
 public:
  FlowBaker(const Terrain& terrain, const Hydrology& hydrology, int stride, const FordLook& fords)
      : terrain_(terrain),
        hydrology_(hydrology),
        fords_(fords),
        stride_(stride),
        sums_(terrain.height.width() / stride, terrain.height.height() / stride) {}

  void add(const RiverReach& reach) {
    const int count = int(reach.cells.size());
    for (int i = 0; i < count; ++i) {
      const glm::vec2 along = place(reach, i + direction_cells) - place(reach, i - direction_cells);
      const float length = glm::length(along);
      if (length <= 0) continue;
      const std::uint32_t cell = reach.cells[std::size_t(i)];
      const glm::vec2 at = place(reach, i);
      const float ford = fords_.share(double(at.x), double(at.y));
      const float depth = ford_depth(
          hydrology_.water_depth[cell] > 0 ? hydrology_.water_depth[cell] : river_depth(hydrology_.discharge[cell]), ford);
      const float fall = fall_at(reach, i);
      const float roughness = std::max(glm::smoothstep(smooth_fall, white_fall, fall), ford_roughness(ford));
      // Rows run south.
      const glm::vec2 speed = glm::vec2(along.x, -along.y) / length * stream_speed(depth, fall);
      const float half_width = ford_half_width(0.5F * river_width(hydrology_.discharge[cell]), ford);
      add_disc(at, half_width, {speed, depth, roughness, 1});
    }
  }

  Grid<Rgba> take() const {
    Grid<Rgba> out(sums_.width(), sums_.height(), Rgba{128, 128, 0, 0});
    const auto code = [](float v) { return std::uint8_t(std::lround(std::clamp(v, 0.0F, 1.0F) * 255)); };
    const auto signed_code = [](float v) { return std::uint8_t(std::lround(128 + 127 * std::clamp(v, -1.0F, 1.0F))); };
    parallel_rows(0, out.height(), [&](int y) {
      for (int x = 0; x < out.width(); ++x) {
        const FlowSum& sum = sums_(x, y);
        const WaterKind kind = hydrology_.water(x * stride_ + stride_ / 2, y * stride_ + stride_ / 2);
        if (kind == WaterKind::lake || kind == WaterKind::sea) {
          out(x, y)[2] = code(hydrology_.water_depth(x * stride_ + stride_ / 2, y * stride_ + stride_ / 2) / deepest_water);
        } else if (sum.weight > 0) {
          const glm::vec2 speed = sum.speed / sum.weight / fastest_flow;
          out(x, y) = {signed_code(speed.x), signed_code(speed.y), code(sum.depth / sum.weight / deepest_water),
                       code(sum.roughness / sum.weight)};
        }
      }
    });
    return out;
  }

 private:
  /// Cell of a reach's point, which may lie before its first or behind its last.
  [[nodiscard]] std::size_t cell(const RiverReach& reach, int i) const {
    return reach.cells[std::size_t(std::clamp(i, 0, int(reach.cells.size()) - 1))];
  }
  [[nodiscard]] glm::vec2 place(const RiverReach& reach, int i) const {
    const auto width = std::size_t(hydrology_.water.width());
    return {float(cell(reach, i) % width), float(cell(reach, i) / width)};
  }
  /// Metres of fall a metre around a point, never uphill.
  [[nodiscard]] float fall_at(const RiverReach& reach, int i) const {
    const float drop = terrain_.height[cell(reach, i - fall_cells)] - terrain_.height[cell(reach, i + fall_cells)];
    const float run = glm::length(place(reach, i + fall_cells) - place(reach, i - fall_cells)) * float(terrain_.cell_size);
    return run > 0 ? std::max(0.0F, drop / run) : 0.0F;
  }
  /// Adds to the texels within `half_width` metres and a texel more of a cell; most in the middle.
  void add_disc(glm::vec2 at, float half_width, const FlowSum& flow) {
    const float radius = half_width / (float(terrain_.cell_size) * float(stride_)) + 1.6F;
    const glm::vec2 centre = (at + 0.5F) / float(stride_) - 0.5F;
    const int x0 = std::max(0, int(std::ceil(centre.x - radius)));
    const int x1 = std::min(sums_.width() - 1, int(std::floor(centre.x + radius)));
    const int y0 = std::max(0, int(std::ceil(centre.y - radius)));
    const int y1 = std::min(sums_.height() - 1, int(std::floor(centre.y + radius)));
    for (int y = y0; y <= y1; ++y) {
      for (int x = x0; x <= x1; ++x) {
        const float weight = 1 - glm::length(glm::vec2(x, y) - centre) / radius;
        if (weight <= 0) continue;
        FlowSum& sum = sums_(x, y);
        sum.speed += weight * flow.speed;
        sum.depth += weight * flow.depth;
        sum.roughness += weight * flow.roughness;
        sum.weight += weight;
      }
    }
  }

  const Terrain& terrain_;
  const Hydrology& hydrology_;
  const FordLook& fords_;
  int stride_;
  Grid<FlowSum> sums_;
};

}  // namespace

float stream_speed(float depth, float slope) {
  // Even a level stream creeps.
  const float speed = std::pow(std::max(depth, 0.05F), 2.0F / 3.0F) * std::sqrt(std::max(slope, 0.0004F)) / manning_roughness;
  return std::min(speed, fastest_flow);
}

Grid<Rgba> water_flow(const Terrain& terrain, const Hydrology& hydrology, int stride, const FordLook& fords) {
  FlowBaker baker(terrain, hydrology, stride, fords);
  for (const RiverReach& reach : hydrology.reaches) baker.add(reach);
  return baker.take();
}

}  // namespace biotope

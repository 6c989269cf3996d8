#include "render/map_picture.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/glm.hpp>

#include "render/terrain_shadow.hpp"

namespace biotope {
namespace {

constexpr int coarse_map_side = 512;

/// What a shade depends on besides the heights around a cell.
struct ReliefLook {
  float lowest = 0;
  float highest = 0;
  float cell_size = 1;
  float exaggeration = 1;
  std::array<glm::vec3, 4> suns{};
};

constexpr float sun_altitude = 0.74F;
constexpr std::array<float, 4> sun_weights{0.14F, 0.22F, 0.44F, 0.20F};

ReliefLook relief_look(const Terrain& terrain, int stride) {
  const auto heights = terrain.height.cells();
  const auto [low, high] = std::minmax_element(heights.begin(), heights.end());
  ReliefLook look{*low, *high, float(terrain.cell_size * stride), 1, {}};
  // Coarse cells have lost their slopes; a little more exaggeration brings the relief back (our choice).
  look.exaggeration = float(std::clamp(1.15 * std::pow(double(look.cell_size) / 4, 0.25), 1.0, 2.5));
  // Four lights around the north-west, so that no valley lies in one flat shadow.
  constexpr std::array<float, 4> azimuths{225, 270, 315, 360};
  for (std::size_t i = 0; i < look.suns.size(); ++i) {
    const float azimuth = glm::radians(azimuths[i]);
    look.suns[i] = {std::sin(azimuth) * std::cos(sun_altitude), std::cos(azimuth) * std::cos(sun_altitude),
                    std::sin(sun_altitude)};
  }
  return look;
}

/// A muted colour by height.
glm::vec3 tint(const ReliefLook& look, float height) {
  if (height < 0 && look.lowest < 0) {
    return glm::mix(glm::vec3(0.62F, 0.71F, 0.74F), glm::vec3(0.30F, 0.42F, 0.52F),
                    std::clamp(height / std::min(look.lowest, -1.0F), 0.0F, 1.0F));
  }
  const float low = std::max(look.lowest, std::min(0.0F, look.highest));
  const float t = std::clamp((height - low) / std::max(look.highest - low, 1.0F), 0.0F, 1.0F);
  static constexpr std::array<std::array<float, 3>, 5> stops{{{0.560F, 0.608F, 0.478F},
                                                              {0.690F, 0.690F, 0.545F},
                                                              {0.745F, 0.690F, 0.560F},
                                                              {0.690F, 0.615F, 0.535F},
                                                              {0.865F, 0.850F, 0.825F}}};
  const float position = t * 4;
  const auto stop = std::size_t(std::min(int(position), 3));
  const auto colour = [](const std::array<float, 3>& c) { return glm::vec3(c[0], c[1], c[2]); };
  return glm::mix(colour(stops[stop]), colour(stops[stop + 1]), glm::smoothstep(0.0F, 1.0F, position - float(stop)));
}

Rgba relief_texel(const ReliefLook& look, const Grid<float>& heights, int x, int y) {
  const auto at = [&](int dx, int dy) { return heights.clamped(x + dx, y + dy); };
  const float nw = at(-1, -1), n = at(0, -1), ne = at(1, -1);
  const float w = at(-1, 0), here = at(0, 0), e = at(1, 0);
  const float sw = at(-1, 1), s = at(0, 1), se = at(1, 1);
  const float run = look.exaggeration / (8 * look.cell_size);
  const float east = (ne + 2 * e + se - nw - 2 * w - sw) * run;
  const float north = (nw + 2 * n + ne - sw - 2 * s - se) * run;
  const glm::vec3 normal = glm::vec3(-east, -north, 1) * (1 / std::sqrt(east * east + north * north + 1));
  float light = 0;
  for (std::size_t i = 0; i < look.suns.size(); ++i) light += sun_weights[i] * std::max(glm::dot(normal, look.suns[i]), 0.0F);
  float shade = 0.5F * light / look.suns[0].z;
  // Hollows a little darker, crests a little lighter: texture that one light direction cannot give.
  const float laplacian = (n + s + e + w - 4 * here) / look.cell_size;
  shade -= std::clamp(laplacian * 0.10F * look.exaggeration, -0.05F, 0.07F);
  const glm::vec3 colour = tint(look, here);
  const auto code = [](float v) { return std::uint8_t(std::clamp(v, 0.0F, 1.0F) * 255 + 0.5F); };
  return {code(colour.r), code(colour.g), code(colour.b), code(shade)};
}

std::shared_ptr<const MapWater> map_water(const Hydrology& hydrology) {
  auto water = std::make_shared<MapWater>();
  water->wet = Grid<Rg>(hydrology.water.width(), hydrology.water.height());
  parallel_rows(0, water->wet.height(), [&](int y) {
    for (int x = 0; x < water->wet.width(); ++x) {
      // Depths of 20 m and more are all deep.
      const float deep = std::sqrt(std::clamp(hydrology.water_depth(x, y) / 20, 0.0F, 1.0F));
      water->wet(x, y) = {std::uint8_t(hydrology.water(x, y) != WaterKind::dry ? 255 : 0), std::uint8_t(deep * 255 + 0.5F)};
    }
  });
  water->wet_mipmaps = mipmaps(water->wet);
  water->rivers = river_ribbons(hydrology, hydrology.water.width());
  return water;
}

}  // namespace

std::shared_ptr<const MapRelief> shaded_relief(const Terrain& terrain, int stride) {
  auto out = std::make_shared<MapRelief>();
  out->stride = stride;
  if (stride > 1) out->thinned = thinned(terrain.height, stride);
  const Grid<float>& heights = stride > 1 ? out->thinned : terrain.height;
  out->height_mipmaps = mipmaps(heights);
  const ReliefLook look = relief_look(terrain, stride);
  out->relief = Grid<Rgba>(heights.width(), heights.height());
  parallel_rows(0, heights.height(), [&](int y) {
    for (int x = 0; x < heights.width(); ++x) out->relief(x, y) = relief_texel(look, heights, x, y);
  });
  out->relief_mipmaps = mipmaps(out->relief);
  return out;
}

MapMaker::MapMaker()
    : maker_([this](const MapRequest& request, const std::stop_token& outdated, const Maker::Publish& publish) {
        make(request, outdated, publish);
      }) {}

void MapMaker::request(MapRequest request) {
  const bool elsewhere = asked_ && asked_->height.rect() != request.terrain->height.rect();
  asked_ = request.terrain;
  maker_.request(std::move(request), elsewhere);
}

void MapMaker::make(const MapRequest& request, const std::stop_token& outdated, const Maker::Publish& publish) {
  const int side = std::max(request.terrain->height.width(), request.terrain->height.height());
  const bool same_ground = last_ && last_->of.terrain == request.terrain;
  const bool same_extent = last_ && last_->of.terrain->height.rect() == request.terrain->height.rect();
  if (!same_extent && side > coarse_map_side) {
    last_.reset();
    const auto coarse = shaded_relief(*request.terrain, (side + coarse_map_side - 1) / coarse_map_side);
    publish(std::make_shared<const MapPicture>(MapPicture{request, coarse, nullptr, nullptr}));
  }
  auto picture = std::make_shared<MapPicture>();
  picture->of = request;
  picture->relief = same_ground ? last_->relief : shaded_relief(*request.terrain, 1);
  if (outdated.stop_requested()) return;
  if (request.hydrology) {
    const bool same_water = last_ && last_->of.hydrology == request.hydrology;
    picture->water = same_water ? last_->water : map_water(*request.hydrology);
  }
  if (outdated.stop_requested()) return;
  if (request.trails) {
    const bool same_trails = last_ && last_->of.trails == request.trails;
    picture->trails = same_trails ? last_->trails : std::make_shared<const RibbonMesh>(trail_ribbons(*request.trails));
  }
  last_ = picture;
  publish(std::move(picture));
}

}  // namespace biotope

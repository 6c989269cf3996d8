#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/base/parallel.hpp"
#include "core/terrain/sun.hpp"
#include "core/terrain/vector_clones.hpp"

namespace biotope {
namespace {

constexpr int sector_count = 16;
/// Cells treated together, so that their normals, horizons and sums stay in the first-level cache.
constexpr int chunk = 256;
using ChunkValues = std::array<float, chunk>;

/// One hour (or the sunlit part of it) of one month's middle day.
struct SunSample {
  /// n.s x weight = up - east_factor x dz/dx - north_factor x dz/dy, before normalising.
  float up = 0;
  float east_factor = 0;
  float north_factor = 0;
  /// Lit fraction = (top - horizon) x inverse_band, clamped to 0..1: the share of the sample's time during which the sun stands above.
  float top = 0;
  float inverse_band = 0;
  /// Horizon sectors on either side of the sun and the share of the second.
  std::size_t sector = 0;
  std::size_t next_sector = 0;
  float sector_share = 0;
};

/// Terrain blurs a shadow's edge at least this much, rad. Our choice: about four sun's radii; the time the sun takes to pass a horizon
/// blurs it further where the sun rises or sets, while a fixed 0.13 rad (7.5 degrees) would wash out the shade of whole valleys.
constexpr double least_half_band = 0.02;

double tangent_of_elevation(const SunPosition& sun) {
  return std::tan(std::clamp(sun.elevation, -1.5, 1.5));
}

/// Adds the unit vector toward the sun, times `weight`, to the sample's factors.
void add_direction(const SunPosition& sun, double weight, SunSample& sample) {
  const double level = std::cos(sun.elevation) * weight;
  sample.up += float(std::sin(sun.elevation) * weight);
  sample.east_factor += float(std::sin(sun.azimuth) * level);
  sample.north_factor += float(std::cos(sun.azimuth) * level);
}

SunSample make_sample(double latitude, double day, double from, double to) {
  const SunPosition middle = sun_position(latitude, day, (from + to) / 2);
  const double weight = (to - from) / 24;
  const double first = tangent_of_elevation(sun_position(latitude, day, from));
  const double last = tangent_of_elevation(sun_position(latitude, day, to));
  const double centre = (first + last) / 2;
  const double half_band = std::max(std::abs(first - last) / 2, least_half_band * (1 + centre * centre));
  const double place = middle.azimuth / (2 * std::numbers::pi) * sector_count;
  SunSample sample;
  // The mean direction over the hour, by Simpson's rule.
  add_direction(sun_position(latitude, day, from), weight / 6, sample);
  add_direction(middle, weight * 4 / 6, sample);
  add_direction(sun_position(latitude, day, to), weight / 6, sample);
  // At sunrise and sunset the sun is on the horizon of flat ground, and flat ground must count the whole sample.
  sample.top = float(std::max(centre + half_band, 2 * half_band));
  sample.inverse_band = float(1 / (2 * half_band));
  sample.sector = std::size_t(place) % sector_count;
  sample.next_sector = (sample.sector + 1) % sector_count;
  sample.sector_share = float(place - std::floor(place));
  return sample;
}

/// The whole hours of a day, cut at sunrise and sunset.
std::vector<SunSample> day_samples(double latitude, double day) {
  std::vector<SunSample> samples;
  const double half_day = day_length(latitude, day) / 2;
  for (int hour = 0; hour < 24; ++hour) {
    const double from = std::max(double(hour), 12 - half_day);
    const double to = std::min(double(hour + 1), 12 + half_day);
    if (to - from > 1e-6) samples.push_back(make_sample(latitude, day, from, to));
  }
  return samples;
}

/// What the samples need to know of one chunk of cells.
struct ChunkGround {
  ChunkValues east;
  ChunkValues north;
  ChunkValues inverse_norm;
  std::array<ChunkValues, sector_count> horizons;
};

BIOTOPE_VECTOR_CLONES
void add_sample(const SunSample& sample, const ChunkGround& ground, ChunkValues& sum) {
  const ChunkValues& here = ground.horizons[sample.sector];
  const ChunkValues& beside = ground.horizons[sample.next_sector];
  const float up = sample.up;
  const float east = sample.east_factor;
  const float north = sample.north_factor;
  const float top = sample.top;
  const float inverse_band = sample.inverse_band;
  const float share = sample.sector_share;
  for (std::size_t i = 0; i < chunk; ++i) {
    float facing = up - east * ground.east[i] - north * ground.north[i];
    facing = facing > 0 ? facing : 0;
    const float horizon = here[i] + share * (beside[i] - here[i]);
    float lit = (top - horizon) * inverse_band;
    lit = lit > 0 ? lit : 0;
    lit = lit < 1 ? lit : 1;
    sum[i] += facing * lit;
  }
}

/// Where each column of the terrain lies between the columns of the horizon grid.
struct ColumnPlaces {
  std::vector<std::uint16_t> left;
  std::vector<float> share;
};

/// Cell coordinate on the horizon grid of a terrain column or row.
double coarse_place(int fine, int stride, int count) {
  return std::clamp((fine - (stride - 1) / 2.0) / stride, 0.0, double(count - 1));
}

ColumnPlaces column_places(int width, int stride, int columns) {
  ColumnPlaces places{std::vector<std::uint16_t>(std::size_t(width)), std::vector<float>(std::size_t(width))};
  for (int x = 0; x < width; ++x) {
    const double place = coarse_place(x, stride, columns);
    const int left = std::min(int(place), std::max(columns - 2, 0));
    places.left[std::size_t(x)] = std::uint16_t(left);
    places.share[std::size_t(x)] = float(place - left);
  }
  return places;
}

/// Horizons along one terrain row, still at the horizon grid's columns (one more column repeats the last).
std::vector<float> row_horizons(const Horizons& horizons, int y) {
  const int columns = horizons.sectors[0].width();
  const int rows = horizons.sectors[0].height();
  const double place = coarse_place(y, horizons.stride, rows);
  const int above = std::min(int(place), std::max(rows - 2, 0));
  const float share = float(place - above);
  std::vector<float> row(std::size_t(columns + 1) * sector_count);
  for (std::size_t s = 0; s < sector_count; ++s) {
    const auto north = horizons.sectors[s].row(above);
    const auto south = horizons.sectors[s].row(std::min(above + 1, rows - 1));
    float* out = row.data() + s * std::size_t(columns + 1);
    for (std::size_t x = 0; x < std::size_t(columns); ++x) out[x] = north[x] + share * (south[x] - north[x]);
    out[columns] = out[columns - 1];
  }
  return row;
}

void load_chunk(const Derivatives& derivatives, const ColumnPlaces& places, const std::vector<float>& horizon_row, int y, std::size_t x0,
                std::size_t count, ChunkGround& ground) {
  const auto east = derivatives.east.row(y);
  const auto north = derivatives.north.row(y);
  for (std::size_t i = 0; i < count; ++i) {
    const float gx = east[x0 + i];
    const float gy = north[x0 + i];
    ground.east[i] = gx;
    ground.north[i] = gy;
    ground.inverse_norm[i] = 1 / std::sqrt(1 + gx * gx + gy * gy);
  }
  const std::size_t columns = horizon_row.size() / sector_count;
  for (std::size_t s = 0; s < sector_count; ++s) {
    const float* row = horizon_row.data() + s * columns;
    for (std::size_t i = 0; i < count; ++i) {
      const std::size_t left = places.left[x0 + i];
      ground.horizons[s][i] = row[left] + places.share[x0 + i] * (row[left + 1] - row[left]);
    }
  }
}

using MonthSamples = std::array<std::vector<SunSample>, 12>;
using MonthGrids = std::array<Grid<float>, 12>;

void illuminate_row(const Derivatives& derivatives, const Horizons& horizons, const ColumnPlaces& places, const MonthSamples& samples,
                    int y, MonthGrids& grids) {
  const std::vector<float> horizon_row = row_horizons(horizons, y);
  const auto width = std::size_t(derivatives.east.width());
  ChunkGround ground{};
  for (std::size_t x0 = 0; x0 < width; x0 += chunk) {
    const std::size_t count = std::min<std::size_t>(chunk, width - x0);
    load_chunk(derivatives, places, horizon_row, y, x0, count, ground);
    for (std::size_t month = 0; month < 12; ++month) {
      ChunkValues sum{};
      for (const SunSample& sample : samples[month]) add_sample(sample, ground, sum);
      const auto out = grids[month].row(y);
      for (std::size_t i = 0; i < count; ++i) out[x0 + i] = sum[i] * ground.inverse_norm[i];
    }
  }
}

}  // namespace

Result<std::array<Grid<float>, 12>> compute_monthly_illumination(const Terrain& terrain, const Derivatives& derivatives,
                                                                 const TaskContext& context) {
  const int width = terrain.height.width();
  const int height = terrain.height.height();
  context.report("illumination", 0);
  const Horizons horizons = compute_horizons(terrain, sector_count);
  const ColumnPlaces places = column_places(width, horizons.stride, horizons.sectors[0].width());
  MonthSamples samples;
  MonthGrids grids;
  for (int month = 0; month < 12; ++month) {
    samples[std::size_t(month)] = day_samples(terrain.latitude, middle_day(month));
    grids[std::size_t(month)] = Grid<float>(width, height);
  }
  constexpr int band = 128;
  for (int y0 = 0; y0 < height; y0 += band) {
    if (context.stopped()) return fail("stopped");
    context.report("illumination", 0.1 + 0.9 * y0 / height);
    parallel_rows(y0, std::min(y0 + band, height),
                  [&](int y) { illuminate_row(derivatives, horizons, places, samples, y, grids); });
  }
  return grids;
}

}  // namespace biotope

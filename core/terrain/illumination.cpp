#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/base/parallel.hpp"
#include "core/terrain/sun.hpp"
#include "core/terrain/sunlight.hpp"
#include "core/terrain/vector_clones.hpp"

namespace biotope {
namespace {

constexpr int sector_count = illumination_sectors;
/// Cells treated together, so that their normals, horizons and sums stay in the first-level cache.
constexpr int chunk = 256;
using ChunkValues = std::array<float, chunk>;

/// Terrain blurs a shadow's edge at least this much, rad. Our choice: about four sun's radii; the time the sun takes to pass a
/// horizon blurs it further where the sun rises or sets, while a fixed 0.13 rad (7.5 degrees) would wash out the shade of whole
/// valleys.
constexpr double least_half_band = 0.02;

double tangent_of_elevation(const SunPosition& sun) { return std::tan(std::clamp(sun.elevation, -1.5, 1.5)); }

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

void load_slopes(const Derivatives& derivatives, int y, std::size_t x0, std::size_t count, std::size_t at, ChunkGround& ground) {
  const auto east = derivatives.east.row(y);
  const auto north = derivatives.north.row(y);
  for (std::size_t i = 0; i < count; ++i) {
    const float gx = east[x0 + i];
    const float gy = north[x0 + i];
    ground.east[at + i] = gx;
    ground.north[at + i] = gy;
    ground.inverse_norm[at + i] = 1 / std::sqrt(1 + gx * gx + gy * gy);
  }
}

/// Cell coordinate on the horizon grid of a terrain column or row.
double coarse_place(int fine, int stride, int count) {
  return std::clamp((fine - (stride - 1) / 2.0) / stride, 0.0, double(count - 1));
}

/// First of the two rows of the horizon grid between which a terrain row lies, and how far it is toward the second.
std::pair<int, float> between_rows(const Horizons& horizons, int y) {
  const int rows = horizons.sectors[0].height();
  const double place = coarse_place(y, horizons.stride, rows);
  const int above = std::min(int(place), std::max(rows - 2, 0));
  return {above, float(place - above)};
}

/// Some columns of horizons along one terrain row, still at the horizon grid's columns (beyond the last it repeats).
void horizons_of_row(const Horizons& horizons, int y, int first_column, int columns, std::vector<float>& out) {
  const int rows = horizons.sectors[0].height();
  const int last = horizons.sectors[0].width() - 1;
  const auto [above, share] = between_rows(horizons, y);
  out.resize(std::size_t(columns) * sector_count);
  for (std::size_t s = 0; s < sector_count; ++s) {
    const auto north = horizons.sectors[s].row(above);
    const auto south = horizons.sectors[s].row(std::min(above + 1, rows - 1));
    float* row = out.data() + s * std::size_t(columns);
    for (int c = 0; c < columns; ++c) {
      const auto from = std::size_t(std::min(first_column + c, last));
      row[c] = north[from] + share * (south[from] - north[from]);
    }
  }
}

/// Whether a sample finds the sun clear of both its horizons wherever they lie in these ranges, or behind both.
bool same_light(const SunSample& sample, const TangentRange& here, const TangentRange& beside) {
  // Far more than what rounding can make of a horizon between two others.
  const float margin = 1e-5F * (1 + sample.top);
  if (std::max(here.highest, beside.highest) < sample.top - 1 / sample.inverse_band - margin) return true;
  return std::min(here.lowest, beside.lowest) > sample.top + margin;
}

}  // namespace

Sunlight::Sunlight(double latitude, int width, const Horizons& horizons) : left_(std::size_t(width)), share_(std::size_t(width)) {
  for (int month = 0; month < 12; ++month) samples_[std::size_t(month)] = day_samples(latitude, middle_day(month));
  const int columns = horizons.sectors[0].width();
  for (int x = 0; x < width; ++x) {
    const double place = coarse_place(x, horizons.stride, columns);
    const int left = std::min(int(place), std::max(columns - 2, 0));
    left_[std::size_t(x)] = std::uint16_t(left);
    share_[std::size_t(x)] = float(place - left);
  }
}

TangentRange Sunlight::read_by(const Horizons& horizons, std::size_t sector, const Rect& cells) const {
  const Grid<float>& tangents = horizons.sectors[sector];
  const int last_row = std::min(between_rows(horizons, cells.y1 - 1).first + 1, tangents.height() - 1);
  const auto first = std::size_t(left_[std::size_t(cells.x0)]);
  const auto last = std::min(std::size_t(left_[std::size_t(cells.x1) - 1]) + 1, std::size_t(tangents.width()) - 1);
  TangentRange range;
  for (int y = between_rows(horizons, cells.y0).first; y <= last_row; ++y) {
    for (const float tangent : tangents.row(y).subspan(first, last + 1 - first)) range.add(tangent);
  }
  return range;
}

std::array<bool, 12> Sunlight::changed_months(const Horizons& horizons, const MovedHorizons& moved, std::size_t tile,
                                              const Rect& cells) const {
  std::array<bool, sector_count> others{};
  std::array<TangentRange, sector_count> ranges;
  for (std::size_t s = 0; s < sector_count; ++s) {
    others[s] = moved.before(s, tile).any();
    ranges[s] = read_by(horizons, s, cells);
    ranges[s].add(moved.before(s, tile));
  }
  std::array<bool, 12> changed{};
  for (std::size_t month = 0; month < 12; ++month) {
    changed[month] = std::ranges::any_of(samples_[month], [&](const SunSample& sample) {
      if (!others[sample.sector] && !others[sample.next_sector]) return false;
      return !same_light(sample, ranges[sample.sector], ranges[sample.next_sector]);
    });
  }
  return changed;
}

void Sunlight::illuminate(const Derivatives& derivatives, const Horizons& horizons, const Rect& cells,
                          const std::array<Grid<float>*, 12>& out) const {
  const auto width = std::size_t(cells.width());
  const auto x0 = std::size_t(cells.x0);
  const int first_column = left_[x0];
  const int columns = left_[std::size_t(cells.x1) - 1] + 2 - first_column;
  const int rows = chunk / cells.width();
  std::vector<float> horizon_row;
  ChunkGround ground{};
  for (int y0 = cells.y0; y0 < cells.y1; y0 += rows) {
    const int y1 = std::min(y0 + rows, cells.y1);
    for (int y = y0; y < y1; ++y) {
      const std::size_t at = std::size_t(y - y0) * width;
      load_slopes(derivatives, y, x0, width, at, ground);
      horizons_of_row(horizons, y, first_column, columns, horizon_row);
      for (std::size_t s = 0; s < sector_count; ++s) {
        const float* row = horizon_row.data() + s * std::size_t(columns);
        for (std::size_t i = 0; i < width; ++i) {
          const std::size_t left = left_[x0 + i] - std::size_t(first_column);
          ground.horizons[s][at + i] = row[left] + share_[x0 + i] * (row[left + 1] - row[left]);
        }
      }
    }
    for (std::size_t month = 0; month < 12; ++month) {
      if (out[month] == nullptr) continue;
      ChunkValues sum{};
      for (const SunSample& sample : samples_[month]) add_sample(sample, ground, sum);
      for (int y = y0; y < y1; ++y) {
        const std::size_t at = std::size_t(y - y0) * width;
        float* row = out[month]->row(y).data() + x0;
        for (std::size_t i = 0; i < width; ++i) row[i] = sum[at + i] * ground.inverse_norm[at + i];
      }
    }
  }
}

Result<std::array<Grid<float>, 12>> compute_monthly_illumination(const Terrain& terrain, const Derivatives& derivatives,
                                                                 const TaskContext& context) {
  const int width = terrain.height.width();
  const int height = terrain.height.height();
  context.report("illumination", 0);
  const Horizons horizons = compute_horizons(terrain, sector_count);
  const Sunlight sunlight(terrain.latitude, width, horizons);
  std::array<Grid<float>, 12> grids;
  std::array<Grid<float>*, 12> out{};
  for (std::size_t month = 0; month < 12; ++month) {
    grids[month] = Grid<float>(width, height);
    out[month] = &grids[month];
  }
  const int columns = (width + tile_side - 1) / tile_side;
  for (int y = 0; y < height; y += tile_side) {
    if (context.stopped()) return fail("stopped");
    context.report("illumination", 0.1 + 0.9 * y / height);
    parallel_each(std::size_t(columns), [&](std::size_t column) {
      const int x = int(column) * tile_side;
      sunlight.illuminate(derivatives, horizons, {x, y, std::min(x + tile_side, width), std::min(y + tile_side, height)}, out);
    });
  }
  return grids;
}

}  // namespace biotope

#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "core/base/grid.hpp"
#include "core/terrain/derivatives.hpp"
#include "core/terrain/moved_horizons.hpp"
#include "core/terrain/sun.hpp"
#include "core/terrain/terrain.hpp"
#include "core/terrain/tile_set.hpp"

namespace biotope {

/// Azimuths in which horizons are looked for by the illumination.
inline constexpr int illumination_sectors = 16;

/// Horizons of a ground that changes here and there: only the lines through changed cells are scanned again. Always equal to
/// compute_horizons of the same ground, to the bit.
class HorizonField {
 public:
  HorizonField() = default;
  explicit HorizonField(const Terrain& terrain, int sectors = illumination_sectors, int stride = 0);

  /// Follows the ground, of the same size, after changes in some tiles; notes for every cell whose horizon may differ what it
  /// was.
  void update(const Terrain& terrain, const TileSet& changed, MovedHorizons& moved);
  [[nodiscard]] const Horizons& horizons() const { return horizons_; }

 private:
  Grid<float> coarse_;
  Horizons horizons_;
};

/// One hour (or the sunlit part of it) of one month's middle day.
struct SunSample {
  /// n.s x weight = up - east_factor x dz/dx - north_factor x dz/dy, before normalising.
  float up = 0;
  float east_factor = 0;
  float north_factor = 0;
  /// Lit fraction = (top - horizon) x inverse_band, clamped to 0..1: the share of the sample's time during which the sun stands
  /// above.
  float top = 0;
  float inverse_band = 0;
  /// Horizon sectors on either side of the sun and the share of the second.
  std::size_t sector = 0;
  std::size_t next_sector = 0;
  float sector_share = 0;
};

/// Monthly illumination of any cells of a terrain; one cell's depends on its slope and its horizons alone.
class Sunlight {
 public:
  /// For terrains of this width and horizons of this layout.
  Sunlight(double latitude, int width, const Horizons& horizons);

  /// By month: whether the light of a small tile, whose slopes are as they were, may have changed since its horizons were what
  /// was noted. Where the sun stands clear of a horizon before and after, or behind it both times, it did not.
  [[nodiscard]] std::array<bool, 12> changed_months(const Horizons& horizons, const MovedHorizons& moved, std::size_t tile,
                                                    const Rect& cells) const;

  /// Writes the twelve ratios (see compute_monthly_illumination) of a rectangle at most tile_side wide; null: a month that is not
  /// asked for.
  void illuminate(const Derivatives& derivatives, const Horizons& horizons, const Rect& cells,
                  const std::array<Grid<float>*, 12>& out) const;

 private:
  /// Horizons that some cells read, between the lowest and the highest.
  [[nodiscard]] TangentRange read_by(const Horizons& horizons, std::size_t sector, const Rect& cells) const;

  std::array<std::vector<SunSample>, 12> samples_;
  /// Where each column of the terrain lies between the columns of the horizon grid.
  std::vector<std::uint16_t> left_;
  std::vector<float> share_;
};

}  // namespace biotope

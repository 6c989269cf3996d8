#pragma once

#include <cstdint>

#include "core/base/grid.hpp"

namespace biotope {

/// Smooth random field: values of a lattice `wavelength` apart, uniform in -1..1, joined by cubic B-splines (so mostly within -0.7..0.7).
/// The same (seed, wavelength) gives the same field at every resolution.
class SmoothNoise {
 public:
  /// Covers the square [0, side] x [0, side], in the unit of `wavelength`.
  SmoothNoise(std::uint64_t seed, double side, double wavelength);
  [[nodiscard]] float operator()(double x, double y) const;

 private:
  double inverse_wavelength_;
  Grid<float> lattice_;
};

/// Several SmoothNoise, each of half the wavelength and `gain` times the height of the one before.
class LayeredNoise {
 public:
  LayeredNoise(std::uint64_t seed, double side, double wavelength, int octaves, float gain = 0.5F);
  [[nodiscard]] float operator()(double x, double y) const;

 private:
  std::vector<SmoothNoise> layers_;
  float gain_;
};

}  // namespace biotope
